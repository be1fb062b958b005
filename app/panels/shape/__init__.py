"""The shape panel: a card of sliders for each segment, with its joint's rule, in plain words."""
