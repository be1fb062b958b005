"""The path against closed forms and against distances measured from outside."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import resources
import resources.library
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from sgb_core.document.manufacture import Manufacture, Shrinkage, Stage
from sgb_core.document.model import Document
from sgb_core.findings.toolpaths import Lean
from sgb_core.surfaces.laws.law import Law
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.settings import Wanted
from sgb_core.toolpaths.strand import Part
from tests.sgb_core.toolpaths.printing import BIG, CLAY, CYLINDER, PLASTIC, chain, roomy, wall_of


def preset(name: str) -> Document:
    return project_file.load(resources.path(f"presets/{name}.sgb"))


def test_a_cylinder_is_one_helix_with_a_level_last_turn() -> None:
    path = toolpath(CYLINDER, BIG, Wanted(layer=0.2, bead=0.5))
    z = path.points[:, 2]
    assert z[0] == 0.0
    assert z[-1] == pytest.approx(21.3, abs=1e-12)
    assert np.all(np.diff(z) >= 0.0)
    # One layer a turn, exactly.
    angle = np.unwrap(np.arctan2(path.points[:, 1], path.points[:, 0]))
    climbing = z < 21.3
    assert z[climbing] == pytest.approx(0.2 * angle[climbing] / (2.0 * pi), abs=1e-9)
    assert angle[-1] - angle[np.flatnonzero(z >= 21.3 - 1e-12)[0]] == pytest.approx(2.0 * pi)
    assert np.hypot(*path.points[:, :2].T) == pytest.approx(np.full(len(z), 29.75), abs=1e-9)
    assert (path.parts[1:] == Part.WALL).all()


def test_the_flow_of_a_cylinder_is_its_wall_and_of_its_first_turn_half_a_turn() -> None:
    path = toolpath(CYLINDER, BIG, Wanted(layer=0.3, bead=0.5, chord=1e-3))
    turn = 2.0 * pi * 29.75
    # The chords are shorter than the arcs by (Δ/2)²/6 of their length, a chord of 1e-3.
    assert path.extruded_volume == pytest.approx(turn * 21.3 * 0.5, rel=3e-5)
    assert path.material_volume == pytest.approx(turn * 21.3 * 0.5, rel=1e-9)
    first = path.volumes[path.turns == 0].sum()
    assert first == pytest.approx(turn * 0.5 * 0.3 / 2.0, rel=2e-2)
    last = path.volumes[path.points[:, 2] >= 21.3 - 1e-12].sum()
    assert last == pytest.approx(turn * 0.5 * 0.3 / 2.0, rel=2e-2)


def test_chords_cut_no_deeper_than_asked() -> None:
    for chord in (0.5, 0.02, 1e-3):
        path = toolpath(CYLINDER, BIG, Wanted(chord=chord, layer=2.0))
        angle = np.diff(np.unwrap(np.arctan2(path.points[:, 1], path.points[:, 0])))
        assert 29.9 * (1.0 - cos(angle.max() / 2.0)) <= chord * 1.0001


def farthest(document: Document, path, inside: float) -> float:
    """Return how far the wall is from lying ``inside`` the drawn profile, found by shapely."""
    points = wall_of(path)
    points = points[:: max(1, len(points) // 997)]
    s = np.linspace(0.0, 1.0, 2001)
    drawn = np.concatenate([segment.point(s) for segment in document.profile])
    drawn *= document.unit.millimetres
    drawn[:, 1] -= drawn[:, 1].min()
    curve = shapely.LineString(drawn)
    places = np.column_stack([np.hypot(*points[:, :2].T), points[:, 2]])
    low, high = abs(inside), drawn[:, 1].max() - abs(inside)
    between = (places[:, 1] > low) & (places[:, 1] < high)
    away = shapely.distance(shapely.points(places[between]), curve)
    return float(np.abs(away - abs(inside)).max())


@pytest.mark.parametrize("name", ["vase", "bottle", "tower", "ceramic-pot"])
@pytest.mark.parametrize("bead", [0.0, 1.0, 4.0])
def test_each_point_lies_half_a_bead_inside_the_exact_profile(name, bead) -> None:
    document = preset(name)
    wanted = Wanted(layer=1.0, bead=bead, anyway=True)
    path = toolpath(document, BIG, wanted)
    assert farthest(document, path, bead / 2.0) < 1e-3
    if bead:
        assert path.extruded_volume == pytest.approx(path.material_volume, rel=1e-2)


def test_outside_means_outside() -> None:
    document = replace(preset("vase"), solid=Solid(side=WallSide.OUTSIDE))
    path = toolpath(document, BIG, Wanted(layer=1.0, bead=2.0, anyway=True))
    assert farthest(document, path, -1.0) < 1e-3
    inner = toolpath(preset("vase"), BIG, Wanted(layer=1.0, bead=2.0, anyway=True))
    assert np.hypot(*path.points[:, :2].T).max() > np.hypot(*inner.points[:, :2].T).max() + 1.9


@settings(max_examples=30)
@given(
    st.lists(st.floats(8.0, 60.0), min_size=4, max_size=4),
    st.lists(st.floats(0.05, 1.0), min_size=3, max_size=3),
    st.tuples(st.floats(0, 4), st.floats(0, 6), st.floats(0, 4), st.floats(0, 1)),
    st.just(0.0) | st.floats(0.2, 3.0),
    st.booleans(),
)
def test_random_climbing_profiles_are_printed_on_their_surface(r, rises, shape, bead, down) -> None:
    heights = 40.0 * np.cumsum([0.0, *rises])
    segment = Segment(np.column_stack([r, heights]), ShapeParameters(*shape))
    document = Document(Profile.of([segment.reversed() if down else segment]))
    wanted = Wanted(layer=2.0, bead=bead, chord=0.2, anyway=True)
    try:
        path = toolpath(document, BIG, wanted)
    except ToolpathError:
        # What does not climb all the way is refused.
        climb = segment.point(np.linspace(0.0, 1.0, 400))[:, 1]
        assert np.diff(climb).min() < 1e-3
        return
    assert np.isfinite(path.points).all()
    assert np.all(np.diff(wall_of(path)[:, 2]) >= 0.0)
    assert farthest(document, path, bead / 2.0) < 1e-3


def test_with_a_law_each_point_lies_on_the_exact_surface() -> None:
    document = preset("melon-jar")
    path = toolpath(document, BIG, Wanted(layer=8.0, bead=0.0, anyway=True))
    points = wall_of(path)
    scale = document.unit.millimetres
    lowest = min(segment.quartic[:, 1].min() for segment in document.profile) * scale
    for x, y, z in points[:: len(points) // 60]:
        profile = document.surface.profile_at(np.arctan2(y, x) + document.surface.start)
        drawn = np.concatenate([s.point(np.linspace(0, 1, 4001)) for s in profile]) * scale
        curve = shapely.LineString(drawn - [0.0, lowest])
        assert curve.distance(shapely.Point(np.hypot(x, y), z)) < 1e-3


def test_with_a_law_the_flow_is_the_wall() -> None:
    segment = Segment([(30, 0), (50, 20), (50, 40), (32, 60)], ShapeParameters(1, 3, 1, 1))
    document = replace(
        Document(Profile.of([segment])),
        variation=(Law("lambda2", "cosine", start=0.0, end=6.0, count=6),),
    )
    for bead in (0.6, 3.0):
        path = toolpath(document, BIG, Wanted(layer=1.2, bead=bead, anyway=True))
        assert path.extruded_volume == pytest.approx(path.material_volume, rel=3e-3)


def test_the_floor_fills_the_foot_and_leads_into_the_wall_without_a_jump() -> None:
    for layers in (1, 2, 3, 4):
        path = toolpath(CYLINDER, BIG, Wanted(layer=0.4, bead=0.8, floor_layers=layers))
        floor = path.parts == Part.FLOOR
        assert path.volumes[floor].sum() == pytest.approx(pi * 30.0**2 * 0.4 * layers, rel=1e-2)
        assert (path.parts[1:] != Part.TRAVEL).all()
        wall = wall_of(path)
        assert wall[0, 2] == pytest.approx(0.4 * layers, abs=1e-2)
        assert path.lengths[1:].max() < 2.3
        assert np.all(np.diff(path.points[:, 2]) >= -1e-12)
        assert path.extruded_volume == pytest.approx(path.material_volume, rel=1e-2)


def test_a_drain_hole_stays_open() -> None:
    solid = Solid(BodyKind.VESSEL, wall=2.0, base=2.0, drain_hole=10.0)
    document = replace(CYLINDER, solid=solid)
    path = toolpath(document, BIG, Wanted(layer=0.5))
    floor = path.parts == Part.FLOOR
    assert np.hypot(*path.points[floor, :2].T).min() == pytest.approx(6.0, abs=1e-9)
    wanted = pi * (30.0**2 - 5.0**2) * 2.0
    assert path.volumes[floor].sum() == pytest.approx(wanted, rel=2e-2)
    assert (path.parts[1:] != Part.TRAVEL).all()


def test_several_beads_fill_the_wall_of_a_vessel() -> None:
    solid = Solid(BodyKind.VESSEL, wall=3.0, base=0.0)
    document = replace(chain((40.0, 0.0), (55.0, 60.0)), solid=solid)
    path = toolpath(document, BIG, Wanted(layer=0.5, walls=4))
    assert path.plan.bead == 0.75
    assert path.extruded_volume == pytest.approx(path.material_volume, rel=1e-2)
    assert np.all(np.diff(path.points[:, 2]) >= 0.0)
    assert path.lengths[1:].max() < 4.0


def test_turns_stay_equally_apart_where_the_pitch_follows_the_lean() -> None:
    cone = chain((20.0, 0.0), (60.0, 40.0))
    wanted = Wanted(layer=0.4, bead=2.0, adaptive=True)
    path = toolpath(cone, BIG, wanted)
    wall = wall_of(path)
    turned = np.unwrap(np.arctan2(wall[:, 1], wall[:, 0])) / (2.0 * pi)
    climbing = wall[:, 2] < 39.99
    pitch = np.polyfit(turned[climbing], wall[climbing, 2], 1)[0]
    assert pitch == pytest.approx(0.4 / np.sqrt(2.0), rel=1e-3)
    stubborn = replace(BIG, layer=replace(BIG.layer, usual=0.4, least=0.35))
    path = toolpath(cone, stubborn, wanted)
    turned = np.unwrap(np.arctan2(wall_of(path)[:, 1], wall_of(path)[:, 0])) / (2.0 * pi)
    climbing = wall_of(path)[:, 2] < 39.99
    assert np.polyfit(turned[climbing], wall_of(path)[climbing, 2], 1)[0] == pytest.approx(0.35)


def test_leaning_turns_are_named_where_they_lean() -> None:
    leaning = chain((30.0, 0.0), (30.0, 20.0), (50.0, 30.0), (50.0, 50.0))
    path = toolpath(leaning, roomy(CLAY), Wanted(layer=1.0, bead=3.0))
    (lean,) = [finding for finding in path.findings if isinstance(finding, Lean)]
    assert lean.beads == pytest.approx(2.0 / 3.0, rel=1e-2)
    assert 19.0 < lean.low < 21.5
    assert 29.0 < lean.high < 32.1
    assert path.largest_step == pytest.approx(2.0, rel=1e-2)
    with pytest.raises(ToolpathError, match="nothing to rest on"):
        toolpath(leaning, roomy(CLAY), Wanted(layer=1.0, bead=1.5))
    assert toolpath(leaning, roomy(CLAY), Wanted(layer=1.0, bead=1.5, anyway=True)).findings


def test_the_other_way_round_is_the_mirror_image() -> None:
    one = toolpath(CYLINDER, BIG, Wanted(layer=2.0))
    other = toolpath(CYLINDER, BIG, Wanted(layer=2.0, clockwise=True))
    assert other.points == pytest.approx(one.points * [1.0, -1.0, 1.0], abs=1e-9)


def test_the_wet_size_is_printed_unless_the_fired_is_asked_for() -> None:
    document = replace(CYLINDER, manufacture=Manufacture(shrinkage=Shrinkage(10.0)))
    wet = toolpath(document, BIG, Wanted(layer=1.0))
    fired = toolpath(document, BIG, Wanted(layer=1.0, stage=Stage.FIRED))
    assert wet.points[-1, 2] == pytest.approx(21.3 / 0.9)
    assert fired.points[-1, 2] == pytest.approx(21.3)


@pytest.mark.parametrize(
    ("document", "wanted", "words"),
    [
        (replace(CYLINDER, revolution=replace(CYLINDER.revolution, sweep_deg=180.0)), {}, "part"),
        (preset("ring"), {}, "closed profile"),
        (chain((30.0, 0.0), (-5.0, 20.0), (30.0, 40.0)), {}, "crosses the axis in segment 0"),
        (chain((30.0, 0.0), (35.0, 20.0), (40.0, 10.0), (45.0, 60.0)), {}, "from 10 mm on"),
        (chain((30.0, 0.0), (30.0, 40.0), (25.0, 30.0)), {}, "upper end"),
        (chain((30.0, 0.0), (30.0, 0.05)), {}, "lower than one layer"),
        (CYLINDER, {"layer": 3.0}, "a layer of 3 mm is beyond Plastic, Marlin; allowed is 0.05 to"),
        (CYLINDER, {"bead": 3.0}, "a bead of 3 mm is beyond"),
        (preset("vase"), {}, "it needs 1.* × 290.0 mm; Plastic, Marlin has room for 220 × 220 × 2"),
        (preset("bowl"), {}, "a bead of 4 mm .* which this wall has with 5 beads"),
    ],
)
def test_what_cannot_be_printed_is_one_line(document, wanted, words) -> None:
    with pytest.raises(ToolpathError, match=words) as caught:
        toolpath(document, PLASTIC, Wanted(**wanted))
    assert "\n" not in str(caught.value)


def test_an_endless_path_is_refused_before_it_is_made() -> None:
    tall = chain((3000.0, 0.0), (3000.0, 9000.0))
    with pytest.raises(ToolpathError, match="points; allowed are 5000000"):
        toolpath(tall, roomy(PLASTIC), Wanted(layer=0.01, chord=1e-3))


@pytest.mark.parametrize("index", range(len(resources.presets())))
def test_every_preset_is_printed_or_says_why_not(index) -> None:
    document = project_file.loads(resources.presets()[index].file.read_bytes())
    printed = 0
    for printer in (PLASTIC, CLAY):
        try:
            path = toolpath(document, printer, Wanted(chord=2.0))
        except ToolpathError as error:
            refused = str(error)
        else:
            printed, refused, bed = printed + 1, "", printer.bed
            assert (path.on_bed >= -1e-9).all()
            assert (path.on_bed <= [bed.width, bed.depth, bed.height]).all()
        assert "\n" not in refused
    assert printed or refused
