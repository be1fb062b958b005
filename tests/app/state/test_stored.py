"""Settings of any kind: what makes no sense gives way to the default and is set aside, once."""

import random

import pytest
from PySide6.QtCore import QByteArray, QPoint, QSettings

from app.state import preferences, stored
from app.state.preferences import Preferences
from app.state.stored import ASIDE

KINDS = ("", "-5", "nan", "1e400", "purple", "a, b", ["x", "y"], 7, -1.5, True, QPoint(1, 2))
KINDS += (QByteArray(b"\x01\xff"), {"a": 1}, None, "@Variant(junk)", "0", "on", "1e30")


@pytest.fixture(autouse=True)
def _nothing_said():
    stored.faults()


def test_an_unknown_theme_gives_way_and_is_said_once():
    QSettings().setValue("theme", "sepia")
    assert stored.stored_theme() == "system"
    assert stored.faults() == ["theme"]
    assert stored.stored_theme() == "system"
    assert stored.faults() == []
    assert QSettings().value(f"{ASIDE}/theme") == "sepia"
    QSettings().setValue("theme", "dark")
    assert stored.stored_theme() == "dark"


def test_a_number_out_of_its_range_gives_way():
    for value, right in (("2.5", 2.5), ("-1", 1.0), ("inf", 1.0), ("x", 1.0), (["3"], 1.0)):
        QSettings().setValue("n", value)
        assert stored.stored_number("n", 1.0, 0.0, 10.0) == right


@pytest.mark.parametrize("seed", range(30))
def test_whatever_is_stored_preferences_are_in_their_ranges(seed):
    drawn = random.Random(seed)
    for name in Preferences.__slots__:
        QSettings().setValue(name, drawn.choice(KINDS))
    read = preferences.reload()
    assert read.navigation_style in preferences.STYLES
    assert 80 <= read.text_percent <= 200
    assert 0.0 <= read.snap_step <= preferences.LARGEST_STEP
    assert all(isinstance(getattr(read, n), bool) for n in ("animate_views", "invert_wheel"))
    # What was set aside is not met again.
    stored.faults()
    assert preferences.reload() == read
    assert stored.faults() == []


def test_a_file_that_is_no_settings_is_moved_aside(tmp_path, monkeypatch):
    place = tmp_path / "broken.conf"
    place.write_bytes(b"[General\nthis is no line of settings\n\x00\xff")
    monkeypatch.setattr(stored, "QSettings", _settings_of(place))
    stored.check_store()
    left = list(tmp_path.iterdir())
    if place in left:
        # This system reads past the junk: nothing stands in the way of a start.
        assert stored.faults() == []
    else:
        assert stored.faults() == [f"the file {place}"]
        assert left[0].read_bytes().startswith(b"[General\n")


def test_a_folder_in_the_place_of_the_settings_is_said(tmp_path, monkeypatch):
    place = tmp_path / "folder.conf"
    place.mkdir()
    monkeypatch.setattr(stored, "QSettings", _settings_of(place))
    stored.check_store()
    assert stored.faults() == [f"the file {place}"]


def _settings_of(place):
    class Settings(QSettings):
        def __init__(self):
            super().__init__(str(place), QSettings.Format.IniFormat)

    return Settings


def test_an_empty_list_is_read_back_from_the_file_without_a_word(tmp_path, monkeypatch):
    place = tmp_path / "settings.conf"
    place.write_text("[General]\nnames=@Invalid()\n")
    monkeypatch.setattr(stored, "QSettings", _settings_of(place))
    assert stored.stored_words("names") == []
    assert stored.faults() == []


def test_a_store_that_cannot_be_written_is_known(tmp_path, monkeypatch):
    place = tmp_path / "no folder" / "settings.conf"
    monkeypatch.setattr(stored, "QSettings", _settings_of(place))
    stored.QSettings().setValue("theme", "dark")
    assert stored.unkept() == ""
    place.unlink()
    place.mkdir()
    stored.QSettings().setValue("theme", "light")
    assert stored.unkept() == str(place)
