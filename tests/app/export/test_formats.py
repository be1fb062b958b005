"""A format put into the table from outside is offered, explained and written like the others."""

import numpy as np
import pytest

from app.__main__ import main
from app.export.dialog import ExportDialog
from app.export.plan import ExportPlan, examine
from sgb_core import exchange
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.file import project_file
from sgb_core.document.model import Document

SIDE = Segment(np.linspace((20.0, 0.0), (20.0, 60.0), 4))
CYLINDER = Document(Profile.of([SIDE]), name="Cylinder")


def _points(request, stream):
    stream.writelines(b"%r %r %r\n" % tuple(point) for point in request.mesh.positions.tolist())
    return {f"{request.stem}.count": b"%d" % len(request.mesh.positions)}


POINTS = exchange.Format(
    ".pts", "Points", _points, lambda request: f"Points of {request.document.name}", any_unit=False
)


@pytest.fixture(autouse=True)
def _offered(monkeypatch):
    monkeypatch.setitem(exchange.FORMATS, POINTS.suffix, POINTS)


def test_the_command_line_names_and_writes_it(tmp_path, capsys):
    assert main(["export", "--help"]) == 0
    assert ".pts" in capsys.readouterr().out
    project = tmp_path / "cylinder.sgb"
    project_file.save(CYLINDER, project)
    assert main(["export", str(project), str(tmp_path / "a.pts"), "--samples", "4", "8"]) == 0
    lines = (tmp_path / "a.pts").read_text().splitlines()
    assert len(lines) == 5 * 8
    assert (tmp_path / "a.count").read_text() == "40"
    assert {float(line.split()[2]) for line in lines} == {0.0, 15.0, 30.0, 45.0, 60.0}
    assert main(["export", str(project), str(tmp_path / "a.nonsense")]) == 1
    assert ".pts" in capsys.readouterr().err


def test_the_dialog_offers_it_as_what_it_is(qtbot):
    dialog = ExportDialog(CYLINDER, exchange.suffixes())
    qtbot.addWidget(dialog)
    place = dialog.format.findData(".pts")
    assert dialog.format.itemText(place) == "Points (.pts)"
    dialog.format.setCurrentIndex(place)
    assert dialog.by_tolerance.isEnabled()
    assert not dialog.unit.isEnabled()
    assert dialog.axis.isEnabled()
    assert not dialog.form.isRowVisible(dialog.look)
    dialog.reject()


def test_what_its_file_will_hold_is_told_beforehand(tmp_path):
    found = examine(ExportPlan(CYLINDER, ".pts", samples=(4, 8)))
    assert "Points of Cylinder" in found.lines
    exchange.write(CYLINDER, tmp_path / "a.pts", samples=(4, 8))
    assert found.size == sum(each.stat().st_size for each in tmp_path.iterdir())
