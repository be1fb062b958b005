"""The body in the 3-D picture: its mesh, its liquid, and what is left away to look inside."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty, vtkRenderer

from app.scene.actors import Array, rgb
from app.scene.plain_shading import shade
from app.state.cut import Cut
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.solid_mesh import triangulate
from sgb_core.document.body_state import BodyState, cut_faces
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface


class CutActor:
    """One mesh drawn by up to two actors, each clipped by planes: together all but a wedge."""

    def __init__(self, renderer: vtkRenderer, first: vtkActor | None = None) -> None:
        self._own = first is None
        self.first = _actor() if first is None else first
        self.second = _actor()
        self._renderer = renderer
        self._wedge: tuple[object, ...] = ()
        if self._own:
            renderer.AddActor(self.first)
        renderer.AddActor(self.second)

    def drop(self) -> None:
        """Take the actors made here out of the picture."""
        self._renderer.RemoveActor(self.second)
        if self._own:
            self._renderer.RemoveActor(self.first)

    def set_data(self, data: vtkPolyData) -> None:
        """Draw another mesh."""
        for actor in (self.first, self.second):
            actor.GetMapper().SetInputData(data)

    def dress(self, front: vtkProperty, back: vtkProperty | None) -> None:
        """Set the looks of both sides."""
        for actor in (self.first, self.second):
            actor.SetProperty(front)
            actor.SetBackfaceProperty(back)

    def cut(self, surface: RevolutionSurface, cut: Cut) -> None:
        """Leave a wedge away."""
        wedge = (surface.axis, surface.placement, cut)
        if wedge == self._wedge:
            return
        self._wedge = wedge
        low, high = cut.wedge
        for actor in (self.first, self.second):
            actor.GetMapper().RemoveAllClippingPlanes()
        if cut is Cut.NONE:
            return
        # What turns on from the wedge's start is away; in a quarter's case what lies beyond its
        # end, on the same side of the first plane, comes back by the second actor.
        self.first.GetMapper().AddClippingPlane(_plane(surface, low, -1.0))
        if high - low < pi - 1e-9:
            self.second.GetMapper().AddClippingPlane(_plane(surface, low, 1.0))
            self.second.GetMapper().AddClippingPlane(_plane(surface, high, 1.0))

    def show(self, visible: bool, cut: Cut) -> None:
        """Show or hide."""
        self.first.SetVisibility(visible)
        self.second.SetVisibility(visible and cut is Cut.QUARTER)


class BodyScene:
    """What a scene shows of a document's body, beside the surface's own fast path."""

    def __init__(self, renderer: vtkRenderer, front: vtkProperty, back: vtkProperty) -> None:
        self._renderer = renderer
        self._front = front
        self._back = back
        self._state: BodyState | None = None
        self._face_key: tuple[object, ...] = ()
        self._levels: dict[vtkActor, CutActor] = {}
        self._body, self._liquid = CutActor(renderer), CutActor(renderer)
        self._faces, self._liquid_faces = _actor(), _actor()
        self._water = vtkProperty()
        for actor in (self._faces, self._liquid_faces):
            renderer.AddActor(actor)
            actor.VisibilityOff()
            # In front of an end face of the body that lies in the same plane.
            actor.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(-1.0, -6.0)
        self._body.dress(front, back)
        self._liquid.dress(self._water, None)
        for each in (self._body.first, self._body.second):
            shade(each)
        self._body.show(False, Cut.NONE)
        self._liquid.show(False, Cut.NONE)

    @property
    def state(self) -> BodyState | None:
        """The body that is shown."""
        return self._state

    @property
    def body_actors(self) -> tuple[vtkActor, vtkActor]:
        """The two actors that share the body's mesh."""
        return self._body.first, self._body.second

    def second_of(self, level: vtkActor) -> vtkActor:
        """Return the actor that draws what a quarter cut leaves of a bare surface."""
        return self._levels[level].second

    @property
    def replaces_surface(self) -> bool:
        """Whether a body is there to be drawn in the surface's place."""
        return self._state is not None and self._state.mesh is not None

    def update(
        self, state: BodyState | None, view: ViewState, level: vtkActor, surface: RevolutionSurface
    ) -> None:
        """Show a body, None for the bare surface whose actor of the present fineness is given."""
        if state is not self._state:
            self._state = state
            self._face_key = ()
            if state is not None and state.mesh is not None:
                self._body.set_data(mesh_data(state.mesh))
            if state is not None and state.liquid is not None:
                self._liquid.set_data(mesh_data(state.liquid))
        placed = surface if state is None else state.surface
        shown, cut = view.shows(Overlay.SURFACE), view.cut
        whole = shown and cut is not Cut.SECTION
        for actor in [known for known in self._levels if known is not level]:
            self._levels.pop(actor).drop()
        if level not in self._levels:
            self._levels[level] = CutActor(self._renderer, level)
            self._levels[level].dress(self._front, self._back)
            self._levels[level].set_data(level.GetMapper().GetInput())
            shade(self._levels[level].second)
        for part in (self._body, self._liquid, self._levels[level]):
            part.cut(placed, cut)
        has_liquid = self.replaces_surface and state is not None and state.liquid is not None
        bare = whole and not self.replaces_surface
        self._levels[level].show(bare, cut)
        self._body.show(whole and self.replaces_surface, cut)
        self._liquid.show(whole and has_liquid and view.shows(Overlay.LIQUID), cut)
        self._show_faces(view, placed)
        solid = state is not None and state.document.solid.kind is not BodyKind.SURFACE
        closed = solid and self.replaces_surface
        if closed or cut is not Cut.NONE:
            self._front.SetBackfaceCulling(closed and cut is Cut.NONE)

    def hide(self) -> None:
        """Hide all of it until the next update."""
        for part in (self._body, self._liquid, *self._levels.values()):
            part.show(False, Cut.NONE)
        for actor in (self._faces, self._liquid_faces):
            actor.VisibilityOff()

    def set_palette(self, palette: Palette) -> None:
        """Take all colours from a theme."""
        for actor, colour in ((self._faces, palette.cut), (self._liquid_faces, palette.liquid)):
            look = actor.GetProperty()
            look.SetColor(rgb(colour))
            look.SetAmbient(0.93)
            look.SetDiffuse(0.1)
        self._liquid_faces.GetProperty().SetOpacity(0.75)
        self._water.SetColor(rgb(palette.liquid))
        self._water.SetAmbient(0.4)
        self._water.SetDiffuse(0.6)
        self._water.SetSpecular(0.35)
        self._water.SetSpecularPower(60.0)
        self._water.SetOpacity(0.62)
        self._water.SetInterpolationToPhong()
        self._water.SetBackfaceCulling(True)

    def _show_faces(self, view: ViewState, surface: RevolutionSurface) -> None:
        state, cut = self._state, view.cut
        key = (cut, state)
        if key != self._face_key and cut is not Cut.NONE and state is not None:
            self._face_key = key
            faces = [(angle, cut_faces(state, angle)) for angle in _face_angles(surface, cut)]
            self._faces.GetMapper().SetInputData(_faces_data(surface, faces))
            wet = [(angle, [(loop,) for loop in state.liquid_section]) for angle, _ in faces]
            self._liquid_faces.GetMapper().SetInputData(_faces_data(surface, wet))
        flat = cut is Cut.SECTION
        for actor in (self._faces, self._liquid_faces):
            actor.GetProperty().SetLighting(not flat)
        visible = cut is not Cut.NONE and self.replaces_surface and view.shows(Overlay.SURFACE)
        self._faces.SetVisibility(visible)
        wet_shown = state is not None and state.liquid is not None and view.shows(Overlay.LIQUID)
        self._liquid_faces.SetVisibility(visible and wet_shown)


def _actor() -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(vtkPolyData())
    mapper.ScalarVisibilityOff()
    mapper.SetVBOShiftScaleMethod(0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def _plane(surface: RevolutionSurface, angle: float, sign: float) -> vtkPlane:
    plane = vtkPlane()
    plane.SetOrigin(*surface.placement.translation)
    plane.SetNormal(*(sign * surface.directions(np.array(angle))[1]))
    return plane


def _face_angles(surface: RevolutionSurface, cut: Cut) -> list[float]:
    """Return the absolute angles of a wedge's two sides as far as the surface reaches there."""
    found = []
    for angle in cut.wedge:
        turned = (angle - surface.start) % (2.0 * pi)
        if surface.is_full_turn or turned <= surface.sweep + 1e-9:
            found.append(surface.start + turned)
    return found


def mesh_data(mesh: Mesh) -> vtkPolyData:
    """Return a mesh as VTK draws it, with its exact normals."""
    corners = mesh.corner_positions
    return _polydata(mesh.positions[corners], mesh.normals, mesh.triangles)


def _faces_data(
    surface: RevolutionSurface, faces: Sequence[tuple[float, Sequence[tuple[Array, ...]]]]
) -> vtkPolyData:
    """Return flat polygons with holes, each list standing upright at an angle."""
    points, normals, triangles, count = [np.zeros((0, 3))], [np.zeros((0, 3))], [], 0
    for angle, polygons in faces:
        outward, along, up = surface.directions(np.array(angle))
        for loops in polygons:
            flat = np.concatenate(loops)
            triangles.append(triangulate(list(loops)) + count)
            placed = flat[:, :1] * outward + flat[:, 1:] * up
            points.append(placed + np.asarray(surface.placement.translation))
            normals.append(np.broadcast_to(along, (len(flat), 3)))
            count += len(flat)
    cells = np.concatenate(triangles) if triangles else np.zeros((0, 3), dtype=np.int64)
    return _polydata(np.concatenate(points), np.concatenate(normals), cells)


def _polydata(points: Array, normals: Array, triangles: Array) -> vtkPolyData:
    data = vtkPolyData()
    shared = vtkPoints()
    shared.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float32), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtk(triangles.reshape(-1).astype(np.int32), deep=True))
    data.SetPoints(shared)
    data.SetPolys(cells)
    flat = np.ascontiguousarray(normals, dtype=np.float32)
    data.GetPointData().SetNormals(numpy_to_vtk(flat, deep=True))
    return data
