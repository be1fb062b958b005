"""Drawings on paper: the dimensioned section, the vessel plate and the template at true size.

A page is a frozen value in millimetres, y upwards; what writes or shows it knows nothing of
documents. Knows documents; sources, exchange and toolpaths know nothing of it.
"""
