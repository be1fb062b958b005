"""What one tick of a slider costs in the scene alone, beside copying and other programs' meshes.

Ticks: edit, evaluate, write points and normals and tell VTK; no drawing, no window: what the hand
feels is measured in ``test_window.py``. Everything is timed in turns, so that a busy machine slows
all alike; medians are printed. Run with ``-s``.
"""

import os
import statistics
import sys
import time
from dataclasses import replace

import numpy as np
import pytest

import resources
from sgb_core.document import edits
from sgb_core.document.evaluation import evaluate
from sgb_core.document.file import project_file
from sgb_core.surfaces.grid import SweepGrid
from tests.app.viewport.helpers import FakePresenter, document

# Intervals (per segment, around) of the three-segment vase.
SIZES = {"16k": (42, 128), "164k": (136, 400), "500k": (235, 704)}
OMEGAS = np.linspace(0.05, 0.95, 7)


def shaped(doc, omega):
    return edits.set_shape_parameter(doc, 1, "omega", float(omega))


def milliseconds(action, *arguments):
    start = time.perf_counter()
    action(*arguments)
    return (time.perf_counter() - start) * 1e3


def test_tick(benchmark):
    from app.scene.actors import SurfacePart

    doc = document()
    first = evaluate(doc)
    parts, copies = {}, {}
    for name, (per_segment, around) in SIZES.items():
        parts[name] = SurfacePart((3, per_segment, around), [])
        grid = parts[name].grid
        copies[name] = (np.empty_like(grid.points), np.empty_like(grid.normals))

    def tick(part, omega):
        evaluation = evaluate(shaped(doc, omega), first)
        part.grid.write(evaluation.surface)
        part.written()

    def copy(part, target):
        np.copyto(target[0], part.grid.points)
        np.copyto(target[1], part.grid.normals)

    ticks, copied = ({name: [] for name in SIZES} for _ in range(2))
    for turn in range(42):
        for name, part in parts.items():
            ticks[name].append(milliseconds(tick, part, OMEGAS[turn % len(OMEGAS)]))
            copied[name].append(milliseconds(copy, part, copies[name]))
    print()
    for name, part in parts.items():
        whole, plain = statistics.median(ticks[name]), statistics.median(copied[name])
        vertices = len(part.grid.points)
        print(f"tick  {vertices:7d} vertices  {whole:7.3f} ms  {whole / plain:5.1f} x copying")
        benchmark.extra_info[name] = whole
    benchmark.pedantic(tick, (parts["164k"], 0.5), rounds=10, warmup_rounds=1)


def test_a_grid_under_laws(benchmark):
    """What writing a surface with laws takes, beside one without and a copy of the same bytes."""
    melon = project_file.loads(resources.load_preset("melon-jar"))
    count = len(melon.profile.segments)
    grid = SweepGrid(count, 164_000 // 401 // count - 1, 400)
    points, normals = np.empty_like(grid.points), np.empty_like(grid.normals)
    surfaces = {
        "laws": [shaped(melon, omega).surface for omega in OMEGAS],
        "no laws": [shaped(replace(melon, variation=()), omega).surface for omega in OMEGAS],
    }

    def copy():
        np.copyto(points, grid.points)
        np.copyto(normals, grid.normals)

    taken = {name: [] for name in (*surfaces, "copy")}
    for turn in range(42):
        for name, each in surfaces.items():
            taken[name].append(milliseconds(grid.write, each[turn % len(OMEGAS)]))
        taken["copy"].append(milliseconds(copy))
    print()
    for name, times in taken.items():
        print(
            f"grid  {len(grid.points):7d} vertices, {name:>7}  {statistics.median(times):7.3f} ms"
        )
    benchmark.pedantic(grid.write, (surfaces["laws"][0],), rounds=10, warmup_rounds=1)


@pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
def test_picture_with_a_range_or_a_ghost(benchmark, qtbot):
    """What a hovered slider or a state to compare with adds to the bare picture; at most a third.

    A range is fan, leg and circle; a ghost another state of the document.
    """
    from PySide6.QtWidgets import QApplication

    from app.state.view_state import Hover
    from app.viewport.view import SurfaceView

    presenter = FakePresenter(document())
    view = SurfaceView(presenter)
    presenter.target = view
    view.resize(1200, 800)
    presenter.send()
    view.show()
    qtbot.waitUntil(lambda: view.scene is not None, timeout=30000)
    pictures = []
    view.plotter.ren_win.AddObserver("EndEvent", lambda *_: pictures.append(None))

    def picture(hover, omega, compared=None):
        presenter.view = replace(presenter.view, hover=hover)
        presenter.compared = compared
        before = len(pictures)
        presenter.edit(shaped(document(), omega), dragging=True)
        while len(pictures) == before:
            QApplication.processEvents()
        QApplication.processEvents()

    kinds = {
        "bare": None,
        "its own range": Hover("omega", 1),
        "another's": Hover("lambda2", 1),
        "of all": Hover("lambda2", None),
    }
    ghost = evaluate(shaped(document(), 0.2))
    times = {name: [] for name in (*kinds, "ghost")}
    for _ in range(6):
        for name in times:
            shown = (kinds.get(name), None if name in kinds else ghost)
            picture(shown[0], 0.5, shown[1])
            times[name].extend(milliseconds(picture, shown[0], w, shown[1]) for w in OMEGAS)
    print()
    bare = statistics.median(times["bare"])
    for name, taken in times.items():
        median = statistics.median(taken)
        print(f"picture  {name:>14}  {median:6.1f} ms  {median / bare:5.2f} x bare")
        benchmark.extra_info[name] = median
    benchmark.pedantic(picture, (kinds["its own range"], 0.6), rounds=5)
    view.shut_down()
    view.close()


def test_other_programs_on_the_same_shape():
    """The vase as each would make it anew for every tick; those not installed are left out."""
    from sgb_core.surfaces.grid import SweepGrid

    surface = shaped(document(), 0.5).surface
    per_segment, around = SIZES["164k"]
    grid = SweepGrid(len(surface.profile), per_segment, around)
    line = grid.section(surface)
    copies = np.empty_like(grid.points), np.empty_like(grid.normals)

    def copy():
        np.copyto(copies[0], grid.points)
        np.copyto(copies[1], grid.normals)

    def by_pyvista():
        import pyvista

        points = grid.points.reshape(grid.rows, grid.columns, 1, 3)
        mesh = pyvista.StructuredGrid(*np.moveaxis(points, -1, 0).astype(float))
        mesh.extract_surface().compute_normals(inplace=True)

    def by_trimesh():
        trimesh = pytest.importorskip("trimesh")
        _ = trimesh.creation.revolve(line, sections=around).vertex_normals

    ways = {"copying": copy, "ours": lambda: grid.write(surface)}
    ways |= {"pyvista": by_pyvista, "trimesh": by_trimesh}
    taken = {name: [] for name in ways}
    for turn in range(4):
        for name, way in ways.items():
            took = milliseconds(way)
            if turn:
                taken[name].append(took)
    print()
    own = statistics.median(taken["ours"])
    for name, times in taken.items():
        median = statistics.median(times)
        print(
            f"mesh  {name:>8}  {len(grid.points)} vertices  {median:8.2f} ms  {median / own:6.1f} x"
        )
