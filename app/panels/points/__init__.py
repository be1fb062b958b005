"""The table of control points, with exact coordinates to type."""
