"""The CAD kernel: faces sewn into shells and solids. Loaded when a STEP file is written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.step.faces import TurnedFaces, Turning
from sgb_core.exchange.step.parts import StepPart
from sgb_core.exchange.step.topology import shell_of
from sgb_core.findings.exports import KernelFailure


@contextmanager
def kernel_errors() -> Iterator[None]:
    """Turn whatever the kernel raises, and its absence, into an ExportError."""
    try:
        yield
    except ImportError as error:
        raise ExportError(KernelFailure.MISSING) from error
    except Exception as error:
        # The kernel's exceptions have no base of their own.
        if not type(error).__module__.startswith("OCP"):
            raise
        raise ExportError(KernelFailure.SHAPE) from error


def kernel_shape(parts: Sequence[StepPart], turning: Turning) -> Any:
    """Return the kernel's shape: a solid or shell for each part, a compound where several.

    Raises ExportError where the kernel cannot build one, or what it built is not closed.
    """
    return together([_part_shape(part, turning) for part in parts])


def together(shapes: Sequence[Any]) -> Any:
    """Return one shape of the kernel as it is, several as a compound."""
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Compound

    if len(shapes) == 1:
        return shapes[0]
    builder, compound = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(compound)
    for shape in shapes:
        builder.Add(compound, shape)
    return compound


def _part_shape(part: StepPart, turning: Turning) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.TopoDS import TopoDS

    faces = TurnedFaces(part, turning)
    runs = [faces.run(number) for number in range(len(part.runs))]
    if not part.solid:
        return shell_of(runs[0], closed=False)
    if not turning.surface.is_full_turn:
        runs = [[face for run in runs for face in run] + faces.ends()]
    shells = [shell_of(run, closed=True) for run in runs]
    maker = BRepBuilderAPI_MakeSolid(outward(shells[0]))
    for inner in shells[1:]:
        maker.Add(TopoDS.Shell(outward(inner).Reversed()))
    solid = maker.Solid()
    if not BRepCheck_Analyzer(solid).IsValid():
        raise ExportError(KernelFailure.SHAPE)
    return solid


def outward(shell: Any) -> Any:
    """Return a closed shell whose faces look outward."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid
    from OCP.BRepLib import BRepLib
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    solid = BRepBuilderAPI_MakeSolid(shell).Solid()
    BRepLib.OrientClosedSolid_s(solid)
    explorer = TopExp_Explorer(solid, TopAbs_ShapeEnum.TopAbs_SHELL)
    return TopoDS.Shell(explorer.Current())
