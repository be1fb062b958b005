"""Project files and a runner that the command line's tests share."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

SPINDLE = [
    {"points": [[0, 0], [15, 0], [30, 10], [25, 30]], "lambda": [0.5, 4, 2], "omega": 0.7},
    {"points": [[25, 30], [20, 50], [10, 60], [0, 60]], "lambda": [2, 3.5, 0.2], "omega": 1},
]


def project(segments: Any = SPINDLE, **sections: Any) -> dict[str, Any]:
    """Return a project as the plain object of its file; ``profile_...`` goes into the profile."""
    profile = {"segments": segments}
    for key in [key for key in sections if key.startswith("profile_")]:
        profile[key.removeprefix("profile_")] = sections.pop(key)
    return {"format": "sgb-document", "version": 1, "profile": profile, **sections}


def write_project(path: Path, *segments: Any, **sections: Any) -> str:
    """Write a project file and return its path as it would be typed."""
    path.write_text(json.dumps(project(*segments, **sections)), encoding="utf-8")
    return str(path)
