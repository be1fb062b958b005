"""Paths of a printer straight from the exact surface, and their G-code; no mesh, no slicer.

Lengths are in millimetres, with the axis upright and the body's lowest point at height 0. Knows
documents and what they are made of; sources, exchange and drawings know nothing of it.
"""
