from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import resources
from sgb_core.document.file import json_text, project_file
from sgb_core.document.file.project_file import FileError
from sgb_core.document.model import Unit
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import documents, json_values

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))
SEGMENT = {"points": [[1, 0], [2, 1], [2, 2], [1, 3]]}


def profile(*segments: object, **more: object) -> dict:
    return samples.tree(profile={"segments": list(segments) or [SEGMENT], **more})


def law(**changes: object) -> dict:
    return samples.tree(variation=[{"parameter": "omega", "law": "paper", **changes}])


def refusal(data: bytes) -> str:
    with pytest.raises(FileError) as caught:
        project_file.loads(data)
    text = str(caught.value)
    assert "\n" not in text
    assert text.isprintable()
    return text


def test_only_three_things_are_required() -> None:
    document = project_file.loads(samples.data(samples.tree()))
    assert document.name == "Untitled"
    assert document.unit is Unit.MM
    assert document.revolution.axis == "z"
    assert document.revolution.sweep_deg == 360.0
    shape = document.profile.segments[0].shape
    assert (shape.lambda1, shape.lambda2, shape.lambda3, shape.omega) == (1, 3, 1, 0)


BAD = [
    ([], "the file is a list of 0; allowed is an object"),
    (samples.tree(format="svg"), 'format is "svg"; allowed is "sgb-document"'),
    ({"version": 1}, "format is missing"),
    (samples.tree(version=2), "version is 2; allowed is at most 1: a newer SGB Studio"),
    (samples.tree(version=10**308 * 9), "version is 9000"),
    (samples.tree(version=True), "version is true"),
    (samples.tree(version="1"), 'version is "1"'),
    (samples.tree(version=0), "version is 0"),
    (samples.tree(version=0.5), "version is 0.5"),
    (samples.tree(name=3), "name is 3; allowed is a string"),
    (samples.tree(unit="m"), 'unit is "m"; allowed is "mm", "cm", "in"'),
    ({"format": "sgb-document", "version": 1}, "profile is missing"),
    (samples.tree(profile=[]), "profile is a list of 0; allowed is an object"),
    (samples.tree(profile={}), "profile.segments is missing; allowed is a list of 1"),
    (samples.tree(profile={"segments": []}), "profile.segments is a list of 0"),
    (profile(3), "profile.segments[0] is 3; allowed is an object"),
    (profile({}), "profile.segments[0].points is missing; allowed is a list of 4 points"),
    (profile(SEGMENT, {**SEGMENT, "omega": 2}), "profile.segments[1].omega is 2; allowed is"),
    (profile({**SEGMENT, "omega": True}), "profile.segments[0].omega is true; allowed is a number"),
    (profile({**SEGMENT, "omega": None}), "profile.segments[0].omega is null"),
    (profile({**SEGMENT, "omega": "1"}), 'profile.segments[0].omega is "1"'),
    (profile({**SEGMENT, "lambda": [1, 3]}), "profile.segments[0].lambda is a list of 2"),
    (profile({**SEGMENT, "lambda": [1, 6.5, 1]}), "segments[0].lambda[1] is 6.5; allowed is a "),
    (profile({"points": [[1, 0]] * 3}), "profile.segments[0].points is a list of 3"),
    (profile({"points": [[1, 0, 0]] * 4}), "points[0] is a list of 3; allowed is a point"),
    (profile({"points": [[1, 2e9]] * 4}), "points[0][1] is 2000000000.0; allowed is a number fr"),
    (profile({"points": [[10**400, 0]] * 4}), "points[0][0] is too large"),
    (profile(SEGMENT, joints=["G1"]), "profile.joints is a list of 1; allowed is a list of 0"),
    (
        profile(SEGMENT, SEGMENT, joints=[]),
        "profile.joints is a list of 0; allowed is a list of 1:",
    ),
    (profile(SEGMENT, closed=1), "profile.closed is 1; allowed is true or false"),
    (profile(SEGMENT, closed=True), "profile.closed is true, but the last point is 3 from"),
    (profile(SEGMENT, SEGMENT, joints=["G3"]), 'profile.joints[0] is "G3"; allowed is "free"'),
    (profile(SEGMENT, SEGMENT), 'profile.joints[0] is "G0" (the default), but segments 0 and 1'),
    (profile(SEGMENT, SEGMENT, joints=["C1"]), 'profile.joints[0] is "C1", but segments 0 and 1'),
    (samples.tree(revolution={"axis": "w"}), 'revolution.axis is "w"'),
    (samples.tree(revolution={"sweep_deg": 0}), "revolution.sweep_deg is 0; allowed is a number"),
    (samples.tree(revolution={"sweep_deg": 361}), "revolution.sweep_deg is 361"),
    (samples.tree(revolution={"sweep_deg": 5e-324}), "revolution.sweep_deg is 5e-324"),
    (samples.tree(variation={}), "variation is an object; allowed is a list"),
    (samples.tree(variation=[{}]), "variation[0].parameter is missing"),
    (law(parameter="lambda4"), 'variation[0].parameter is "lambda4"'),
    (law(law="sine"), 'variation[0].law is "sine"; allowed is "paper"'),
    (law(to=1.5), "variation[0].to is 1.5; allowed is a number from 0 to 1"),
    (law(**{"from": -1}), "variation[0].from is -1"),
    (law(segments=[1]), "variation[0].segments[0] is 1; allowed is a segment number from 0 to 0"),
    (law(segments="some"), 'variation[0].segments is "some"'),
    (law(law="cosine", n=0), "variation[0].n is 0; allowed is a whole number"),
    (law(law="cosine", n=1.5), "variation[0].n is 1.5"),
    (law(law="keyframes"), "variation[0].keyframes is missing"),
    (law(law="keyframes", keyframes=[]), "variation[0].keyframes is a list of 0"),
    (law(law="keyframes", keyframes=[[0, 2]]), "variation[0].keyframes[0][1] is 2"),
    (law(law="keyframes", keyframes=[[0, 0], [360, 1]]), "variation[0].keyframes has two keys at"),
    (
        law(law="keyframes", keyframes=[[-1e-20, 0], [0, 0]]),
        "keyframes has two keys at 360 degrees",
    ),
    (law(law="keyframes", keyframes=[[1, 0], [1 + 1e-12, 1]]), "has two keys at 1 degrees"),
    (samples.tree(solid={"kind": "ball"}), 'solid.kind is "ball"'),
    (samples.tree(solid={"wall": 0}), "solid.wall is 0; allowed is a positive number"),
    (samples.tree(solid={"base": -1}), "solid.base is -1; allowed is a number of at least 0"),
    (samples.tree(solid={"drain_hole": -1}), "solid.drain_hole is -1"),
    (samples.tree(solid={"foot_ring": -1}), "solid.foot_ring is -1"),
    (samples.tree(placement={"rotation_deg": [0, 0]}), "placement.rotation_deg is a list of 2"),
    (samples.tree(placement={"translation": [0, 0, "a"]}), 'placement.translation[2] is "a"'),
]


@pytest.mark.parametrize(("tree", "text"), BAD, ids=[text[:40] for _, text in BAD])
def test_a_fault_is_named_with_its_place_and_what_is_allowed(tree: object, text: str) -> None:
    assert text in refusal(samples.data(tree))


UNREADABLE = [
    (b"", "not valid JSON (line 1, column 1)"),
    (b'{"format":\n "sgb-document",}', "not valid JSON (line 2, column 1"),
    (b'{"a": "\xff"}', "not UTF-8 text (byte 7)"),
    ('{"a": 1}'.encode("utf-16"), "not UTF-8 text"),
    (b'{"a": [1, NaN]}', "a[1] is NaN; allowed are finite numbers only"),
    (b'{"a": -Infinity}', "a is too large"),
    (b'{"a": 1e999}', "a is too large"),
    (b'{"a": ' + b"9" * 5000 + b"}", "a is too large"),
    (b"NaN", "the file is NaN"),
    (b'"\\ud800"', "the file holds half a character"),
    (b'{"a b": {"c": 1, "c": 2}}', '"a b".c is given twice'),
    (b'{"a": "\\udc00"}', "a holds half a character"),
    (b'{"a": {"\\udc00": 1}}', "half a character in its name"),
    (b"[" * 200_000, "nested deeper than 64 levels"),
    (b'{"a":' * 100 + b"1" + b"}" * 100, "nested deeper than 64 levels"),
    (b"[" * 100 + b"]" * 100, "nested deeper than 64 levels"),
    (b" " * (json_text.MAX_BYTES + 1), "larger than 32 MB"),
    (b"[" + b"[]," * 300_000, "more than 500000 values"),
]


@pytest.mark.parametrize(("data", "text"), UNREADABLE, ids=[text for _, text in UNREADABLE])
def test_what_is_no_strict_json_is_refused_in_one_line(data: bytes, text: str) -> None:
    assert text in refusal(data)


def test_too_many_segments_are_refused() -> None:
    line = {"points": [[1, 1]] * 4}
    assert "profile.segments is a list of 2001" in refusal(samples.data(profile(*[line] * 2_001)))


def test_free_joints_may_be_apart_and_rounding_is_no_gap() -> None:
    apart = profile(SEGMENT, SEGMENT, joints=["free"])
    assert project_file.loads(samples.data(apart)).profile.rules == ("free",)
    near = {"points": [[1, 3 + 1e-9], [2, 1], [2, 2], [1, 3]]}
    loaded = project_file.loads(samples.data(profile(SEGMENT, near)))
    assert loaded.profile.segments[1].points[0, 1] == 3 + 1e-9


def test_laws_are_read_as_written() -> None:
    keys = [[0, 0.5], [90, 1], [360, 0.5]]
    tree = law(parameter="lambda2", law="keyframes", to=6, segments=[0], keyframes=keys)
    (found,) = project_file.loads(samples.data(tree)).variation
    assert found.kind == "keyframes"
    assert (found.parameter, found.start, found.end, found.segments) == ("lambda2", 0, 6, (0,))
    assert found.keyframes == ((0, 0.5), (90, 1), (360, 0.5))


def test_unknown_keys_are_kept_at_every_level() -> None:
    tree = {
        **law(ghost=1, **{"from": 0.25}),
        "appearance": {"colour": [0.1, None, {"deep": "ü"}]},
        "revolution": {"axis": "x", "ghost": 2},
        "solid": {"ghost": 3},
        "placement": {"ghost": 4},
    }
    tree["profile"] = {"segments": [{**SEGMENT, "ghost": 5}], "ghost": 6}
    again = json.loads(project_file.dumps(project_file.loads(samples.data(tree))))
    assert again["appearance"] == tree["appearance"]
    places = [again[key]["ghost"] for key in ("revolution", "solid", "placement", "profile")]
    assert places == [2, 3, 4, 6]
    assert again["profile"]["segments"][0]["ghost"] == 5
    assert again["variation"][0]["ghost"] == 1


def test_files_are_readable_and_exact() -> None:
    third = {"points": [[1 / 3, -0.0], [2, 1], [2e-7, 2], [1e9, 3]]}
    text = project_file.dumps(project_file.loads(samples.data(profile(third)))).decode()
    assert '"points": [[0.3333333333333333, -0.0], [2, 1], [2e-07, 2], [1000000000, 3]],' in text
    assert max(map(len, text.splitlines())) <= 100
    assert text.endswith("}\n")


def test_a_byte_order_mark_is_no_fault() -> None:
    assert project_file.loads(b"\xef\xbb\xbf" + samples.data(samples.tree())).name == "Untitled"


@pytest.mark.parametrize("preset", resources.presets(), ids=lambda preset: preset.name)
def test_presets_load_without_a_warning_that_is_not_their_point(preset: resources.Preset) -> None:
    document = project_file.loads(resources.load_preset(preset.name))
    assert project_file.loads(project_file.dumps(document)) == document


def test_loading_names_the_file(tmp_path: Path) -> None:
    target = tmp_path / "a.sgb"
    with pytest.raises(FileError, match=r"cannot read .*a\.sgb: No such file"):
        project_file.load(target)
    with pytest.raises(FileError, match="it is a folder"):
        project_file.load(tmp_path)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(FileError, match="not a regular file"):
        project_file.load(tmp_path / "pipe")
    with pytest.raises(FileError, match="cannot read"):
        project_file.load("a\0b")
    target.write_bytes(b"{")
    with pytest.raises(FileError, match=re.escape(f"{target}: the file is not valid JSON")):
        project_file.load(target)


def test_saving_and_loading(tmp_path: Path) -> None:
    document = samples.document(rules=("G1", "free"))
    project_file.save(document, tmp_path / "vase.sgb")
    assert project_file.load(tmp_path / "vase.sgb") == document


def survives(data: bytes) -> None:
    document, fault = None, ""
    try:
        document = project_file.loads(data)
    except FileError as error:
        fault = str(error)
    assert "\n" not in fault
    if document is not None:
        assert project_file.loads(project_file.dumps(document)) == document


@calm
@given(st.binary(max_size=200) | st.text(max_size=100).map(lambda text: text.encode()))
def test_any_bytes_give_a_document_or_one_line(data: bytes) -> None:
    survives(data)


@calm
@given(json_values, st.sampled_from(["profile", "revolution", "variation", "solid", "name"]))
def test_any_json_gives_a_document_or_one_line(value: object, key: str) -> None:
    survives(samples.data(value))
    survives(samples.data(samples.tree(**{key: value})))


@settings(calm, max_examples=120)
@given(documents(most=2), st.data())
def test_a_file_with_one_value_replaced_gives_a_document_or_one_line(document, data) -> None:
    tree = json.loads(project_file.dumps(document))
    place: object = tree
    while True:
        keys = list(place) if isinstance(place, dict) else list(range(len(place)))
        if not keys:
            return
        key = data.draw(st.sampled_from(keys))
        if not isinstance(place[key], (dict, list)) or data.draw(st.integers(0, 3)) == 0:
            break
        place = place[key]
    odd = json_values | st.sampled_from([1e300, -1, 2, 10**20, 0.5, True, "all", [], {}, [[0, 0]]])
    place[key] = data.draw(odd)
    survives(json.dumps(tree).encode())


@calm
@given(documents(most=2), st.data())
def test_a_file_with_bytes_changed_gives_a_document_or_one_line(document, data) -> None:
    text = bytearray(project_file.dumps(document))
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(text) - 1))
        text[at : at + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=3))
    survives(bytes(text))
