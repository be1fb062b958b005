"""What window tests need between them."""

import gc
import sys

import pytest


@pytest.fixture(autouse=True)
def _no_wrappers_of_closed_windows():
    """Free closed viewports at once.

    A Python wrapper of a closed viewport's surface that outlives it would be taken for the
    next object that Qt makes at the same address, a menu's action say.
    """
    yield
    if "pyvistaqt" in sys.modules:
        gc.collect()
