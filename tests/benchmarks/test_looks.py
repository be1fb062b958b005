"""What each look costs: one tick of a drag, drawn. Run with ``-s`` to see the table.

Off screen at 1200×800 and the coarse level that a drag uses: edit, evaluate, write, draw, wait for
the picture. All are timed in turns, so that a busy machine slows them alike; medians are printed.
"""

import statistics
import time
from dataclasses import replace

from vtkmodules.vtkRenderingCore import vtkRenderer

from app.scene.camera import standard_pose
from app.scene.offscreen import offscreen_window
from app.scene.scene import Scene
from app.state.view_state import ViewState
from app.theme.palette import LIGHT
from sgb_core.document import edits
from sgb_core.document.appearance.model import (
    Appearance,
    ColourMap,
    Layer,
    LayerKind,
    MapKind,
    MaterialName,
    Texture,
)
from sgb_core.document.evaluation import evaluate
from tests.app.viewport.helpers import document

OMEGAS = (0.1, 0.4, 0.7)
TURNS = 3
BARE = ViewState(segment=-1, show=frozenset({"surface"}))
CLAY = Appearance()
LOOKS = {
    **{str(name): Appearance(name) for name in MaterialName},
    "shadow": replace(CLAY, shadow=True),
    "outline and edges": replace(CLAY, silhouette=True, features=True),
    "flat facets": replace(CLAY, shading="flat"),
    "texture": replace(CLAY, textures=(Texture("lotus", repeat=(6.0, 3.0)),)),
    "texture that follows": replace(CLAY, textures=(Texture("lotus"),)),
    "painted bands": replace(CLAY, drawing=(Layer(LayerKind.BAND),)),
    "map of mean curvature": replace(CLAY, map=ColourMap(MapKind.MEAN)),
    "zebra stripes": replace(CLAY, map=ColourMap(MapKind.ZEBRA)),
}


class Stage:
    """One scene with one look."""

    def __init__(self, appearance):
        self.document = replace(document(), appearance=appearance)
        self.window = offscreen_window()
        self.window.SetSize(1200, 800)
        renderer = vtkRenderer()
        self.window.AddRenderer(renderer)
        self.scene = Scene(renderer, LIGHT)
        self.tick(0.5)
        self.scene.fit(1.5, standard_pose(self.document.revolution.axis))

    def tick(self, omega):
        shaped = edits.set_shape_parameter(self.document, 1, "omega", omega)
        self.scene.update(evaluate(shaped), BARE)
        self.window.Render()
        self.window.WaitForCompletion()


def test_looks(benchmark):
    stages = {name: Stage(appearance) for name, appearance in LOOKS.items()}
    taken = {name: [] for name in LOOKS}
    for _ in range(TURNS):
        for name, stage in stages.items():
            for omega in OMEGAS:
                start = time.perf_counter()
                stage.tick(omega)
                taken[name].append((time.perf_counter() - start) * 1e3)
    plain = statistics.median(taken["clay"])
    print()
    for name, times in taken.items():
        median = statistics.median(times)
        benchmark.extra_info[name] = median
        print(f"{name:24} {median:7.1f} ms  {median / plain:4.1f} x clay")
    benchmark.pedantic(stages["clay"].tick, (0.3,), rounds=3)
    for stage in stages.values():
        stage.window.Finalize()
