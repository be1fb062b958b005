"""What a solid body costs: one coarse enough to follow a drag, and one as exported."""

from __future__ import annotations

from dataclasses import replace

import pytest

import resources
from sgb_core.bodies.body import body_mesh
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.document import edits
from sgb_core.document.file import project_file


def shaped(name: str, omega: float):
    """Return a preset's surface after one tick of a slider: nothing of it is cached."""
    document = project_file.loads(resources.load_preset(name))
    return edits.set_shape_parameter(document, 0, "omega", omega).surface


@pytest.mark.parametrize("name", ["vase", "plant-pot", "amphora"])
@pytest.mark.parametrize("part", ["section", "live mesh", "fine mesh", "measures"])
def test_body(benchmark, name: str, part: str) -> None:
    size = shaped(name, 0.5).profile.size
    solid = Solid(BodyKind.VESSEL, size / 60, WallSide.INSIDE, size / 50)
    omegas = iter([k / 1000 for k in range(1, 999)])
    actions = {
        "section": lambda surface: cross_section(surface, solid),
        "live mesh": lambda surface: body_mesh(surface, solid, tolerance=4e-3 * size),
        "fine mesh": lambda surface: body_mesh(surface, solid, tolerance=2e-4 * size),
        "measures": lambda surface: vessel_measures(surface, solid),
    }

    def fresh():
        return (replace(shaped(name, next(omegas))),), {}

    benchmark.pedantic(actions[part], setup=fresh, rounds=15)
