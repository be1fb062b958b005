"""What one step of unsaved work holds: the sections that changed since the step before.

Of a profile's segments those alone that changed; where they are many their numbers stand in one
text of base64, little-endian doubles, so that a step is written at once however long the profile
is. Pictures stand in records of their own, once.
"""

from __future__ import annotations

import base64
import time
from collections.abc import Mapping, Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.appearance.picture_file import PICTURE
from sgb_core.document.errors import FileError
from sgb_core.document.file.records import record
from sgb_core.document.file.shared_pictures import pictures_of, share
from sgb_core.document.model import Document
from sgb_core.fields.record import codec_of, table_of
from sgb_core.findings.files import NoContent
from sgb_core.values import dataclass

# So many segments are written one by one, to be read by eye.
FEW = 16
# Of a segment: its points, then λ1, λ2, λ3, ω.
_NUMBERS = 12
_IN_NUMBERS = ("points", "lambda", "omega")


@dataclass(slots=True)
class Written:
    """What an entry holds, how long it is, and how long it was at first; sizes in bytes."""

    document: Document
    pictures: set[str]
    size: int = 0
    first: int = 0


def step(
    document: Document,
    target: str | None,
    number: int,
    written: Written,
    *,
    whole: bool = False,
) -> bytes:
    """Return the records of a step from what is written to a document, and note them there."""
    table, before = table_of(Document), written.document
    changed: dict[str, object] = {}
    new: list[bytes] = []
    segments = {} if whole else _changed_segments(before.profile, document.profile)
    for row in table.written:
        if row.name == "profile" and segments:
            continue
        if whole or getattr(document, row.name) is not getattr(before, row.name):
            if row.name == "profile":
                changed[row.name] = {row.key: _profile(document.profile)}
            else:
                changed[row.name] = _shared(document, table.part(document, row), written, new)
    if whole or document.extra is not before.extra:
        changed["extra"] = dict(document.extra)
    told: dict[str, object] = {
        "step": number,
        "seconds": time.time(),
        "target": target,
        "sections": changed,
    }
    if segments:
        told["segments"] = segments
    return b"".join([*new, record(told)])


def _profile(profile: Profile) -> dict[str, object]:
    """Return a profile's section, its segments packed where they are many."""
    if len(profile) <= FEW:
        return codec_of(Profile).to_plain(profile)
    table = table_of(Profile)
    section: dict[str, object] = {}
    for row in table.written:
        if row.name == "segments":
            section[row.key] = _packed(profile.segments)
        else:
            section.update(table.part(profile, row))
    return {**section, **profile.extra}


def _changed_segments(before: Profile, after: Profile) -> dict[str, object]:
    """Return the segments that changed, by their numbers, where nothing else of a profile did."""
    rest = (each.name for each in fields(Profile) if each.name != "segments")
    if len(before) != len(after) or any(getattr(before, k) != getattr(after, k) for k in rest):
        return {}
    pairs = enumerate(zip(before.segments, after.segments, strict=True))
    changed = {k: new for k, (old, new) in pairs if new is not old}
    if len(changed) <= FEW:
        return {str(k): codec_of(Segment).to_plain(new) for k, new in changed.items()}
    return {"numbers": list(changed), **_packed(list(changed.values()))}


def _packed(segments: Sequence[Segment]) -> dict[str, object]:
    """Return segments as one text of all their numbers, and what else few of them have."""
    table = np.empty((len(segments), _NUMBERS), "<f8")
    table[:, :8] = np.stack([segment.points for segment in segments]).reshape(-1, 8)
    table[:, 8:] = [
        (s.lambda1, s.lambda2, s.lambda3, s.omega) for s in (segment.shape for segment in segments)
    ]
    more: dict[str, object] = {}
    for place, segment in enumerate(segments):
        if segment.extra or segment.holds_start or segment.holds_end:
            plain = codec_of(Segment).to_plain(segment)
            more[str(place)] = {k: v for k, v in plain.items() if k not in _IN_NUMBERS}
    return {"packed": base64.b64encode(table.tobytes()).decode("ascii"), "more": more}


def _shared(
    document: Document, part: dict[str, object], written: Written, new: list[bytes]
) -> dict[str, object]:
    """Return a part of a document's tree without pictures, which become records of their own."""
    if part.keys().isdisjoint(("appearance", "states", "reference")):
        return part
    for picture in pictures_of(document):
        if picture.name not in written.pictures:
            written.pictures.add(picture.name)
            new.append(record({"picture": PICTURE.to_plain(picture)}))
    return share(document, part, set(written.pictures))


def replay(sections: dict[str, Any], value: Mapping[str, Any]) -> None:
    """Take a step into the sections of the work so far; raises ValueError where it does not fit."""
    sections.update(value["sections"])
    changed = value.get("segments", {})
    if not isinstance(changed, dict):
        raise FileError(NoContent.NO_DOCUMENT)
    try:
        if "profile" in value["sections"]:
            profile = sections["profile"]["profile"]
            if isinstance(profile["segments"], dict):
                profile["segments"] = _unpacked(profile["segments"])
        if "packed" in changed:
            changed = dict(zip(changed["numbers"], _unpacked(changed), strict=True))
        for number, segment in changed.items():
            sections["profile"]["profile"]["segments"][int(number)] = segment
    except (LookupError, TypeError):
        raise FileError(NoContent.NO_DOCUMENT) from None


def _unpacked(packed: Mapping[str, Any]) -> list[dict[str, object]]:
    """Return the plain values of segments that :func:`_packed` gave."""
    data = np.frombuffer(base64.b64decode(packed["packed"], validate=True), "<f8")
    table = data.reshape(-1, _NUMBERS)
    # JSON has no others, and the reader of the document expects none.
    if not np.isfinite(table).all():
        raise FileError(NoContent.NO_DOCUMENT)
    return [
        {
            "points": [row[0:2], row[2:4], row[4:6], row[6:8]],
            "lambda": row[8:11],
            "omega": row[11],
            **packed["more"].get(str(place), {}),
        }
        for place, row in enumerate(table.tolist())
    ]
