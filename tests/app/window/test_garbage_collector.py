"""Where and when cyclic garbage is collected while the program runs."""

import gc
import threading

import pytest
from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from app.window import garbage_collector


class Loop:
    """Garbage that only the cycle collector frees, and that tells where it was freed."""

    def __init__(self, freed):
        self.me = self
        self.freed = freed

    def __del__(self):
        self.freed.append(threading.current_thread())


@pytest.fixture
def collector(qapp, monkeypatch):
    monkeypatch.setattr(garbage_collector, "INTERVAL_MILLISECONDS", 10)
    gc.collect()
    gc.enable()
    parent = QObject()
    made = garbage_collector.GarbageCollector(parent)
    yield made
    made.stop()


def litter():
    """Allocate what would make Python collect many times over."""
    return [[] for _ in range(100 * gc.get_threshold()[0])]


def test_a_worker_thread_frees_nothing_and_the_gui_thread_does(collector, qtbot):
    freed = []
    Loop(freed)
    worker = threading.Thread(target=litter)
    worker.start()
    worker.join()
    assert freed == []
    kept = litter()
    qtbot.waitUntil(lambda: freed == [threading.main_thread()])
    assert kept


def test_nothing_is_freed_during_a_drag(collector, qtbot):
    widget = QWidget()
    qtbot.addWidget(widget)
    widget.show()
    freed = []
    Loop(freed)
    kept = litter()
    QTest.mousePress(widget, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    QTest.qWait(100)
    assert freed == []
    QTest.mouseRelease(widget, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    qtbot.waitUntil(lambda: bool(freed))
    assert kept


def test_python_collects_again_afterwards(collector):
    assert not gc.isenabled()
    collector.stop()
    assert gc.isenabled()
