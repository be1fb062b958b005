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
LAYERS = ("curves", "surfaces", "bodies", "design", "document", "exchange")
QT = {"PySide6", "shiboken6", "superqt", "pyvistaqt", "qtpy"}
THREE_D = {"vtk", "vtkmodules", "pyvista", "pyvistaqt"}
MAY_DRAW = re.compile(r"app\.(scene|viewport|figures|film)\.")
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


def _is_type_checking(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)


def _import_nodes(node: ast.AST) -> Iterator[ast.Import | ast.ImportFrom]:
    """Yield all imports that run, those inside functions too."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import | ast.ImportFrom):
            yield child
        elif not _is_type_checking(child):
            yield from _import_nodes(child)


def _imports(path: Path) -> set[str]:
    """Return the imported modules by full name: ours as far as they are modules."""
    names: set[str] = set()
    for node in _import_nodes(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
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


def _layer(name: str) -> int | None:
    parts = name.split(".")
    return LAYERS.index(parts[1]) if len(parts) > 1 and parts[1] in LAYERS else None


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
    views = {m for m in MODULES if re.match(r"app\.\w+_(view|panel|table|bar)$", m)}
    assert _offenders((m, n) for m, n in _pairs() if m in views and n in views) == []


def test_the_core_is_layered() -> None:
    def wrong() -> Iterator[tuple[str, str]]:
        for module, name in _pairs():
            if _top(module) != "sgb_core" or _top(name) != "sgb_core" or module == "sgb_core":
                continue
            low, high = _layer(name), _layer(module)
            # What lies under all layers (arrays) may import nothing above, and nobody the facade.
            if name == "sgb_core" or (low is not None and (high is None or low > high)):
                yield module, name

    assert _offenders(wrong()) == []


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
    assert {name: n for name, n in lengths.items() if n > 350} == {}


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
