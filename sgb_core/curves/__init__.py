"""One SG-Bézier curve, and chains of them.

Knows fields and findings only: no axis, no surface.
"""
