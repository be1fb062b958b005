"""The quiet bar in which the window says what happened and offers to mend it."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QToolButton, QWidget

from app.state.presenter import Frame, Notice, Presenter

# Long enough to read two lines; errors and notices with a button stay until dismissed.
INFO_MILLISECONDS = 6000


class NoticeBar(QWidget):
    """One line of text, at most one button, and a cross; hidden while there is nothing to say."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("noticeBar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._presenter = presenter
        self._notice: Notice | None = None
        self._generation = 0
        self._text = QLabel(self)
        self._text.setWordWrap(True)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._button = QPushButton(self)
        self._button.setAccessibleName("Mend what the notice says")
        self._button.setToolTip("Do what mends it")
        self._button.clicked.connect(self._run)
        self._close = QToolButton(self)
        self._close.setText("×")
        self._close.setToolTip("Dismiss this notice (Esc)")
        self._close.setAccessibleName("Dismiss notice")
        self._close.setShortcut(Qt.Key.Key_Escape)
        self._close.clicked.connect(self.dismiss)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 4, 6, 4)
        layout.addWidget(self._text, 1)
        layout.addWidget(self._button)
        layout.addWidget(self._close)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.dismiss)
        presenter.noticed.connect(self.show_notice)
        presenter.refreshed.connect(self._refreshed)
        self.hide()

    @property
    def notice(self) -> Notice | None:
        """What is being said, if anything."""
        return self._notice

    def show_notice(self, notice: Notice) -> None:
        """Say ``notice`` in place of whatever was said before."""
        # What the notice before this one offered, or told of, is shown no more.
        self._presenter.set_view(preview=None, before=None)
        self._notice = notice
        self._generation = self._presenter.frame.generation
        mark = {"info": "", "warning": "⚠ ", "error": "✕ "}[notice.level]
        self._text.setText(mark + notice.text)
        self._text.setAccessibleName(notice.text)
        self._button.setText(notice.action)
        self._button.setAccessibleName(f"{notice.action}: {notice.text}")
        self._button.setVisible(bool(notice.action))
        self.setProperty("level", notice.level)
        self.style().unpolish(self)
        self.style().polish(self)
        self.show()
        if notice.level == "info" and not notice.action:
            self._timer.start(INFO_MILLISECONDS)
        else:
            self._timer.stop()

    def dismiss(self) -> None:
        """Hide the bar."""
        self._timer.stop()
        self._notice = None
        self._presenter.set_view(preview=None, before=None)
        self.hide()

    def _refreshed(self, frame: Frame) -> None:
        # What was said of one document says nothing of the next; an offer, as to restore, stays.
        notice = self._notice
        if notice is not None and not notice.action and frame.generation != self._generation:
            self.dismiss()

    def _run(self) -> None:
        notice = self._notice
        self.dismiss()
        if notice is not None and notice.callback is not None:
            notice.callback()
