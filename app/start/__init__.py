"""What greets: gallery of presets, hints, guided tour, and the offer of unsaved work.

Knows the state and the files; moves sliders through the presenter as a hand would.
"""
