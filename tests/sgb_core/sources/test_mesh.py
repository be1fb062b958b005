"""Meshes: the axis is found, and the outer wall that most of the turn agrees on."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np
import pytest
import trimesh

import resources
from sgb_core.arrays import Floats, Ints
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.file.project_file import loads
from sgb_core.document.model import Document, Unit
from sgb_core.exchange import write
from sgb_core.findings.sources import NoSource, OutOfRound, TooMuch, Unreadable, Wall
from sgb_core.sources import Options, SourceError, Taken, take
from tests.sgb_core.sources.files import apart, taken

PROFILE = Profile.of(
    [
        Segment([[0, 0], [20, 0], [30, 0], [32, 2]]),
        Segment([[32, 2], [60, 30], [60, 60], [25, 90]]),
        Segment([[25, 90], [18, 96], [20, 110], [30, 120]]),
    ]
)
SIZE = PROFILE.size
TOLERANCE = 1e-3 * SIZE


def vase(around: int = 96, along: int = 120) -> tuple[Floats, Ints]:
    """Return vertices and triangles of the profile turned about z."""
    line = np.concatenate(
        [
            s.point(np.linspace(0.0, 1.0, along // 3 + 1))[k > 0 :]
            for k, s in enumerate(PROFILE.segments)
        ]
    )
    turn = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
    r, h = line.T
    rows = [np.outer(r, np.cos(turn)), np.outer(r, np.sin(turn)), np.outer(h, np.ones(around))]
    vertices = np.stack(rows, axis=-1).reshape(-1, 3)
    a = np.arange(len(line) - 1)[:, None] * around + np.arange(around)
    b = np.arange(len(line) - 1)[:, None] * around + (np.arange(around) + 1) % around
    lower, upper = np.stack([a, b, b + around], -1), np.stack([a, b + around, a + around], -1)
    return vertices, np.concatenate([lower.reshape(-1, 3), upper.reshape(-1, 3)])


def read(folder: Path, vertices: Floats, faces: Ints, options: Options | None = None) -> Taken:
    """Return what is taken from a mesh written as STL."""
    path = folder / "mesh.stl"
    trimesh.Trimesh(vertices, faces, process=False).export(path)
    return take(path, options or Options(tolerance=TOLERANCE))


def places(lift: float = 0.0) -> Floats:
    """Return places along the profile, lifted."""
    s = np.linspace(0.0, 1.0, 50)
    return np.concatenate([segment.point(s) for segment in PROFILE.segments]) + np.array(
        [0.0, lift]
    )


@pytest.mark.parametrize(
    ("suffix", "unit"),
    [(".stl", Unit.MM), (".obj", Unit.MM), (".ply", Unit.MM), (".glb", Unit.CM), (".3mf", Unit.IN)],
)
def test_our_own_meshes_come_back_in_their_unit(tmp_path: Path, suffix: str, unit: Unit) -> None:
    path = tmp_path / f"vase{suffix}"
    write(Document(PROFILE, "vase", unit), path)
    found = take(path, Options(unit=unit, axis="y" if suffix == ".glb" else "z"))
    assert apart(found.trace.profile, places()) < 3e-3
    assert len(found.trace.profile) <= len(PROFILE) + 1


def test_a_letter_keeps_the_file_s_heights_and_auto_stands_on_zero(tmp_path: Path) -> None:
    vertices, faces = vase()
    vertices = np.add(vertices, (0.0, 0.0, 7.0))
    kept = read(tmp_path, vertices, faces, Options(axis="z"))
    assert apart(kept.trace.profile, places(7.0)) < 3e-3
    stood = read(tmp_path, vertices, faces)
    assert apart(stood.trace.profile, places()) < 3e-3


def _plain(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    return vertices, faces


def _noisy(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    return vertices + 0.002 * SIZE * np.random.default_rng(1).normal(size=vertices.shape), faces


def _holed(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    return vertices, faces[np.random.default_rng(2).random(len(faces)) > 0.3]


def _halved(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    return vertices, faces[vertices[faces].mean(axis=1)[:, 0] > -5.0]


def _handled(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    handle = trimesh.creation.torus(18.0, 4.0)
    handle.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [1, 0, 0]))
    handle.apply_translation([55.0, 0.0, 60.0])
    joined = np.concatenate([vertices, np.asarray(handle.vertices)])
    return joined, np.concatenate([faces, np.asarray(handle.faces) + len(vertices)])


@pytest.mark.parametrize(
    ("harm", "noise"),
    [(_plain, 0.0), (_noisy, 0.004), (_holed, 0.0), (_halved, 0.0), (_handled, 0.0)],
)
def test_the_axis_is_found_whatever_was_done_to_the_object(
    tmp_path: Path, harm: Callable[[Floats, Ints], tuple[Floats, Ints]], noise: float
) -> None:
    vertices, faces = harm(*vase())
    turn = trimesh.transformations.euler_matrix(0.4, -0.3, 1.0)[:3, :3]
    shift = np.array([30.0, -200.0, 55.0])
    found = read(tmp_path, vertices @ turn.T + shift, faces)
    point, direction = np.array(found.axis[:3]), np.array(found.axis[3:])
    axis = turn @ [0.0, 0.0, 1.0]
    assert np.degrees(np.arccos(min(abs(direction @ axis), 1.0))) < 0.1
    middle = shift + turn @ [0.0, 0.0, 60.0]
    off = point - middle
    assert np.linalg.norm(off - (off @ axis) * axis) < 2e-3 * SIZE
    points = places()
    if direction @ axis < 0.0:
        points = points * [1.0, -1.0] + [0.0, 120.0]
    assert apart(found.trace.profile, points) < 4e-3 + noise


def test_the_outer_wall_is_taken_and_the_inner_one_said(tmp_path: Path) -> None:
    outer = [[0, 0], [40, 0], [40, 60], [37, 60], [37, 3], [0, 3]]
    profile = Profile.of([Segment(np.linspace(a, b, 4)) for a, b in pairwise(outer)])
    path = tmp_path / "cup.stl"
    write(Document(profile, "cup"), path)
    found = take(path, Options(axis="z"))
    ends = [found.trace.profile.segments[0].points[0]]
    ends += [segment.points[3] for segment in found.trace.profile.segments]
    np.testing.assert_allclose(ends, [[0, 0], [40, 0], [40, 60]], atol=0.2)
    (wall,) = found.notes
    assert isinstance(wall, Wall)
    assert wall.median == pytest.approx(3.0, abs=0.1)


CURL = [[20, 12], [26, 0], [40, 0], [50, 30], [44, 90], [30, 96], [34, 88]]


def _sheets() -> list[Profile]:
    ends = pairwise(np.array(CURL, dtype=np.float64))
    curled = Profile.of([Segment(np.linspace(a, b, 4)) for a, b in ends])
    return [curled, loads(resources.load_preset("earthen-house")).profile]


@pytest.mark.parametrize("profile", _sheets(), ids=["curled ends", "eaves and a court"])
def test_a_sheet_comes_back_whole_whatever_it_hides(tmp_path: Path, profile: Profile) -> None:
    path = tmp_path / "sheet.stl"
    write(Document(profile, "sheet"), path)
    found = take(path, Options(axis="z")).trace
    assert len(found.profile) <= len(profile) + 1
    assert apart(found.profile, profile.sample(50).reshape(-1, 2)) < 2e-3
    assert apart(profile, found.profile.sample(50).reshape(-1, 2)) < 2e-3


TEAPOT = Path(__file__).parents[4] / "shared" / "data" / "meshes" / "teapot.obj"
# Newell's body, about the axis: cubic Bézier curves from the rim's inside to the foot's middle.
BODY = [
    [(1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4)],
    [(1.5, 2.4), (1.75, 1.875), (2.0, 1.35), (2.0, 0.9)],
    [(2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15)],
    [(1.5, 0.15), (1.5, 0.075), (1.425, 0.0), (0.0, 0.0)],
]


@pytest.mark.skipif(not TEAPOT.exists(), reason="the data are not here")
def test_the_teapot_is_its_published_profile_spout_and_handle_notwithstanding() -> None:
    found = take(TEAPOT, Options()).trace.profile
    body = Profile.of([Segment(np.array(points)) for points in BODY])
    # Within half a percent of the body's height, where the lid does not hide it.
    seen = body.sample(80).reshape(-1, 2)[20:]
    assert apart(found, seen) * found.size < 0.005 * 2.53
    assert len(found) <= 12


def test_parts_that_do_not_touch_make_one_outline(tmp_path: Path) -> None:
    line = np.array([[0, 0], [30, 0], [50, 40], [34, 80], [33, 81], [12, 90], [0, 91]])
    pieces = [line[:4], line[4:]]
    meshes = []
    for piece in pieces:
        part = tmp_path / "part.stl"
        ends = pairwise(piece.astype(np.float64))
        profile = Profile.of([Segment(np.linspace(a, b, 4)) for a, b in ends])
        write(Document(profile, "part"), part)
        meshes.append(trimesh.load_mesh(part))
    path = tmp_path / "both.stl"
    trimesh.util.concatenate(meshes).export(path)
    found = take(path, Options(axis="z", tolerance=0.5)).trace
    assert apart(found.profile, line) * found.profile.size < 1.0
    assert len(found.profile) <= len(line) + 1


@pytest.mark.parametrize("axis", [(0, 0, 0, 0, 0, 0), 4.0])
def test_what_is_no_axis_of_a_mesh_is_refused(tmp_path: Path, axis: object) -> None:
    with pytest.raises(SourceError, match="axis is"):
        read(tmp_path, *vase(12, 12), Options(axis=axis))  # type: ignore[arg-type]


EMPTY = b"solid nothing\nendsolid nothing\n"
PLANE = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("mesh.stl", EMPTY),
        ("mesh.obj", b"# nothing\n"),
        ("mesh.obj", PLANE),
        ("mesh.obj", b"v 0 0 0\nv 1 0 nan\nv 1 1 0\nf 1 2 3\n"),
        ("mesh.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 9\n"),
        ("mesh.ply", b"ply\nformat ascii 1.0\n"),
        ("mesh.stl", b"\x89PNG\r\n\x1a\n" * 20),
        ("mesh.glb", b"glTF\x02\0\0\0\xff\xff\xff\xff"),
        ("mesh.3mf", b"PK\x03\x04 and no more"),
        ("mesh.3mf", b"It was the best of times"),
    ],
)
def test_what_is_no_solid_of_revolution_is_refused(tmp_path: Path, name: str, data: bytes) -> None:
    with pytest.raises(SourceError) as error:
        taken(tmp_path, name, data)
    assert isinstance(error.value.finding, NoSource | Unreadable | TooMuch)
    assert "\n" not in str(error.value)


CUBE = (
    "".join(f"v {n // 4} {n // 2 % 2} {n % 2}\n" for n in range(8))
    + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
)


def test_what_is_not_round_at_all_gets_an_answer(tmp_path: Path) -> None:
    found = taken(tmp_path, "cube.obj", CUBE)
    assert np.isfinite(found.points).all()
    assert len(found.trace.profile) >= 1
    assert any(isinstance(note, OutOfRound) for note in found.notes)


def test_walls_that_no_radius_is_common_to_are_told_out_of_round(tmp_path: Path) -> None:
    """Each wall of six is near the median radius at two places only."""
    mesh = trimesh.creation.cylinder(30.0, 80.0, sections=6)
    found = read(tmp_path, np.asarray(mesh.vertices), np.asarray(mesh.faces))
    (note,) = found.notes
    assert isinstance(note, OutOfRound)
    across = 30.0 * (1.0 - np.cos(np.pi / 6.0))
    assert 0.2 * across < note.rms < 0.5 * across
    assert 0.5 * across < note.largest < 1.05 * across


def test_the_largest_part_may_be_apart_from_the_axis(tmp_path: Path) -> None:
    rod, tyre = trimesh.creation.cylinder(2.0, 8.0), trimesh.creation.torus(60.0, 20.0)
    mesh = trimesh.util.concatenate([rod, tyre])
    found = read(tmp_path, np.asarray(mesh.vertices), np.asarray(mesh.faces))
    assert float(found.points[:, 0].max()) == pytest.approx(80.0, abs=0.5)


def _threemf(path: Path, *models: str) -> Path:
    with ZipFile(path, "w", ZIP_DEFLATED) as archive:
        for number, model in enumerate(models):
            archive.writestr(f"3D/part{number}.model", model)
    return path


def _model(first: int, last: int, height: float) -> str:
    """Return the model of a cone of so many sides, of which some are there."""
    turn = np.linspace(0.0, 2.0 * np.pi, 61)
    around = "".join(f'<vertex x="{np.cos(t)}" y="{np.sin(t)}" z="{height}"/>' for t in turn)
    sides = "".join(f'<triangle v1="0" v2="{k + 1}" v3="{k + 2}"/>' for k in range(first, last))
    return (
        '<model unit="centimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core">'
        f'<resources><object><mesh><vertices><vertex x="0" y="0" z="0"/>{around}</vertices>'
        f"<triangles>{sides}</triangles></mesh></object></resources></model>"
    )


def test_the_meshes_of_a_3mf_count_their_corners_each_for_itself(tmp_path: Path) -> None:
    path = _threemf(
        tmp_path / "cone.3mf", _model(0, 30, 2.0), " " * 9_000_000 + _model(30, 60, 2.0)
    )
    found = take(path, Options(axis="z"))
    np.testing.assert_allclose(found.trace.profile.bounds()[1], [10.0, 20.0], rtol=3e-3)


@pytest.mark.parametrize(
    ("model", "finding"),
    [
        ('<!DOCTYPE m [<!ENTITY a "b">]><model>&a;</model>', NoSource.ENTITIES),
        ("<model/>", NoSource.NO_TRIANGLES),
        (_model(0, 90, 2.0), NoSource.NO_CORNER),
    ],
)
def test_a_3mf_that_is_none_is_refused(tmp_path: Path, model: str, finding: NoSource) -> None:
    with pytest.raises(SourceError) as error:
        take(_threemf(tmp_path / "mesh.3mf", model), Options(axis="z"))
    assert error.value.finding is finding


def test_vertices_alone_are_no_mesh(tmp_path: Path) -> None:
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "mesh.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n")
    assert error.value.finding is NoSource.NO_TRIANGLES


def test_a_material_file_that_a_mesh_names_is_not_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    vertices, faces = vase(24, 30)
    lines = ["mtllib secret.mtl"]
    lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces.tolist()]
    (tmp_path / "secret.mtl").write_text("newmtl a\n")
    opened: list[str] = []
    real = open

    def watched(file: object, *rest: object, **more: object) -> object:
        opened.append(str(file))
        return real(file, *rest, **more)  # type: ignore[call-overload]

    monkeypatch.setattr("builtins.open", watched)
    taken(tmp_path, "vase.obj", "\n".join(lines), Options(axis="z"))
    assert not [name for name in opened if "secret" in name]
