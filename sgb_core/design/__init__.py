"""Search for parameters instead of evaluating them.

Knows curves, surfaces and bodies as what is evaluated; no document and no file.
"""
