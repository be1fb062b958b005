"""The wheel: what it holds, and that it works away from the checkout."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
BUILD = "import sys; from hatchling.build import build_wheel; build_wheel(sys.argv[1])"


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel offline, with the backend alone."""
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run([sys.executable, "-c", BUILD, str(folder)], cwd=ROOT, check=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def unpacked(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


def _python(*arguments: str, site: Path, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=cwd,
        env={**os.environ, "PYTHONPATH": str(site)},
        capture_output=True,
        text=True,
    )


def test_the_wheel_holds_every_file_of_the_packages_and_nothing_else(unpacked: Path) -> None:
    def files(root: Path) -> set[str]:
        return {
            str(path.relative_to(root))
            for package in ("app", "sgb_core", "resources")
            for path in (root / package).rglob("*")
            if path.is_file() and "__pycache__" not in path.parts
        }

    assert files(unpacked) == files(ROOT)
    assert (unpacked / "sgb_core" / "py.typed").exists()
    top = {path.name for path in unpacked.iterdir() if not path.name.endswith(".dist-info")}
    assert top == {"app", "sgb_core", "resources"}


def test_the_wheel_installs_the_console_command(unpacked: Path) -> None:
    (entry,) = unpacked.glob("*.dist-info/entry_points.txt")
    assert "sgb-studio = app.__main__:main" in entry.read_text(encoding="utf-8")


def test_presets_are_reached_from_the_wheel(unpacked: Path, tmp_path: Path) -> None:
    code = "import resources; print(resources.__file__, len(resources.load_preset('vase')) > 0)"
    done = _python("-c", code, site=unpacked, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert str(unpacked) in done.stdout
    assert done.stdout.strip().endswith("True")


def test_the_command_line_works_from_the_wheel(unpacked: Path, tmp_path: Path) -> None:
    for arguments in (("new", "vase", "vase.sgb"), ("export", "vase.sgb", "vase.stl")):
        done = _python("-m", "app", *arguments, site=unpacked, cwd=tmp_path)
        assert done.returncode == 0, done.stderr
    assert (tmp_path / "vase.stl").stat().st_size > 84
