"""How a document's appearance is drawn: shader, paint, shadow, lines and ground of the scene.

Clay in the studio has a quick shader of its own, whatever is painted on it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any
from weakref import WeakKeyDictionary

from vtkmodules.vtkRenderingCore import vtkActor, vtkProperty, vtkRenderer

from app.scene.actors import Colour, LinePart, SurfacePart, rgb
from app.scene.ambient_occlusion import AmbientLight, Subject
from app.scene.body import BodyScene
from app.scene.coats import BodyCoat, MapCoat, PaintCoat, needs_picture
from app.scene.colour_bar import ColourBar
from app.scene.ground import Ground, feature_lines, upward
from app.scene.pbr_shader import DECLARATIONS, LIGHTS, PAINTED, SHADE, TEXTURED
from app.scene.plain_shading import BUMP, pass_openness, shade_look, two_tone
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.bodies.solid import BodyKind
from sgb_core.document.appearance.finishes import FINISHES, base_color
from sgb_core.document.appearance.model import (
    PLAIN,
    Appearance,
    Background,
    Lighting,
    MapKind,
    MaterialName,
    Shading,
)
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.body_state import BodyState
from sgb_core.document.evaluation import Evaluation

_QUICK, _WITH_PICTURE = ("plain", "painted"), ("painted", "textured")
_LIT, _MAP, _ZEBRA = 0.0, 1.0, 2.0
# Width of the silhouette in pixels of the screen.
_OUTLINE = 1.6
_INK, _CHALK = (0.10, 0.11, 0.12), (0.93, 0.94, 0.95)


def is_quick(appearance: Appearance) -> bool:
    """Whether the surface is drawn by the quick shader; its colour and paint may be any."""
    return (
        appearance.material is MaterialName.CLAY
        and appearance.lighting is Lighting.STUDIO
        and appearance.map is None
    )


class SceneLook:
    """Dresses the surfaces of one scene; ``reach`` is how far its shadow goes, in radii."""

    def __init__(
        self, renderer: vtkRenderer, front: vtkProperty, back: vtkProperty, net: vtkProperty
    ) -> None:
        self._renderer = renderer
        self._properties = (front, back, net)
        self._palette: Palette | None = None
        self._pixel_ratio = 1.0
        self._evaluation: Evaluation | None = None
        self._appearance = PLAIN
        self._pictured = False
        # Which shader each actor has.
        self._shaders: WeakKeyDictionary[vtkActor, str] = WeakKeyDictionary()
        self._told: WeakKeyDictionary[vtkActor, tuple[Any, ...]] = WeakKeyDictionary()
        self._paint, self._map, self._body = PaintCoat(), MapCoat(), BodyCoat()
        # The actors of a body whose relief is geometry.
        self._displaced: set[vtkActor] = set()
        self.ambient = AmbientLight()
        self.ground = Ground(renderer)
        self.features = LinePart(lift=5.0)
        renderer.AddActor(self.features.actor)
        self.bar = ColourBar(renderer)
        self.reach = 1.0

    def update(
        self,
        evaluation: Evaluation,
        level: SurfacePart,
        fine: bool,
        hurried: bool = False,
        *,
        painted: bool = True,
    ) -> None:
        """Show the appearance of a document on a level of its surface.

        ``hurried`` says that the picture is not fine and that drawing it is what costs. Not
        ``painted`` it has no pictures: what says a value by its colour is to be seen.
        """
        appearance = evaluation.document.appearance
        pictured = painted and appearance.map is None and needs_picture(appearance)
        changed = appearance != self._appearance or pictured != self._pictured
        self._pictured = pictured
        reshaped = evaluation is not self._evaluation
        self._evaluation, self._appearance = evaluation, appearance
        if changed:
            self._set_colours()
        if reshaped and appearance.features:
            self.features.write(feature_lines(evaluation))
        self.features.show(appearance.features)
        self._dress(level, evaluation, fine, hurried)

    def set_palette(self, palette: Palette) -> None:
        """Take the theme's colours where the appearance has none of its own."""
        self._palette = palette
        self._set_colours()

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        self._pixel_ratio = ratio
        self.features.set_width(2.0 * ratio)
        self.bar.set_pixel_ratio(ratio)
        self._set_uniforms()

    def _dress(self, level: SurfacePart, evaluation: Evaluation, fine: bool, hurried: bool) -> None:
        """Give a level the shader, the texture and the coordinates of its appearance."""
        appearance, actor = self._appearance, level.actor
        shown = appearance.map
        coat, kind = None, "plain" if is_quick(appearance) else "coloured"
        if shown is not None and shown.of is not MapKind.ZEBRA:
            self._map.write(level, evaluation, shown)
            coat, kind = self._map.texture, "textured"
            self.bar.show(self._map)
        else:
            self.bar.hide()
            if self._pictured:
                self._paint.write(level, evaluation, fine, hurried)
                coat = self._paint.texture
                kind = "painted" if is_quick(appearance) else "textured"
        actor.SetTexture(coat)
        self._use(actor, kind)
        self._set_uniforms()

    def fine_work(
        self, evaluation: Evaluation, view: ViewState, body: BodyState | None
    ) -> list[Callable[[], None]]:
        """Return what to run aside before a fine update, so that it is quick."""
        appearance = evaluation.document.appearance
        work = [self.ambient.fine_work(_subject(evaluation, view, body))]
        if appearance.map is None and needs_picture(appearance):
            work.append(self._paint.fine_work(evaluation))
        return [each for each in work if each is not None]

    def shade(
        self,
        evaluation: Evaluation,
        level: SurfacePart,
        solid: BodyScene,
        view: ViewState,
        fine: bool,
    ) -> None:
        """Darken the hollows of what is shown, and the ground below it."""
        self.ambient.take(_subject(evaluation, view, solid.state), fine)
        if solid.replaces_surface and solid.state is not None:
            self.ambient.lay_on_body(solid.state, solid.body_actors[0].GetMapper().GetInput())
        else:
            # What says a value by its colour keeps it.
            self.ambient.lay_on_level(level, even=view.influence is not None)
        ground = self.ambient.ground(evaluation.surface)
        if ground is not None:
            self.ground.write(evaluation.surface, ground)
        self.ground.show(ground is not None)

    def dress_solid(self, solid: BodyScene, level: SurfacePart) -> None:
        """Give the body, and what a cut leaves of a bare surface, the look of the level."""
        kind = self._shaders[level.actor]
        actors = [solid.second_of(level.actor)]
        if solid.replaces_surface and solid.state is not None:
            actors += solid.body_actors
            if kind in _WITH_PICTURE:
                mapped = self._appearance.map is not None
                self._body.write(
                    solid.state, level, solid.body_actors[0], mapped, self._paint.parts
                )
        self._displaced = set(solid.body_actors) if _is_displaced(solid.state) else set()
        for actor in actors:
            actor.SetTexture(level.actor.GetTexture())
            self._use(actor, kind)
        self._set_uniforms()

    # Shaders.

    def _use(self, actor: vtkActor, kind: str) -> None:
        if self._shaders.get(actor) == kind:
            return
        self._shaders[actor] = kind
        self._told.pop(actor, None)
        shader = actor.GetShaderProperty()
        shader.ClearAllFragmentShaderReplacements()
        if kind in _QUICK:
            shade_look(actor, TEXTURED if kind == "painted" else None)
            return
        pass_openness(actor)
        textured = kind == "textured"
        bump = BUMP.replace("NORMAL", "normalLook") if textured else ""
        shading = SHADE.replace("LOOK_PAINT", TEXTURED if textured else PAINTED)
        for place, code in (
            ("//VTK::Normal::Dec", DECLARATIONS),
            ("//VTK::Light::Impl", shading.replace("LOOK_BUMP", bump)),
            # The texture is a colour of the material here, not of the light.
            ("//VTK::TCoord::Impl", "\n"),
        ):
            shader.AddFragmentShaderReplacement(place, True, code, False)

    def _set_uniforms(self) -> None:
        appearance = self._appearance
        base = self._properties[0].GetDiffuseColor()
        # The width of the outline is all that depends on the pixels.
        outline = self._pixel_ratio if appearance.silhouette else 1.0
        for actor, kind in self._shaders.items():
            depth = 0.0 if actor in self._displaced else self._paint.depth
            lines = (appearance.shading, appearance.silhouette, outline, depth)
            quick = kind in _QUICK
            told = lines if quick else (appearance, base, self._up, outline, depth)
            # VTK builds the shader anew whenever it is told anything.
            if self._told.get(actor) == told:
                continue
            self._told[actor] = told
            # The picture's alpha holds heights: it makes nothing clear.
            opaque = FINISHES[appearance.material].opacity == 1.0
            alpha = kind in _WITH_PICTURE and self._paint.depth > 0.0
            actor.SetForceOpaque(alpha and opaque)
            uniforms = actor.GetShaderProperty().GetFragmentCustomUniforms()
            _write_lines(uniforms, appearance, outline, depth)
            if not quick:
                _write_light(uniforms, appearance, base, self._up)

    @property
    def _up(self) -> tuple[float, float, float]:
        return (0.0, 0.0, 1.0) if self._evaluation is None else upward(self._evaluation.surface)

    # Colours.

    def _set_colours(self) -> None:
        palette, appearance = self._palette, self._appearance
        if palette is None:
            return
        front, back, net = self._properties
        for prop in (front, back):
            prop.SetOpacity(1.0)
        own = appearance.color or (
            None if appearance.material is MaterialName.CLAY else base_color(appearance)
        )
        tones = palette if own is None else replace(palette, surface=own)
        two_tone(front, back, net, tones, white=self._pictured)
        if not is_quick(appearance):
            tone = rgb(tones.surface)
            for prop in (front, back):
                prop.SetColor(tone)
                prop.SetDiffuse(1.0)
                # What is not quite opaque is drawn after the rest.
                prop.SetOpacity(FINISHES[appearance.material].opacity)
        self._set_background(palette, appearance.background)
        self.reach = 2.2 if appearance.shadow else 1.0
        ink = _INK if _is_light(appearance, palette) else _CHALK
        self.features.style(ink)
        if appearance.background in (Background.THEME, Background.TRANSPARENT):
            self.bar.style(rgb(palette.text), rgb(palette.viewport_bottom))
        else:
            self.bar.style(ink, _CHALK if ink is _INK else _INK)
        self.features.show(appearance.features)

    def _set_background(self, palette: Palette, background: Background) -> None:
        bottom, top = {
            Background.WHITE: ("#ffffff", "#ffffff"),
            Background.DARK: ("#17191b", "#17191b"),
            Background.GRADIENT: ("#c9d3da", "#6f8394"),
        }.get(background, (palette.viewport_bottom, palette.viewport_top))
        self._renderer.SetBackground(rgb(bottom))
        self._renderer.SetBackground2(rgb(top))
        self._renderer.GradientBackgroundOn()


def _subject(evaluation: Evaluation, view: ViewState, body: BodyState | None) -> Subject:
    """Return what soft light falls on: the body where there is one, else the bare surface."""
    solid = body is not None and body.document.solid.kind is not BodyKind.SURFACE
    there = body if body is not None and solid and body.mesh is not None else None
    return Subject(evaluation.surface, there, evaluation.document.appearance.shadow, view.cut)


def _is_displaced(body: BodyState | None) -> bool:
    """Whether a body's mesh has its relief, which shading then need not show."""
    if body is None or not body.fine or body.unworked is not None:
        return False
    return relief_of(body.document.appearance) is not None


def _is_light(appearance: Appearance, palette: Palette) -> bool:
    if appearance.background in (Background.THEME, Background.TRANSPARENT):
        return palette.name == "light"
    return appearance.background is not Background.DARK


def _write_lines(uniforms: Any, appearance: Appearance, pixel_ratio: float, depth: float) -> None:
    """Tell a shader of facets, the outline and what relief is to be shaded."""
    shown = appearance.map
    mode = _LIT if shown is None else _ZEBRA if shown.of is MapKind.ZEBRA else _MAP
    for name, value in (
        ("lookMode", mode),
        ("lookDepth", depth),
        ("lookFlat", float(appearance.shading is Shading.FLAT)),
        ("lookOutline", _OUTLINE * pixel_ratio if appearance.silhouette else 0.0),
    ):
        uniforms.SetUniformf(name, value)
    uniforms.SetUniform3f("lookInk", _INK)


def _write_light(uniforms: Any, appearance: Appearance, base: Colour, up: Colour) -> None:
    """Tell a shader of the material and of the light."""
    material, light = FINISHES[appearance.material], LIGHTS[appearance.lighting.value]
    for name, value in (
        ("lookRough", material.roughness),
        ("lookMetallic", material.metallic),
        ("lookCoat", material.coat),
        ("lookCoatRough", material.coat_roughness),
        ("lookSoft", material.soft),
        ("lookOpacity", material.opacity if appearance.map is None else 1.0),
        # Light comes through glass into every hollow; a map keeps its colours.
        ("lookHollow", float(material.opacity == 1.0)),
    ):
        uniforms.SetUniformf(name, value)
    for name, vector in (
        ("lookBase", base),
        ("lookUp", up),
        ("lookZenith", light.zenith),
        ("lookHorizon", light.horizon),
        ("lookGround", light.ground),
    ):
        uniforms.SetUniform3f(name, vector)
    for number, box in enumerate(light.boxes):
        uniforms.SetUniform3f(f"lookPlace{number}", box.place)
        uniforms.SetUniform2f(f"lookSides{number}", (box.width, box.height))
        uniforms.SetUniform3f(f"lookBox{number}", box.light)
