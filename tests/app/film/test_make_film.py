import pytest
from PIL import Image

from app.film.dialog import FilmDialog
from app.film.film import FRAMES, SPEEDS
from app.state.child_command import run_aside
from app.state.jobs import Cancelled
from sgb_core.document import edits
from tests.app.viewport.helpers import document


@pytest.fixture
def dialog(qtbot):
    dialog = FilmDialog(document(), 1)
    qtbot.addWidget(dialog)
    return dialog


def test_the_dialog_speaks_the_command_s_language(dialog):
    assert dialog.arguments == ["--turntable", "--frames", "60", "--fps", "20", "--size", "480x480"]
    dialog.what.setCurrentIndex(dialog.what.findData("lambda2"))
    assert dialog.arguments[:5] == ["--vary", "1", "lambda2", "0.0", "6.0"]
    dialog.segment.setCurrentIndex(0)
    assert dialog.arguments[1] == "all"


def test_states_are_offered_where_there_are_any(dialog, qtbot, tmp_path):
    assert dialog.what.findData("state") < 0
    doc = edits.store_state(document(), "-A")
    stated = FilmDialog(edits.store_state(edits.scale(doc, 1.5), "B 2"), 0)
    qtbot.addWidget(stated)
    stated.what.setCurrentIndex(stated.what.findData("state"))
    assert stated.arguments[:1] == ["--to=-A"]
    stated.from_state.setCurrentIndex(2)
    assert stated.arguments[:2] == ["--to=-A", "--from=B 2"]
    stated.frames.enter(2)
    stated.pixels.width.enter(32)
    stated.pixels.height.enter(24)
    final = edits.store_state(edits.scale(doc, 1.5), "B 2")
    run_aside("animate", final, tmp_path / "a.gif", lambda _part: None, stated.arguments)
    assert (tmp_path / "a.gif").exists()


def test_a_film_is_drawn_aside_with_progress(dialog, tmp_path):
    # A film keeps frames once that look alike; these differ from their neighbours.
    dialog.what.setCurrentIndex(dialog.what.findData("omega"))
    dialog.frames.enter(4)
    dialog.pixels.width.enter(64)
    dialog.pixels.height.enter(36)
    parts = []
    run_aside(
        "animate", document(), tmp_path / "a.gif", parts.append, ["--progress", *dialog.arguments]
    )
    assert parts[-1] == 1.0
    assert parts == sorted(parts)
    with Image.open(tmp_path / "a.gif") as found:
        assert found.n_frames == 4
        assert found.size == (64, 36)


def test_sizes_are_common_ones_or_free(dialog):
    size = dialog.pixels
    size.common.setCurrentIndex(2)
    assert dialog.arguments[-1] == "1280x720"
    size.width.enter(1000)
    assert (size.common.currentText(), dialog.arguments[-1]) == ("Free", "1000x720")
    size.width.enter(480)
    size.height.enter(480)
    assert size.common.currentText().startswith("Square")


def test_cancelled_it_leaves_nothing(dialog, tmp_path):
    def stop(_part):
        raise Cancelled

    with pytest.raises(Cancelled):
        run_aside(
            "animate", document(), tmp_path / "a.gif", stop, ["--progress", *dialog.arguments]
        )
    assert not (tmp_path / "a.gif").exists()


def test_what_the_command_refuses_is_said(dialog, tmp_path):
    with pytest.raises(ValueError, match=r"folder|directory|no such"):
        run_aside(
            "animate",
            document(),
            tmp_path / "no" / "a.gif",
            lambda _: None,
            ["--frames", "2", "--size", "16x16"],
        )


def test_the_dialog_takes_the_speeds_that_a_film_has(dialog):
    assert (dialog.fps.kind.minimum, dialog.fps.kind.maximum) == SPEEDS
    assert (dialog.frames.kind.minimum, dialog.frames.kind.maximum) == FRAMES
    dialog.fps.set_value(0.5)
    assert dialog.arguments[3:5] == ["--fps", "0.5"]
