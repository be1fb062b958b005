"""Writing a mesh, profile or picture from the window: dialog, preview, plan of what is written."""
