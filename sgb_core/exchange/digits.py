"""Numbers as text, whole arrays at a time: what OBJ and 3MF files consist of.

Characters are looked up four digits at a time and placed in a table of bytes with one row a
record; blanks are NUL bytes, which :func:`packed` takes out at the end.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import floor, log10
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.values import dataclass

Bytes = NDArray[np.uint8]
_Number = TypeVar("_Number", np.float64, np.int64)

# Relative to the largest value of the array: positions nearly in full, directions and texture
# coordinates as single precision holds them.
FINE = 11
COARSE = 7

CHUNK = 65_536

_FOUR = np.array([b"%04d" % value for value in range(10_000)], dtype="S4").view(np.uint32)


@dataclass(frozen=True, slots=True)
class Decimal:
    """How a whole array is written: ``places`` digits after the point, then ``exponent``.

    ``digits`` is the columns kept for digits, a multiple of four.
    """

    digits: int
    places: int
    exponent: int

    @classmethod
    def for_values(cls, values: Floats, significant: int = FINE) -> Decimal:
        """Return the notation that gives the largest of finite values ``significant`` digits.

        Values around 1 are written plainly; very large or small ones with a common power of ten.
        """
        # One digit is spare, since rounding may carry 9.99… over to 10.
        digits = 4 * (significant // 4 + 1)
        largest = float(np.abs(values).max(initial=0.0))
        magnitude = floor(log10(largest)) + 1 if largest > 0.0 else 1
        exponent = 0 if 0 <= magnitude < significant else magnitude - 1
        return cls(digits, significant - (magnitude - exponent), exponent)

    @property
    def width(self) -> int:
        """The columns that one number takes: sign, digits, point, exponent."""
        return 1 + self.digits + 1 + len(self.suffix)

    @property
    def suffix(self) -> bytes:
        """The power of ten as text; empty when it is 1."""
        return b"e%d" % self.exponent if self.exponent else b""

    def write(self, values: Floats, table: Bytes) -> None:
        """Write ``values``, shape (n,), into ``table``, shape (n, width); blanks become NUL."""
        # In parts, each of which stays in the range of floating-point numbers.
        half = -self.exponent // 2
        near_one = values * 10.0**half * 10.0 ** (-self.exponent - half)
        scaled = np.rint(near_one * 10.0**self.places).astype(np.int64)
        whole = np.abs(scaled)
        characters = _characters(whole, self.digits)
        ahead = self.digits - self.places
        # Zeros ahead of the first digit, but the one before the point stays.
        for column in range(ahead - 1):
            characters[whole < 10 ** (self.digits - 1 - column), column] = 0
        table[:, 0] = np.where(scaled < 0, ord("-"), 0)
        table[:, 1 : 1 + ahead] = characters[:, :ahead]
        table[:, 1 + ahead] = ord(".")
        table[:, 2 + ahead : 2 + self.digits] = characters[:, ahead:]
        table[:, 2 + self.digits :] = np.frombuffer(self.suffix, np.uint8)


def number_lines(
    values: Floats, before: tuple[bytes, ...], after: bytes, significant: int = FINE
) -> Iterator[bytes]:
    """Yield the rows of ``values``, shape (n, k), as text, many rows at a time.

    ``before`` holds what stands ahead of each of the k numbers, ``after`` what ends a row.
    """
    notation = Decimal.for_values(values, significant)
    return _lines(values, before, after, notation.width, notation.write)


def integer_lines(
    values: Ints, before: tuple[bytes, ...], after: bytes, named: Ints
) -> Iterator[bytes]:
    """Yield the rows of ``named[values]``, in [0, 10¹²), as :func:`number_lines` does.

    ``values`` has shape (n, k), ``named`` (m,). The numbers of a mesh's points come again and
    again: each is made into text once.
    """
    width = len(str(int(named.max(initial=0))))
    table = np.empty((len(named), width), dtype=np.uint8)
    for start in range(0, len(named), CHUNK):
        write_integers(named[start : start + CHUNK], table[start : start + CHUNK])
    names = table.view(f"V{width}")[:, 0]

    def look_up(column: Ints, target: Bytes) -> None:
        target[:] = names[column].view(np.uint8).reshape(len(column), width)

    return _lines(values, before, after, width, look_up)


def _lines(
    values: NDArray[_Number],
    before: tuple[bytes, ...],
    after: bytes,
    width: int,
    write: Callable[[NDArray[_Number], Bytes], None],
) -> Iterator[bytes]:
    """Yield rows whose numbers ``write`` puts into tables of ``width`` columns."""
    row = sum(map(len, before)) + len(before) * width + len(after)
    table = np.empty((min(CHUNK, len(values)), row), dtype=np.uint8)
    for start in range(0, len(values), CHUNK):
        chunk = values[start : start + CHUNK]
        used = table[: len(chunk)]
        at = 0
        for text, column in zip(before, chunk.T, strict=True):
            used[:, at : at + len(text)] = np.frombuffer(text, np.uint8)
            at += len(text)
            write(column, used[:, at : at + width])
            at += width
        used[:, at:] = np.frombuffer(after, np.uint8)
        yield packed(used)


def write_integers(values: Ints, table: Bytes) -> None:
    """Write ``values`` in [0, 10¹²), shape (n,), right-aligned into ``table``, shape (n, w).

    ``w`` ≤ 12 has to be enough for the largest; blanks become NUL.
    """
    width = table.shape[1]
    digits = 4 * ((width + 3) // 4)
    table[:] = _characters(values, digits)[:, digits - width :]
    for column in range(width - 1):
        table[values < 10 ** (width - 1 - column), column] = 0


def packed(table: Bytes) -> bytes:
    """Return the bytes of a table without its NULs."""
    return table.tobytes().translate(None, b"\0")


def _characters(values: Ints, digits: int) -> Bytes:
    """Return the digits of integers in [0, 10^digits), shape (n, digits)."""
    groups = np.empty((len(values), digits // 4), dtype=np.uint32)
    rest = values
    for column in range(digits // 4 - 1, 0, -1):
        rest, low = np.divmod(rest, 10_000)
        groups[:, column] = _FOUR[low]
    groups[:, 0] = _FOUR[rest]
    return groups.view(np.uint8)
