import subprocess
import sys
from math import pi

import numpy as np
import pytest
from PIL import Image

from app.film.film import Film, Passage, Variation, check_target, write_film
from app.film.frames import film_images
from app.state.view_state import ViewState
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, LayerKind
from sgb_core.document.file import project_file
from tests.app.viewport.helpers import document

VIEW = ViewState(segment=-1, show=frozenset({"surface"}))


def flat_images(count, size=(8, 6)):
    for number in range(count):
        image = np.full((size[1], size[0], 4), 255, np.uint8)
        image[..., 0] = 40 * number
        yield image


def test_a_turntable_goes_once_around():
    doc = document()
    steps = list(Film(frames=8).steps(doc))
    assert all(each is doc for each, _ in steps)
    assert np.diff([turn for _, turn in steps]) == pytest.approx(np.full(7, -pi / 4))


def test_a_parameter_goes_there_and_back():
    film = Film(frames=8, variation=Variation(1, "omega", 0.1, 0.9))
    values = [each.profile.segments[1].shape.omega for each, _ in film.steps(document())]
    assert values[0] == pytest.approx(0.1)
    assert values[4] == pytest.approx(0.9)
    assert values[1:4] == pytest.approx(values[:4:-1])
    wrong = Film(frames=4, variation=Variation(1, "omega", 0.0, 3.0))
    with pytest.raises(edits.EditError):
        list(wrong.steps(document()))


def test_a_passage_goes_from_one_state_to_another_and_back():
    doc = edits.store_state(document(), "A")
    bent = edits.set_shape_parameter(doc, 0, "omega", 0.9)
    doc = edits.switch_state(edits.store_state(bent, "B"), "A")
    start = doc.profile.segments[0].shape.omega
    for first in (None, "A"):
        steps = list(Film(frames=8, variation=Passage(first, "B")).steps(doc))
        values = [each.profile.segments[0].shape.omega for each, _ in steps]
        assert values[0] == pytest.approx(start)
        assert values[4] == pytest.approx(0.9)
        assert values[1:4] == pytest.approx(values[:4:-1])
    with pytest.raises(edits.EditError, match="no state 'C'"):
        list(Film(frames=4, variation=Passage("A", "C")).steps(doc))
    other = edits.store_state(edits.append_segment(doc), "longer")
    with pytest.raises(edits.EditError, match="segments"):
        list(Film(frames=4, variation=Passage("A", "longer")).steps(other))


@pytest.mark.parametrize("options", [{"frames": 1}, {"frames": 9999}, {"fps": 0.0}, {"fps": 500.0}])
def test_what_is_out_of_range_is_refused(options):
    with pytest.raises(ValueError, match="allowed"):
        Film(**options)


def test_gif_holds_every_frame_and_reports(tmp_path):
    parts = []
    write_film(tmp_path / "a.gif", flat_images(5), Film(frames=5, fps=10.0), parts.append)
    assert parts == [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]
    with Image.open(tmp_path / "a.gif") as found:
        assert found.n_frames == 5
        assert found.info["duration"] == 100
        found.seek(3)
        assert abs(int(np.asarray(found.convert("RGB"))[0, 0, 0]) - 120) <= 2


def test_pictures_are_numbered(tmp_path):
    write_film(tmp_path / "a.png", flat_images(3), Film(frames=3), lambda _: None)
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["a_0001.png", "a_0002.png", "a_0003.png"]


def test_mp4_can_be_read_again(tmp_path):
    ffmpeg = pytest.importorskip("imageio_ffmpeg")
    write_film(tmp_path / "a.mp4", flat_images(6, (64, 48)), Film(frames=6), lambda _: None)
    count, seconds = ffmpeg.count_frames_and_secs(str(tmp_path / "a.mp4"))
    assert count == 6
    assert seconds == pytest.approx(0.3, abs=0.06)
    assert [path.name for path in tmp_path.iterdir()] == ["a.mp4"]


@pytest.mark.parametrize("suffix", [".gif", ".png"])
def test_cancelled_nothing_is_left(tmp_path, suffix):
    def stop(part):
        if part > 0.5:
            raise InterruptedError

    with pytest.raises(InterruptedError):
        write_film(tmp_path / f"a{suffix}", flat_images(4), Film(frames=4), stop)
    assert list(tmp_path.iterdir()) == []


def test_other_suffixes_are_refused(tmp_path):
    with pytest.raises(ValueError, match="gif"):
        check_target(tmp_path / "a.avi")


def test_a_stripe_goes_around_and_the_form_stays():
    stripe = Layer(LayerKind.STRIPES, "#0020c0", 0.0, 1.0, count=1, width=0.2)
    doc = edits.set_appearance(
        document(), material="terracotta", background="white", drawing=(stripe,)
    )
    frames = list(film_images(doc, Film(frames=4), (120, 140), VIEW))
    ground = frames[0][2, 2]
    shapes = [np.abs(each.astype(int) - ground).max(axis=-1) > 20 for each in frames]
    for shape in shapes[1:]:
        assert (shape != shapes[0]).mean() < 0.02
    blue = [(each[..., 2] > 1.6 * each[..., 0]).sum() for each in frames]
    assert max(blue) > 200
    assert min(blue) < 0.2 * max(blue)


def test_from_the_command_line(tmp_path):
    project_file.save(document(), tmp_path / "a.sgb")
    command = [sys.executable, "-m", "app", "animate", "a.sgb", "a.gif"]
    options = ["--vary", "1", "omega", "0.1", "0.9", "--frames", "4", "--size", "80x80"]

    def run(*arguments):
        return subprocess.run(
            [*command, *arguments],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            env={"PYTHONPATH": str(_root()), "PATH": "/usr/bin:/bin"},
        )

    done = run(*options, "--progress")
    assert done.returncode == 0, done.stderr
    assert done.stdout.split()[-1] == "100"
    with Image.open(tmp_path / "a.gif") as found:
        assert found.n_frames == 4
    assert run("--vary", "9", "omega", "0", "1").returncode == 1
    assert run("--vary", "1", "mu", "0", "1").returncode == 2
    assert run("--vary", "1", "omega", "0", "1", "--turntable").returncode == 2


def _root():
    from pathlib import Path

    return Path(__file__).resolve().parents[3]
