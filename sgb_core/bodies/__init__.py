"""Solid things: outline, wall, floor, foot, rim, vessel; their meshes, thickness and stability.

Knows curves and surfaces.
"""
