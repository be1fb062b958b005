"""The print path in the viewport: in the surface's place at rest, through its time, on its bed."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

import resources
from app.scene.print_path import on_bed
from app.state import preferences
from app.state.overlays import Overlay
from app.state.path_colours import MEASURES, shade_numbers
from app.state.printed import planned
from app.viewport.print_bar import MOMENTS
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.model import Document, Revolution
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.twist import Twist
from sgb_core.surfaces.variation import Law
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.printer import read_printer
from sgb_core.toolpaths.settings import Wanted
from tests.app.window_stage import WindowStage

PLASTIC = read_printer(resources.printers()[0])
CUP = Document(Profile.of([line((20.0, 3.0), (26.0, 33.0))]), name="Cup")


@pytest.fixture
def stage(qtbot):
    stage = WindowStage(qtbot)
    stage.presenter.replace_document(CUP)
    stage.settle()
    yield stage
    preferences.change(printer="", print_layer=0.0)
    stage.close()


def shown(stage):
    scene = stage.window.surface_view.scene
    return scene.path.shown


def see(stage):
    QTest.keyClick(
        stage.window,
        Qt.Key.Key_G,
        Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier,
    )
    stage.until(lambda: shown(stage))
    stage.settle()


def test_every_point_lies_on_the_surface_wherever_that_stands():
    laws = (Law("radius", "lobes", 1.0, 1.2, count=5),)
    document = replace(
        CUP,
        variation=laws,
        twist=Twist(turns=0.3),
        revolution=Revolution(axis=Axis.X, start_deg=70.0),
        placement=Placement((10.0, 20.0, 30.0), (5.0, 6.0, 7.0)),
    )
    path = toolpath(document, PLASTIC, Wanted(bead=0.0))
    surface = document.surface
    wall = path.points[path.turns >= 0]
    grid = on_bed(surface, path, wall)
    mesh = document.body().mesh(tolerance=0.02)
    some = grid[:: len(grid) // 200]
    corners = mesh.positions[mesh.corner_positions[mesh.triangles]]
    assert max(_distance(point, corners) for point in some) < 0.05


def _distance(point, corners):
    """How far a point lies from the nearest triangle, by projections onto its plane and edges."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    near = np.linalg.norm(corners.mean(axis=1) - point, axis=1)
    pick = np.argsort(near)[:60]
    best = np.inf
    for p, q, r in zip(a[pick], b[pick], c[pick], strict=True):
        basis = np.stack([q - p, r - p], axis=1)
        (u, v), *_ = np.linalg.lstsq(basis, point - p, rcond=None)
        u, v = np.clip([u, v], 0.0, 1.0)
        if u + v > 1.0:
            u, v = u / (u + v), v / (u + v)
        best = min(best, float(np.linalg.norm(p + basis @ [u, v] - point)))
    return best


def test_it_takes_the_surface_s_place_and_gives_it_back(stage):
    before = stage.viewport()
    see(stage)
    with_path = stage.viewport()
    assert (np.abs(with_path.astype(int) - before).max(axis=2) > 24).mean() > 0.02
    assert stage.window.surface_view.print_bar.isVisible()
    stage.window.surface_view.print_bar.close_button.click()
    stage.settle()
    assert not stage.window.surface_view.print_bar.isVisible()
    assert not shown(stage)


def test_a_drag_shows_the_surface_and_the_new_path_follows_it(stage):
    see(stage)
    first = stage.presenter.frame.printed
    stage.presenter.begin("lambda")
    stage.presenter.apply(lambda d: edits.scale(d, 1.1))
    stage.presenter.refresh_now()
    assert not shown(stage)
    stage.presenter.commit()
    stage.until(lambda: shown(stage))
    assert stage.presenter.frame.printed.path.length > first.path.length


def test_the_slider_runs_through_the_time_of_printing(stage):
    see(stage)
    bar, part = stage.window.surface_view.print_bar, stage.window.surface_view.scene.path
    whole = part.fine.actor.GetMapper().GetInput().GetNumberOfCells()
    tip = part.nozzle.GetMapper().GetInput().GetBounds()[4]
    bar.moment.setFocus()
    for _ in range(10):
        QTest.keyClick(bar.moment, Qt.Key.Key_PageDown)
    assert bar.moment.value() == MOMENTS // 2
    stage.settle()
    half = part.fine.actor.GetMapper().GetInput().GetNumberOfCells()
    assert 0.3 * whole < half < 0.7 * whole
    assert part.nozzle.GetMapper().GetInput().GetBounds()[4] < tip
    assert "layer" in bar.now.text()


def test_a_moving_picture_draws_fewer_beads(stage):
    see(stage)
    view = stage.window.surface_view
    part = view.scene.path
    assert part.fine.actor.GetVisibility()
    assert not part.rough.actor.GetVisibility()
    view._orbit_by_hand(12.0, 3.0)
    assert part.rough.actor.GetVisibility()
    assert not part.fine.actor.GetVisibility()
    printed = stage.presenter.frame.printed
    assert len(printed.rough.quads) < len(printed.beads.quads)
    stage.settle()
    assert part.fine.actor.GetVisibility()


def test_playing_ends_with_the_print(stage):
    see(stage)
    bar = stage.window.surface_view.print_bar
    bar.moment.setValue(MOMENTS - 12)
    bar.play.click()
    stage.until(lambda: not bar.play.isChecked())
    assert bar.moment.value() == MOMENTS


@pytest.mark.parametrize("measure", MEASURES)
def test_it_is_coloured_by_each_measure(stage, measure):
    see(stage)
    stage.presenter.set_view(path_measure=measure)
    stage.settle()
    bar = stage.window.surface_view.print_bar
    assert bar.colouring.currentData() == measure
    printed = stage.presenter.frame.printed
    colours = stage.window.surface_view.scene.path.fine.actor.GetMapper().GetInput().GetPointData()
    wanted = len(set(shade_numbers(printed.path, measure)[printed.beads.kept].tolist()))
    scalars = colours.GetScalars()
    painted = {scalars.GetTuple(k) for k in range(scalars.GetNumberOfTuples())}
    assert len(painted) == wanted


def test_another_printer_is_chosen_in_the_bar(stage):
    see(stage)
    bar = stage.window.surface_view.print_bar
    names = [bar.printer.itemData(k).name for k in range(bar.printer.count())]
    bar.printer.setFocus()
    while bar.printer.currentData().name != "generic-clay":
        QTest.keyClick(bar.printer, Qt.Key.Key_Down)
    assert "generic-clay" in names
    stage.until(
        lambda: (
            stage.presenter.frame.printed is not None
            and stage.presenter.frame.printed.path is not None
            and stage.presenter.frame.printed.path.plan.printer.name == "generic-clay"
        )
    )


def test_what_cannot_be_printed_is_seen_and_says_why(stage):
    see(stage)
    stage.presenter.do("turn", lambda d: edits.set_revolution(d, sweep_deg=180.0))
    bar = stage.window.surface_view.print_bar
    stage.until(lambda: "turn" in bar.told.text() and "planned" not in bar.told.text())
    stage.settle()
    assert not shown(stage)
    assert stage.presenter.view.shows(Overlay.PRINT)


def test_beads_in_the_wall_are_as_few_as_the_printer_can():
    vessel = edits.set_solid(CUP, kind="vessel", wall=2.0)
    printed = planned(vessel, PLASTIC, PLASTIC.layer.usual)
    assert printed.path.plan.walls == int(np.ceil(2.0 / PLASTIC.bead.most))
