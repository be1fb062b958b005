"""The printers' data files: all as the schema says, faults named."""

from __future__ import annotations

import json

import jsonschema
import pytest

import resources
from sgb_core.findings.refusal import RefusalError
from sgb_core.toolpaths.printer import printer_of, printer_text, schema

FILES = resources.printers()


def test_the_schema_in_the_resources_is_the_one_of_the_class() -> None:
    jsonschema.Draft202012Validator.check_schema(schema())
    assert json.loads(resources.read("sgb-printer.schema.json")) == schema()


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_each_printer_follows_the_schema_and_comes_back(path) -> None:
    tree = json.loads(path.read_bytes())
    jsonschema.validate(tree, schema())
    printer = printer_of(path.read_bytes())
    assert printer.name == path.stem
    assert printer_of(printer_text(printer)) == printer
    assert not any("{" in line for line in printer.lines(printer.start + printer.end))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"bed": {"width": -1, "depth": 1, "height": 1}}, r"bed\.width is -1; allowed is a number"),
        ({"layer": {"usual": 9, "least": 1, "most": 2}}, r"layer\.usual is 9.*from 1 to 2"),
        ({"firmware": "own"}, "firmware is .*marlin"),
        ({"nozzle": None}, "nozzle is null"),
        ({"start": ["G28\nM104 S400"]}, r"start\[0\] is .*a line"),
        ({"feed": {"unit": "none"}}, r"feed\.flow .*above 0"),
        ({"format": "sgb-document"}, "format is .*sgb-printer"),
    ],
)
def test_a_fault_is_named_with_its_place_and_what_is_allowed(change, words) -> None:
    tree = {**json.loads(FILES[0].read_bytes()), **change}
    with pytest.raises(RefusalError, match=words) as caught:
        printer_of(json.dumps(tree))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("text", ["", "[]", "{", "[" * 100_000, "3", "null", '{"format": 1}'])
def test_what_is_no_printer_is_one_line(text) -> None:
    with pytest.raises(RefusalError) as caught:
        printer_of(text)
    assert "\n" not in str(caught.value)
