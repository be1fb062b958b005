"""Objects far from the origin: single precision keeps the tolerance, or says that it cannot."""

from __future__ import annotations

import io
import json
import struct
from dataclasses import replace

import numpy as np
import pytest
import trimesh

import sgb_core.exchange as exchange
from sgb_core.document.model import Unit
from sgb_core.exchange.errors import ExportError
from sgb_core.findings.exports import SinglePrecision
from sgb_core.surfaces.placement import Placement
from tests.sgb_core.exchange.shapes import spindle

# A point of a survey's grid, in the unit of the object.
FAR = (44_600_000.0, 555_000_000.0, 12_000.0)


def far(unit: Unit = Unit.CM):
    return replace(spindle(), unit=unit, placement=Placement(translation=FAR))


def test_stl_refuses_what_it_would_flatten(tmp_path) -> None:
    with pytest.raises(ExportError) as refused:
        exchange.write(far(), tmp_path / "far.stl", tolerance=0.01)
    found = refused.value.finding
    assert isinstance(found, SinglePrecision)
    assert found.rounding > found.allowed == 0.01
    assert not (tmp_path / "far.stl").exists()
    exchange.write(far(), tmp_path / "coarse.stl", tolerance=100.0)


def test_glb_keeps_the_shape_and_its_place(tmp_path) -> None:
    exchange.write(spindle(), tmp_path / "here.glb", samples=(16, 24))
    exchange.write(replace(far(), unit=spindle().unit), tmp_path / "far.glb", samples=(16, 24))
    here, there = (_node(tmp_path / f"{name}.glb") for name in ("here", "far"))
    assert "translation" not in here
    scale = there["scale"][0]
    loaded = [trimesh.load(tmp_path / f"{name}.glb", force="mesh") for name in ("here", "far")]
    centre = np.array(FAR) * scale
    # +Z up becomes +Y up: (x, y, z) to (x, z, −y).
    wanted = loaded[0].bounds + np.array([centre[0], centre[2], -centre[1]])
    np.testing.assert_allclose(loaded[1].bounds, wanted, rtol=1e-12, atol=1e-7)
    assert loaded[1].area == pytest.approx(loaded[0].area, rel=1e-5)


def _node(path) -> dict:
    stream = io.BytesIO(path.read_bytes())
    stream.seek(12)
    length, _ = struct.unpack("<II", stream.read(8))
    (node,) = json.loads(stream.read(length))["nodes"]
    return node
