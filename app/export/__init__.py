"""Writing a mesh, profile or picture from the window: dialog, preview, plan of what is written.

Knows the state, the scene for pictures, and the core's exchange; no panel or view.
"""
