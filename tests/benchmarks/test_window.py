"""What the hand feels in the real window: from the event to the picture on the screen.

``pytest tests/benchmarks/test_window.py -s`` prints a table; what is compared is timed in turns.
Nothing is judged by time: what may be judged, the counts, is in ``tests/app/window``. With
BENCHMARKS=short in the environment each is run a few times only, so that it cannot rot.
"""

import os
import statistics
import sys
import time

import pytest
from PySide6.QtTest import QTest

from sgb_core.document import edits
from tests.app.waiting import PatientBot
from tests.app.window_stage import WindowStage
from tests.benchmarks.table import Table
from tests.benchmarks.window import SIZE, Hand, Watch, chain, preset, start, stream

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)

SHORT = os.environ.get("BENCHMARKS") == "short"
MOVES, TURNS = (3, 1) if SHORT else (12, 3)
SECONDS = 0.3 if SHORT else 2.0
PRESETS = ("vase",) if SHORT else ("vase", "ceramic-pot", "melon-jar", "bowl")
LENGTHS = (10, 30) if SHORT else (10, 100, 500)
KINDS = ("slider", "editor", "space", "orbit")


@pytest.fixture(scope="module")
def table():
    """Collect the figures of all, and print them as one table at the end."""
    made = Table()
    yield made
    print("\n" + "\n".join(made.lines()))


@pytest.fixture
def stage(qapp, request):
    made = WindowStage(PatientBot(request), SIZE, make_panels=False)
    yield made
    made.presenter.cancel()
    made.close()


def show(stage, document):
    stage.presenter.replace_document(document)
    stage.settle()


def middle(times):
    return statistics.median(times)


def late(times):
    """Return what all but one in twenty stay below."""
    return sorted(times)[min(len(times) - 1, int(0.95 * len(times)))]


def test_a_move_until_its_picture(stage, table):
    watch, taken = Watch(stage), {}
    view = stage.window.surface_view.plotter
    print(f"\nviewport {view.width()}×{view.height()}")
    for _ in range(TURNS):
        for name in PRESETS:
            show(stage, preset(name))
            for kind in KINDS:
                hand = Hand(stage, kind)
                found = taken.setdefault((name, kind), [])
                found += [watch.timed(hand.move) for _ in range(MOVES)]
                hand.let_go()
                stage.settle()
    own = middle(taken["vase", "slider"])
    for (name, kind), times in taken.items():
        usual = middle(times)
        table.tell(f"move, {name}, {kind}", usual)
        print(
            f"move  {name:>12} {kind:>6}  {usual:6.1f} ms  p95 {late(times):6.1f}"
            f"  {usual / own:5.2f} x vase"
        )


def test_a_stream_of_moves_and_the_rest_after_it(stage, table):
    watch = Watch(stage)
    print()
    for name in PRESETS:
        show(stage, preset(name))
        hand = Hand(stage, "slider")
        pictures, behind = stream(watch, hand, SECONDS)
        released = time.perf_counter()
        hand.let_go()
        stage.settle()
        refined = 1e3 * (watch.swapped[-1] - released)
        table.tell(f"stream, {name}, pictures a second", pictures)
        table.tell(f"stream, {name}, late", behind)
        table.tell(f"stream, {name}, refined", refined)
        print(
            f"stream {name:>12}  {pictures:5.1f} pictures a second, {behind:6.1f} ms late,"
            f" refined {refined:6.0f} ms after the hand"
        )


def test_a_window_left_alone(stage, table):
    watch = Watch(stage)
    print()
    for name in PRESETS:
        show(stage, preset(name))
        drawn, busy = len(watch.drawn), time.process_time()
        # The event loop sleeps as in the program: asking for events again and again would be what
        # is measured.
        QTest.qWait(round(1e3 * SECONDS))
        share = (time.process_time() - busy) / SECONDS
        table.tell(f"idle, {name}, % of a core", 100.0 * share)
        print(f"idle  {name:>12}  {len(watch.drawn) - drawn} pictures, {share:6.1%} of a core")


def test_a_tick_of_all_of_the_window_but_the_drawing(stage, table):
    print()
    for name in PRESETS:
        show(stage, preset(name))
        one = ticks(stage, 0, 40 if not SHORT else 3)
        table.tell(f"tick, {name}", one)
        print(f"tick  {name:>12}  {one:6.2f} ms of the window's thread")


def test_a_long_chain(stage):
    print()
    for count in LENGTHS:
        document = chain(count)
        began = time.thread_time()
        show(stage, document)
        opened = time.thread_time() - began
        one = ticks(stage, count // 2, 10 if not SHORT else 2)
        everything = ticks(stage, None, 4 if not SHORT else 1)
        print(
            f"chain {count:5d} segments  open {opened:5.2f} s of the thread, tick of one"
            f" {one:6.1f} ms, of all {everything:7.1f} ms"
        )


def ticks(stage, segment, count):
    """Return the thread's milliseconds for one change of a slider, nothing drawn."""
    stage.presenter.begin("ω")
    taken = []
    for k in range(count + 2):
        value = 0.3 + 0.03 * (k % 13)
        began = time.thread_time()
        stage.presenter.apply(lambda d, v=value: edits.set_shape_parameter(d, segment, "omega", v))
        stage.presenter.refresh_now()
        taken.append(1e3 * (time.thread_time() - began))
    stage.presenter.cancel()
    stage.settle()
    return middle(taken[2:])


def test_a_start(table):
    found = [start() for _ in range(TURNS)]
    print()
    for stage_name in found[0]:
        usual = middle([each[stage_name] for each in found])
        table.tell(f"start, {stage_name}", 1e3 * usual)
        print(f"start  {stage_name:>8}  {usual:5.2f} s")
