"""Preferences, the text's size, and keys of one's own."""
