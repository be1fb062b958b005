"""The saved truth of a project and the ways to change it.

Knows all geometry; no format but its own, no window.
"""
