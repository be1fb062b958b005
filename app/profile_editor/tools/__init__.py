"""The tools of the profile editor: what the hand does there instead of selecting and dragging."""

from __future__ import annotations
