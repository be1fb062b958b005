"""How a pointer grabs the profile: coordinates, hits, drags, snapping, and the canvas it draws on.

Shared by the profile editor and the viewport; knows neither.
"""
