"""The paper's figures: plates made from the data in ``resources/figures``, and what is measured.

Every panel is an ordinary document; where the printed paper is wrong, the data say so in a note.
"""

from __future__ import annotations

import json
from math import radians
from string import ascii_lowercase
from typing import Any

import numpy as np

import resources
from app.figures import paper_fits
from app.figures.paper_report import joints_line, measured, panel_record
from app.figures.plate import (
    BLACK,
    BLUE,
    CYCLE,
    GREY,
    TINT,
    VERMILION,
    WIDTHS,
    Array,
    Curve,
    CurvePanel,
    Panel,
    Plate,
    SurfacePanel,
)
from app.scene.camera import Pose
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.appearance.model import Appearance
from sgb_core.document.edits import head_to_tail, set_variation
from sgb_core.document.model import Document, Revolution
from sgb_core.fields.kinds import Range
from sgb_core.fields.record import table_of
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Unknown
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.variation import Law
from sgb_core.values import dataclass

NUMBERS = range(1, 15)
DASHES = ((), (5.0, 1.6), (3.0, 1.4), (5.0, 1.4, 1.2, 1.4), (1.2, 1.2))

Data = dict[str, Any]


@dataclass(frozen=True, slots=True)
class PaperFigure:
    """One figure: its plate, and the object that its JSON file holds."""

    number: int
    plate: Plate
    record: Data


def figure(number: int) -> PaperFigure:
    """Return figure ``number`` of the paper; raises ValueError unless it is 1 to 14."""
    if number not in NUMBERS:
        raise FindingError(Unknown("figure", number, Range(NUMBERS[0], NUMBERS[-1], whole=True)))
    data = json.loads(resources.read(f"figures/figure_{number:02d}.json"))
    make = {"families": _family, "fits": _fits, "surfaces": _surface}[data["kind"]]
    made = [make(data, k) for k in range(len(data["panels"]))]
    record = {"figure": number, "title": data["title"]}
    if "note" in data:
        record["note"] = data["note"]
    record["panels"] = [part for _, part in made]
    panels = tuple(panel for panel, _ in made)
    width = data.get("width_mm", WIDTHS["Two columns"])
    return PaperFigure(number, Plate(panels, data["columns"], _pose(data), width), record)


def panel_document(data: Data, entry: Data) -> Document:
    """Return the document of one set of parameters of a figure's data."""
    polygons = entry["segments"] if "segments" in entry else data["segments"]
    segments = []
    for corners, lambdas, omega in zip(polygons, entry["lambda"], entry["omega"], strict=True):
        lambda1, lambda2, lambda3 = lambdas
        shape = ShapeParameters(lambda1, lambda2, lambda3, omega)
        segments.append(Segment(np.array(corners, dtype=np.float64), shape))
    rules = [JointRule(rule) for rule in data.get("joints", ["G0"] * (len(segments) - 1))]
    turn = Revolution(Axis(data["axis"]), 0.0, float(entry.get("sweep_deg", 360.0)))
    document = Document(
        Profile.of(segments, rules),
        name=f"Figure {data['number']}",
        revolution=turn,
        appearance=table_of(Appearance).from_plain(entry.get("appearance", {}), ("appearance",)),
    )
    laws = [
        Law(law["parameter"], law["law"], law["from"], law["to"])
        for law in entry.get("variation", ())
    ]
    return set_variation(document, laws) if laws else document


def _pose(data: Data) -> Pose:
    view = data.get("view", {"up": "z", "azimuth_deg": 0.0, "elevation_deg": 0.0})
    turn, rise = radians(view["azimuth_deg"]), radians(view["elevation_deg"])
    nowhere = (0.0, 0.0, 0.0)
    return Pose(Axis(view["up"]), turn, rise, 1.0, nowhere, nowhere, parallel=True)


def _surface(data: Data, number: int) -> tuple[Panel, Data]:
    entry = data["panels"][number]
    label = ascii_lowercase[number]
    document = panel_document(data, entry)
    remark = ""
    outline: tuple[Array, ...] = ()
    facts = measured(document)
    if "target" in entry:
        target = paper_fits.target(entry["target"])
        if "fit" in entry:
            document = paper_fits.fitted_document(document, target)
            facts = measured(document)
        facts |= paper_fits.facts(document, target)
        remark = f"off by {paper_fits.percent(facts['relative'])} of the half axis"
        outline = (target.points(241),)
    elif data.get("tell_joints"):
        remark = joints_line(facts["joints"])
    # Halves that both run upwards have their outsides on different sides.
    apart = joined_head_to_tail(document.profile) is not None
    panel = SurfacePanel(
        head_to_tail(document) if apart else document,
        label,
        tuple(entry["caption"]),
        (remark,) if remark else (),
        frozenset(data["show"]),
        entry.get("tint", TINT),
        tuple((height, colour) for height, colour in entry.get("bands", ())),
        tuple(entry.get("stripes", ())),
        outline,
    )
    return panel, panel_record(label, document, facts)


def _family(data: Data, number: int) -> tuple[Panel, Data]:
    entry = data["panels"][number]
    label = ascii_lowercase[number]
    documents = [panel_document(data, member) for member in entry["family"]]
    corners = _upright(documents[0].profile.control_points[0], data["axis"])
    curves = [*_polygon(corners, GREY, ())]
    for place, (member, document) in enumerate(zip(entry["family"], documents, strict=True)):
        points = _upright(document.profile.sample(201)[0], data["axis"])
        curves.append(Curve(points, CYCLE[place], 1.3, DASHES[place % 5], name=member["name"]))
    record = panel_record(label, documents[0], {})
    record["vary"] = vary = entry["vary"]
    shapes = [document.profile.segments[0].shape for document in documents]
    record["values"] = [getattr(shape, vary) for shape in shapes]
    # One set of parameters for each curve of the family, in the order of the legend.
    record["lambda"] = [member["lambda"][0] for member in entry["family"]]
    record["omega"] = [member["omega"][0] for member in entry["family"]]
    record["measured"] = {
        "generatrix_length": [measured(document)["generatrix_length"] for document in documents]
    }
    caption = tuple(entry["caption"])
    panel = CurvePanel(tuple(curves), ("x", "y"), label, caption, legend="lower right")
    return panel, record


def _fits(data: Data, number: int) -> tuple[Panel, Data]:
    entry = data["panels"][number]
    label = ascii_lowercase[number]
    document = panel_document(data, entry)
    target = paper_fits.target(entry["target"])
    best = paper_fits.fitted_document(document, target)
    facts = measured(document) | paper_fits.facts(document, target)
    corners, free = (each.profile.control_points[0] for each in (document, best))
    centre = np.array([[0.0, target.centre]])
    # Named once; the panels beside it look the same.
    names = ("published", "free polygon", "target") if number == 0 else ("", "", "")
    curves = (
        *_polygon(corners, GREY, ()),
        *_polygon(free, BLUE, (1.5, 1.5)),
        Curve(centre, BLACK, mark="."),
        Curve(document.profile.sample(241)[0], VERMILION, 1.3, name=names[0]),
        Curve(best.profile.sample(241)[0], BLUE, 1.3, name=names[1]),
        Curve(target.points(241), BLACK, 1.0, (3.0, 2.0), name=names[2]),
    )
    bests = {name: paper_fits.percent(found["relative"]) for name, found in facts["best"].items()}
    remark = (
        f"published: off by {paper_fits.percent(facts['relative'])} of the half axis",
        f"best $\\omega$: {bests['omega']}, best $\\lambda$ and $\\omega$: {bests['shape']}",
        f"free polygon, smooth poles: {bests['polygon_smooth_poles']}",
        f"free polygon, any poles: {bests['polygon']}",
    )
    caption = tuple(entry["caption"])
    panel = CurvePanel(curves, ("x", "z"), label, caption, remark, legend=(0.07, 0.53))
    return panel, panel_record(label, document, facts)


def _polygon(corners: Array, colour: str, dashes: tuple[float, ...]) -> tuple[Curve, ...]:
    """Return a control polygon with its points marked as everywhere: P1 a star, P2 a ring."""
    return (
        Curve(corners, colour, 0.7, dashes),
        Curve(corners[[0, 3]], colour, mark="."),
        Curve(corners[1:2], colour, mark="*"),
        Curve(corners[2:3], colour, mark="o"),
    )


def _upright(points: Array, axis: str) -> Array:
    """Return (r, h) as (right, up): a profile about x lies, with its height to the right."""
    return points[:, ::-1] if axis == "x" else points
