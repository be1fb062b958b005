"""The Vary panel: laws of the shape parameters over the turn, and an editor of one's own curve."""
