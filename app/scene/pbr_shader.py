"""The shader of the looks: physically based, lit by an environment made of a few formulas.

The environment stands upright with the object and turns with the viewer, as lamps do that a
photographer moves along. It is a sky over a ground and up to three soft boxes; rough surfaces
see it blurred by widening the boxes' edges. There is no picture to load, no pass to wait for, and
it costs a few dozen operations a pixel, so it runs under software rendering too.
"""

from __future__ import annotations

from app.scene.plain_shading import OPEN
from sgb_core.values import dataclass

Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Box:
    """A soft box: where it is (right, up, towards the viewer), half its sides, its light."""

    place: Triple
    width: float
    height: float
    light: Triple


@dataclass(frozen=True, slots=True)
class Light:
    """An environment: its colours above, at the horizon and below, and three boxes."""

    zenith: Triple
    horizon: Triple
    ground: Triple
    boxes: tuple[Box, Box, Box]


_OFF = Box((0.0, 1.0, 0.0), 0.1, 0.1, (0.0, 0.0, 0.0))
LIGHTS = {
    "studio": Light(
        (0.50, 0.52, 0.56),
        (0.34, 0.35, 0.37),
        (0.17, 0.16, 0.15),
        (
            Box((-0.75, 0.75, 0.75), 0.38, 0.55, (7.2, 7.0, 6.7)),
            Box((0.95, 0.25, 0.35), 0.16, 0.75, (3.2, 3.3, 3.5)),
            Box((-0.15, 0.55, -0.9), 0.8, 0.25, (2.2, 2.2, 2.2)),
        ),
    ),
    "daylight": Light(
        (0.36, 0.52, 0.82),
        (0.66, 0.72, 0.80),
        (0.26, 0.24, 0.19),
        (Box((0.6, 0.85, 0.65), 0.11, 0.11, (56.0, 51.0, 42.0)), _OFF, _OFF),
    ),
    "gallery": Light(
        (0.17, 0.15, 0.13),
        (0.22, 0.20, 0.18),
        (0.13, 0.11, 0.09),
        (
            Box((-0.45, 1.0, 0.6), 0.16, 0.16, (21.0, 18.5, 15.0)),
            Box((0.6, 0.9, 0.35), 0.14, 0.14, (13.0, 11.6, 9.6)),
            Box((0.0, 0.7, -0.9), 0.2, 0.2, (6.0, 5.6, 5.0)),
        ),
    ),
    "technical": Light(
        (0.80, 0.80, 0.80),
        (0.56, 0.56, 0.56),
        (0.28, 0.28, 0.28),
        (Box((-0.4, 0.5, 1.0), 0.9, 0.9, (1.3, 1.3, 1.3)), _OFF, _OFF),
    ),
}

DECLARATIONS = (
    OPEN
    + """
vec3 boxLight(vec3 d, vec3 place, vec2 sides, vec3 light, float blur) {
  vec3 w = normalize(place);
  vec3 u = normalize(cross(vec3(0.0, 1.0, 0.001), w));
  vec3 v = cross(w, u);
  float ahead = dot(d, w);
  vec2 p = abs(vec2(dot(d, u), dot(d, v))) / max(ahead, 0.05);
  vec2 soft = vec2(0.02 + 1.1 * blur);
  vec2 inside = 1.0 - smoothstep(sides - soft, sides + soft, p);
  // What is spread over more of the sky is weaker there.
  vec2 spread = min(vec2(1.0), sides / (0.55 * soft));
  return light * inside.x * inside.y * spread.x * spread.y * step(0.0, ahead);
}
vec3 skyLight(vec3 d, float blur) {
  float y = d.y;
  float k = 0.10 + blur;
  vec3 upper = mix(lookHorizon, lookZenith, smoothstep(0.0, 1.0, max(y, 0.0)));
  vec3 lower = lookGround * (0.7 + 1.8 * max(-y, 0.0));
  // Far walls are dark: polished things live by the contrast.
  float wall = (y - 0.06) / (0.10 + 1.5 * blur);
  float dark = 0.62 * exp(-wall * wall) / (1.0 + 8.0 * blur);
  return mix(lower, upper, smoothstep(-k, k, y)) * (1.0 - dark);
}
vec3 environment(vec3 d, float rough) {
  float blur = rough * rough;
  return skyLight(d, blur)
    + boxLight(d, lookPlace0, lookSides0, lookBox0, blur)
    + boxLight(d, lookPlace1, lookSides1, lookBox1, blur)
    + boxLight(d, lookPlace2, lookSides2, lookBox2, blur);
}
float solidAngle(vec2 sides) { return 4.0 * sides.x * sides.y / (1.0 + dot(sides, sides)); }
vec3 boxDiffuse(vec3 n, vec3 place, vec2 sides, vec3 light, float soft) {
  float facing = (dot(n, normalize(place)) + soft) / (1.0 + soft);
  return light * max(facing, 0.0) * solidAngle(sides) / 3.14159;
}
vec3 diffuseLight(vec3 n, float soft) {
  vec3 sky = mix(lookGround, mix(lookHorizon, lookZenith, 0.5), 0.5 + 0.5 * n.y);
  return sky
    + boxDiffuse(n, lookPlace0, lookSides0, lookBox0, soft)
    + boxDiffuse(n, lookPlace1, lookSides1, lookBox1, soft)
    + boxDiffuse(n, lookPlace2, lookSides2, lookBox2, soft);
}
// What a hollow leaves of a reflection: much of what comes straight back out of it.
vec3 reflected(float facing, float open, float rough, vec3 f) {
  float left = clamp(pow(facing + open, exp2(-16.0 * rough - 1.0)) - 1.0 + open, 0.0, 1.0);
  return softLight(left, f);
}
vec3 toLinear(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
"""
)

# Vectors in the frame of the environment: right in the picture, up along the object, towards the
# viewer. The camera never rolls, so right is level.
SHADE = """//VTK::Light::Impl
  vec3 lookRight = vec3(1.0, 0.0, 0.0);
  vec3 lookTop = normalize(normalMatrix * lookUp);
  vec3 lookFront = cross(lookRight, lookTop);
  vec3 normalLook = normalVCVSOutput;
  if (lookFlat > 0.5) {
    normalLook = normalize(cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz)));
  }
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  if (dot(normalLook, toEye) < 0.0) { normalLook = -normalLook; }
LOOK_BUMP  float facing = clamp(dot(normalLook, toEye), 0.0, 1.0);
  vec3 bounce = reflect(-toEye, normalLook);
  vec3 n = vec3(normalLook.x, dot(normalLook, lookTop), dot(normalLook, lookFront));
  vec3 r = vec3(bounce.x, dot(bounce, lookTop), dot(bounce, lookFront));
LOOK_PAINT  vec3 albedo = toLinear(painted);
  float open = mix(1.0, openSide(), lookHollow);
  vec3 shown;
  float solidness = lookOpacity;
  if (lookMode > 1.5) {
    // Zebra stripes: what a row of straight lamps would look like in a mirror.
    float phase = asin(clamp(r.y, -1.0, 1.0)) * 7.0;
    float width = max(fwidth(phase), 0.001);
    float stripe = smoothstep(-width, width, sin(phase));
    shown = vec3(mix(0.025, 0.90, stripe)) * (0.75 + 0.25 * facing);
  } else if (lookMode > 0.5) {
    // A map: its colours, with only so much light as shows the form.
    shown = albedo * (0.66 + 0.22 * n.y * (gl_FrontFacing ? 1.0 : 0.0) + 0.22 * facing);
  } else {
    float fresnel = pow(1.0 - facing, 5.0);
    float coatShare = lookCoat * (0.04 + 0.96 * fresnel);
    vec3 grain = albedo;
    // Glaze and soft bodies are deeper in colour where they are seen slantwise.
    grain *= mix(vec3(1.0), 0.55 + 0.45 * albedo, lookSoft * (1.0 - facing) * (1.0 - facing));
    vec3 base = grain * (1.0 - lookMetallic) * diffuseLight(n, lookSoft * 0.6);
    base *= softLight(open, albedo);
    vec3 f0 = mix(vec3(0.03), albedo, lookMetallic);
    vec3 f = f0 + (max(vec3(1.0 - lookRough), f0) - f0) * fresnel;
    // Polished metal has nothing but its reflection to be seen by. Under a full glaze the body's
    // own dull gloss is not seen, and what has no glaze reflects nothing from it.
    vec3 gloss = vec3(0.0);
    if (lookCoat < 0.6) {
      gloss = environment(r, lookRough) * f * mix(1.0 - lookRough, 1.9, lookMetallic);
      gloss *= reflected(facing, open, lookRough, f);
    }
    vec3 coat = vec3(0.0);
    if (lookCoat > 0.0) {
      coat = environment(r, lookCoatRough) * coatShare;
      coat *= reflected(facing, open, lookCoatRough, vec3(0.04));
    }
    shown = (base + gloss) * (1.0 - coatShare) + coat;
    solidness = lookOpacity + (1.0 - lookOpacity) * clamp(
      fresnel + dot(coat, vec3(0.33)) + 0.35 * pow(1.0 - facing, 2.0), 0.0, 1.0);
    // Bright light runs softly into white.
    shown = 1.2 * shown * (1.0 + shown / 9.0) / (1.0 + 0.9 * shown);
  }
  shown = pow(max(shown, vec3(0.0)), vec3(1.0 / 2.2));
  if (lookOutline > 0.0) {
    float slope = facing / max(fwidth(facing), 0.0001);
    shown = mix(lookInk, shown, smoothstep(lookOutline - 0.5, lookOutline + 0.9, slope));
  }
  fragOutput0 = vec4(shown, solidness);
"""
# What is seen slantwise is read twice along the way in which the picture is pressed together, up to
# twice as finely: OpenGL's own anisotropic filter does no more with two readings, and where the
# processor computes it that costs twice as much as all else.
TEXTURED = """  vec2 lookTexels = vec2(textureSize(actortexture, 0));
  vec2 lookAside = dFdx(tcoordVCVSOutput), lookAbove = dFdy(tcoordVCVSOutput);
  float lookWide = length(lookAside * lookTexels), lookHigh = length(lookAbove * lookTexels);
  float lookPressed = max(lookWide, lookHigh) / max(min(lookWide, lookHigh), 0.000001);
  float lookFiner = -min(1.0, log2(max(lookPressed, 1.0)));
  vec2 lookApart = (-0.25 * lookFiner) * (lookWide > lookHigh ? lookAside : lookAbove);
  vec3 painted = 0.5 * (
    texture(actortexture, tcoordVCVSOutput - lookApart, lookFiner).rgb
    + texture(actortexture, tcoordVCVSOutput + lookApart, lookFiner).rgb);
"""
# The inside has no colour of its own until the outside is seen too.
PAINTED = "  vec3 painted = max(diffuseColor, gl_FrontFacing ? vec3(0.0) : lookBase);\n"
