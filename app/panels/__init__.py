"""The docks around the views, one room or module each.

They know the state and the widgets, not each other.
"""
