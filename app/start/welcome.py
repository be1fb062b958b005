"""What greets the user: gallery, hints, tour, and the offer of work that a crash left behind."""

from __future__ import annotations

from PySide6.QtCore import QObject, QPoint, QSettings
from PySide6.QtWidgets import QWidget

from app.files.files import Files
from app.files.safekeeping import Safekeeping
from app.hand.coordinates import DesignPoint
from app.panels.shape.panel import ShapePanel
from app.profile_editor.view import ProfileView
from app.start.gallery import Gallery
from app.start.hints import Hint, Hints
from app.start.tour import Tour
from app.state import preferences
from app.state.presenter import Presenter
from app.viewport.view import SurfaceView
from app.widgets.mark_slider import MarkSlider
from sgb_core.values import dataclass

WELCOMED = "welcomed"


@dataclass(frozen=True, slots=True)
class Landmarks:
    """What the hints point at: the panel of the sliders and the two views."""

    shape_panel: ShapePanel
    editor: ProfileView
    viewport: SurfaceView


class Welcome(QObject):
    """Lays things over one window; each is made when it is first wanted."""

    def __init__(
        self,
        window: QWidget,
        presenter: Presenter,
        files: Files,
        safekeeping: Safekeeping,
        landmarks: Landmarks,
    ) -> None:
        super().__init__(window)
        self._safekeeping = safekeeping
        self.gallery = Gallery(files, window)
        self.tour = Tour(presenter, window, landmarks.shape_panel.hand_over)
        self.hints = Hints(_hints(window, presenter, landmarks), window)
        self.gallery.left.connect(self.hints.show)

    def at_start(self) -> None:
        """Greet: unsaved work first of all, else at the first start, or when asked to, gallery."""
        first = not QSettings().contains(WELCOMED)
        QSettings().setValue(WELCOMED, True)
        if self._safekeeping.offer():
            return
        if first or preferences.current().gallery_at_start:
            self.show_gallery()
        else:
            self.hints.show()

    def show_gallery(self) -> None:
        """Offer shapes to start from."""
        self.tour.stop()
        self.hints.hide()
        self.gallery.open()

    def start_tour(self) -> None:
        """Show what the four parameters do."""
        self.gallery.leave()
        self.hints.hide()
        self.tour.start()

    def show_hints(self) -> None:
        """Show the three hints once more."""
        self.gallery.leave()
        self.tour.stop()
        self.hints.show_again()

    def follow_size(self) -> None:
        """Keep to their places in a window of another size."""
        self.gallery.place()
        self.tour.place()
        self.hints.look()


def _hints(window: QWidget, presenter: Presenter, landmarks: Landmarks) -> list[Hint]:
    panel, editor, view = landmarks.shape_panel, landmarks.editor, landmarks.viewport

    def on_window(widget: QWidget, point: QPoint) -> QPoint | None:
        seen = widget.isVisible() and not widget.visibleRegion().isEmpty()
        return widget.mapTo(window, point) if seen else None

    def middle(each: QWidget) -> int:
        return each.mapTo(panel, each.rect().center()).y()

    def slider() -> QPoint | None:
        for each in panel.findChildren(MarkSlider):
            inside = each.visibleRegion().contains(each.rect().center())
            if each.isVisible() and each.isEnabled() and inside:
                # From beside the panel, so that the names of the sliders stay to be read.
                return on_window(panel, QPoint(0, middle(each)))
        return None

    def point() -> QPoint | None:
        segments = presenter.document.profile.segments
        r, h = segments[len(segments) // 2].points[1]
        at = editor.transform.to_screen(DesignPoint(float(r), float(h)))
        place = QPoint(round(at.x), round(at.y))
        return on_window(editor, place + QPoint(7, 0)) if editor.rect().contains(place) else None

    def viewport() -> QPoint | None:
        return on_window(view, QPoint(view.width() // 2, round(view.height() * 0.62)))

    def shapes() -> tuple[object, object]:
        frame = presenter.frame
        return frame.generation, [s.shape for s in frame.document.profile.segments]

    def points() -> tuple[object, object]:
        frame = presenter.frame
        return frame.generation, frame.document.profile.control_points.tobytes()

    def pose() -> tuple[object, object]:
        at = view.pose
        epoch = (presenter.frame.generation, at is None)
        return epoch, None if at is None else (at.azimuth, at.elevation)

    return [
        Hint(
            "slider",
            "Drag a slider: λ1, λ2, λ3 and ω reshape the segment, its points stay.",
            "left",
            slider,
            shapes,
        ),
        Hint(
            "point", "Drag a point of the profile; Esc takes the drag back.", "right", point, points
        ),
        Hint(
            "orbit",
            "Drag here to look from another side; the wheel zooms at the cursor.",
            "top",
            viewport,
            pose,
        ),
    ]
