"""Whether the same object is told in another unit: views then keep it where it is in sight."""

from __future__ import annotations

import numpy as np

from sgb_core.document.model import Document


def factor_between(old: Document, new: Document) -> float:
    """Return by what all lengths were multiplied so that the object kept its true size, else 1."""
    if old.unit is new.unit or len(old.profile) != len(new.profile):
        return 1.0
    factor = float(old.unit.factor_to(new.unit))
    rewritten = factor * old.profile.control_points
    same = np.allclose(new.profile.control_points, rewritten, rtol=1e-9, atol=0.0)
    return factor if same else 1.0
