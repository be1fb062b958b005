"""Meshes: the axis they turn about, and the section that most of the turn agrees on."""

from __future__ import annotations

import io
from typing import Any

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.fields.kinds import Said
from sgb_core.findings.finding import Finding
from sgb_core.findings.refusal import Argument
from sgb_core.findings.sources import NoSource, OutOfRound, TooMuch, Unreadable, Wall
from sgb_core.sources.errors import SourceError
from sgb_core.sources.mesh_axis import AxisLine, find_axis, surface_samples
from sgb_core.sources.mesh_section import section_of
from sgb_core.sources.mesh_slices import sliced
from sgb_core.sources.options import Options
from sgb_core.sources.reading import Half, Reading
from sgb_core.sources.threemf import read_threemf
from sgb_core.values import dataclass

_MOST_TRIANGLES = 5_000_000
_LETTERS = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_AXES = Said("auto, x, y, z or px,py,pz,dx,dy,dz")
# Of the radius: an object further out of round is worth a word.
_ROUND = 0.01


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Vertices (N, 3), triangles (M, 3), and how many millimetres the unit is, None: not said."""

    vertices: Floats
    faces: Ints
    millimetres: float | None


def read_mesh(mesh: Mesh, options: Options) -> Reading:
    """Return the profile of a mesh: (r, h) about its axis, outside only, foot to rim.

    The axis is the letter or the line given, else found; with a letter heights stay the file's,
    else the lowest point is h = 0. GLB is in metres, 3MF in its own unit, the others in the unit
    asked for. Raises SourceError for what turns about nothing.
    """
    vertices, faces = mesh.vertices, mesh.faces
    if mesh.millimetres is not None:
        vertices = vertices * (mesh.millimetres / options.unit.millimetres)
    points, normals = surface_samples(vertices, faces)
    lowest = False
    if isinstance(options.axis, str):
        axis = AxisLine(np.zeros(3), np.array(_LETTERS[options.axis]))
    elif isinstance(options.axis, tuple):
        direction = np.array(options.axis[3:])
        if not direction.any():
            raise SourceError(
                Argument("axis", options.axis, Said("a direction that is not 0, 0, 0"))
            )
        axis = AxisLine(np.array(options.axis[:3]), direction / np.linalg.norm(direction))
        lowest = True
    elif options.axis is None:
        axis = find_axis(points, normals)
        lowest = True
    else:
        raise SourceError(Argument("axis", options.axis, _AXES))
    section = section_of(sliced(vertices, faces, axis))
    line, unit = section.points, options.unit.value
    if lowest:
        line = line - np.array([0.0, float(line[:, 1].min())])
    notes: list[Finding] = []
    if section.rms > _ROUND * float(line[:, 0].max()):
        notes.append(OutOfRound(section.rms, section.largest, unit))
    if section.wall is not None:
        notes.append(Wall(*section.wall, unit))
    place = (*axis.point.tolist(), *axis.direction.tolist())
    return Reading(Half(line, closed=section.closed), None, place, None, tuple(notes))


def parse_mesh(kind: str, data: bytes) -> Mesh:
    """Return the mesh that a file of a kind holds; raises SourceError for what is none."""
    if kind == "3mf":
        vertices, faces, millimetres = read_threemf(data)
        unit: float | None = millimetres
    else:
        vertices, faces = _by_trimesh(kind, data)
        unit = 1000.0 if kind == "glb" else None
    if not len(faces):
        raise SourceError(NoSource.NO_TRIANGLES)
    if len(faces) > _MOST_TRIANGLES:
        raise SourceError(TooMuch("triangles", _MOST_TRIANGLES))
    if not np.isfinite(vertices).all():
        raise SourceError(NoSource.NOT_FINITE)
    if float(np.ptp(vertices, axis=0).max()) == 0.0:
        raise SourceError(NoSource.ONE_PLACE)
    return Mesh(vertices, faces, unit)


def _by_trimesh(kind: str, data: bytes) -> tuple[Floats, Ints]:
    # Imported late: it takes a while to load.
    import trimesh

    try:
        loaded: Any = trimesh.load(
            io.BytesIO(data),
            file_type=kind,
            # No file but the one opened is read.
            resolver=None,
            process=False,
            skip_materials=True,
        )
        mesh = loaded.to_mesh() if isinstance(loaded, trimesh.Scene) else loaded
        vertices = np.asarray(mesh.vertices, dtype=np.float64).reshape(-1, 3)
        # Vertices alone come as a cloud of points, which has none.
        faces = np.asarray(getattr(mesh, "faces", ()), dtype=np.int64).reshape(-1, 3)
    except MemoryError:
        raise
    except Exception as error:
        # Each loader raises what it likes on a damaged file.
        raise SourceError(Unreadable(f"{kind.upper()} mesh", str(error))) from None
    if len(faces) and (faces.min() < 0 or faces.max() >= len(vertices)):
        raise SourceError(NoSource.NO_CORNER)
    return vertices, faces
