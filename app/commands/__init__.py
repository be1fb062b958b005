"""Actions by name, as menus, palette and keys offer them, and their dialogs.

They know small Protocols of what they act on, never the window.
"""
