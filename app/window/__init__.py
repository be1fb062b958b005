"""The main window: which views and panels there are, where they sit, and the menus.

Knows all rooms below it; only the command line's entry knows it.
"""
