"""What VTK draws: surface, bodies, looks, overlays and highlights of one frame, on screen and off.

Knows frames and colours, no event of a mouse or key.
"""
