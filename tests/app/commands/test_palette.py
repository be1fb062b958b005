"""The rows of the command palette: level with each other, icons seen on the chosen one."""

from functools import partial

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction, QColor, QIcon, QPixmap
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLabel, QLineEdit, QListWidget

from app.commands.asked import asked
from app.commands.palette import NOTHING, CommandPalette
from app.commands.synonyms import SYNONYMS
from app.state.presenter import Presenter
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.locks.dimension import Dimension
from sgb_core.document import edits
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.app.helpers import tower
from tests.app.window_stage import WindowStage


def palette(qtbot):
    done, entries = [], []
    for name in ("Fit view", "Save", "Save as"):
        action = QAction(name)
        action.triggered.connect(lambda _checked=False, name=name: done.append(name))
        entries.append((name, action))
    picture = QPixmap(32, 32)
    picture.fill(Qt.GlobalColor.red)
    entries[0][1].setIcon(QIcon(picture))
    made = CommandPalette(entries)
    qtbot.addWidget(made)
    made.show()
    return made, made.findChild(QListWidget), done


def test_rows_are_level_and_the_chosen_icon_keeps_its_colour(qtbot):
    _, rows, _ = palette(qtbot)
    heights = {rows.visualItemRect(rows.item(k)).height() for k in range(rows.count())}
    assert len(heights) == 1
    icon = rows.item(0).icon()
    for mode in (QIcon.Mode.Normal, QIcon.Mode.Selected):
        colour = icon.pixmap(QSize(16, 16), mode).toImage().pixelColor(5, 5)
        assert colour == QColor(Qt.GlobalColor.red)


def test_letters_narrow_and_enter_does(qtbot):
    made, rows, done = palette(qtbot)
    QTest.keyClicks(made.findChild(QLineEdit), "sas")
    assert rows.currentItem().text() == "Save as"
    QTest.keyClick(made.findChild(QLineEdit), Qt.Key.Key_Return)
    assert done == ["Save as"]


def test_what_is_typed_arrives_without_a_click(qtbot):
    made, rows, done = palette(qtbot)
    qtbot.waitExposed(made)
    # As the window system delivers keys: to the window, whose part with the focus gets them.
    for key in (Qt.Key.Key_S, Qt.Key.Key_A, Qt.Key.Key_S):
        QTest.keyClick(made.windowHandle(), key)
    assert rows.currentItem().text() == "Save as"
    QTest.keyClick(made.windowHandle(), Qt.Key.Key_Return)
    assert done == ["Save as"]


def typed(qtbot, words, entries, **options):
    made = CommandPalette(entries, **options)
    qtbot.addWidget(made)
    made.show()
    QTest.keyClicks(made.findChild(QLineEdit), words)
    rows = made.findChild(QListWidget)
    return made, [rows.item(k).text() for k in range(rows.count())]


WORDS = {
    "draw": "tool_pen",
    "import": "import",
    "diameter": "panel_turn",
    "twist": "panel_vary",
    "lobes": "panel_vary",
    "spout": "panel_vary",
    "smooth": "make_fair",
    "fair": "make_fair",
    "photo": "picture_around",
    "photo around the belly": "picture_around",
    "make it thicker": "panel_solid",
    "undoo": "undo",
    "relief": "panel_look",
    "volume": "panel_measures",
    "undo": "undo",
    "units": "preferences",
    "thick": "panel_solid",
    "holes": "panel_solid",
    "measure": "panel_measures",
    "print": "print_path",
    "gcode": "print_path",
    "trace": "import",
    "background": "picture_behind",
    "variants": "variants",
    "guide": "guide_level",
}


def test_it_knows_the_users_words_and_says_when_it_finds_nothing(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    bowl = stage.document.profile.bounds()[1][1]
    stage.presenter.do("Height", lambda document: edits.set_height(document, bowl + 1.0))
    stage.settle()
    stage.window.commands["palette"].trigger()
    made = QApplication.activePopupWidget()
    query, rows = made.findChild(QLineEdit), made.findChild(QListWidget)
    for word, name in WORDS.items():
        query.setText(word)
        numbers = [rows.item(k).data(Qt.ItemDataRole.UserRole) for k in range(rows.count())]
        found = [made._entries[k][1].objectName() for k in numbers]
        assert name in found[:5], word
    query.setText("zzyzx")
    assert rows.count() == 0
    nothing = next(each for each in made.findChildren(QLabel) if each.text() == NOTHING)
    assert nothing.isVisible()
    QTest.keyClick(query, Qt.Key.Key_Return)
    assert made.isVisible()
    made.close()
    stage.close()


def test_a_photo_is_laid_around_from_the_palette(qtbot, tmp_path, monkeypatch):
    stage = WindowStage(qtbot, wait_for_scene=False, make_panels=False)
    path = tmp_path / "cat.png"
    picture = QPixmap(8, 8)
    picture.fill(Qt.GlobalColor.red)
    assert picture.save(str(path))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    stage.window.commands["palette"].trigger()
    made = QApplication.activePopupWidget()
    query, rows = made.findChild(QLineEdit), made.findChild(QListWidget)
    QTest.keyClicks(query, "photo")
    assert rows.currentItem().text().startswith("Picture around the surface")
    QTest.keyClick(query, Qt.Key.Key_Return)
    stage.settle()
    (texture,) = stage.document.appearance.textures
    assert texture.segments is None
    assert stage.session.undo_label == "Picture cat.png"
    assert stage.window.panels.docks["look"].isVisible()
    stage.close()


def test_every_synonym_belongs_to_an_action(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    unknown = set(SYNONYMS) - set(stage.window.commands.actions)
    stage.close()
    assert unknown == set()


def test_keys_stand_at_the_right(qtbot):
    action = QAction("Save")
    action.setShortcut("Ctrl+S")
    made, found = typed(qtbot, "sa", [("Save", action)])
    assert found == ["Save"]
    rows = made.findChild(QListWidget)
    picture = rows.viewport().grab().toImage()
    row = rows.visualItemRect(rows.item(0))
    ground = picture.pixel(row.center())
    right = range(row.right() - 60, row.right() - 8)
    middle = range(row.center().y() - 6, row.center().y() + 6)
    assert any(picture.pixel(x, y) != ground for x in right for y in middle)


def test_a_name_and_a_number_are_a_command(qtbot):
    presenter = Presenter(Session(tower()))
    made, found = typed(qtbot, "height 95", [], asked=partial(asked, presenter))
    assert found == ["Height 95 mm"]
    QTest.keyClick(made.findChild(QLineEdit), Qt.Key.Key_Return)
    assert presenter.document.height == pytest.approx(95.0)
    assert presenter.session.undo_label == "Height 95 mm"


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ("wall 4", "Wall 4 mm"),
        ("thick 0.5cm", "Wall 5 mm"),
        ("diameter = 3in", "Largest diameter 76.2 mm"),
        ("hold 0.35 l", "Make it hold 350 ml"),
        ("hold 12 fl oz", "Make it hold 354.882 ml"),
        ("volume 350", "Volume 350 ml"),
        ("fill 10", "Fill line below the rim 10 mm"),
        ("scale 2", "Scale × 2"),
        ("guide 3cm", "Level guide at 30 mm"),
        ("upright 7.5", "Upright guide at 7.5 mm"),
        ("sweep 180", "Sweep 180°"),
        ("lobes 8", "Lobes 8"),
        ("sides 6", "Sides 6"),
        ("twist 0.25", "Twist 0.25 turns"),
        ("shrinkage 12%", "Shrinkage 12 %"),
        ("height", None),
        ("height x", None),
        ("frob 3", None),
        ("height 1/", None),
    ],
)
def test_what_can_be_asked(query, words):
    found = asked(Presenter(Session(tower())), query)
    assert (None if found is None else found[0]) == words


def test_rim_and_foot_take_exact_numbers(qtbot):
    cup = Document(Profile.of([line((20, 0), (40, 60))]))
    presenter = Presenter(Session(cup))
    for query, words in (("rim 90", "Rim diameter 90 mm"), ("foot 5cm", "Foot diameter 50 mm")):
        made, found = typed(qtbot, query, [], asked=partial(asked, presenter))
        assert found == [words]
        QTest.keyClick(made.findChild(QLineEdit), Qt.Key.Key_Return)
        assert presenter.session.undo_label == words
    foot, rim = (presenter.document.profile.point(0, s)[0] for s in (0.0, 1.0))
    assert 2.0 * rim == pytest.approx(90.0)
    assert 2.0 * foot == pytest.approx(50.0)
    # Both are told in the drawing from then on, each once.
    asked(presenter, "rim 100")[1]()
    assert [each.kind.value for each in presenter.document.dimensions] == [
        "rim_diameter",
        "foot_diameter",
    ]


def test_lobes_and_sides_take_a_number_and_another_one_changes_it(qtbot):
    presenter = Presenter(Session(tower()))
    for query in ("lobes 8", "lobes 5", "sides 6"):
        asked(presenter, query)[1]()
    lobes, sides = presenter.document.variation
    assert (lobes.shape.name, lobes.parameter, lobes.count) == ("lobes", "radius", 5)
    assert (sides.shape.name, sides.count) == ("polygon", 6)
    asked(presenter, "twist 0.25")[1]()
    assert presenter.document.twist.turns == 0.25


def test_what_is_asked_to_hold_gets_a_wall_whatever_it_was(qtbot):
    for queries in (("fill 10", "hold 350ml"), ("hold 350ml", "fill 10", "hold 350ml")):
        presenter = Presenter(Session(Document(Profile.of([line((30, 0), (40, 100))]))))
        for query in queries:
            asked(presenter, query)[1]()
        document = presenter.document
        assert document.solid.kind is BodyKind.VESSEL
        assert (document.solid.wall, document.manufacture.fill.below_rim) == (3.0, 10.0)
        filled = dimension_value(document, Dimension("filled"))
        assert filled * document.unit.millilitres == pytest.approx(350.0, rel=1e-6)


def test_a_foot_takes_a_number_where_the_profile_starts_on_the_axis(qtbot):
    closed = Profile.of([line((0, 0), (29, 2)), line((29, 2), (6, 10)), line((6, 10), (40, 90))])
    presenter = Presenter(Session(Document(closed)))
    said = []
    presenter.noticed.connect(lambda notice: said.append(notice.text))
    asked(presenter, "foot 50")[1]()
    assert presenter.session.undo_label == "Foot diameter 50 mm"
    assert presenter.document.profile.point(1, 0.0) == pytest.approx([25.0, 2.0])
    assert presenter.document.profile.point(0, 0.0) == pytest.approx([0.0, 0.0])
    assert presenter.document.profile.point(2, 1.0) == pytest.approx([40.0, 90.0])
    assert said == []


def test_a_round_bottom_says_that_it_has_no_foot(qtbot):
    ball = Document(Profile.of([Segment(((0, 0), (40, 0), (40, 30), (20, 60)))]))
    presenter = Presenter(Session(ball))
    said = []
    presenter.noticed.connect(lambda notice: said.append(notice.text))
    asked(presenter, "foot 50")[1]()
    assert presenter.document is ball
    assert len(said) == 1
    assert "without a rim or a foot" in said[0]


def test_what_lies_in_a_submenu_says_of_what_it_is_and_a_body_is_found(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False, make_panels=False)
    stage.presenter.notify("Could not open vase.sgb.", "error")
    stage.window.commands["palette"].trigger()
    made = QApplication.activePopupWidget()
    query, rows = made.findChild(QLineEdit), made.findChild(QListWidget)
    assert made.geometry().top() >= stage.window.notice_bar.foot
    QTest.keyClicks(query, "dark")
    assert rows.currentItem().text() == "Theme: Dark"
    query.clear()
    QTest.keyClicks(query, "pot")
    texts = [rows.item(k).text() for k in range(rows.count())]
    rows.setCurrentRow(texts.index("Body: Vessel"))
    QTest.keyClick(query, Qt.Key.Key_Return)
    assert stage.document.solid.kind is BodyKind.VESSEL
    assert stage.session.undo_label == "Body: vessel"
    stage.close()
