"""How the surface takes the light: one key light, and a soft sky that costs no second one."""

from __future__ import annotations

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkActor, vtkProperty

from app.scene.actors import OPENNESS, rgb
from app.theme.palette import Palette

# What fragment shaders need to know how open a point lies to the light, and what is left of soft
# light there: what a hollow does not swallow it throws back, more of it the paler it is.
OPEN = """//VTK::Normal::Dec
in vec2 opennessVSOutput;
float openSide() { return gl_FrontFacing ? opennessVSOutput.x : opennessVSOutput.y; }
vec3 softLight(float open, vec3 albedo) {
  float least = 0.03 + 0.97 * open;
  return least / (1.0 - 0.85 * albedo * (1.0 - least));
}
"""

# Added after VTK's own lighting, in view coordinates (y up in the picture, z to the viewer): a
# sky that lights what faces up more than what faces down, and a rim that sets the outline off.
SKY = """//VTK::Light::Impl
  float sky = 0.5 + 0.5 * normalVCVSOutput.y;
  float away = 1.0 - clamp(normalVCVSOutput.z, 0.0, 1.0);
  float rim = away * away * away;
  vec3 soft = softLight(openSide(), diffuseColor);
  vec3 lit = fragOutput0.rgb * (0.4 + 0.6 * soft) + diffuseColor * (0.26 + 0.22 * sky) * soft;
  fragOutput0.rgb = lit * (1.0 - 0.22 * rim);
"""


def shade(actor: vtkActor) -> None:
    """Add the sky, the rim and the shade in hollows to a surface."""
    pass_openness(actor)
    shader = actor.GetShaderProperty()
    shader.AddFragmentShaderReplacement("//VTK::Normal::Dec", True, OPEN, False)
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, SKY, False)


def pass_openness(actor: vtkActor) -> None:
    """Let the fragment shader of an actor know the openness that its points are given."""
    actor.GetMapper().MapDataArrayToVertexAttribute(
        "opennessMC", OPENNESS, vtkDataObject.FIELD_ASSOCIATION_POINTS, -1
    )
    shader = actor.GetShaderProperty()
    for place, code in (
        ("//VTK::Normal::Dec", "in vec2 opennessMC;\nout vec2 opennessVSOutput;\n"),
        ("//VTK::Normal::Impl", "opennessVSOutput = opennessMC;\n"),
    ):
        shader.AddVertexShaderReplacement(place, True, f"{place}\n{code}", False)


def two_tone(front: vtkProperty, back: vtkProperty, net: vtkProperty, palette: Palette) -> None:
    """Set the look of the outside, and of the inside: the same hue, quieter and darker.

    ``net`` is the look of the lines on the surface.
    """
    red, green, blue = rgb(palette.surface)
    inside = (0.86 * red, 0.90 * green, 0.95 * blue)
    for prop, tone in ((front, (red, green, blue)), (back, inside)):
        prop.SetInterpolationToPhong()
        prop.SetColor(tone)
        prop.SetSpecularColor(1.0, 1.0, 1.0)
        prop.SetSpecularPower(42.0)
    front.SetAmbient(0.26)
    front.SetDiffuse(0.60)
    front.SetSpecular(0.22)
    back.SetAmbient(0.28)
    back.SetDiffuse(0.46)
    back.SetSpecular(0.03)
    net.LightingOff()
    net.SetColor(0.60 * red, 0.66 * green, 0.62 * blue)
    net.SetLineWidth(1.0)
