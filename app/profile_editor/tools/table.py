"""The table of the profile editor's tools: what stands here has a key, a button, a command."""

from __future__ import annotations

from PySide6.QtCore import Qt

from app.profile_editor.tools.measure import MeasureTool
from app.profile_editor.tools.pen import PenTool
from app.profile_editor.tools.pencil import PencilTool
from app.profile_editor.tools.placing import PlacingTool
from app.profile_editor.tools.tool import ToolKind

SELECT = "select"

TOOLS = (
    ToolKind(
        SELECT,
        "Select",
        Qt.Key.Key_V,
        "tool-select",
        "Select and drag points of the profile",
    ),
    ToolKind(
        "pen",
        "Pen",
        Qt.Key.Key_P,
        "tool-pen",
        "Draw the profile: click for a corner, drag for a smooth point",
        PenTool,
    ),
    ToolKind(
        "pencil",
        "Pencil",
        Qt.Key.Key_N,
        "tool-pencil",
        "Draw freehand: a whole profile, on from an end, or a part of it anew",
        PencilTool,
    ),
    ToolKind(
        "picture",
        "Picture",
        Qt.Key.Key_B,
        "tool-picture",
        "Move, turn and scale the picture behind the profile",
        PlacingTool,
    ),
    ToolKind(
        "measure",
        "Measure",
        Qt.Key.Key_M,
        "tool-measure",
        "Read any distance, angle, radius of curvature and wall: click from place to place, "
        "points and the curve are magnetic, Esc leaves",
        MeasureTool,
    ),
)
BY_NAME = {kind.name: kind for kind in TOOLS}
BY_KEY = {int(kind.key): kind for kind in TOOLS}
