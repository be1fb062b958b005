"""The two colour schemes as plain values: one named colour per meaning. Knows no Qt."""

from __future__ import annotations

from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Palette:
    """Colours as #rrggbb. Text on its ground has a contrast of at least 4.5:1."""

    name: str
    window: str
    panel: str
    field: str
    border: str
    text: str
    text_muted: str
    accent: str
    accent_text: str
    error: str
    warning: str
    good: str
    viewport_top: str
    viewport_bottom: str
    canvas: str
    grid_minor: str
    grid_major: str
    axis: str
    surface: str
    generatrix: str
    polygon: str
    circle_p1: str
    circle_p2: str
    ghost: str
    selection: str
    quartic: str
    hover: str
    pressed: str
    groove: str
    selected: str
    text_disabled: str
    compare: str
    bend_out: str
    bend_in: str
    cut: str
    liquid: str


LIGHT = Palette(
    name="light",
    window="#eceeef",
    panel="#f7f8f8",
    field="#ffffff",
    border="#c9ced1",
    text="#1d2327",
    text_muted="#566068",
    accent="#1668b8",
    accent_text="#ffffff",
    error="#b3261e",
    warning="#8a5200",
    good="#1b6e3c",
    viewport_top="#fdfdfd",
    viewport_bottom="#dfe5e8",
    canvas="#fbfcfc",
    grid_minor="#e9edef",
    grid_major="#d3dade",
    axis="#7b868d",
    surface="#a9dfb0",
    generatrix="#c99a00",
    polygon="#1f5fd0",
    circle_p1="#c2255c",
    circle_p2="#6a3fb5",
    ghost="#c3ccd1",
    selection="#e8590c",
    quartic="#0b7285",
    hover="#e6ebee",
    pressed="#d6dee3",
    groove="#d5dbdf",
    selected="#e3eef9",
    text_disabled="#9aa3a9",
    compare="#7a4a00",
    bend_out="#0b7285",
    bend_in="#b0279a",
    cut="#c8683a",
    liquid="#3f8fd0",
)

DARK = Palette(
    name="dark",
    window="#1f2427",
    panel="#272d31",
    field="#1a1e21",
    border="#3d464c",
    text="#e9edef",
    text_muted="#a3afb6",
    accent="#5fb0f5",
    accent_text="#0c1820",
    error="#ff8a80",
    warning="#ffc266",
    good="#7fd69b",
    viewport_top="#3a4349",
    viewport_bottom="#1b2023",
    canvas="#1d2225",
    grid_minor="#262c30",
    grid_major="#353d43",
    axis="#8d99a1",
    surface="#8fce98",
    generatrix="#ffd54a",
    polygon="#6ea8ff",
    circle_p1="#ff7fa8",
    circle_p2="#c3a0ff",
    ghost="#4a545b",
    selection="#ff9a4d",
    quartic="#66d3e6",
    hover="#333b40",
    pressed="#404a50",
    groove="#434d54",
    selected="#25364a",
    text_disabled="#69747b",
    compare="#ffb86b",
    bend_out="#66d3e6",
    bend_in="#f58be0",
    cut="#e08a5c",
    liquid="#58a6e0",
)
