"""The command line's frame: status, one line of complaint, what is imported, how it ends."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from app.__main__ import main
from app.cli import parser, preflight
from app.scene.standard_views import STANDARD_VIEWS
from app.state.overlays import Overlay
from sgb_core import exchange
from sgb_core.findings.system import NoScreen
from tests.app.cli.files import SPINDLE, write_project

ROOT = Path(__file__).resolve().parents[3]
FILE_COMMANDS = {
    "check": [],
    "measure": ["--json"],
    "sample": [],
    "export": ["OUT.stl"],
    "render": ["OUT.png"],
    "edit": ["OUT.sgb", "scale", "2"],
}


@pytest.fixture
def spindle(tmp_path):
    return write_project(tmp_path / "spindle.sgb")


def complaint(capsys) -> str:
    """Return the one line on standard error; nothing must be on standard output."""
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert err.endswith("\n")
    assert "Traceback" not in err
    assert err.startswith("sgb-studio")
    return err


@pytest.mark.parametrize("command", ["", *parser.COMMANDS, "edit a b set"])
def test_each_command_has_help(capsys, command):
    assert main([*command.split(), "--help"]) == 0
    assert capsys.readouterr().out.startswith("usage: sgb-studio")


def test_help_names_the_formats_there_are(capsys):
    main(["export", "--help"])
    # The help may break the line between two of them.
    assert " ".join(exchange.suffixes()) in " ".join(capsys.readouterr().out.split())


def test_version(capsys):
    assert main(["--version"]) == 0
    assert re.fullmatch(r"sgb-studio \S.*\n", capsys.readouterr().out)


@pytest.mark.parametrize(
    "typed",
    [
        "mesure a.sgb",
        "measure",
        "measure a.sgb b.sgb",
        "measure a.sgb --jason",
        "--nonsense",
        "new vase",
        "sample a.sgb --per-segment 1",
        "sample a.sgb --per-segment 2.5",
        "export a.sgb",
        "export a.sgb b.stl --tolerance 0",
        "export a.sgb b.stl --tolerance nan",
        "export a.sgb b.stl --tolerance inf",
        "export a.sgb b.stl --tolerance much",
        "export a.sgb b.stl --samples 8",
        "export a.sgb b.stl --samples 0 8",
        "export a.sgb b.stl --samples 8 8 --tolerance 1",
        "render a.sgb b.png --size 100",
        "render a.sgb b.png --size 0x100",
        "render a.sgb b.png --size 100x99999",
        "render a.sgb b.png --view inside",
        "render a.sgb b.png --show surface,ghosts",
        "edit a.sgb b.sgb",
        "edit a.sgb b.sgb polish 1",
        "edit a.sgb b.sgb set 0 lambda4 1",
        "edit a.sgb b.sgb set 0 omega",
        "edit a.sgb b.sgb set zero omega 1",
        "edit a.sgb b.sgb rule 0 G3",
        "edit a.sgb b.sgb scale big",
    ],
)
def test_wrong_usage_is_status_2_and_one_line(capsys, typed):
    assert main(typed.split()) == 2
    assert "--help" in complaint(capsys)


def test_a_misspelt_command_is_guessed(capsys):
    main(["mesure"])
    assert "'measure'" in complaint(capsys)


BROKEN = {
    "json": b'{"format": "sgb-document", ',
    "not text": b"\xff\xfe\x00",
    "empty": b"",
    "a list": b"[]",
    "a NaN": b'{"format": "sgb-document", "version": 1, "profile": {"segments": [{"points": '
    b"[[NaN, 0], [1, 0], [1, 1], [0, 1]]}]}}",
    "deep": b"[" * 100_000,
}


@pytest.mark.parametrize("kind", BROKEN)
@pytest.mark.parametrize("command", FILE_COMMANDS)
def test_broken_files_are_status_1_and_one_line(tmp_path, capsys, command, kind):
    path = tmp_path / "broken.sgb"
    path.write_bytes(BROKEN[kind])
    options = [o.replace("OUT", str(tmp_path / "out")) for o in FILE_COMMANDS[command]]
    assert main([command, str(path), *options]) == 1
    assert str(path) in complaint(capsys)
    assert [p.name for p in tmp_path.iterdir()] == ["broken.sgb"]


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"segments": []}, "profile.segments"),
        ({"segments": [{**SPINDLE[0], "omega": 2}]}, "profile.segments[0].omega"),
        ({"segments": [{**SPINDLE[0], "lambda": [1, 9, 1]}]}, "profile.segments[0].lambda[1]"),
        ({"segments": [{"points": [[0, 0]]}]}, "profile.segments[0].points"),
        ({"segments": SPINDLE[::-1]}, "profile.joints[0]"),
        ({"unit": "furlong"}, "unit"),
        ({"revolution": {"sweep_deg": 0}}, "revolution.sweep_deg"),
        ({"version": 99}, "version"),
        ({"format": "other"}, "format"),
    ],
)
def test_the_line_names_the_place(tmp_path, capsys, changes, place):
    path = write_project(tmp_path / "a.sgb", **changes)
    assert main(["check", path]) == 1
    assert place in complaint(capsys)


@pytest.mark.parametrize("command", FILE_COMMANDS)
def test_missing_files(tmp_path, capsys, command):
    missing = str(tmp_path / "no  such file.sgb")
    options = [o.replace("OUT", str(tmp_path / "out")) for o in FILE_COMMANDS[command]]
    assert main([command, missing, *options]) == 1
    assert missing in complaint(capsys)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "typed",
    [
        "export FILE DIR/none/a.stl",
        "export FILE DIR/a.xyz",
        "export FILE DIR/a",
        "edit FILE DIR/none/a.sgb scale 2",
        "sample FILE --out DIR/none/a.csv",
        "sample FILE --per-segment 999999999",
        "sample FILE --out FILE",
        "render FILE FILE",
        "render FILE DIR/a.jpg",
        "new nonsense DIR/a.sgb",
        "export FILE DIR/a.stl --tolerance 1e-300",
        "export FILE DIR/a.stl --samples 99999999 99999999",
        "edit FILE DIR/a.sgb set 2 omega 1",
        "edit FILE DIR/a.sgb set 0 omega 2",
        "edit FILE DIR/a.sgb set 0 omega nan",
        "edit FILE DIR/a.sgb split 0 1",
        "edit FILE DIR/a.sgb merge 1",
        "edit FILE DIR/a.sgb rule 5 G1",
        "edit FILE DIR/a.sgb open",
        "edit FILE DIR/a.sgb scale 0",
        "edit FILE DIR/a.sgb scale inf",
    ],
)
def test_what_cannot_be_done_is_status_1_and_leaves_nothing(tmp_path, capsys, spindle, typed):
    words = typed.replace("FILE", spindle).replace("DIR", str(tmp_path)).split()
    assert main(words) == 1
    complaint(capsys)
    assert [path.name for path in tmp_path.iterdir()] == ["spindle.sgb"]


def test_a_failed_command_keeps_the_old_output(tmp_path, capsys, spindle):
    before = Path(spindle).read_bytes()
    assert main(["edit", spindle, spindle, "set", "0", "omega", "7"]) == 1
    assert Path(spindle).read_bytes() == before
    assert "0 to 1" in complaint(capsys)


def test_a_file_name_opens_the_window_and_a_missing_one_says_so(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(preflight, "window_finding", lambda: NoScreen.NO_DISPLAY)
    assert main([]) == 1
    assert "there is no screen" in complaint(capsys)
    assert main([write_project(tmp_path / "pot.sgb")]) == 1
    assert "there is no screen" in complaint(capsys)
    assert main([str(tmp_path / "other.sgb")]) == 1
    assert "no such file" in complaint(capsys)
    assert main([str(tmp_path / "pot.sgb"), "more"]) == 2
    assert "'more'" in complaint(capsys)


def run(*words: str, code: str = "", **options) -> subprocess.CompletedProcess[str]:
    source = f"import sys\nfrom app.__main__ import main\nstatus = main({list(words)!r})\n{code}"
    return subprocess.run(
        [sys.executable, "-c", source + "\nsys.exit(status)"],
        capture_output=True,
        text=True,
        cwd=ROOT,
        encoding="utf-8",
        **options,
    )


def test_what_draws_nothing_imports_neither_qt_nor_vtk(tmp_path, spindle):
    out = str(tmp_path / "out")
    commands = [
        ["presets"],
        ["new", "vase", f"{out}.sgb"],
        ["check", spindle],
        ["measure", spindle, "--json"],
        ["sample", spindle],
        *(["export", spindle, out + suffix] for suffix in (".stl", ".glb", ".3mf")),
        ["edit", spindle, f"{out}.sgb", "split", "0", "0.5"],
    ]
    code = (
        f"statuses = [status, *map(main, {commands!r})]\n"
        "heavy = {'PySide6', 'shiboken6', 'vtk', 'vtkmodules', 'pyvista', 'pyvistaqt', "
        "'matplotlib', 'scipy', 'numpy.ma', 'difflib'}\n"
        "print('heavy:', sorted(heavy & set(sys.modules)), 'statuses:', set(statuses))"
    )
    done = run("--help", code=code)
    assert done.stdout.splitlines()[-1] == "heavy: [] statuses: {0}", done.stderr
    assert done.stderr == ""


def printed(code):
    """Return what code prints in a program of its own."""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True
    )
    return done.stdout


def test_the_frame_of_the_window_needs_neither_the_core_nor_numpy():
    code = """
import sys
from app.cli import parser
import app.window.program

print(sorted(name for name in sys.modules if name.partition(".")[0] in HEAVY or name in UNASKED))
"""
    heavy = {"numpy", "scipy", "shapely", "matplotlib", "pyvista", "pyvistaqt", "vtkmodules"}
    unasked = {"sgb_core.curves", "sgb_core.document.model", "app.state.presenter"}
    assert printed(f"HEAVY, UNASKED = {heavy!r}, {unasked!r}\n{code}") == "[]\n"


def test_the_window_loads_no_dialog_before_it_is_wanted():
    code = """
import sys
from app.window import all_commands, menus, status_bar
from app.start import welcome
from app.export import exporter

print([name for name in UNASKED if name in sys.modules])
"""
    unasked = ("sgb_core.sources", "app.intake.sheet", "app.printing.dialog")
    assert printed(f"UNASKED = {unasked!r}\n{code}") == "[]\n"


def test_help_and_usage_errors_do_not_even_import_numpy():
    done = run("measure", code="assert 'numpy' not in sys.modules")
    assert done.returncode == 2, done.stderr


def test_a_reader_that_stops_early_is_no_fault(spindle):
    code = f"{sys.executable} -m app sample {spindle} --per-segment 200000 | head -1"
    done = subprocess.run(
        ["/bin/sh", "-c", code], capture_output=True, text=True, cwd=ROOT, check=True
    )
    assert done.stdout == "segment,s,r,h\n"
    assert done.stderr == ""


def test_an_interrupt_is_quiet(monkeypatch, capsys, spindle):
    def interrupted(*_):
        raise KeyboardInterrupt

    from app.cli import commands

    monkeypatch.setattr(commands, "check", interrupted)
    assert main(["check", spindle]) == 130
    assert capsys.readouterr() == ("", "")


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs a device that is always full")
def test_a_full_disk_is_one_line(spindle):
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "app", "measure", spindle],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            cwd=ROOT,
        )
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1
    assert "space" in done.stderr


def test_a_terminal_without_greek_letters(spindle):
    done = subprocess.run(
        [sys.executable, "-m", "app", "measure", spindle],
        capture_output=True,
        cwd=ROOT,
        env={**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"},
    )
    assert done.returncode == 0
    assert done.stderr == b""
    assert b"volume" in done.stdout


def test_the_words_of_render_are_those_of_the_window():
    for command, target in (("render", "a.png"), ("animate", "a.gif")):
        for name in STANDARD_VIEWS:
            words = [command, "a.sgb", target, "--view", name, "--show", ",".join(Overlay)]
            options = parser.build_parser().parse_args(words)
            assert (options.view, options.show) == (name, frozenset(Overlay))
