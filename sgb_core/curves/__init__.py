"""One SG-Bézier curve, and chains of them."""
