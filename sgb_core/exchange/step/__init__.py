"""STEP: exact surfaces and solids for CAD programs.

What is drawn is exact; walls that are moved along its normal, and what laws vary, are splines
within a tolerance. Curves of the half-plane come from the drawn profile (``drawn``) or from a
body's section (``walls``); the kernel turns, sews and checks them.
"""

from sgb_core.exchange.step.writer import FORMAT, write_step

__all__ = ["FORMAT", "write_step"]
