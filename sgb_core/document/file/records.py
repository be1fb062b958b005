"""Records appended to a file, each with its length and a checksum, so that a torn end is seen.

A record is one line: CRC-32 of the rest in 8 hexadecimal digits, a blank, the JSON text of an
object. JSON text of one line has no line break inside, so that records stay apart.
"""

from __future__ import annotations

import json
import os
import re
import zlib
from collections.abc import Iterator, Mapping

_DIGITS = 8
_TORN = re.compile(rb"[0-9a-f]{0,8}|[0-9a-f]{8} (\{[^\n]*)?")


def record(value: Mapping[str, object]) -> bytes:
    """Return a value as a record."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return b"%08x %s\n" % (zlib.crc32(text), text)


def records(data: bytes) -> Iterator[bytes]:
    """Yield the JSON texts of the records up to the first that is torn or damaged."""
    begin = 0
    while (end := data.find(b"\n", begin)) >= 0:
        text = data[begin + _DIGITS + 1 : end]
        if data[begin : begin + _DIGITS + 1] != b"%08x " % zlib.crc32(text):
            return
        yield text
        begin = end + 1


def is_torn(data: bytes) -> bool:
    """Return whether bytes are whole records and the beginning of one more, or none at all."""
    rest = data[sum(len(text) + _DIGITS + 2 for text in records(data)) :]
    return _TORN.fullmatch(rest) is not None


def write_all(descriptor: int, data: bytes) -> None:
    """Write bytes and see them to the disk; raises OSError where the system refuses."""
    rest = memoryview(data)
    while rest:
        rest = rest[os.write(descriptor, rest) :]
    # Where the system tells them apart, the bytes matter and the time of change does not.
    getattr(os, "fdatasync", os.fsync)(descriptor)
