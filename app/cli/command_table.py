"""The commands of the command line, each in a line as help lists them."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

COMMANDS: Mapping[str, str] = MappingProxyType(
    {
        "presets": "list the presets, one a line",
        "new": "write a preset as a project file",
        "check": "say what a file holds, and warnings",
        "measure": "print volume, area, lengths, joints and more",
        "sample": "write points of the generatrix as CSV",
        "export": "write the body for other programs; the suffix decides",
        "render": "draw a picture, without a screen",
        "animate": "draw a film: the object turning, or a parameter changing",
        "figures": "make the paper's figures, with what was measured beside each",
        "plate": "make the figure that the project holds",
        "trace": "take a profile from a drawing, a table of points, a mesh or a picture",
        "fit": "fit the profile to a circle, an ellipse or a superellipse",
        "fair": "make the profile as fair as its joints' rules allow",
        "solve": "reach capacity, volume, material, mass, height and diameters together",
        "variants": "write variants that all keep the locks and the joints' rules",
        "toolpath": "write G-code: one continuous path straight from the exact surface",
        "printers": "list the printers, one a line",
        "drawing": "draw a dimensioned section, or a plate of vessels, on paper",
        "template": "draw the profile at true size, to be cut out as a rib or a gauge",
        "compare": "draw other curves on the same polygon beside it, with energies and deviations",
        "edit": "apply one edit and write the result",
    }
)
