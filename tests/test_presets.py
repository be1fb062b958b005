"""The presets: each loads, is what it says, and is handled as any project file is."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

import resources
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.continuity import JointReport, measure_joints
from sgb_core.curves.crossings import axis_crossings, self_intersections
from sgb_core.curves.nearest import farthest
from sgb_core.curves.parameter_fan import most_telling
from sgb_core.curves.segment import PARAMETER_RANGES
from sgb_core.design.tracing.result import distances
from sgb_core.document.appearance import pictures
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.surfaces.measures import volume
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.tessellation import tessellate

NAMES = [preset.name for preset in resources.presets()]
CLASSES = ["gap", "G0", "G1", "C1", "G2"]
# Closed by the axis at both ends, or a ring: their meshes must be watertight.
SOLID = {"goblet", "pagoda", "lidded-jar", "candlestick", "pawn", "sphere", "ring"}
SOLID |= {"ellipsoid-08", "ellipsoid-06", "teapot"}
TEAPOT = Path(__file__).parents[2] / "shared" / "data" / "meshes" / "teapot.obj"
every_preset = pytest.mark.parametrize("name", NAMES)


def _document(name: str) -> Document:
    return project_file.loads(resources.load_preset(name))


def _radial_error(document: Document, b: float) -> float:
    """Return the largest distance from the ellipse r²/b² + (h − 1)² = 1, along its normal."""
    (points,) = document.profile.sample(2001)
    r, y = points[:, 0], points[:, 1] - 1.0
    t = np.arctan2(y, r / b)
    for _ in range(50):
        # Newton on the foot of the perpendicular.
        slope = (b * np.cos(t) - r) * -b * np.sin(t) + (np.sin(t) - y) * np.cos(t)
        bend = (b * np.sin(t)) ** 2 + np.cos(t) ** 2
        bend -= (b * np.cos(t) - r) * b * np.cos(t) + (np.sin(t) - y) * np.sin(t)
        t -= slope / bend
    return float(np.hypot(r - b * np.cos(t), y - np.sin(t)).max())


def test_the_list_is_complete_and_in_words() -> None:
    shipped = {file.stem for file in resources.path("presets").glob("*.sgb")}
    assert shipped == set(NAMES)
    assert len(NAMES) == len(shipped)
    assert NAMES[0] == "vase"
    for preset in resources.presets():
        assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", preset.name)
        assert preset.file == resources.path(f"presets/{preset.name}.sgb")
        assert 0 < len(preset.title) <= 40
        assert 20 <= len(preset.description) <= 100
        assert "\n" not in preset.description
        assert preset.group in ("studio", "paper")


def test_an_unknown_name_is_refused_in_one_line_with_the_choices() -> None:
    with pytest.raises(ValueError, match=r"no preset 'vace'; allowed is vase, bowl, .*ring$"):
        resources.load_preset("vace")
    with pytest.raises(FileNotFoundError, match=r"no resource 'presets/vace\.sgb'"):
        resources.read("presets/vace.sgb")


@every_preset
def test_a_preset_loads_without_a_warning(name: str) -> None:
    document = _document(name)
    (preset,) = (p for p in resources.presets() if p.name == name)
    assert document.name == preset.title
    assert list(project_file.warnings(document)) == []


@every_preset
def test_a_preset_survives_saving(name: str) -> None:
    document = _document(name)
    assert project_file.loads(project_file.dumps(document)) == document
    assert json.loads(project_file.dumps(document))["profile"]["segments"]


@every_preset
def test_joints_are_at_least_what_their_rule_says(name: str) -> None:
    def holds(joint: JointReport) -> bool:
        return CLASSES.index(joint.measured) >= CLASSES.index(joint.rule)

    joints = measure_joints(_document(name).profile)
    assert all(holds(joint) for joint in joints), joints
    assert not any(joint.degenerate for joint in joints)


@every_preset
def test_a_preset_crosses_neither_the_axis_nor_itself(name: str) -> None:
    profile = _document(name).profile
    assert axis_crossings(profile) == ()
    assert self_intersections(profile) == ()


@every_preset
def test_a_preset_opens_where_the_belly_slider_shows(name: str) -> None:
    profile = _document(name).profile
    opened = profile.segments[most_telling(profile)]
    low, high = (
        opened.with_shape(replace(opened.shape, lambda2=value))
        for value in PARAMETER_RANGES["lambda2"]
    )
    apart = max(farthest([low], [high]), farthest([high], [low]))
    points = profile.control_points.reshape(-1, 2)
    size = max(2.0 * np.abs(points[:, 0]).max(), np.ptp(points[:, 1]))
    # The ring has ω = 1/3, as printed.
    assert apart > (0.013 if name == "ring" else 0.019) * size


@every_preset
def test_a_preset_makes_a_sound_mesh(name: str) -> None:
    document = _document(name)
    mesh = tessellate(document.surface, samples=(24, 48))
    assert mesh.is_watertight == (name in SOLID)
    if name in SOLID:
        # Chords lie within: a little less than the exact volume, and outward.
        assert 0.97 < mesh.volume / volume(document.surface) < 1.03
        assert mesh.volume > 0.0


@every_preset
def test_the_body_that_a_preset_names_is_closed(name: str) -> None:
    pictures.set_library(resources.texture)
    document = _document(name)
    if document.solid.kind is not BodyKind.SURFACE:
        mesh = document.body().mesh(tolerance=2e-3 * document.profile.size)
        assert mesh.is_watertight
        assert mesh.volume > 0.0


@pytest.mark.parametrize(
    ("name", "b", "limit"),
    [("sphere", 1.0, 1.6e-4), ("ellipsoid-08", 0.8, 1.5e-4), ("ellipsoid-06", 0.6, 1.3e-4)],
)
def test_sphere_and_ellipsoids_are_as_near_as_they_claim(name: str, b: float, limit: float) -> None:
    document = _document(name)
    assert _radial_error(document, b) < limit
    assert volume(document.surface) == pytest.approx(4 / 3 * pi * b * b, rel=1e-3)


def test_paper_examples_carry_the_printed_points() -> None:
    tower = _document("tower")
    assert tower.revolution.axis is Axis.Z
    assert tower.profile.control_points.tolist() == [
        [[5, 13], [6, 12], [3, 10], [2, 8]],
        [[2, 8], [1, 6], [2, 3], [5, -1]],
        [[5, -1], [8, -5], [5, -9], [8, -10]],
    ]
    single = _document("figure-2")
    assert single.revolution.axis is Axis.X
    assert single.profile.control_points.tolist() == [[[0.2, 0.2], [0.9, 0], [0.9, 1], [0.2, 0.8]]]
    ring = _document("ring").profile
    assert ring.closed
    assert ring.segments[1].reversed().points.tolist() == [[2, 0], [0.8, 0], [0.8, 2], [2, 2]]


def test_shape_parameters_matter_in_our_own_presets() -> None:
    for preset in resources.presets():
        if preset.group == "paper" or preset.name == "teapot":
            continue
        segments = _document(preset.name).profile.segments
        shaped = [s for s in segments if s.shape.leg_fractions != (0.75, 0.5, 0.75)]
        assert len(shaped) >= 3, preset.name
        assert len({s.shape for s in shaped}) >= 3, preset.name


def test_the_teapot_is_the_published_profile() -> None:
    profile = _document("teapot").profile
    # Newell's control points in his own units, rim and lid: 40 mm each.
    body = [(1.425, 0), (1.5, 0.075), (1.5, 0.15), (1.5, 0.225), (2, 0.45), (2, 0.9), (2, 1.35)]
    body += [(1.75, 1.875), (1.5, 2.4), (1.4375, 2.53125), (1.3375, 2.53125), (1.4, 2.4)]
    lid = [(1.3, 2.4), (1.3, 2.55), (0.4, 2.55), (0.2, 2.7), (0, 2.85), (0.8, 3.15), (0, 3.15)]
    points = profile.control_points
    np.testing.assert_allclose(points[:4, 1:].reshape(-1, 2), 40 * np.array(body), rtol=1e-15)
    np.testing.assert_allclose(points[5:, 1:].reshape(-1, 2), 40 * np.array(lid[1:]), rtol=1e-15)
    assert points[5, 0].tolist() == [52.0, 96.0]
    # ω = 1: the plain cubics, with every slider alive.
    assert all(s.shape.leg_fractions == (0.75, 0.5, 0.75) for s in profile.segments)
    assert all(s.shape.omega == 1.0 for s in profile.segments)


@pytest.mark.skipif(not TEAPOT.is_file(), reason="needs the mesh of the teapot")
def test_the_teapots_mesh_lies_on_the_preset() -> None:
    lines = TEAPOT.read_text(encoding="utf-8").splitlines()
    x, y, z = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], float).T
    radius = np.hypot(x, z)
    # Away from spout and handle; each quarter turn is a cubic, a little out of round.
    beside = np.abs(x) <= 0.2 * radius
    points = 40.0 * np.stack([radius, y], axis=1)[beside]
    assert len(points) > 100
    assert distances(_document("teapot").profile, points).max() < 0.001 * 126.0


@pytest.mark.parametrize("name", ["ceramic-pot", "earthen-house"])
def test_pot_and_house_come_dressed_and_with_two_variants_by_shape_alone(name: str) -> None:
    document = _document(name)
    assert document.appearance.textures
    original, *variants = document.states
    assert original.profile == document.profile
    assert len(variants) == 2
    points = document.profile.control_points
    shapes = {tuple(s.shape for s in each.profile.segments) for each in document.states}
    assert len(shapes) == 3
    for each in variants:
        np.testing.assert_array_equal(each.profile.control_points, points)
        assert self_intersections(each.profile) == ()
        assert axis_crossings(each.profile) == ()
