"""The texture part of the look panel: which picture lies where, how often, how turned."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Literal

from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QFileDialog, QWidget

from app.panels.look.form import LookForm, show_choice, show_depths
from app.panels.look.swatches import picture_swatch, texture_swatch
from app.state.picture_choice import PICTURE_FILES, TEXTURES, picture_bytes
from app.state.presenter import Frame, Presenter
from app.state.window_reader import segment_titles
from app.widgets.number_field import NumberField
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Appearance, Raised, Texture
from sgb_core.fields.lists import Fixed
from sgb_core.fields.record import table_of

Pair = Literal["repeat", "offset"]
_OWN = "own picture"
_PLAIN = Texture("none")


class TexturePart(LookForm):
    """Textures of the whole surface, or of one segment over it."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, "Texture", parent)
        self._profile: Profile | None = None
        self._where: int | None = None
        # The document's own pictures as they are offered, and what the files of some were called.
        self._own: dict[str, str] = {}
        self._files: dict[str, str] = {}
        self.where = self.combo("On", [("Everything", None)], self._look_at, "What is covered")
        entries = [("None", None), *TEXTURES, ("Picture from a file…", _OWN)]
        self.image = self.combo(
            "Picture",
            entries,
            self._choose,
            "A texture of the program, or a PNG or JPEG file",
            lambda name: QIcon() if name in (None, _OWN) else texture_swatch(name),
        )
        self.around = self._pair(
            "Around",
            "repeat",
            0,
            "Repeats around the object",
            span=(1.0, 16.0),
        )
        self.along = self._pair(
            "Along",
            "repeat",
            1,
            "Repeats along the profile; 0 keeps the picture's proportions",
            span=(1.0, 16.0),
        )
        shift = "In repeats of the picture"
        self.shift_u = self._pair("Shift around", "offset", 0, shift, step=0.05, span=(0.0, 1.0))
        self.shift_v = self._pair("Shift along", "offset", 1, shift, step=0.05, span=(0.0, 1.0))
        self.turn = self.number(
            "Turn",
            lambda look, value: self._with(look, lambda each: replace(each, rotate_deg=value)),
            "Turns the picture, to the nearest angle that closes around without a seam",
            reset=_PLAIN.rotate_deg,
            span=(-180.0, 180.0),
            allowed=table_of(Texture).row("rotate_deg").kind,
            step=15.0,
            unit="°",
            to_all=lambda look, value: _of_all(look, lambda each: replace(each, rotate_deg=value)),
        )
        self._build_depths()

    def _build_depths(self) -> None:
        """Add the rows of a texture's relief."""
        self.relief = self._length(
            "Relief",
            "relief",
            "Raises the surface by the picture's grey, or sinks it where negative; 0 is paint",
            (-2.0, 2.0),
            0.1,
        )
        self.edge = self._length(
            "Soft edge", "edge", "How far the picture's steps are smoothed", (0.5, 6.0), 0.5
        )
        self.raised = self.combo(
            "Full depth",
            [("Light parts", Raised.LIGHT), ("Dark parts", Raised.DARK)],
            lambda raised: self.do(
                "Full depth", lambda look: self._with(look, partial(_changed, raised=raised))
            ),
            "Which parts of the picture are moved by the full depth",
        )

    def _length(
        self, name: str, key: str, tip: str, span: tuple[float, float], step: float
    ) -> NumberField:
        """Add a row for a length of a texture's relief."""
        return self.number(
            name,
            lambda look, value: self._with(look, partial(_changed, **{key: value})),
            tip,
            reset=getattr(_PLAIN, key),
            span=span,
            allowed=table_of(Texture).row(key).kind,
            step=step,
            to_all=lambda look, value: _of_all(look, partial(_changed, **{key: value})),
        )

    def _pair(self, name: str, key: Pair, place: int, tip: str, **numbers: Any) -> NumberField:
        """Add a row for one of the two numbers of a texture's field."""
        kind = table_of(Texture).row(key).kind
        assert isinstance(kind, Fixed)
        return self.number(
            name,
            lambda look, value: self._with(look, partial(_placed, key, place, value)),
            tip,
            reset=getattr(_PLAIN, key)[place],
            allowed=kind.inner[place],
            to_all=lambda look, value: _of_all(look, partial(_placed, key, place, value)),
            **numbers,
        )

    def refresh(self, frame: Frame) -> None:
        """Show the texture of the chosen part."""
        profile = frame.document.profile
        if profile is not self._profile and not frame.dragging:
            self._profile = profile
            self._offer(segment_titles(profile))
        self._show(frame.document.appearance)

    def _offer(self, titles: list[str]) -> None:
        """Offer everything and each segment, keeping the one that is chosen."""
        if [self.where.itemText(k) for k in range(1, self.where.count())] != titles:
            self.where.clear()
            self.where.addItem("Everything", None)
            for segment, title in enumerate(titles):
                self.where.addItem(title, segment)
            if self._where is not None and self._where >= len(titles):
                self._where = None
            show_choice(self.where, self._where)

    def _show(self, look: Appearance) -> None:
        texture = self._present(look)
        self._offer_own(look)
        show_choice(self.image, texture.image if texture else None)
        shown = texture or _PLAIN
        for field, value in (
            (self.around, shown.repeat[0]),
            (self.along, shown.repeat[1]),
            (self.shift_u, shown.offset[0]),
            (self.shift_v, shown.offset[1]),
            (self.turn, shown.rotate_deg),
        ):
            field.set_value(value)
            field.setEnabled(texture is not None)
        show_depths(self.presenter.document, self.relief, shown.relief, self.edge, shown.edge)
        show_choice(self.raised, shown.raised)
        self.relief.setEnabled(texture is not None)
        for part in (self.edge, self.raised):
            self.form.setRowVisible(part, shown.relief != 0.0)

    def _offer_own(self, look: Appearance) -> None:
        """Offer the pictures that the document has of its own, before those in files."""
        own = {
            picture.name: self._files.get(picture.name, f"Own picture {number}")
            for number, picture in enumerate(look.pictures, 1)
        }
        if own == self._own:
            return
        for name in self._own:
            self.image.removeItem(self.image.findData(name))
        for picture in look.pictures:
            icon, title = picture_swatch(picture.data), own[picture.name]
            self.image.insertItem(self.image.count() - 1, icon, title, picture.name)
        self._own = own

    def _look_at(self, segment: int | None) -> None:
        self._where = segment
        self._show(self.appearance)

    @property
    def _segments(self) -> tuple[int, ...] | None:
        return None if self._where is None else (self._where,)

    def _present(self, look: Appearance) -> Texture | None:
        found = (each for each in look.textures if each.segments == self._segments)
        return next(found, None)

    def _replaced(self, look: Appearance, texture: Texture | None) -> Appearance:
        return edits.with_texture(look, self._segments, texture)

    def _with(self, look: Appearance, change: Callable[[Texture], Texture]) -> Appearance:
        texture = self._present(look)
        return look if texture is None else self._replaced(look, change(texture))

    def _choose(self, image: str | None) -> None:
        look = self.appearance
        if image == _OWN:
            self.ask_for_picture()
            return
        texture = None
        if image is not None:
            first = Texture(image, repeat=(1.0, 0.0)) if image in self._own else Texture(image)
            texture = replace(self._present(look) or first, image=image)
            texture = replace(texture, segments=self._segments)
        named = self.image.itemText(self.image.findData(image))
        title = named if image in self._own else named.lower()
        self.do(f"Texture {title}", lambda look: self._replaced(look, texture))

    def ask_for_picture(self) -> None:
        """Ask for a picture in a file and lay it over the chosen part."""
        path, _ = QFileDialog.getOpenFileName(self, "Picture for the surface", "", PICTURE_FILES)
        if path:
            self.take_picture(Path(path))
        self._show(self.appearance)

    def take_picture(self, path: Path) -> None:
        """Lay the picture in a file over the chosen part; it is kept inside the project."""
        data = picture_bytes(self.presenter, path)
        if data is None:
            return
        segments = self._segments
        taken = self.presenter.do(
            f"Picture {path.name}", lambda document: edits.add_picture(document, data, segments)
        )
        texture = self._present(self.appearance)
        if taken and texture is not None:
            self._files[texture.image] = path.stem
            self._show(self.appearance)


def _changed(texture: Texture, **changes: Any) -> Texture:
    return replace(texture, **changes)


def _placed(key: Pair, place: int, value: float, texture: Texture) -> Texture:
    first, second = texture.repeat if key == "repeat" else texture.offset
    pair = (value, second) if place == 0 else (first, value)
    return replace(texture, repeat=pair) if key == "repeat" else replace(texture, offset=pair)


def _of_all(look: Appearance, change: Callable[[Texture], Texture]) -> Appearance:
    return replace(look, textures=tuple(change(each) for each in look.textures))
