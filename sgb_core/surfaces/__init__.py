"""What turning a profile about an axis gives: surfaces, meshes, measures.

Knows curves; nothing of walls, bodies or files.
"""
