"""Targets reached together: capacity, volume, material, height and diameters."""
