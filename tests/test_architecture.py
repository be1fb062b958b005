"""The house rules, read from the imports themselves."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OURS = ("app", "sgb_core", "resources")
# From the ground up: what lies in one step knows the steps before it, and not its neighbours.
PACKAGES = (
    ("findings",),
    ("fields",),
    ("lettering",),
    ("curves",),
    ("surfaces",),
    ("bodies",),
    ("design",),
    ("document",),
    ("sources", "exchange", "toolpaths", "drawings"),
)
ROOMS = (
    ("theme",),
    ("widgets",),
    ("state",),
    ("hand",),
    ("scene",),
    ("commands",),
    ("viewport", "profile_editor"),
    ("figures",),
    ("files",),
    ("panels",),
    ("settings",),
    ("export",),
    ("intake",),
    ("start",),
    ("film", "printing", "drawings"),
    ("window",),
    ("cli",),
)
# Each draws frames on its own; of the panels each room or module is one.
VIEWS = re.compile(r"app\.(viewport|profile_editor|panels\.\w+)\b")
QT = {"PySide6", "shiboken6", "superqt", "pyvistaqt", "qtpy"}
THREE_D = {"vtk", "vtkmodules", "pyvista", "pyvistaqt"}
MAY_DRAW = re.compile(r"app\.(scene|viewport|figures|film)\.")
LONGEST_FILE, LONGEST_FUNCTION = 350, 60
# Imported names whose distribution is called otherwise, or comes with a declared one.
DISTRIBUTION = {
    "OCP": "cadquery-ocp-novtk",
    "PIL": "pillow",
    "imageio_ffmpeg": "imageio-ffmpeg",
    "fontTools": "fonttools",
    "PySide6": "pyside6-essentials",
    "shiboken6": "pyside6-essentials",
    "vtkmodules": "vtk",
}


def _modules(*packages: str) -> dict[str, Path]:
    found = {}
    for package in packages:
        for path in sorted((ROOT / package).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


MODULES = _modules(*OURS)


def _imports(path: Path) -> set[str]:
    """Return the imported modules by full name: ours as far as they are modules.

    Those inside functions are among them, and those that only a type checker sees.
    """
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        if not isinstance(node, ast.ImportFrom):
            continue
        assert node.level == 0, f"{path.name}: relative import in line {node.lineno}"
        assert node.module is not None
        for alias in node.names:
            full = f"{node.module}.{alias.name}"
            names.add(full if full in MODULES else node.module)
    return names


IMPORTS = {name: _imports(path) for name, path in MODULES.items()}


def _top(name: str) -> str:
    return name.partition(".")[0]


def _step(name: str, order: tuple[tuple[str, ...], ...]) -> tuple[int, str] | None:
    """Return on which step a module's room lies, and the room; None for what lies in no room."""
    _, _, room = name.partition(".")
    room = room.partition(".")[0]
    return next(((k, room) for k, step in enumerate(order) if room in step), None)


def _upwards(top: str, order: tuple[tuple[str, ...], ...]) -> Iterator[tuple[str, str]]:
    """Yield the imports inside a tree that lead up or to a neighbour."""
    for module, name in _pairs():
        here, there = _step(module, order), _step(name, order)
        if _top(module) != top or _top(name) != top or there is None:
            continue
        # What lies in no room, beside the tree's own door and its entry, lies under all rooms.
        if here is None:
            if module not in (top, f"{top}.__main__"):
                yield module, name
        elif there[0] > here[0] or (there[0] == here[0] and there[1] != here[1]):
            yield module, name


def _offenders(wrong: Iterator[tuple[str, str]]) -> list[str]:
    return sorted(f"{module} imports {name}" for module, name in wrong)


def _pairs() -> Iterator[tuple[str, str]]:
    return ((module, name) for module, names in IMPORTS.items() for name in names)


def test_the_core_knows_neither_the_window_nor_the_resources() -> None:
    wrong = ((m, n) for m, n in _pairs() if _top(m) == "sgb_core" and _top(n) in OURS)
    assert _offenders((m, n) for m, n in wrong if _top(n) != "sgb_core") == []


def test_qt_stays_in_the_window() -> None:
    assert _offenders((m, n) for m, n in _pairs() if _top(n) in QT and _top(m) != "app") == []


def test_only_the_scene_draws_in_three_dimensions() -> None:
    wrong = ((m, n) for m, n in _pairs() if _top(n) in THREE_D and not MAY_DRAW.match(m))
    assert _offenders(wrong) == []


def test_views_do_not_know_each_other() -> None:
    def wrong() -> Iterator[tuple[str, str]]:
        for module, name in _pairs():
            here, there = VIEWS.match(module), VIEWS.match(name)
            if here is not None and there is not None and here[0] != there[0]:
                yield module, name

    assert _offenders(wrong()) == []


def test_imports_run_down() -> None:
    assert _offenders(_upwards("sgb_core", PACKAGES)) == []
    assert _offenders(_upwards("app", ROOMS)) == []


def test_nobody_goes_round_by_the_front_door() -> None:
    doors = {"sgb_core", "app", "app.__main__"}
    assert _offenders((m, n) for m, n in _pairs() if n in doors and _top(m) == _top(n)) == []


def test_every_folder_is_a_room_with_its_place_and_its_docstring() -> None:
    for top, order in (("sgb_core", PACKAGES), ("app", ROOMS)):
        folders = {p.parent for p in (ROOT / top).rglob("*.py")} - {ROOT / top}
        rooms = {folder.relative_to(ROOT / top).parts[0] for folder in folders}
        assert rooms - {room for step in order for room in step} == set()
        for folder in folders:
            door = folder / "__init__.py"
            assert door.is_file(), folder
            assert ast.get_docstring(ast.parse(door.read_text(encoding="utf-8"))), door


def test_the_app_has_no_module_outside_its_rooms() -> None:
    assert {p.name for p in (ROOT / "app").glob("*.py")} == {"__init__.py", "__main__.py"}


def test_tests_mirror_the_tree() -> None:
    tests = ROOT / "tests"
    folders = {p.parent.relative_to(tests) for top in OURS for p in (tests / top).rglob("*.py")}
    assert {str(folder) for folder in folders if not (ROOT / folder).is_dir()} == set()


def test_values_are_made_by_what_makes_them_fast() -> None:
    """The standard decorator took a third of a short command; sgb_core.values says why."""
    wrong = {
        name
        for name, path in MODULES.items()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module == "dataclasses"
        if "dataclass" in {alias.name for alias in node.names}
    }
    assert wrong == {"sgb_core.values"}


def test_imports_have_no_cycle() -> None:
    graph = {m: {n for n in names if n in MODULES and n != m} for m, names in IMPORTS.items()}
    TopologicalSorter(graph).prepare()


def test_everything_imported_is_declared() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    wanted = project["dependencies"] + extras["cad"] + extras["video"]
    declared = {re.split(r"[^\w-]", line)[0].lower() for line in wanted}
    used = {_top(name) for _, name in _pairs()} - set(sys.stdlib_module_names) - set(OURS)
    assert {DISTRIBUTION.get(name, name) for name in used} <= declared


def test_the_core_loads_neither_qt_nor_vtk() -> None:
    """Also not through a third party: what is loaded is looked at from outside."""
    code = f"import {', '.join(m for m in MODULES if _top(m) == 'sgb_core')}, sys"
    done = subprocess.run(
        [sys.executable, "-c", f"{code}; print(*sys.modules)"],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert {_top(name) for name in done.stdout.split()}.isdisjoint(QT | THREE_D)


def test_no_file_is_too_long() -> None:
    lengths = {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for path in _modules(*OURS, "tests").values()
    }
    assert {name: n for name, n in lengths.items() if n > LONGEST_FILE} == {}


def test_no_function_is_too_long() -> None:
    lengths = {
        f"{module}.{node.name}": (node.end_lineno or 0) - node.lineno + 1
        for module, path in _modules(*OURS, "tests").items()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    }
    assert {name: n for name, n in lengths.items() if n > LONGEST_FUNCTION} == {}


def test_the_top_level_is_fixed() -> None:
    fixed = {"README.md", "app", "pyproject.toml", "resources", "sgb_core", "tests"}
    leftovers = {"__pycache__", "build", "dist"}
    seen = {p.name for p in ROOT.iterdir() if not p.name.startswith(".")} - leftovers
    assert seen == fixed


def test_no_file_names_a_machine() -> None:
    path_of_a_machine = re.compile(r"(?<![\w.])/(?:home|root|work|tmp|Users)/\w")
    kinds = {".py", ".md", ".toml", ".json", ".sgb", ".svg", ".css", ".qss", ""}
    wrong = [
        str(path.relative_to(ROOT))
        for top in (*OURS, "tests", ".ci")
        for path in (ROOT / top).rglob("*")
        if path.is_file()
        and path.suffix in kinds
        and "__pycache__" not in path.parts
        and path_of_a_machine.search(path.read_text(encoding="utf-8"))
    ]
    assert wrong == []
