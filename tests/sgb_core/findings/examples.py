"""An example of every finding: segments and joints are number 40, nothing else is near it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from enum import Enum
from importlib import import_module
from pkgutil import iter_modules

import sgb_core.findings
from sgb_core.fields.kinds import Choice, Range
from sgb_core.findings import (
    bodies,
    cut_outs,
    drawings,
    edits,
    exports,
    fairing,
    files,
    joints,
    line,
    locks,
    pictures,
    plates,
    profile,
    refusal,
    relief,
    solving,
    sources,
    surfaces,
    system,
    toolpaths,
    tracing,
    typed,
)
from sgb_core.findings.finding import Finding

for _, _name, _ in iter_modules(sgb_core.findings.__path__):
    import_module(f"sgb_core.findings.{_name}")

SEGMENT = 40
PLACE = (12.5, 60.25)

GAP = joints.Gap(SEGMENT, SEGMENT + 1, 0.5)
BEYOND_AXIS = profile.BeyondAxis(SEGMENT, 0.25, 0.75)
CROSSING = profile.Crossing(SEGMENT, 0.25, SEGMENT, 0.75, PLACE)
TIGHT = bodies.TightCurve(PLACE, 3.0, SEGMENT, (0.25, 0.75))

# Those that name a segment or a joint, or count up to one.
COUNTING: tuple[Finding, ...] = (
    toolpaths.CrossesAxis(SEGMENT, 0.5),
    locks.Locked("point", None, "", points=((SEGMENT, 3),)),
    locks.Shared((locks.Locked("point", None, "", points=((SEGMENT, 3),)),), (("G1", 2),)),
    locks.LocksInTheWay((1,), (locks.Locked("point", None, "", points=((SEGMENT, 3),)),), True),
    toolpaths.FallingWall(SEGMENT, 7.5),
    GAP,
    BEYOND_AXIS,
    CROSSING,
    TIGHT,
    joints.UnmetRule(SEGMENT, SEGMENT + 1, "G1", "G0", 12.5),
    joints.UnmetRule(SEGMENT, SEGMENT + 1, "G1", "G0", 12.5, joints.Hindrance.UNTRIED_STILL_END),
    profile.Crossing(SEGMENT, 1.0, SEGMENT, 1.0, PLACE, touches=True),
    profile.SegmentIsPoint(SEGMENT, PLACE),
    profile.LegsWithoutLength((SEGMENT,)),
    joints.RuleMoves(
        SEGMENT,
        SEGMENT + 1,
        "G2",
        (
            joints.Moved(SEGMENT, "lambda3", 1.5, 0.25),
            joints.Moved(SEGMENT, "P2", (12.5, 60.25), (13.5, 60.5)),
        ),
    ),
    joints.RuleMoves(SEGMENT, SEGMENT + 1, "G2", ()),
    profile.TurnsBeyondAxis(SEGMENT, 0.5, 90.0),
    bodies.UnfitProfile(GAP),
    bodies.UnfitProfile(BEYOND_AXIS),
    bodies.UnfitProfile(CROSSING),
    bodies.AtAngle(TIGHT, 90.0),
    edits.NoSuch("segment", SEGMENT, 3),
    edits.NoSuch("joint", SEGMENT, 0),
    edits.NoSuchKey(SEGMENT, 3),
    edits.NoPlace(SEGMENT, 3),
    edits.BackwardRun(SEGMENT, SEGMENT),
    edits.LastSegment(SEGMENT),
    edits.NotJoined(SEGMENT, SEGMENT),
    edits.NoChord(SEGMENT),
    edits.PulledApart(SEGMENT, SEGMENT + 1),
    solving.Unreachable((solving.Nearest("capacity", 2.5, 1.5),), ((SEGMENT, "P2.h"),)),
    fairing.JointInTheWay(SEGMENT, SEGMENT + 1, "G1", 0.5),
    line.InFile("jar.sgb", TIGHT),
    files.NotReopened(TIGHT),
    files.Unwritten("jar.sgb", TIGHT),
    refusal.Apart(("profile", "joints", 7), "G1", (SEGMENT, 7), 0.5),
)

OTHERS: tuple[Finding, ...] = (
    profile.MoreCrossings(300),
    profile.OpposedParts(),
    surfaces.TooManyTriangles(3e7, 20_000_000),
    surfaces.TooFewAround(2, 3),
    bodies.EndCutSquare(PLACE, "rim"),
    bodies.RimTooShort(PLACE),
    bodies.SealedHollow(PLACE, 7.5),
    refusal.Refusal(("solid", "wall"), -5.0, Range(0.0, 9.0)),
    refusal.HalfCharacter(("name",)),
    refusal.Taken(("states", 2, "name"), "state"),
    refusal.SameAngle(("variation", 0, "keyframes"), 90.0),
    refusal.OpenRing(("profile", "closed"), 0.5),
    refusal.Argument("the factor", -1.0, Range(0.0, 9.0)),
    refusal.Unknown("unit", "m", Choice(("mm", "cm"))),
    bodies.LoosePart(PLACE),
    bodies.TouchingCircle(PLACE),
    bodies.Crumb(PLACE),
    bodies.WallOutOfReach(1e9, 0.5, 80.0),
    exports.NoFormat("jar.xyz", ".xyz", (".stl", ".obj")),
    exports.NoFormat("jar", "", (".stl", ".obj")),
    drawings.NoDrawingFormat("jar.xyz", (".svg", ".pdf")),
    drawings.DoesNotFit("1:1", "A4 portrait", (250.5, 300.5), (180.5, 250.5)),
    drawings.TooFine(1200.0, 545),
    drawings.TooManyPages(300, 200),
    exports.SinglePrecision(1e9, 32.0, 0.5),
    exports.SinglePrecision(1e39, None, None),
    bodies.WallBeyondEnds(3.0),
    bodies.NoCavity(3.0, None),
    bodies.NoCavity(3.0, 4.0),
    bodies.HoleTooWide(9.0),
    bodies.NoRoomForRing(3.0, 2.5),
    bodies.ChangingSection(90.0),
    bodies.BodyFailure("out of clay"),
    edits.Deviation(0.5, "mm"),
    edits.TooLarge(2.5, "mm", 80.0, 0.01),
    edits.NotOfSegment("legs", 7),
    edits.NotOfSegment("points", 7),
    edits.TwoRadii(2.5, 3.5),
    edits.TooMany("segments", 2000),
    edits.TooMany("pictures", 8),
    edits.TooMany("states", 100),
    edits.TooManyToFit(300, 20),
    edits.TooManyWaves(300, 100),
    edits.WrongPanelCount(576, 100),
    edits.OtherLength(3, 5),
    edits.NoState("jar"),
    edits.StateTaken("jar"),
    edits.StateNameLength(60),
    fairing.MeasureInTheWay("volume", 0.5),
    solving.Nearest("rim_diameter", 2.5, 1.5),
    line.Line("No space left on device"),
    files.IsTheProject("jar.sgb"),
    plates.NotNumbers("1, two"),
    plates.OtherVersion("0.0.9", "the program", "0.1.0"),
    files.NotText(7),
    files.NotJson(3, 5, "Expecting value"),
    files.TooDeep(64, ("solid", "wall")),
    files.TooManyBytes(33_554_432),
    files.TooManyValues(500_000),
    files.NotFinite(("solid", "wall"), "NaN"),
    files.GivenTwice(("solid", "wall")),
    files.HalfCharacterName(("material", "walls")),
    files.Unread("jar.sgb", "it is a folder"),
    pictures.LargePicture(4 << 20),
    pictures.ManyPixels(16_000_000),
    pictures.NoTexture("clay"),
    system.MissingPackages("drawing", ("libegl1",)),
    tracing.TooFewPoints(1),
    tracing.NoPoint(7),
    tracing.WithinTolerance(0.5),
    tracing.Scattered(2.5, 0.5),
    sources.Unreadable("SVG", "no element found: line 1, column 0"),
    sources.TooMuch("points", 1000),
    sources.TooLarge(200.0, 32.0),
    sources.NoNumbers(12, "Dear Sir"),
    sources.SeveralPaths(3),
    sources.NoUnit("mm"),
    sources.Wall(4.0, 0.25, "mm"),
    sources.OutOfRound(0.5, 2.0, "mm"),
    sources.PictureSize(30_000, 30_000, 20_000, 50_000_000),
    sources.TinyPicture(1, 1),
    toolpaths.BeyondPrinter("bead", 4.0, 0.3, 0.9, "Plastic", 5),
    toolpaths.BeyondBed((300.0, 300.0, 90.0), (220.0, 220.0, 250.0), "Plastic"),
    toolpaths.TooManyPoints(9_000_000, 5_000_000),
    toolpaths.Lean(3, 5, 1.5, 4.5, 0.75),
    toolpaths.HighLayer(2.0, 1.5),
    toolpaths.Floating(3.0),
    relief.ReliefPierces(4.0, 3.0),
    relief.ThinUnderRelief(0.5, 3.0),
    relief.ReliefMeets(2.0, 31.0),
    relief.ReliefHeldBack(0.75),
    relief.EdgeWidened(0.1, 0.25),
    typed.SaysNothing("dots", "layer", ("band", "text")),
    cut_outs.NoPatternWord("star", "shape", ("circle", "slot")),
    cut_outs.NoPatternValue("rows=two", "a number"),
    cut_outs.NoRoomForHoles(7, 12.0, 8.5),
    cut_outs.NoRoomForHoles(7, 12.0, -2.0),
    cut_outs.HolesTooNear(7, 2, 1.5, 2.0),
    cut_outs.HolesTooNear(7, 2, -1.5, 2.0),
    cut_outs.HoleTooLarge(7, 2, 40.0, 36.5),
    cut_outs.IslandsFallOut(7, 0.0),
    cut_outs.IslandsFallOut(7, 2.5),
    cut_outs.NothingToCut(7, True),
    cut_outs.NothingToCut(7, False),
    cut_outs.TooManyHoles(7, 90_000),
    locks.LockMissed(1, locks.Locked("height", 95.0, " mm"), 94.5),
)


def kinds(base: type[Finding] = Finding) -> Iterator[type[Finding]]:
    """Yield all findings, without the bases of more special ones."""
    for kind in base.__subclasses__():
        # Slots make a class anew; the one before it may still be there, without a name.
        if getattr(sys.modules[kind.__module__], kind.__name__, None) is not kind:
            continue
        if kind.__subclasses__():
            yield from kinds(kind)
        else:
            yield kind


def plain() -> Iterator[Finding]:
    """Yield the members of those that have nothing to count or to measure."""
    for kind in kinds():
        if issubclass(kind, Enum):
            yield from kind


EXAMPLES = (*COUNTING, *OTHERS, *plain())
