"""What the system lacks for a window or a picture, said before Qt or OpenGL aborts over it.

Only Linux needs this: elsewhere the wheels and the system bring everything.
"""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Callable, Mapping
from glob import glob

from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.system import MissingPackages, NoScreen

# Library: Debian and Ubuntu package. What Qt's xcb plugin and the 3-D viewport load.
WINDOW_LIBRARIES: Mapping[str, str] = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libfontconfig.so.1": "libfontconfig1",
    "libdbus-1.so.3": "libdbus-1-3",
    "libX11-xcb.so.1": "libx11-xcb1",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
}
# What drawing off screen loads where there is no X server.
DRAWING_LIBRARIES: Mapping[str, str] = {"libEGL.so.1": "libegl1"}

DRIVER_PACKAGE = "libgl1-mesa-dri"
# Without a driver, EGL loads and then crashes. Mesa's drivers are files, others libraries.
_DRIVER_FILES = tuple(
    f"{folder}/{name}"
    for folder in ("/usr/lib/*", "/usr/lib", "/usr/lib64")
    for name in ("dri/*_dri.so", "dri/dri_gbm.so", "libgallium*.so")
)
_OTHER_DRIVERS = ("libEGL_nvidia.so.0",)


def check_drawing() -> None:
    """Raise FindingError where nothing can be drawn off screen here."""
    finding = drawing_finding()
    if finding is not None:
        raise FindingError(finding)


def window_finding() -> Finding | None:
    """Return why no window can open here, None where one can."""
    if not sys.platform.startswith("linux"):
        return None
    missing = missing_packages(WINDOW_LIBRARIES)
    if missing:
        return MissingPackages("the window", tuple(missing))
    platform = os.environ.get("QT_QPA_PLATFORM", "")
    if platform.partition(":")[0] in {"offscreen", "minimal", "vnc"}:
        return None
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return NoScreen.NO_DISPLAY
    return None


def drawing_finding() -> Finding | None:
    """Return why no picture can be drawn off screen here, None where one can."""
    if not sys.platform.startswith("linux"):
        return None
    missing = [] if os.environ.get("DISPLAY") else missing_packages(DRAWING_LIBRARIES)
    if not has_driver():
        missing.append(DRIVER_PACKAGE)
    return MissingPackages("drawing", tuple(missing)) if missing else None


def missing_packages(libraries: Mapping[str, str]) -> list[str]:
    """Return the packages of those libraries that cannot be loaded, in order."""
    return [package for library, package in libraries.items() if not _loads(library)]


def has_driver(found: Callable[[str], object] = glob) -> bool:
    """Return whether any OpenGL driver is installed.

    ``found`` says whether a file pattern matches anything on the disk.
    """
    folders = filter(None, os.environ.get("LIBGL_DRIVERS_PATH", "").split(":"))
    patterns = [f"{folder}/*_dri.so" for folder in folders]
    return any(map(found, (*patterns, *_DRIVER_FILES))) or any(map(_loads, _OTHER_DRIVERS))


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
