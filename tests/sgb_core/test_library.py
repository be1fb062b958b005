"""The core as a library: its names, its examples, and what a script asks of a document."""

from __future__ import annotations

import builtins
import doctest
import importlib
import inspect
import math
import pkgutil
import sys
from types import ModuleType

import numpy as np
import pytest

import sgb_core as sgb
from tests.sgb_core.document import samples

EXACT = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
# What a script makes by hand; the other classes are what functions return.
MADE = (
    sgb.Body,
    sgb.Document,
    sgb.Placement,
    sgb.Profile,
    sgb.Revolution,
    sgb.RevolutionSurface,
    sgb.Segment,
    sgb.ShapeParameters,
    sgb.Solid,
)
FUNCTIONS = [each for name in sgb.__all__ if inspect.isfunction(each := getattr(sgb, name))]
EDITS = [each for name in sgb.edits.__all__ if inspect.isfunction(each := getattr(sgb.edits, name))]


def _modules() -> list[ModuleType]:
    found = pkgutil.walk_packages(sgb.__path__, "sgb_core.")
    return [sgb, *(importlib.import_module(each.name) for each in found)]


def _examples() -> list[doctest.DocTest]:
    finder = doctest.DocTestFinder(exclude_empty=True)
    shared = {"sgb": sgb, "math": math}
    return [
        test
        for module in _modules()
        for test in finder.find(module, extraglobs=shared)
        if test.examples
    ]


@pytest.mark.parametrize("example", [pytest.param(each, id=each.name) for each in _examples()])
def test_the_examples_are_true(example, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said: list[str] = []
    doctest.DocTestRunner(optionflags=EXACT).run(example, out=said.append)
    assert "".join(said) == ""


@pytest.mark.parametrize("thing", [*MADE, *FUNCTIONS], ids=lambda thing: thing.__name__)
def test_what_a_script_needs_has_an_example(thing):
    assert ">>> " in inspect.getdoc(thing)


def test_no_name_hides_a_standard_one():
    standard = set(sys.stdlib_module_names) | set(dir(builtins))
    assert standard.isdisjoint(sgb.__all__)


OF_SURFACES = (
    "volume",
    "area",
    "centroid",
    "bounds",
    "height",
    "largest_diameter",
    "surface_bending_energy",
)
OF_SECTIONS = ("generatrix_length", "bending_energy")


def _turned() -> sgb.Document:
    """Return a part turn that laws vary, lying along x and moved."""
    turned = sgb.edits.set_revolution(samples.document(), axis="x", start_deg=30, sweep_deg=200)
    moved = sgb.edits.set_placement(turned, translation=(1, 2, 3))
    return sgb.edits.add_law(moved, sgb.Law("omega", "raised-cosine", 0.2, 0.9))


@pytest.mark.parametrize("document", [samples.document(), _turned()], ids=["whole", "turned"])
@pytest.mark.parametrize("name", [*OF_SURFACES, *OF_SECTIONS])
def test_a_document_is_measured_as_its_surface(document, name):
    measure, surface = getattr(sgb, name), document.surface
    meant = surface if name in OF_SURFACES else surface.profile_at(surface.start)
    expected = measure(meant)
    for found in (measure(document), measure(surface), getattr(document, name)):
        np.testing.assert_equal(found, expected)


def test_a_profile_is_a_sequence_of_its_segments():
    profile = samples.document().profile
    assert tuple(profile) == profile.segments
    assert profile[1] is profile.segments[1]
    assert profile[-1] is profile.segments[len(profile) - 1]
    with pytest.raises(IndexError):
        profile[len(profile)]


TUBE = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
CUP = sgb.edits.set_solid(TUBE, kind="vessel", wall=3, base=4)


def test_a_body_answers_for_what_is_made_of_a_document():
    body = CUP.body()
    assert body == sgb.Body(CUP.surface, CUP.solid)
    assert body.capacity == pytest.approx(math.pi * 17**2 * 56)
    assert body.capacity_to(32.0) == pytest.approx(math.pi * 17**2 * 28)
    assert body.material_volume == pytest.approx(math.pi * (20**2 * 60 - 17**2 * 56))
    assert body.wall_min == pytest.approx(3.0)
    mesh = body.mesh(samples=(4, 256))
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(body.material_volume, rel=1e-3)
    # All of the section's points lie on the outline of a wall of 3 and a floor of 4.
    (part,) = body.section()
    assert {*np.unique(part.exterior.round(9))} == {0.0, 4.0, 17.0, 20.0, 60.0}
    assert body.stand.stands
    assert body.stand.centre[:2] == pytest.approx([0.0, 0.0], abs=1e-9)


def test_a_bare_surface_has_a_mesh_and_no_measures():
    body = TUBE.body()
    assert not body.mesh(tolerance=0.1).is_watertight
    assert body.section() == ()
    with pytest.raises(ValueError, match="bare surface"):
        body.capacity  # noqa: B018 - asking is what raises


def test_a_body_that_cannot_be_says_so_when_asked():
    body = sgb.edits.set_solid(CUP, wall=30).body()
    with pytest.raises(sgb.SolidError):
        body.mesh()
    with pytest.raises(sgb.SolidError):
        body.material_volume  # noqa: B018 - asking is what raises


@pytest.mark.parametrize("edit", EDITS, ids=lambda edit: edit.__name__)
def test_edits_name_all_their_keywords(edit):
    kinds = {each.kind for each in inspect.signature(edit).parameters.values()}
    assert inspect.Parameter.VAR_KEYWORD not in kinds
