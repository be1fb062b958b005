"""SVG drawings: exact pieces in true units, whatever program wrote them."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import numpy as np
import pytest

from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document, Unit
from sgb_core.exchange.svg import write_svg
from sgb_core.findings.finding import Finding
from sgb_core.findings.sources import NoSource, NoUnit, SeveralPaths, Unreadable, Wall
from sgb_core.sources import Options, Side, SourceError
from tests.sgb_core.sources.files import MM, apart, svg, taken

CUBIC = '<path d="M10 90 C40 80 50 40 20 20"/>'
POINTS = np.array([[10.0, -90.0], [40.0, -80.0], [50.0, -40.0], [20.0, -20.0]])


def test_a_cubic_is_one_segment_with_every_slider_alive(tmp_path: Path) -> None:
    found = svg(tmp_path, CUBIC)
    (segment,) = found.trace.profile.segments
    np.testing.assert_allclose(segment.points, POINTS, atol=1e-12)
    assert segment.shape == ShapeParameters(1.0, 3.0, 1.0, 1.0)
    assert found.trace.exact
    assert found.notes == ()
    assert found.document().reference.kind == "svg"


def test_lines_and_quadratics_are_exact_too_and_joints_are_as_they_are(tmp_path: Path) -> None:
    found = svg(tmp_path, '<path d="M10,90 L30,90 Q50,90 50,70 T50,50 V20 h-10"/>')
    profile = found.trace.profile
    assert found.trace.exact
    assert len(profile) == 5
    assert profile.rules == (JointRule.G1, JointRule.G1, JointRule.G1, JointRule.G0)
    s = np.linspace(0.0, 1.0, 11)[:, None]
    middle = (1 - s) ** 2 * [30, -90] + 2 * s * (1 - s) * [50, -90] + s**2 * [50, -70]
    assert apart(profile, middle) < 1e-12


@pytest.mark.parametrize(
    ("root", "scale"),
    [
        ('width="20cm" height="20cm" viewBox="0 0 100 100"', 2.0),
        ('width="2in" height="4in" viewBox="0 0 100 100"', 0.508),
        ('width="100mm" height="100mm"', 25.4 / 96.0),
        ('width="283.46456692913387pt" viewBox="0 0 100 100"', 1.0),
    ],
)
def test_the_root_says_how_large_its_units_are(tmp_path: Path, root: str, scale: float) -> None:
    found = svg(tmp_path, CUBIC, root=root)
    np.testing.assert_allclose(found.trace.profile.segments[0].points, scale * POINTS, rtol=1e-12)
    inches = svg(tmp_path, CUBIC, Options(unit=Unit.IN), root=root)
    np.testing.assert_allclose(
        inches.trace.profile.segments[0].points, scale * POINTS / 25.4, rtol=1e-12
    )


def test_a_drawing_without_a_unit_is_in_the_one_asked_for(tmp_path: Path) -> None:
    found = svg(tmp_path, CUBIC, Options(unit=Unit.CM), root='viewBox="0 0 100 100"')
    np.testing.assert_allclose(found.trace.profile.segments[0].points, POINTS)
    assert found.notes == (NoUnit("cm"),)


@pytest.mark.parametrize(
    "body",
    [
        '<g transform="translate(5 50)"><g transform="scale(2)"><path '
        'd="M2.5 20 C17.5 15 22.5 -5 7.5 -15"/></g></g>',
        '<defs><path id="p" d="M0 0 C30 -10 40 -50 10 -70"/></defs><use xlink:href="#p" x="10" '
        'y="90"/>',
        '<symbol id="s"><path d="M0 0 C30 -10 40 -50 10 -70"/></symbol><use href="#s" '
        'transform="translate(10,90)"/>',
        '<path transform="rotate(90) matrix(0 -1 1 0 0 0)" d="m10 90c30-10 40-50 10-70"/>',
        f'<rect width="9" height="9" visibility="hidden"/><text>vase</text>{CUBIC}',
        f'<style>.no{{display:none}}</style><path class="no" d="M0 0 L99 99"/>{CUBIC}',
        f'<image xlink:href="file:///etc/passwd" width="9" height="9"/>{CUBIC}',
    ],
    ids=["nested", "use", "symbol", "turned", "hidden", "css", "linked picture"],
)
def test_transforms_uses_and_styles_count(tmp_path: Path, body: str) -> None:
    (segment,) = svg(tmp_path, body).trace.profile.segments
    np.testing.assert_allclose(segment.points, POINTS, atol=1e-9)


LINE = '<path d="M10 10 C40 20 30 60 20 70"/>'
SYMBOL = '<symbol id="a" viewBox="0 0 100 100" {}>' + LINE + "</symbol>"


@pytest.mark.parametrize(
    ("body", "across", "up", "x", "y"),
    [
        (SYMBOL.format("") + '<use href="#a" x="5" width="50" height="50"/>', 0.5, 0.5, 5, 0),
        (SYMBOL.format("") + '<use href="#a" width="50" height="100"/>', 0.5, 0.5, 0, 25),
        (
            SYMBOL.format('preserveAspectRatio="none"')
            + '<use href="#a" width="50" height="100"/>',
            0.5,
            1.0,
            0,
            0,
        ),
        (SYMBOL.format('width="50%" height="50%"') + '<use href="#a"/>', 0.5, 0.5, 0, 0),
        (
            f'<svg x="10" y="20" width="50" height="50" viewBox="0 0 100 100">{LINE}</svg>',
            0.5,
            0.5,
            10,
            20,
        ),
        (
            '<svg width="50" height="100" viewBox="10 10 100 100" '
            f'preserveAspectRatio="xMinYMin slice">{LINE}</svg>',
            1.0,
            1.0,
            -10,
            -10,
        ),
        (f'<svg x="10mm" y="20">{LINE}</svg>', 1.0, 1.0, 960 / 25.4, 20),
        (
            f'<svg id="n" width="0" height="9">{LINE}</svg>'
            f'<defs><g id="g">{LINE}</g><symbol id="b" viewBox="0 0 50 50"><use '
            'xlink:href="#g" transform="translate(1 2)"/></symbol></defs>'
            '<use href="#b" width="25" height="25" transform="translate(3 4)"/>',
            0.5,
            0.5,
            3.5,
            5,
        ),
    ],
)
def test_symbols_and_drawings_inside_are_where_they_are_drawn(
    tmp_path: Path, body: str, across: float, up: float, x: float, y: float
) -> None:
    (segment,) = svg(tmp_path, body, Options(axis=-50.0)).trace.profile.segments
    wanted = np.array([[50 + across * 20 + x, -up * 70 - y], [50 + across * 10 + x, -up * 10 - y]])
    np.testing.assert_allclose(segment.points[[0, 3]], wanted, atol=1e-9)


def test_an_arc_is_followed(tmp_path: Path) -> None:
    found = svg(tmp_path, '<path d="M0 100 A50 50 0 0 0 0 0"/>', Options(axis=0.0))
    assert not found.trace.exact
    angle = np.linspace(-np.pi / 2, np.pi / 2, 50)
    circle = np.stack([50 * np.cos(angle), 50 * np.sin(angle) - 50], axis=1)
    assert apart(found.trace.profile, circle) < 1e-5
    assert len(found.trace.profile) <= 2


def test_a_silhouette_is_cut_at_its_axis_and_both_sides_count(tmp_path: Path) -> None:
    body = '<path d="M50 90 H30 C10 60 20 30 40 10 H60 C80 30 90 60 70 90 Z"/>'
    found = svg(tmp_path, body)
    assert found.axis == (50.0,)
    assert found.left_right == pytest.approx(0.0, abs=1e-9)
    (segment,) = found.trace.profile.segments
    np.testing.assert_allclose(segment.points, [[20, -90], [40, -60], [30, -30], [10, -10]])
    askew = body.replace("C80 30 90 60 70 90", "C80 30 94 60 70 90")
    assert svg(tmp_path, askew, Options(axis=50.0)).left_right > 0.5  # type: ignore[operator]
    left = svg(tmp_path, askew, Options(axis=50.0, side=Side.LEFT))
    np.testing.assert_allclose(left.trace.profile.segments[0].points, segment.points)


@pytest.mark.parametrize("options", [Options(axis=10.0), Options()])
@pytest.mark.parametrize("wall", [3, 7])
def test_a_half_section_gives_the_outer_line_and_its_wall(
    tmp_path: Path, options: Options, wall: int
) -> None:
    body = f'<path d="M10 90 H40 V10 H{40 - wall} V{90 - wall} H10 Z"/>'
    found = svg(tmp_path, body, options)
    assert found.axis == (10.0,)
    profile = found.trace.profile
    ends = [profile.segments[0].points[0], *(segment.points[3] for segment in profile.segments)]
    np.testing.assert_allclose(ends, [[0, -90], [30, -90], [30, -10]], atol=1e-9)
    (note,) = found.notes
    assert isinstance(note, Wall)
    assert note.median == pytest.approx(wall, abs=0.05)


def test_the_longest_path_is_taken_and_the_others_are_said(tmp_path: Path) -> None:
    found = svg(tmp_path, f'<path d="M1 1 L2 1"/>{CUBIC}<circle cx="90" cy="90" r="3"/>')
    assert found.notes == (SeveralPaths(3),)
    np.testing.assert_allclose(found.trace.profile.segments[0].points, POINTS)


def test_pieces_drawn_apart_make_one_path_with_merge_fewer_segments(tmp_path: Path) -> None:
    steps = np.linspace(0.0, np.pi / 2, 41)
    places = np.stack([80 * np.cos(steps), 90 - 80 * np.sin(steps)], axis=1)
    lines = "".join(
        f'<line x1="{a[0]!r}" y1="{a[1]!r}" x2="{b[0]!r}" y2="{b[1]!r}"/>'
        for a, b in zip(places[:-1].tolist(), places[1:].tolist(), strict=True)
    )
    kept = svg(tmp_path, lines, Options(axis=0.0))
    assert kept.trace.exact
    assert len(kept.trace.profile) == 40
    merged = svg(tmp_path, lines, Options(axis=0.0, tolerance=0.1, merge=True))
    assert not merged.trace.exact
    assert len(merged.trace.profile) == 1
    assert merged.trace.largest_deviation <= 0.1


def test_our_own_path_changed_by_another_program_is_what_is_drawn(tmp_path: Path) -> None:
    stream = BytesIO()
    points = [[20.0, 0.0], [60.0, 10.0], [50.0, 40.0], [30.0, 50.0]]
    write_svg(Document(Profile.of([Segment(np.array(points))]), "jar"), stream)
    text = stream.getvalue().decode()
    old, new = "C 60 -10 50 -40 30 -50", "C 70 -10 50 -40 30 -50"
    assert old in text
    (segment,) = taken(tmp_path, "jar.svg", text.replace(old, new)).trace.profile.segments
    assert segment.points[1].tolist() == [70.0, 10.0]


@pytest.mark.parametrize("closed", [False, True])
def test_our_own_files_come_back_whole(tmp_path: Path, closed: bool) -> None:
    parameters = ShapeParameters(2.0, 4.5, 0.25, 0.875)
    points = [[20.0, 0.0], [60.0, 10.0], [50.0, 40.0], [30.0, 50.0]]
    back = [[30.0, 50.0], [10.0, 60.0], [5.0, 10.0], [20.0, 0.0]]
    segments = [Segment(np.array(points), parameters), Segment(np.array(back), parameters)]
    rules = (JointRule.G0,) * (2 if closed else 1)
    profile = Profile(tuple(segments), rules, closed)
    stream = BytesIO()
    write_svg(Document(profile, "jar"), stream)
    found = taken(tmp_path, "jar.svg", stream.getvalue()).trace.profile
    assert found.closed == closed
    np.testing.assert_allclose(found.quartics, profile.quartics, atol=1e-12)


_BOMB = '<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'


@pytest.mark.parametrize(
    ("text", "finding"),
    [
        (f'{_BOMB}<svg xmlns="http://www.w3.org/2000/svg">&b;</svg>', NoSource.ENTITIES),
        ('<svg xmlns="http://www.w3.org/2000/svg"><text>jar</text></svg>', NoSource.NO_PATH),
        ("<html/>", Unreadable("SVG", "its root is <html>")),
        (
            '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 V9"/></svg>',
            NoSource.ON_AXIS,
        ),
    ],
)
def test_what_is_no_drawing_is_refused(tmp_path: Path, text: str, finding: Finding) -> None:
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "drawing.svg", text, Options(axis=0.0))
    assert error.value.finding == finding


@pytest.mark.parametrize(
    "body",
    [
        '<g id="a"><use xlink:href="#a"/></g>',
        '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>',
        "<g>" * 5000 + "</g>" * 5000,
        '<g id="a0"><path d="M0 0 L1 1"/></g>'
        + "".join(f'<g id="a{k + 1}">' + f'<use href="#a{k}"/>' * 10 + "</g>" for k in range(30)),
        '<path d="M0 0 C 1e999 0 0 0 5 5"/>',
        '<path d="M1e308 0 L-1e308 5e307 L1e308 3"/>',
        '<path d="M0 0 nonsense"/>',
        "<path",
    ],
    ids=["itself", "each other", "deep", "laughs", "infinite", "vast", "nonsense", "cut off"],
)
def test_hostile_drawings_are_refused_in_one_line(tmp_path: Path, body: str) -> None:
    with pytest.raises(SourceError) as error:
        svg(tmp_path, body)
    assert "\n" not in str(error.value)


def test_files_that_a_drawing_names_are_not_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[object] = []
    real = open

    def watched(file: object, *rest: object, **more: object) -> object:
        opened.append(file)
        return real(file, *rest, **more)  # type: ignore[call-overload]

    monkeypatch.setattr("builtins.open", watched)
    linked = tmp_path / "linked.svg"
    linked.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    svg(tmp_path, f'<image href="{linked}"/><use href="{linked}#a"/>{CUBIC}', root=MM)
    assert str(linked) not in map(str, opened)


def test_a_path_of_too_many_numbers_is_refused_before_it_is_parsed(tmp_path: Path) -> None:
    places = " ".join(f"L{k % 97} {k}" for k in range(400_000))
    with pytest.raises(SourceError, match="more than 50000 lines and curves"):
        svg(tmp_path, f'<path d="M0 0 {places}"/>')
