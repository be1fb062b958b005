"""Films of the object turning or changing, as GIF, MP4 or pictures.

Knows the scene, drawn off the screen, and the state.
"""
