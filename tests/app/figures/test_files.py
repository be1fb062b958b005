"""Plates as files, taken apart: pictures under curves to a fraction of a pixel, text as text."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from base64 import b64decode
from dataclasses import replace
from functools import cache
from io import BytesIO
from math import radians
from pathlib import Path

import numpy as np
import pytest
from fontTools.ttLib import TTFont
from matplotlib.image import imread

from app.__main__ import main
from app.figures.drawing import draw, panel_poses, panel_raster, plate_layout, with_bodies
from app.figures.files import figure_bytes, plate_style
from app.figures.lines import space_lines
from app.figures.plate import Plate, SurfacePanel
from app.figures.projection import farthest_about, hidden, project, runs
from app.scene.camera import Pose
from app.state.child_command import run_aside
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.document.plates import PlateSettings, Variation
from sgb_core.surfaces.revolution import Axis

SVG = "{http://www.w3.org/2000/svg}"
SPHERE = ((0, 0), (1.50505, 0), (1.50505, 2), (0, 2))
SHAPE = ShapeParameters(1.68374, 3, 1.68374, 1)
NOWHERE = (0.0, 0.0, 0.0)


def ball() -> Document:
    return Document(Profile.of([Segment(SPHERE, SHAPE)]))


def plate(parallel: bool = True, elevation: float = 0.0, **changes: object) -> Plate:
    show = frozenset({"generatrix", "polygon", "circles", "axes"})
    panels = tuple(
        SurfacePanel(ball(), label, (rf"$\lambda_2={value}$",), show=show)
        for label, value in (("a", 3), ("b", 4.5))
    )
    pose = Pose(Axis.Z, radians(-90), radians(elevation), 1.0, NOWHERE, NOWHERE, parallel)
    return Plate(panels, 2, pose, width_mm=85.0, dpi=200, **changes)


@cache
def written(suffix: str) -> bytes:
    with plate_style():
        drawn = draw(plate())
    return figure_bytes(drawn, suffix)


@pytest.mark.parametrize("parallel", [True, False])
def test_the_surfaces_edge_lies_under_its_projection(parallel: bool) -> None:
    made = plate(parallel)
    layout = plate_layout(made)
    panel, box = made.panels[0], layout.panels[0]
    assert isinstance(panel, SurfacePanel)
    pose = panel_poses(made, layout)[0]
    image = panel_raster(panel, pose, box).image
    cover = image[..., 3].astype(float) / 255.0
    # The outline of a ball, seen in either projection, is a circle about its projected centre.
    (centre,), (depth,) = project(pose, np.array([[0.0, 0.0, 1.0]]))
    radius = 1.0 if parallel else 1.0 / np.sqrt(1.0 - (1.0 / depth) ** 2)
    edge = radius / pose.parallel_scale * (1.0 if parallel else pose.distance / depth)
    pixel = 2.0 / box.height
    wide = cover.sum(axis=1).max() * pixel / 2.0
    high = cover.sum(axis=0).max() * pixel / 2.0
    assert wide == pytest.approx(edge, abs=0.35 * pixel)
    assert high == pytest.approx(edge, abs=0.35 * pixel)
    rows, columns = np.mgrid[: box.height, : box.width] + 0.5
    x = (columns / box.width * 2.0 - 1.0) * layout.aspect
    y = 1.0 - rows / box.height * 2.0
    assert (x * cover).sum() / cover.sum() == pytest.approx(centre[0], abs=0.1 * pixel)
    assert (y * cover).sum() / cover.sum() == pytest.approx(centre[1], abs=0.1 * pixel)


def test_what_lies_behind_is_known() -> None:
    made = plate(elevation=20.0)
    layout = plate_layout(made)
    panel, box = made.panels[0], layout.panels[0]
    assert isinstance(panel, SurfacePanel)
    pose = panel_poses(made, layout)[0]
    raster = panel_raster(panel, pose, box)
    points = np.random.default_rng(4).normal(size=(4000, 3))
    on_ball = np.array([0, 0, 1.0]) + 1.001 * points / np.linalg.norm(points, axis=1)[:, None]
    seen, depth = project(pose, on_ball)
    behind = hidden(farthest_about(raster.depth), seen, depth, layout.aspect, 3.0)
    facing = (on_ball - np.array([0, 0, 1.0])) @ pose.basis[2]
    clear = np.abs(facing) > 0.3
    assert (behind == (facing < 0.0))[clear].all()


def test_runs_of_a_line_meet_and_ignore_single_points() -> None:
    flags = np.array([False, False, True, False, False, True, True, True])
    assert list(runs(flags)) == [(0, 5, False), (5, 7, True)]


def test_svg_words_curves_pictures_and_fonts() -> None:
    text = written(".svg").decode()
    root = ET.fromstring(text)
    words = ["".join(node.itertext()).replace("\u200b", "") for node in root.iter(f"{SVG}text")]
    assert [re.sub(r"\s+", "", word) for word in words] == ["(a)λ2=3", "(b)λ2=4.5"]
    assert len(list(root.iter(f"{SVG}image"))) == 2
    kinds = {group.get("id", "") for group in root.iter(f"{SVG}g")}
    assert {"generatrix", "polygon", "circles", "circles-marks", "axes-hidden"} <= kinds
    fonts = re.findall(r"font-style:(\w+);src:url\(data:font/woff;base64,([^)]*)\)", text)
    assert [style for style, _ in fonts] == ["normal", "italic"]
    upright, italic = (TTFont(BytesIO(b64decode(data))) for _, data in fonts)
    assert {ord(letter) for letter in "(a)=4.5"} <= set(upright.getBestCmap())
    assert ord("λ") in italic.getBestCmap()


def test_a_title_of_any_letters_is_kept_in_an_svg() -> None:
    with plate_style():
        drawn = draw(plate(title='5 \\$ -- a < b & "c"'), fine=False)
    root = ET.fromstring(figure_bytes(drawn, ".svg"))
    words = ["".join("".join(node.itertext()).split()) for node in root.iter(f"{SVG}text")]
    assert '5$--a<b&"c"' in words


def test_curves_and_pictures_of_an_svg_share_their_places() -> None:
    made = plate()
    layout = plate_layout(made)
    root = ET.fromstring(written(".svg"))
    panel = made.panels[0]
    assert isinstance(panel, SurfacePanel)
    pose = panel_poses(made, layout)[0]
    image = next(root.iter(f"{SVG}image"))
    scale, _, _, _, left, top = map(float, re.findall(r"-?[\d.]+", image.get("transform", "")))
    width, height = float(image.get("width", 0)), float(image.get("height", 0))
    assert (width, height) == (layout.panels[0].width, layout.panels[0].height)
    polygon = next(line for line in space_lines(panel) if line.kind == "polygon")
    seen, _ = project(pose, polygon.points)
    x = left + scale * width * (seen[:, 0] / layout.aspect + 1.0) / 2.0
    y = top + scale * height * (1.0 - seen[:, 1]) / 2.0
    axes = next(group for group in root.iter(f"{SVG}g") if group.get("id") == "axes_1")
    drawn = []
    for group in axes.iter(f"{SVG}g"):
        if group.get("id") in ("polygon", "polygon-hidden"):
            numbers = re.findall(r"-?[\d.]+", group.find(f"{SVG}path").get("d"))
            drawn.append(np.array(numbers, dtype=float).reshape(-1, 2))
    assert drawn
    there = np.stack([x, y], axis=-1)
    for point in np.concatenate(drawn):
        # A hundredth of a pixel of the picture.
        assert np.hypot(*(there - point).T).min() < 0.01 * scale


@pytest.mark.skipif(shutil.which("pdffonts") is None, reason="needs poppler-utils")
def test_a_pdfs_fonts_are_embedded_and_its_text_can_be_read(tmp_path: Path) -> None:
    path = tmp_path / "plate.pdf"
    path.write_bytes(written(".pdf"))

    def run(*words: str) -> str:
        return subprocess.run(words, capture_output=True, text=True, check=True).stdout

    fonts = run("pdffonts", str(path)).splitlines()[2:]
    assert fonts
    assert all("TrueType" in line and " yes yes yes " in line for line in fonts)
    assert "(a)" in run("pdftotext", str(path), "-")
    pictures = run("pdfimages", "-list", str(path)).splitlines()[2:]
    assert [line.split()[2] for line in pictures] == ["image", "smask"] * 2
    assert all(" 200   200 " in line for line in pictures)


def test_a_pdf_holds_curves_and_truetype_fonts() -> None:
    data = written(".pdf")
    assert data.startswith(b"%PDF")
    assert data.count(b"/Subtype /Image") >= 2
    assert b"/FontFile2" in data
    assert b"/Subtype /Type3" not in data
    box = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", data)
    assert box is not None
    assert float(box[1]) == pytest.approx(85.0 / 25.4 * 72.0, abs=0.3)


def test_the_same_plate_gives_the_same_bytes() -> None:
    with plate_style():
        again = draw(plate())
    for suffix in (".svg", ".pdf"):
        assert figure_bytes(again, suffix) == written(suffix)
    with pytest.raises(ValueError, match="no format"):
        figure_bytes(again, ".gif")


def test_a_png_has_the_size_in_pixels_that_millimetres_and_dpi_say() -> None:
    pixels = imread(BytesIO(written(".png")))
    assert pixels.shape[1] == round(85.0 / 25.4 * 200)
    assert pixels[0, 0, :3].tolist() == [1.0, 1.0, 1.0]


def test_panels_share_their_scale_unless_told_otherwise() -> None:
    big = Document(Profile.of([Segment(2.0 * np.array(SPHERE), SHAPE)]))
    panels = tuple(SurfacePanel(document) for document in (ball(), big))
    for common, ratio in ((True, 2.0), (False, 1.0)):
        made = Plate(panels, 2, plate().pose, width_mm=60.0, dpi=100, common_scale=common)
        layout = plate_layout(made)
        widths = []
        poses = panel_poses(made, layout)
        for panel, pose, box in zip(panels, poses, layout.panels, strict=True):
            raster = panel_raster(panel, pose, box)
            widths.append((raster.image[..., 3] > 127).sum(axis=1).max())
        assert widths[1] / widths[0] == pytest.approx(ratio, rel=0.03)


def test_a_panel_of_a_vessel_shows_its_wall() -> None:
    vessel = replace(ball(), solid=Solid(BodyKind.VESSEL, wall=0.5, side=WallSide.OUTSIDE))
    panels = tuple(SurfacePanel(document) for document in (ball(), vessel))
    made = with_bodies(Plate(panels, 2, plate().pose, width_mm=60.0, dpi=100), fine=False)
    layout = plate_layout(made)
    covers = [
        panel_raster(panel, pose, box).image[..., 3] > 127
        for panel, pose, box in zip(
            made.panels, panel_poses(made, layout), layout.panels, strict=True
        )
    ]
    bare, walled = (cover.sum(axis=1).max() for cover in covers)
    assert walled / bare == pytest.approx(1.5, rel=0.03)
    # The camera makes room for the wall.
    assert not covers[1][[0, -1]].any()
    assert not covers[1][:, [0, -1]].any()


def test_figures_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["figures", "--only", "6", "--out", str(tmp_path / "out")]) == 0
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == [f"figure_06.{suffix}" for suffix in ("json", "pdf", "png", "svg")]
    said = capsys.readouterr()
    assert said.out == ""
    assert "100%  figure 6" in said.err
    assert main(["figures", "--only", "15", "--out", str(tmp_path)]) == 2
    assert main(["figures"]) == 2


def test_plate_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = tmp_path / "ball.sgb"
    project_file.save(ball(), source)
    assert main(["plate", str(source), str(tmp_path / "plate.svg")]) == 1
    assert "holds no figure plate" in capsys.readouterr().err
    settings = PlateSettings((Variation("lambda2", (0.0, 6.0), 0),), width_mm=60.0, dpi=100)
    project_file.save(edits.set_plate(ball(), settings), source)
    assert main(["plate", str(source), str(tmp_path / "plate.svg")]) == 0
    texts = ET.parse(tmp_path / "plate.svg").getroot().iter(f"{SVG}text")
    words = ["".join(text.itertext()).replace("\u200b", "").replace("\u2005", "") for text in texts]
    # λ2 of segment 1, in reading order, two letters of one index included.
    assert [word.split()[-1] for word in words] == ["λ2,1=0", "λ2,1=6"]
    parts: list[float] = []
    aside = tmp_path / "aside.png"
    run_aside("plate", project_file.load(source), aside, parts.append, ["--progress"])
    assert aside.read_bytes().startswith(b"\x89PNG")
    assert parts == sorted(parts)
    assert (len(parts) > 4, parts[-1]) == (True, 1.0)
    assert main(["plate", str(source), str(tmp_path / "plate.gif")]) == 1


def test_a_figure_is_made_again_from_its_file_to_the_last_bit(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    assert main(["figures", "--only", "6", "--dpi", "60", "--out", str(first)]) == 0
    record = json.loads((first / "figure_06.json").read_text())
    assert record["made_by"]["look"]["dpi"] == 60
    assert record["made_by"]["program"] == "SGB Studio"
    assert record["panels"]
    assert main(["figures", "--again", str(first / "figure_06.json"), "--out", str(second)]) == 0
    for path in first.iterdir():
        assert path.read_bytes() == (second / path.name).read_bytes(), path.name
    assert b"/Title (Figure 6" in (first / "figure_06.pdf").read_bytes()


def test_a_plate_is_made_again_from_the_file_beside_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, plate = tmp_path / "ball.sgb", tmp_path / "plate.pdf"
    settings = PlateSettings((Variation("lambda2", (0.0, 6.0), 0),), width_mm=60.0, title="Balls")
    project_file.save(edits.set_plate(ball(), settings), source)
    assert main(["plate", str(source), str(plate), "--dpi", "70"]) == 0
    beside = tmp_path / "plate.pdf.json"
    source.unlink()
    assert main(["plate", str(beside), str(tmp_path / "again.pdf")]) == 0
    assert (tmp_path / "again.pdf").read_bytes() == plate.read_bytes()
    assert b"/Title (Balls)" in plate.read_bytes()
    record = json.loads(beside.read_text())
    record["made_by"]["version"] = "0.0.0"
    beside.write_text(json.dumps(record))
    assert main(["plate", str(beside), str(tmp_path / "third.pdf")]) == 1
    assert "it was made by version 0.0.0" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["{", "[]", "{}", '{"figure": 6}', '{"figure": true}'])
def test_other_files_are_no_figures(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    assert main(["figures", "--again", str(path), "--out", str(tmp_path / "out")]) == 1
    assert main(["plate", str(path), str(tmp_path / "a.pdf")]) == 1
    assert capsys.readouterr().err.count("\n") == 2
    assert main(["figures", "--dpi", "9", "--out", str(tmp_path)]) == 2
