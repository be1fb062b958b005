"""Plates of panels for papers, the paper's figures, and the studio and fit dialog for them.

Knows the scene for what is shaded, and the state; no view of the window.
"""
