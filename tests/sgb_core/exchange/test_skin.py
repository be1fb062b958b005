import json
import struct

import numpy as np
import pytest
import trimesh

import resources
from sgb_core import exchange
from sgb_core.document import edits
from sgb_core.document.appearance import colour_tables, pictures
from sgb_core.document.appearance.model import Along, ColourMap, Layer, LayerKind, MapKind, Texture
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.skin import skin_of
from tests.sgb_core.exchange.shapes import spindle, tube

BAND = Layer(LayerKind.BAND, "#ff0000", 0.0, 0.5, Along.LENGTH)


@pytest.fixture(autouse=True)
def _library():
    pictures.set_library(resources.texture)
    colour_tables.set_tables(resources.colour_table)


def banded(document=None, **changes):
    document = spindle() if document is None else document
    return edits.set_appearance(document, color="#0000ff", drawing=(BAND,), **changes)


def scene_of(path):
    data = path.read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def write(document, path):
    exchange.write(document, path, samples=(12, 24))
    return path


def test_a_plain_look_changes_no_file():
    assert skin_of(spindle()) is None


def test_glb_holds_material_and_picture(tmp_path):
    document = edits.set_appearance(
        spindle(), material="celadon", textures=(Texture("lotus", repeat=(6.0, 0.0)),)
    )
    scene, binary = scene_of(write(document, tmp_path / "pot.glb"))
    material = scene["materials"][0]
    assert material["name"] == "Celadon"
    assert material["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"] == 0.9
    assert scene["extensionsUsed"] == ["KHR_materials_clearcoat"]
    view = scene["bufferViews"][scene["images"][0]["bufferView"]]
    image = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    assert np.array_equal(pictures.decode(image)[..., :3], skin_of(document).picture)
    assert scene["buffers"][0]["byteLength"] == len(binary)


def test_glb_of_glass_is_blended(tmp_path):
    document = edits.set_appearance(spindle(), material="glass")
    material = scene_of(write(document, tmp_path / "a.glb"))[0]["materials"][0]
    assert material["alphaMode"] == "BLEND"
    assert material["pbrMetallicRoughness"]["baseColorFactor"][3] < 1.0


def test_another_program_sees_the_texture(tmp_path):
    mesh = trimesh.load(write(banded(), tmp_path / "pot.glb"), force="mesh")
    colours = mesh.visual.to_color().vertex_colors
    low, high = mesh.vertices[:, 1].min(), mesh.vertices[:, 1].max()
    part = (mesh.vertices[:, 1] - low) / (high - low)
    assert (colours[part < 0.2][:, 0] > 200).all()
    assert (colours[part > 0.8][:, 2] > 200).all()


def test_obj_comes_with_its_material_and_picture(tmp_path):
    path = write(banded(), tmp_path / "a pot.obj")
    text = path.read_text()
    assert "mtllib a pot.mtl\n" in text
    assert "usemtl surface\n" in text
    library = (tmp_path / "a pot.mtl").read_text()
    assert "newmtl surface\n" in library
    assert "map_Kd a pot.png\n" in library
    picture = pictures.decode((tmp_path / "a pot.png").read_bytes())
    assert picture[0, 0, :3].tolist() == [255, 0, 0]
    assert picture[-1, 0, :3].tolist() == [0, 0, 255]
    plain = edits.set_appearance(spindle(), material="metal")
    write(plain, tmp_path / "b.obj")
    assert "map_Kd" not in (tmp_path / "b.mtl").read_text()
    assert not (tmp_path / "b.png").exists()


def test_ply_has_colours(tmp_path):
    mesh = trimesh.load(write(banded(), tmp_path / "pot.ply"))
    colours = np.asarray(mesh.visual.vertex_colors)
    z = mesh.vertices[:, 2]
    part = (z - z.min()) / np.ptp(z)
    assert (colours[part < 0.2][:, :3] == (255, 0, 0)).all()
    assert (colours[part > 0.8][:, :3] == (0, 0, 255)).all()


def test_a_wall_takes_the_paint_of_the_surface_it_follows(tmp_path):
    document = banded(edits.set_solid(tube(), kind="vessel", wall=1.0, base=0.0))
    mesh = exported_mesh(document, samples=(12, 24))
    skin = skin_of(document)
    uv = skin.coordinates(mesh)
    assert uv.min() >= 0.0
    assert uv.max() <= 1.0
    z = mesh.positions[mesh.corner_positions][:, 2]
    share = (z - z.min()) / np.ptp(z)
    assert np.abs(share - uv[:, 1]).max() < 0.02
    colours = skin.position_colors(mesh)
    assert (colours[mesh.positions[:, 2] < z.min() + 0.4 * np.ptp(z)][:, 0] == 255).all()


def test_corners_of_the_seam_meet_at_u_0_and_1():
    mesh = exported_mesh(spindle(), samples=(12, 24))
    first, last = (np.flatnonzero(mesh.uv[:, 0] == end) for end in (0.0, 1.0))
    met = {mesh.corner_positions[k] for k in first} & {mesh.corner_positions[k] for k in last}
    rings = len({round(float(v), 9) for v in mesh.uv[first, 1]})
    assert len(met) >= rings - 2


def mapped(document, kind=MapKind.RADIUS, **limits):
    shown = ColourMap(kind, **limits)
    return edits.set_appearance(document, map=shown, material="metal", drawing=(BAND,))


def test_a_map_is_looked_up_by_its_value_at_each_corner(tmp_path):
    document = mapped(spindle(), low=0.0, high=40.0)
    skin, mesh = skin_of(document), exported_mesh(document, samples=(12, 24))
    positions = mesh.positions[mesh.corner_positions]
    axis = document.revolution.axis.frame[0]
    radius = np.linalg.norm(np.delete(positions, axis, axis=1), axis=1)
    found = skin.coordinates(mesh)
    width = skin.picture.shape[1]
    share = np.clip(radius / 40.0, 0.0, 1.0)
    assert found[:, 0] == pytest.approx((0.5 + share * (width - 1)) / width, abs=2e-5)
    assert (found[:, 1] == 0.5).all()


@pytest.mark.parametrize("kind", [MapKind.MEAN, MapKind.OVERHANG, MapKind.THICKNESS])
def test_any_map_of_any_body_has_coordinates_within_its_colours(kind):
    for document in (spindle(), tube()):
        skin = skin_of(mapped(document, kind))
        found = skin.coordinates(exported_mesh(document, samples=(8, 16)))
        assert np.isfinite(found).all()
        assert 0.0 < found.min() <= found.max() < 1.0


def test_glb_of_a_map_shows_its_colours_in_any_light(tmp_path):
    document = mapped(spindle())
    scene, binary = scene_of(write(document, tmp_path / "map.glb"))
    assert scene["extensionsUsed"] == ["KHR_materials_unlit"]
    material = scene["materials"][0]
    assert material["extensions"] == {"KHR_materials_unlit": {}}
    assert material["name"].startswith("Radius (mm), ")
    assert material["pbrMetallicRoughness"]["baseColorFactor"] == [1.0] * 4
    view = scene["bufferViews"][scene["images"][0]["bufferView"]]
    image = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    assert np.array_equal(pictures.decode(image)[0, :, :3], colour_tables.table("viridis"))


def test_ply_and_obj_of_a_map_have_its_colours(tmp_path):
    document = mapped(spindle())
    cloud = trimesh.load(write(document, tmp_path / "map.ply"), process=False)
    colours = cloud.visual.vertex_colors[:, :3].astype(int)
    table = colour_tables.table("viridis").astype(int)
    radius = np.hypot(cloud.vertices[:, 0], cloud.vertices[:, 1])
    for place, wanted in ((radius.argmax(), table[-1]), (radius.argmin(), table[0])):
        assert np.abs(colours[place] - wanted).max() <= 3
    write(document, tmp_path / "map.obj")
    assert "map_Kd map.png" in (tmp_path / "map.mtl").read_text()
    assert (tmp_path / "map.png").stat().st_size < 3000


def test_zebra_stripes_are_no_colours_of_a_file():
    assert skin_of(edits.set_appearance(spindle(), map=ColourMap(MapKind.ZEBRA))) is None
