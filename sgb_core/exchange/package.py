"""A ZIP file whose large parts are deflated on threads beside the one that makes them.

Deflating takes longer than making the text of a mesh, and lets other threads run. Each chunk is
deflated on its own, with the end of the one before as its dictionary, and ends at a whole byte, so
that all together are one stream; the bytes do not depend on how many threads there are.
"""

from __future__ import annotations

import os
import struct
import zlib
from collections import deque
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, BinaryIO

if TYPE_CHECKING:
    from concurrent.futures import Future

# The text of a mesh shrinks to a fifth at once; more effort gains little and takes long.
_EFFORT = 2
# How far back deflate looks (RFC 1951).
_WINDOW = 32_768
# Bytes from which on a chunk is worth a thread of its own.
_CHUNK = 1 << 20
_THREADS = min(4, os.cpu_count() or 1)
# The fixed date 1980-01-01: the same document gives the same bytes.
_TIME, _DATE = 0, 0x21
_VERSION, _DEFLATED, _SIZES_FOLLOW = 20, 8, 0x8
_LOCAL, _FOLLOWING, _CENTRAL, _END = (
    b"PK\3\4",
    b"PK\7\x08",
    b"PK\1\2",
    b"PK\5\6",
)


def write_package(stream: BinaryIO, parts: Iterable[tuple[str, Iterable[bytes]]]) -> None:
    """Write named parts, less than 4 GiB each and together, as a ZIP file (APPNOTE 6.3.10).

    Names are ASCII. Where the stream cannot be sought the sizes of a part follow it.
    """
    seekable = stream.seekable()
    flags = 0 if seekable else _SIZES_FOLLOW
    listed: list[bytes] = []
    at = count = 0
    for name, chunks in parts:
        known = name.encode("ascii")
        place = stream.tell() if seekable else 0
        stream.write(_LOCAL + _record(flags, 0, 0, 0, len(known)) + known)
        crc = size = packed = 0
        for data, deflated in _deflated(chunks):
            crc, size = zlib.crc32(data, crc), size + len(data)
            packed += len(deflated)
            stream.write(deflated)
        if seekable:
            end = stream.tell()
            stream.seek(place)
            stream.write(_LOCAL + _record(flags, crc, packed, size, len(known)))
            stream.seek(end)
        else:
            stream.write(_FOLLOWING + struct.pack("<III", crc, packed, size))
        record = _record(flags, crc, packed, size, len(known))
        inside = struct.pack("<HHHII", 0, 0, 0, 0, at)
        listed.append(_CENTRAL + struct.pack("<H", _VERSION) + record + inside + known)
        at += 30 + len(known) + packed + (0 if seekable else 16)
        count += 1
    directory = b"".join(listed)
    stream.write(directory + _END)
    stream.write(struct.pack("<HHHHIIH", 0, 0, count, count, len(directory), at, 0))


def _record(flags: int, crc: int, packed: int, size: int, name: int) -> bytes:
    """Return what the header of a part and its line in the directory share."""
    fixed = (_VERSION, flags, _DEFLATED, _TIME, _DATE)
    return struct.pack("<HHHHHIIIHH", *fixed, crc, packed, size, name, 0)


def _deflated(chunks: Iterable[bytes]) -> Iterator[tuple[bytes, bytes]]:
    """Yield chunks with what they are deflated; the last one is empty and ends the stream."""
    # Imported late: where a program ends while a thread imports this module, it would complain.
    from concurrent.futures import ThreadPoolExecutor

    waiting: deque[tuple[bytes, Future[bytes]]] = deque()
    before = b""
    with ThreadPoolExecutor(_THREADS) as threads:
        for data in _gathered(chunks):
            waiting.append((data, threads.submit(_deflate, data, before)))
            before = data[-_WINDOW:]
            if len(waiting) > _THREADS:
                made, deflated = waiting.popleft()
                yield made, deflated.result()
        while waiting:
            made, deflated = waiting.popleft()
            yield made, deflated.result()
    yield b"", zlib.compressobj(_EFFORT, zlib.DEFLATED, -zlib.MAX_WBITS).flush()


def _gathered(chunks: Iterable[bytes]) -> Iterator[bytes]:
    """Yield the same bytes in chunks of some size."""
    held: list[bytes] = []
    size = 0
    for chunk in chunks:
        held.append(chunk)
        size += len(chunk)
        if size >= _CHUNK:
            yield b"".join(held)
            held, size = [], 0
    yield b"".join(held)


def _deflate(data: bytes, before: bytes) -> bytes:
    way = (_EFFORT, zlib.DEFLATED, -zlib.MAX_WBITS, zlib.DEF_MEM_LEVEL, zlib.Z_DEFAULT_STRATEGY)
    deflater = zlib.compressobj(*way, before) if before else zlib.compressobj(*way)
    return deflater.compress(data) + deflater.flush(zlib.Z_SYNC_FLUSH)
