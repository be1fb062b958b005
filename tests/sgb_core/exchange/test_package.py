"""ZIP files deflated on threads, read by the standard library."""

from __future__ import annotations

import io
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.exchange import package
from sgb_core.exchange.package import write_package

CHUNKS = st.lists(st.binary(max_size=40), max_size=6)


class Pipe(io.BytesIO):
    """A stream that only goes on."""

    def seekable(self) -> bool:
        return False

    def seek(self, *_: object) -> int:
        raise io.UnsupportedOperation("seek")

    tell = seek


def written(parts, stream: io.BytesIO | None = None) -> bytes:
    stream = io.BytesIO() if stream is None else stream
    write_package(stream, parts)
    return stream.getvalue()


def read(data: bytes) -> list[tuple[str, bytes]]:
    with zipfile.ZipFile(io.BytesIO(data)) as found:
        assert found.testzip() is None
        assert {each.date_time for each in found.infolist()} <= {(1980, 1, 1, 0, 0, 0)}
        return [(name, found.read(name)) for name in found.namelist()]


@settings(max_examples=60)
@given(st.lists(CHUNKS, max_size=4), st.sampled_from([1, 7, 1000]), st.sampled_from([1, 3]))
def test_what_is_written_is_read(contents, chunk, threads):
    parts = [(f"3D/{k}.txt", chunks) for k, chunks in enumerate(contents)]
    plain = [(name, b"".join(chunks)) for name, chunks in parts]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(package, "_CHUNK", chunk)
        found = written(parts)
        assert read(found) == plain
        assert read(written(parts, Pipe())) == plain
        patch.setattr(package, "_THREADS", threads)
        assert written(parts) == found


def test_chunks_shrink_as_one_text():
    """A chunk is deflated with the end of the one before at hand."""
    rows = [
        b"".join(b"<vertex x=%d/>" % (k * k) for k in range(n, n + 40)) for n in range(0, 8000, 40)
    ]
    whole = len(written([("a", rows)]))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(package, "_CHUNK", 16_000)
        assert len(written([("a", rows)])) < 1.1 * whole


def test_what_a_part_raises_passes_through():
    def failing():
        yield b"first"
        raise ValueError("no more")

    with pytest.raises(ValueError, match="no more"):
        written([("a", failing())])
