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

# Before it: facets instead of a smooth surface, and relief that is no geometry yet.
LEAN = """  if (lookFlat > 0.5) {
    vec3 facet = normalize(cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz)));
    normalVCVSOutput = dot(facet, normalVCVSOutput) < 0.0 ? -facet : facet;
  }
LOOK_BUMP"""
# A picture is what the material is coloured by; the inside is a little quieter.
PAINT = """//VTK::Color::Impl
LOOK_PAINT  ambientColor *= painted;
  diffuseColor *= painted;
"""
OUTLINE = """  if (lookOutline > 0.0) {
    vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
    float facing = clamp(dot(normalVCVSOutput, toEye), 0.0, 1.0);
    float slope = facing / max(fwidth(facing), 0.0001);
    float shown = smoothstep(lookOutline - 0.5, lookOutline + 0.9, slope);
    fragOutput0.rgb = mix(lookInk, fragOutput0.rgb, shown);
  }
"""
# Relief that is no geometry yet leans the normal NORMAL by the slope of its heights, which stand
# in the picture's alpha: M. Mikkelsen, Bump Mapping Unparametrized Surfaces on the GPU (2010).
BUMP = """  if (lookDepth > 0.0 && lookMode < 0.5) {
    vec2 place = tcoordVCVSOutput;
    float here = texture(actortexture, place).a;
    float aside = texture(actortexture, place + dFdx(place)).a - here;
    float above = texture(actortexture, place + dFdy(place)).a - here;
    vec3 alongX = dFdx(vertexVC.xyz), alongY = dFdy(vertexVC.xyz);
    vec3 first = cross(alongY, NORMAL), second = cross(NORMAL, alongX);
    float area = dot(alongX, first);
    vec3 slope = lookDepth * sign(area) * (aside * first + above * second);
    // What is raised outside is sunk where the surface is seen from within.
    float side = dot(NORMAL, normalVCVSOutput) < 0.0 ? -1.0 : 1.0;
    NORMAL = normalize(abs(area) * NORMAL - side * slope);
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
    _replace(actor, {"//VTK::Normal::Dec": OPEN, "//VTK::Light::Impl": SKY})


def shade_look(actor: vtkActor, picture: str | None) -> None:
    """Add facets and the outline too, and a picture with its relief where there is one.

    ``picture`` is what tells the shader ``painted``, the colour there.

    The uniforms lookFlat, lookOutline, lookInk, lookDepth and lookMode say how.
    """
    pass_openness(actor)
    bump = BUMP.replace("NORMAL", "normalVCVSOutput") if picture else ""
    light = LEAN.replace("LOOK_BUMP", bump) + SKY + OUTLINE
    places = {"//VTK::Normal::Dec": OPEN, "//VTK::Light::Impl": light}
    if picture:
        # The texture is a colour of the material here, not of the light.
        places |= {
            "//VTK::Color::Impl": PAINT.replace("LOOK_PAINT", picture),
            "//VTK::TCoord::Impl": "\n",
        }
    _replace(actor, places)


def _replace(actor: vtkActor, places: dict[str, str]) -> None:
    for place, code in places.items():
        actor.GetShaderProperty().AddFragmentShaderReplacement(place, True, code, False)


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


def two_tone(
    front: vtkProperty,
    back: vtkProperty,
    net: vtkProperty,
    palette: Palette,
    *,
    white: bool = False,
) -> None:
    """Set the look of the outside, and of the inside: the same hue, quieter and darker.

    ``net`` is the look of the lines on the surface. What is ``white`` is coloured by a picture.
    """
    red, green, blue = rgb(palette.surface)
    tones = (1.0, 1.0, 1.0) if white else (red, green, blue)
    inside = (0.86 * tones[0], 0.90 * tones[1], 0.95 * tones[2])
    for prop, tone in ((front, tones), (back, inside)):
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
