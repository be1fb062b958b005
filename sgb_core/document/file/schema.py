"""The JSON Schema of project files, made from what the document's classes say of their fields.

``python -m sgb_core.document.file.schema`` prints it, as ``resources/`` holds it.
"""

from __future__ import annotations

import sys
from typing import Any

from sgb_core.document.file import json_text
from sgb_core.document.file.project_file import HEAD
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Schema
from sgb_core.fields.record import table_of

_ABOUT = (
    "A rotation surface: a chain of shape-adjustable generalized Bézier segments and how it "
    "turns. Beyond this schema: the number of joints is one less than that of segments (the same "
    "in a closed profile), ends meet at every joint whose rule is not free, segments named by laws "
    "exist, and a law has one value at each angle. Unknown keys are allowed and kept."
)


def schema() -> dict[str, Any]:
    """Return the schema, of the draft 2020-12."""
    shared: Schema = {}
    sections = table_of(Document).schema(shared)
    head = {key: {"const": value} for key, value in HEAD.items()}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": "https://sgb-studio.invalid/sgb-document.schema.json",
        "title": f"SGB Studio project file, version {HEAD['version']}",
        "description": _ABOUT,
        **sections,
        "required": [*HEAD, *sections["required"]],
        "properties": {**head, **sections["properties"]},
        "$defs": shared,
    }


if __name__ == "__main__":
    sys.stdout.write(json_text.dump(schema()).decode())
