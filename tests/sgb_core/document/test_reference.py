"""What a profile came from: kept in the file and in the journal, in every unit, not in states."""

from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image

import sgb_core as sgb
from sgb_core.document.appearance.picture_file import MAX_PICTURE_BYTES, Picture
from sgb_core.document.file.journal import Journal
from sgb_core.document.file.recovery import recoverable
from sgb_core.document.reference import MAX_POINTS, Reference
from sgb_core.findings.refusal import RefusalError
from sgb_core.sources.embedded import embedded

LINE = sgb.Profile.of([sgb.line((10, 0), (10, 60))])


def png(size: tuple[int, int] = (40, 30), noise: bool = False) -> bytes:
    image = Image.effect_noise(size, 90.0) if noise else Image.new("L", size, 200)
    stream = BytesIO()
    image.save(stream, "PNG")
    return stream.getvalue()


def with_picture(data: bytes) -> sgb.Document:
    source = Reference("photo.png", "picture", Picture(data), axis=(20.0,), origin=(20.0, 29.0))
    return sgb.Document(LINE, reference=source)


def test_it_comes_back_from_the_file_and_stays_out_of_states() -> None:
    document = sgb.edits.store_state(with_picture(png()), "A")
    assert document.states[0].reference is None
    assert sgb.loads(sgb.dumps(document)) == document
    assert sgb.edits.switch_state(document, "A").reference == document.reference
    points = Reference("scan.csv", "points", points=((10.0, 0.0), (11.0, 60.0)), tolerance=0.5)
    document = sgb.Document(LINE, reference=points)
    assert sgb.loads(sgb.dumps(document)) == document


def test_it_keeps_its_true_size_in_another_unit() -> None:
    source = Reference(points=((10.0, 5.0),), scale=0.5, tolerance=1.0, left_right=2.0)
    found = sgb.edits.set_unit(sgb.Document(LINE, reference=source), "cm", convert=True).reference
    assert found is not None
    assert found.points == ((1.0, 0.5),)
    assert (found.scale, found.tolerance, found.left_right) == (0.05, 0.1, 0.2)


def test_the_first_tracers_files_are_read() -> None:
    text = sgb.dumps(sgb.Document(LINE, reference=Reference("a.csv", "points")))
    old = text.replace(b'"name": "a.csv"', b'"points": 200, "name": "a.csv"')
    assert old != text
    found = sgb.loads(old).reference
    assert found is not None
    assert found.points == ()


def test_the_journal_writes_a_picture_once(tmp_path: Path) -> None:
    data = png((300, 300), noise=True)
    document = with_picture(data)
    journal = Journal(tmp_path, tmp_path)
    journal.write(document)
    size = journal.entry.stat().st_size
    for opacity in (0.1, 0.2, 0.3):
        document = sgb.edits.change_reference(document, opacity=opacity)
        journal.write(document)
    assert journal.entry.stat().st_size < size + len(data) / 4
    journal.close()
    (found,) = recoverable(tmp_path, tmp_path)
    assert found.document == document


def test_what_it_may_be() -> None:
    with pytest.raises(RefusalError, match=r"opacity is 2\.0; allowed is a number from 0 to 1"):
        Reference(opacity=2.0)
    with pytest.raises(RefusalError, match=f"at most {MAX_POINTS} points"):
        Reference(points=((1.0, 1.0),) * (MAX_POINTS + 1))
    with pytest.raises(sgb.edits.EditError, match="allowed"):
        sgb.edits.change_reference(with_picture(png()), scale=-1.0)


def test_a_picture_beyond_the_limits_is_kept_smaller_and_its_places_follow() -> None:
    data = png((2600, 2200), noise=True)
    assert len(data) > MAX_PICTURE_BYTES
    source = Reference(axis=(1299.5,), origin=(1299.5, 2199.5), scale=0.1)
    found = embedded(source, data)
    assert found.picture is not None
    assert len(found.picture.data) <= MAX_PICTURE_BYTES
    with Image.open(BytesIO(found.picture.data)) as image:
        factor = image.width / 2600
        assert found.origin == pytest.approx(((image.width - 1) / 2, image.height - 0.5), abs=1.0)
    assert found.axis[0] == pytest.approx(found.origin[0])
    assert found.scale == pytest.approx(0.1 / factor)
