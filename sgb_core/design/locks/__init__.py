"""Dimensions of a profile and its body, and locks: dimensions that hold while all else changes."""
