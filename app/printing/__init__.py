"""Printing from the window: a machine and its settings, the path seen turn by turn, its risks.

Knows the state, files written aside, and the core's toolpaths; no panel, no view, no other dialog.
"""
