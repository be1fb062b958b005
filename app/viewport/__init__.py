"""The 3-D view: navigation, the hand in space, handles, orientation cube, refinement at rest.

Knows the scene and the hand.
"""
