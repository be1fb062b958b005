"""The bar that says which value has which colour, in the picture itself."""

from __future__ import annotations

from typing import Protocol

import numpy as np

# Imported for its side effect: it draws the letters.
import vtkmodules.vtkRenderingFreeType  # noqa: F401
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkTextActor, vtkTextProperty

from app.scene.actors import Array, Colour

# How much the ground of the letters covers what they lie over, where the picture is narrow.
_PLATE = 0.72


class Shown(Protocol):
    """What a bar shows: colours (k, 3) from 0 to 255 between two values, and their title."""

    title: str
    low: float
    high: float
    colours: Array | None


class ColourBar:
    """One bar at the left of the picture; hidden until :meth:`show`."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._table = vtkLookupTable()
        self.actor = vtkScalarBarActor()
        self.actor.SetLookupTable(self._table)
        self.actor.SetNumberOfLabels(5)
        self.actor.UnconstrainedFontSizeOn()
        self.actor.SetPosition(0.03, 0.06)
        self.actor.SetWidth(0.12)
        self.actor.SetHeight(0.46)
        self.actor.SetBarRatio(0.18)
        self.actor.SetLabelFormat("{:.3g}")
        self.actor.SetVisibility(False)
        # The bar's own title would be centred on the bar and cut off by the edge.
        self.title = vtkTextActor()
        self.title.SetTextScaleModeToNone()
        self.title.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        self.title.SetPosition(0.03, 0.54)
        self.title.SetVisibility(False)
        for text in self._texts:
            text.BoldOff()
            text.ItalicOff()
            text.ShadowOff()
        renderer.AddViewProp(self.actor)
        renderer.AddViewProp(self.title)
        self._key: tuple[object, ...] | None = None

    @property
    def _texts(self) -> tuple[vtkTextProperty, vtkTextProperty]:
        return self.title.GetTextProperty(), self.actor.GetLabelTextProperty()

    def show(self, shown: Shown) -> None:
        """Show what the colours mean."""
        assert shown.colours is not None
        self.actor.SetVisibility(True)
        self.title.SetVisibility(True)
        key = (shown.title, shown.low, shown.high, shown.colours.tobytes())
        if key == self._key:
            return
        self._key = key
        self._table.SetNumberOfTableValues(len(shown.colours))
        self._table.SetRange(shown.low, shown.high)
        for number, colour in enumerate(np.asarray(shown.colours, float) / 255.0):
            self._table.SetTableValue(number, *colour, 1.0)
        # The letters of VTK's own font know no Greek.
        spelt = shown.title.replace("ω", "omega").replace("λ", "lambda ")
        self.title.SetInput(spelt)

    def hide(self) -> None:
        """Show no bar."""
        self.actor.SetVisibility(False)
        self.title.SetVisibility(False)

    def style(self, ink: Colour, ground: Colour) -> None:
        """Set the colour of the letters, and of what keeps them apart from the object."""
        for text in self._texts:
            text.SetColor(ink)
            text.SetBackgroundColor(ground)
            text.SetBackgroundOpacity(_PLATE)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of the screen is."""
        self.title.GetTextProperty().SetFontSize(max(6, round(13 * ratio)))
        self.actor.GetLabelTextProperty().SetFontSize(max(6, round(12 * ratio)))
        self.actor.SetMaximumWidthInPixels(round(110 * ratio))
