"""Colours, icons and the style sheet of the light and the dark theme.

Knows Qt and the resources, no document.
"""
