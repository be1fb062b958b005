"""Preferences, the text's size, and keys of one's own.

Knows the commands by name and the preferences that the state keeps; no document.
"""
