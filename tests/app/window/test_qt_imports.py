"""What the started program imports after Qt is not read through by Qt."""

import subprocess
import sys

CHECK = """
import linecache
from app.window.qt_imports import load_qt
{loaded}
import calendar
read = calendar.__file__ in linecache.cache
from PySide6.QtGui import *
from qtpy.QtCore import *
print(read, QPainter.__name__, QTimer.__name__)
"""


def answer(loaded):
    done = subprocess.run(
        [sys.executable, "-c", CHECK.format(loaded=loaded)],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    return done.stdout.split()


def test_no_source_is_read_and_star_imports_of_qt_have_all_classes():
    assert answer("load_qt()") == ["False", "QPainter", "QTimer"]


def test_qt_by_itself_reads_every_source():
    """Where this fails PySide6 has mended it, and load_qt can go."""
    assert answer("import PySide6.QtWidgets")[0] == "True"


def test_loading_twice_changes_nothing():
    assert answer("load_qt(); load_qt()") == ["False", "QPainter", "QTimer"]
