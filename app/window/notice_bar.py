"""The card over the viewport in which the window says what happened and offers to mend it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import (
    QApplication,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from app.state.presenter import Frame, Notice, Presenter

# Long enough to read two lines, and to reach for the button; warnings and errors stay until they
# are dismissed or their cause is gone.
INFO_MILLISECONDS, OFFER_MILLISECONDS = 6000, 15000
# Its widest, how far it keeps from the edges, and what the viewport's buttons take at the right.
WIDEST, MARGIN, BUTTONS = 560, 10, 132
# What is narrower than this lies below the buttons instead, and so far.
LEAST, BELOW = 240, 36


class NoticeBar(QWidget):
    """A text, at most one button, and a cross; hidden while there is nothing to say.

    It lies over its parent and moves nothing there.
    """

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
        layout.setContentsMargins(12, 7, 6, 7)
        layout.addWidget(self._text, 1)
        layout.addWidget(self._button)
        layout.addWidget(self._close)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._time_out)
        if parent is not None:
            parent.installEventFilter(self)
        presenter.noticed.connect(self.show_notice)
        presenter.refreshed.connect(self._refreshed)
        self.hide()

    @property
    def notice(self) -> Notice | None:
        """What is being said, if anything."""
        return self._notice

    @property
    def foot(self) -> int:
        """The height on the screen below which nothing covers it, 0 while it is hidden."""
        if self.isHidden():
            return 0
        return self.mapToGlobal(self.rect().bottomLeft()).y() + MARGIN

    def show_notice(self, notice: Notice) -> None:
        """Say ``notice`` in place of what was said before, but for what stays."""
        if notice.holds is not None and self._notice is not None and self._notice.stays:
            return
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
        self.place()
        self.show()
        self.raise_()
        if notice.level == "info" and not notice.stays and notice.holds is None:
            self._timer.start(OFFER_MILLISECONDS if notice.action else INFO_MILLISECONDS)
        else:
            self._timer.stop()

    def place(self) -> None:
        """Lie in the upper corner of the parent, whatever its size has become."""
        holder = self.parentWidget()
        layout = self.layout()
        if holder is None or layout is None:
            return
        room = holder.width() - 2 * MARGIN
        beside = room - BUTTONS >= LEAST
        width, top = min(WIDEST, room - BUTTONS if beside else room), MARGIN
        if not beside:
            top += BELOW
        height = max(layout.totalHeightForWidth(width), layout.totalMinimumSize().height())
        self.setGeometry(MARGIN, top, width, min(height, holder.height() - top - MARGIN))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.parentWidget() and event.type() == QEvent.Type.Resize:
            self.place()
        return super().eventFilter(watched, event)

    def dismiss(self) -> None:
        """Hide the bar."""
        self._timer.stop()
        self._notice = None
        self._presenter.set_view(preview=None, before=None)
        self.hide()

    def _time_out(self) -> None:
        # What lies under a gallery or a menu has not been read yet.
        if self._is_covered():
            self._timer.start()
        else:
            self.dismiss()

    def _is_covered(self) -> bool:
        """Whether something of the window, or a popup, lies over the bar."""
        popup = QApplication.activePopupWidget()
        middle = self.rect().center()
        if popup is not None and popup.geometry().contains(self.mapToGlobal(middle)):
            return True
        part = self.window().childAt(self.mapTo(self.window(), middle))
        return part is not None and part is not self and not self.isAncestorOf(part)

    def _refreshed(self, frame: Frame) -> None:
        notice = self._notice
        if notice is None:
            return
        if notice.holds is not None:
            # While the hand moves its cause may come and go with each tick.
            if not frame.dragging and not notice.holds(frame):
                self.dismiss()
        elif not notice.stays and frame.generation != self._generation:
            # What was said of one document says nothing of the next.
            self.dismiss()

    def _run(self) -> None:
        notice = self._notice
        self.dismiss()
        if notice is not None and notice.callback is not None:
            notice.callback()
