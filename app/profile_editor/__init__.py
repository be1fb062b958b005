"""The 2-D editor of the generatrix: its sheet, points, curve, grid and guides.

Knows the hand, not the viewport.
"""
