"""How the object looks: material, light, texture, drawing and maps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QToolButton, QVBoxLayout, QWidget

import resources
from app.panels.look.form import LookForm, show_choice
from app.panels.look.layers import DrawingPart
from app.panels.look.swatches import look_swatch, material_swatch
from app.panels.look.texture import TexturePart
from app.state.presenter import Frame, Presenter
from app.theme import icons, theme
from app.widgets.number_field import NumberField
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.segment import PARAMETERS, SYMBOLS
from sgb_core.document.appearance.colour_maps import TITLES, map_limits
from sgb_core.document.appearance.finishes import FINISHES, base_color
from sgb_core.document.appearance.model import (
    PLAIN,
    Appearance,
    Background,
    ColourMap,
    Lighting,
    MapKind,
    MaterialName,
    Scale,
    Shading,
)
from sgb_core.document.edits import apply_look

LIGHTS = {
    Lighting.STUDIO: "Studio",
    Lighting.DAYLIGHT: "Daylight",
    Lighting.GALLERY: "Gallery",
    Lighting.TECHNICAL: "Technical",
}
GROUNDS = {
    Background.THEME: "Like the theme",
    Background.WHITE: "White",
    Background.DARK: "Dark",
    Background.GRADIENT: "Gradient",
    Background.TRANSPARENT: "Transparent in pictures",
}
SCALES = {
    Scale.AUTO: "Automatic",
    Scale.VIRIDIS: "Viridis",
    Scale.CIVIDIS: "Cividis",
    Scale.INFERNO: "Inferno",
    Scale.DIVERGING: "Blue to orange",
}


class LookPanel(QWidget):
    """Everything that changes the look and nothing of the form."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.material = MaterialPart(presenter, self)
        self.texture = TexturePart(presenter, self)
        self.drawing = DrawingPart(presenter, self)
        self.map = MapPart(presenter, self)
        self._parts = (self.material, self.texture, self.drawing, self.map)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 8, 10)
        layout.setSpacing(8)
        for part in self._parts:
            layout.addWidget(part)
        self.plain = QToolButton(self)
        self.plain.setText("Plain look")
        self.plain.setToolTip("Take everything off: light green clay, as at first")
        self.plain.setProperty("segment", "only")
        self.plain.clicked.connect(lambda: self.material.do("Plain look", _plain))
        layout.addWidget(self.plain)
        layout.addStretch(1)

    def refresh(self, frame: Frame) -> None:
        """Show the appearance of the document."""
        for part in self._parts:
            part.refresh(frame)


class MaterialPart(LookForm):
    """Material, colour, light, ground and edges."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, "Material and light", parent)
        ready = [("Choose…", None), *((look.title, look.appearance) for look in resources.looks())]
        self.ready = self.combo(
            "Ready-made",
            ready,
            self._take_ready,
            "Sets everything below to a look made before",
            look_swatch,
        )
        materials = [(FINISHES[name].title, name) for name in MaterialName]
        self.material = self.combo(
            "Material",
            materials,
            lambda v: self.do("Material", lambda look: replace(look, material=v)),
            "What it is made of",
            lambda name: material_swatch(FINISHES[name]),
        )
        self.colour_button = self.colour("Colour", lambda look, value: replace(look, color=value))
        self.own = QToolButton(self)
        self.own.setText("The material's own")
        self.own.setToolTip("Take the colour that the material has by itself")
        self.own.setProperty("segment", "only")
        icons.bind(self.own, "reset")
        for button in (self.own, self.colour_button):
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.own.clicked.connect(
            lambda: self.do("Colour of the material", lambda look: replace(look, color=None))
        )
        self.form.addRow("", self.own)
        self.lighting = self.combo(
            "Light",
            _entries(LIGHTS),
            lambda v: self.do("Light", lambda look: replace(look, lighting=v)),
            "Where it comes from",
        )
        self.background = self.combo(
            "Background",
            _entries(GROUNDS),
            lambda v: self.do("Background", lambda look: replace(look, background=v)),
            "What is behind the object",
        )
        self.shadow = self.check(
            "Shadow on the ground",
            lambda look, on: replace(look, shadow=on),
            "A soft shadow where it stands",
        )
        self.silhouette = self.check(
            "Outline",
            lambda look, on: replace(look, silhouette=on),
            "A dark line around what is seen",
        )
        self.features = self.check(
            "Edges", lambda look, on: replace(look, features=on), "Lines at rims, ends and kinks"
        )
        self.flat = QCheckBox("Flat facets", self)
        self.flat.setToolTip("Show the facets of the mesh instead of a smooth surface")
        self.flat.clicked.connect(self._set_flat)
        self.form.addRow("", self.flat)

    def _set_flat(self, flat: bool) -> None:
        shading = Shading.FLAT if flat else Shading.SMOOTH
        self.do("Flat facets", lambda look: replace(look, shading=shading))

    def _take_ready(self, section: dict[str, object] | None) -> None:
        show_choice(self.ready, None)
        if section is not None:
            self.presenter.do("Ready-made look", lambda document: apply_look(document, section))

    def refresh(self, frame: Frame) -> None:
        """Show material, light and ground."""
        look = frame.document.appearance
        show_choice(self.material, look.material)
        show_choice(self.lighting, look.lighting)
        show_choice(self.background, look.background)
        theirs = look.color is None and look.material is MaterialName.CLAY
        colour = theme.current().surface if theirs else base_color(look)
        self.colour_button.set_colour(colour)
        self.colour_button.setText(colour)
        self.own.setEnabled(look.color is not None)
        self.shadow.setChecked(look.shadow)
        self.silhouette.setChecked(look.silhouette)
        self.features.setChecked(look.features)
        self.flat.setChecked(look.shading is Shading.FLAT)


class MapPart(LookForm):
    """Which quantity colours the surface, in which colours, between which limits."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, "Map", parent)
        kinds = [("None", None), *((TITLES[kind][0], kind) for kind in MapKind)]
        self.of = self.combo("Shows", kinds, self._choose, "Colours the surface by a quantity")
        self.parameter = self.combo(
            "Parameter",
            [(SYMBOLS[name], name) for name in PARAMETERS],
            lambda v: self.do("Parameter", lambda look: _map(look, parameter=v)),
            "Whose influence is shown: how far each point moves per unit of it",
        )
        self.scale = self.combo(
            "Colours",
            _entries(SCALES),
            lambda v: self.do("Colours of the map", lambda look: _map(look, scale=v)),
            "Evenly spaced to the eye and safe for the colour-blind",
        )
        self.auto = QCheckBox("Limits from the values", self)
        self.auto.setToolTip("Off: set the lowest and the highest value by hand")
        self.auto.clicked.connect(self._set_automatic)
        self.form.addRow("", self.auto)
        self.low = self._limit("Lowest", "low", "Value of the first colour", 0)
        self.high = self._limit("Highest", "high", "Value of the last colour", 1)

    def _limit(self, title: str, name: str, tip: str, end: int) -> NumberField:
        return self.number(
            title,
            lambda look, v: _map(look, **{name: v}),
            tip,
            reset=lambda: self._found[end],
            span=lambda: self._found,
            step=0.1,
        )

    def refresh(self, frame: Frame) -> None:
        """Show the map and its limits."""
        shown = frame.document.appearance.map
        show_choice(self.of, None if shown is None else shown.of)
        coloured = shown is not None and shown.of is not MapKind.ZEBRA
        by_hand = shown is not None and (shown.low is not None or shown.high is not None)
        for part, visible in (
            (self.parameter, shown is not None and shown.of is MapKind.INFLUENCE),
            (self.scale, coloured),
            (self.auto, coloured),
            (self.low, coloured and by_hand),
            (self.high, coloured and by_hand),
        ):
            self.form.setRowVisible(part, visible)
        if shown is None:
            return
        show_choice(self.parameter, shown.parameter)
        show_choice(self.scale, shown.scale)
        self.auto.setChecked(not by_hand)
        if shown.low is not None:
            self.low.set_value(shown.low)
        if shown.high is not None:
            self.high.set_value(shown.high)

    def _choose(self, kind: MapKind | None) -> None:
        old = self.appearance.map
        shown = None
        if kind is not None:
            # Limits belong to the quantity.
            shown = replace(old or ColourMap(kind), of=kind, low=None, high=None)
        self.do("Map", lambda look: replace(look, map=shown))
        bare = self.presenter.document.solid.kind is BodyKind.SURFACE
        if kind is MapKind.THICKNESS and bare:
            self.presenter.notify(
                "A bare surface has no wall; make it a vessel in the panel Solid", "info"
            )

    def _set_automatic(self, automatic: bool) -> None:
        low, high = (None, None) if automatic else self._found
        label = "Limits from the values" if automatic else "Limits by hand"
        self.do(label, lambda look: _map(look, low=low, high=high))

    @property
    def _found(self) -> tuple[float, float]:
        """The limits that the values themselves have; (0, 1) without a map."""
        document, shown = self.presenter.document, self.appearance.map
        if shown is None:
            return 0.0, 1.0
        shown = replace(shown, low=None, high=None)
        low, high = map_limits(document.surface, shown, document.solid)
        return float(f"{low:.3g}"), float(f"{high:.3g}")


def _entries(words: Mapping[Any, str]) -> list[tuple[str, Any]]:
    return [(text, value) for value, text in words.items()]


def _plain(look: Appearance) -> Appearance:
    """Return the plain look, with what a newer program has put into this one."""
    return replace(PLAIN, extra=look.extra)


def _map(look: Appearance, **changes: Any) -> Appearance:
    return look if look.map is None else replace(look, map=replace(look.map, **changes))
