"""Settings, recovery entries and folders broken in many ways, each made from its number alone."""

from __future__ import annotations

import os
import random
import re
from pathlib import Path

from app.state.preferences import Preferences
from sgb_core.document import edits
from sgb_core.document.file.journal import Journal
from sgb_core.document.file.recovery import SUFFIX
from tests.app.helpers import tower

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = Path("SGB Studio")
OWN = PROGRAM / PROGRAM
# Values as they stand in a settings file, each of a type or in a range that most keys do not have.
VALUES = (
    "",
    "-5",
    "nan",
    "inf",
    "1e400",
    "99999999999999999999",
    "sepia",
    "a, b, c",
    "@Invalid()",
    "@ByteArray(junk)",
    "@ByteArray(\\x1\\xd9\\xd0\\xcb\\0\\x3\\0\\0\\0\\0)",
    "@Variant(\\0\\0\\0\\x7f\\0\\0\\0\\0)",
    "@Variant(junk",
    "@Rect(0 0 -1 99999999)",
    "@Size(1 2)",
    "@DateTime(\\0\\0\\0)",
    "true, @Invalid(), 3",
    '"\\xd800"',
    "%00%ff",
    "Ctrl+Nonsense",
    "Ctrl+S",
    "é€😀",
    "x" * 100_000,
    "/proc/self/mem, /dev/zero, /, .., \\0",
    ", ".join(["/nowhere/a.sgb"] * 5000),
)
WHOLE = (
    b"",
    b"\0" * 5000,
    b"\xff\xfe[\0G\0e\0n\0",
    b"[General\ntheme=dark\n",
    b"no section\ntheme=sepia\n[[[]]]\n=\n==\n",
    b"[General]\ntheme=dark\n[General]\ntheme=sepia\n[%General]\na/b/c/d=1\n",
    b"[General]\r" + b"a=1\r" * 9000,
    b"[General]\n" + b"".join(b"k%d=1\n" % n for n in range(50_000)),
)
FOLDERS = (
    OWN / "recovery",
    OWN / "thumbnails",
    OWN / "backups",
    OWN / "printers",
    OWN / "log",
    OWN / "locks",
)


def keys() -> list[str]:
    """Return the keys under which the program's text keeps something."""
    found = set(Preferences.__slots__)
    call = re.compile(r"(?:stored\w*|[sS]ettings(?:\(\))?\.(?:setValue|value))\(\s*f?\"([^\"]+)\"")
    name = re.compile(r"^\s*(?:KEY|WELCOMED) = \"([^\"]+)\"", re.MULTILINE)
    for path in (ROOT / "app").rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if "QSettings" in text or "stored" in text:
            found |= {re.sub(r"\{[^}]*\}", "length", key) for key in call.findall(text)}
            found |= set(name.findall(text))
    return sorted(found | {"geometry", "state", "keys/undo", "keys/save", "recent_files"})


def break_settings(config: Path, drawn: random.Random) -> str:
    """Put broken settings into a folder of settings; return what was done."""
    place = config / PROGRAM / f"{PROGRAM}.conf"
    place.parent.mkdir(parents=True, exist_ok=True)
    way = drawn.randrange(10)
    if way == 0:
        place.mkdir()
        return "a folder in its place"
    if way == 1:
        place.symlink_to(drawn.choice(["/nowhere/else", place.name]))
        return "a link to nothing"
    if way == 2:
        place.write_bytes(drawn.choice(WHOLE))
        return "no settings"
    if way == 3:
        place.write_bytes(drawn.randbytes(drawn.choice((10, 1000, 100_000))))
        return "random bytes"
    lines: dict[str, list[str]] = {}
    for key in drawn.sample(keys(), drawn.choice((1, 5, 20))):
        group, _, name = key.rpartition("/")
        lines.setdefault(group or "General", []).append(f"{name}={drawn.choice(VALUES)}")
    text = "".join(f"[{group}]\n{chr(10).join(each)}\n" for group, each in lines.items())
    place.write_text(text, encoding="utf-8")
    return ", ".join(f"{group}: {each[0][:40]}" for group, each in lines.items())


def good_entry(folder: Path) -> bytes:
    """Return the bytes of an entry of two steps."""
    journal = Journal(folder / "made", folder / "made-locks")
    document = tower()
    journal.prepare(document)
    for name in ("one", "two"):
        document = edits.set_shape_parameter(edits.rename(document, name), 0, "lambda2", len(name))
        journal.write(document)
    journal.close()
    return journal.entry.read_bytes()


def break_entries(data: Path, drawn: random.Random, good: bytes) -> str:
    """Put a few broken entries of unsaved work into a folder of data; return their ways."""
    folder = data / OWN / "recovery"
    folder.mkdir(parents=True, exist_ok=True)
    ways = []
    for number in range(drawn.choice((1, 3, 8))):
        place = folder / f"{drawn.randbytes(8).hex()}{SUFFIX}"
        way = drawn.choice(
            ("torn", "flipped", "random", "empty", "folder", "pipe", "loop", "zeros", "sparse",
             "json", "twice", "name", "swapped")
        )  # fmt: skip
        ways.append(f"{number} {way}")
        at = drawn.randrange(len(good))
        if way == "torn":
            place.write_bytes(good[:at])
        elif way == "flipped":
            place.write_bytes(
                good[:at] + bytes([good[at] ^ 1 << drawn.randrange(8)]) + good[at + 1 :]
            )
        elif way == "random":
            place.write_bytes(drawn.randbytes(5000))
        elif way == "empty":
            place.touch()
        elif way == "folder":
            place.mkdir()
        elif way == "pipe":
            os.mkfifo(place)
        elif way == "loop":
            place.symlink_to(place.name)
        elif way == "zeros":
            place.symlink_to("/dev/zero")
        elif way == "sparse":
            with open(place, "wb") as stream:
                stream.truncate(300 << 20)
        elif way == "json":
            texts = (b"{}", b"[" * 100_000, b'{"document": 3}', b'{"target": [], "document": {}}')
            place.write_bytes(drawn.choice(texts))
        elif way == "twice":
            place.write_bytes(good + good)
        elif way == "name":
            os.close(os.open(os.fsencode(folder) + b"/\xff\xfe.recovery", os.O_CREAT))
        else:
            half = len(good) // 2
            place.write_bytes(good[half:] + good[:half])
    return ", ".join(ways)


def break_folder(home: Path, drawn: random.Random) -> str:
    """Put something else in the place of one of the program's folders; return what."""
    place = home / drawn.choice(("data", "state")) / drawn.choice(FOLDERS)
    if os.path.lexists(place):
        return "as it was"
    place.parent.mkdir(parents=True, exist_ok=True)
    way = drawn.choice(("file", "loop", "nowhere", "pipe"))
    if way == "file":
        place.write_bytes(b"in the way")
    elif way == "loop":
        place.symlink_to(place.name)
    elif way == "nowhere":
        place.symlink_to("/nowhere/else")
    else:
        os.mkfifo(place)
    return f"{place.name}: {way}"


def broken_home(home: Path, number: int) -> str:
    """Break a user's folders in the way of a number; return how, in words."""
    drawn = random.Random(number)
    done = [break_settings(home / "config", drawn)]
    good = good_entry(home.parent / f"{home.name}-good")
    done.append(break_entries(home / "data", drawn, good))
    if drawn.random() < 0.5:
        done.append(break_folder(home, drawn))
    return "; ".join(done)
