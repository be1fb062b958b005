"""The ``plate`` section of a project file."""

from __future__ import annotations

from sgb_core.curves.segment import PARAMETER_RANGES
from sgb_core.document.file.fields import Fields, Node
from sgb_core.document.model import MAX_STATE_NAME
from sgb_core.document.plates import (
    MAX_DPI,
    MAX_PANELS,
    MAX_TITLE,
    MAX_VALUES,
    MAX_WIDTH,
    MIN_DPI,
    MIN_WIDTH,
    PlateCamera,
    PlatePart,
    PlateSettings,
    Projection,
    Variation,
)


def read_plate(node: Node) -> PlateSettings | None:
    """Return the ``plate`` section, None where there is none."""
    if not node.is_given or node.value is None:
        return None
    fields = node.object()
    default = PlateSettings()
    vary: tuple[Variation, ...] = ()
    if fields["vary"].is_given:
        items = fields["vary"].array("a list of at most 2 variations", 0, 2)
        vary = tuple(_variation(item.object()) for item in items)
    width, dpi, height = default.width_mm, default.dpi, default.panel_height_mm
    size = f"a number from {MIN_WIDTH:g} to {MAX_WIDTH:g}"
    if fields["width_mm"].is_given:
        width = fields["width_mm"].number(size, MIN_WIDTH, MAX_WIDTH)
    node = fields["panel_height_mm"]
    if node.is_given and node.value is not None:
        height = node.number(f"null or a number from 5 to {MAX_WIDTH:g}", 5.0, MAX_WIDTH)
    if fields["dpi"].is_given:
        allowed = f"a whole number from {MIN_DPI} to {MAX_DPI}"
        dpi = fields["dpi"].integer(allowed, MIN_DPI, MAX_DPI)
    columns = default.columns
    if fields["columns"].is_given:
        columns = fields["columns"].integer(f"a whole number from 0 to {MAX_PANELS}", 0, MAX_PANELS)
    return PlateSettings(
        vary,
        _states(fields["states"]),
        columns,
        fields["labels"].boolean(default.labels),
        fields["captions"].boolean(default.captions),
        _text(fields["title"], MAX_TITLE),
        _show(fields["show"]),
        width,
        height,
        dpi,
        fields["common_scale"].boolean(default.common_scale),
        _camera(fields["camera"].object()),
        fields.rest(),
    )


def plate_tree(plate: PlateSettings) -> dict[str, object]:
    """Return the ``plate`` section."""
    return {
        "vary": [
            {
                "parameter": each.parameter,
                "segment": "all" if each.segment is None else each.segment,
                "values": list(each.values),
                **each.extra,
            }
            for each in plate.vary
        ],
        "states": list(plate.states),
        "columns": plate.columns,
        "labels": plate.labels,
        "captions": plate.captions,
        "title": plate.title,
        "show": [str(part) for part in PlatePart if part in plate.show],
        "width_mm": plate.width_mm,
        "panel_height_mm": plate.panel_height_mm,
        "dpi": plate.dpi,
        "common_scale": plate.common_scale,
        "camera": {
            "azimuth_deg": plate.camera.azimuth_deg,
            "elevation_deg": plate.camera.elevation_deg,
            "projection": str(plate.camera.projection),
            **plate.camera.extra,
        },
        **plate.extra,
    }


def _variation(fields: Fields) -> Variation:
    name = fields["parameter"]
    parameter = next((each for each in PARAMETER_RANGES if each == name.value), None)
    if parameter is None:
        name.fail(", ".join(f'"{each}"' for each in PARAMETER_RANGES))
    low, high = PARAMETER_RANGES[parameter]
    items = fields["values"].array(f"a list of 1 to {MAX_VALUES} numbers", 1, MAX_VALUES)
    values = tuple(item.number(f"a number from {low:g} to {high:g}", low, high) for item in items)
    segment = None
    node = fields["segment"]
    if node.is_given and node.value != "all":
        segment = node.integer('"all" or a segment number', 0, 10**6)
    return Variation(parameter, values, segment, fields.rest())


def _states(node: Node) -> tuple[str, ...]:
    if not node.is_given:
        return ()
    items = node.array(f"a list of at most {MAX_PANELS} names of states", 0, MAX_PANELS)
    return tuple(_text(item, MAX_STATE_NAME) for item in items)


def _text(node: Node, most: int) -> str:
    text = node.text("")
    if len(text) > most:
        node.fail(f"a text of at most {most} characters")
    return text


def _show(node: Node) -> frozenset[PlatePart]:
    if not node.is_given:
        return PlateSettings().show
    return frozenset(item.choice(PlatePart) for item in node.array("a list of parts", 0, 8))


def _camera(fields: Fields) -> PlateCamera:
    default = PlateCamera()
    azimuth, elevation = default.azimuth_deg, default.elevation_deg
    if fields["azimuth_deg"].is_given:
        azimuth = fields["azimuth_deg"].number("a finite number")
    if fields["elevation_deg"].is_given:
        elevation = fields["elevation_deg"].number("a number from -90 to 90", -90.0, 90.0)
    projection = fields["projection"].choice(Projection, default.projection)
    return PlateCamera(azimuth, elevation, projection, fields.rest())
