"""Films of an object: which frames there are, and the files they go into. Draws nothing itself."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from math import cos, pi
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sgb_core.curves.segment import ParameterName
from sgb_core.document import edits
from sgb_core.document.edits.blend import blend
from sgb_core.document.file import hidden
from sgb_core.document.file.atomic import write_whole
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Range
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import NoFormat
from sgb_core.findings.plates import NoFilm
from sgb_core.findings.refusal import Argument
from sgb_core.values import dataclass

Image = NDArray[np.uint8]
Report = Callable[[float], None]

# By its suffix what each kind of film is called.
FORMATS = {".gif": "GIF", ".mp4": "MP4", ".png": "PNG pictures"}
FRAMES = (2, 2000)
# Frames a second.
SPEEDS = (0.5, 60.0)
# GIF counts in hundredths of a second, and viewers slow down what is quicker than two of them.
_GIF_UNIT, _GIF_QUICKEST = 0.01, 2


@dataclass(frozen=True, slots=True)
class Variation:
    """A shape parameter of a segment (None: all) that goes from one value to another and back."""

    segment: int | None
    parameter: ParameterName
    start: float
    end: float


@dataclass(frozen=True, slots=True)
class Passage:
    """From one saved state (None: the document as it is) to another and back."""

    start: str | None
    end: str

    def ends(self, document: Document) -> tuple[Document, Document]:
        """Return the first and the farthest document; raises EditError for a state not there."""
        first = document if self.start is None else edits.switch_state(document, self.start)
        return first, edits.switch_state(document, self.end)


@dataclass(frozen=True, slots=True)
class Film:
    """What moves: the object once around, unless its shape varies; ``fps`` frames a second.

    Raises ValueError for too few or too many frames, or a speed out of range.
    """

    frames: int = 60
    fps: float = 20.0
    variation: Variation | Passage | None = None

    def __post_init__(self) -> None:
        for name, value, allowed in (
            ("frames", self.frames, Range(*FRAMES, whole=True)),
            ("fps", self.fps, Range(*SPEEDS)),
        ):
            if not allowed.low <= value <= allowed.high:
                raise FindingError(Argument(name, value, allowed))

    def steps(self, document: Document) -> Iterator[tuple[Document, float]]:
        """Yield each frame's document and by what angle the viewer has gone around, in radians.

        The last frame leads back to the first. Raises EditError where a value is not allowed.
        """
        for number in range(self.frames):
            part = number / self.frames
            varied = self.variation
            if varied is None:
                # The object turns to the right, so the viewer goes to the left.
                yield document, -2.0 * pi * part
                continue
            share = (1.0 - cos(2.0 * pi * part)) / 2.0
            if isinstance(varied, Passage):
                yield blend(*varied.ends(document), share), 0.0
                continue
            value = varied.start + (varied.end - varied.start) * share
            shaped = edits.set_shape_parameter(document, varied.segment, varied.parameter, value)
            yield shaped, 0.0


def check_target(path: Path) -> None:
    """Raise ValueError unless a film can be written to a file of this name."""
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise FindingError(NoFormat(path.name, suffix, tuple(FORMATS)))
    if suffix == ".mp4" and _encoder() is None:
        raise FindingError(NoFilm.NO_ENCODER)


def write_film(path: Path, images: Iterator[Image], film: Film, report: Report) -> None:
    """Write frames of shape (h, w, 4), whole or not at all; ``report`` is told the part done.

    .gif and .mp4 become one file; .png becomes NAME_0001.png and so on. What ``report`` raises
    ends the writing and leaves nothing.
    """
    check_target(path)
    write = {".gif": _gif, ".mp4": _mp4, ".png": _pictures}[path.suffix.lower()]
    write(path, _reported(images, film, report), film)
    report(1.0)


def _reported(images: Iterator[Image], film: Film, report: Report) -> Iterator[Image]:
    for number, image in enumerate(images):
        report(number / film.frames)
        yield image


def _gif(path: Path, images: Iterator[Image], film: Film) -> None:
    from PIL import Image as Pictures

    frames = [_on_white(image) for image in images]
    # One palette for all: the ground does not flicker.
    sample = np.concatenate(frames[:: max(1, len(frames) // 6)])
    palette = Pictures.fromarray(sample).quantize(255)
    small = [
        Pictures.fromarray(frame).quantize(palette=palette, dither=Pictures.Dither.FLOYDSTEINBERG)
        for frame in frames
    ]
    pause = max(_GIF_QUICKEST, round(1.0 / film.fps / _GIF_UNIT))
    options: dict[str, Any] = {"save_all": True, "append_images": small[1:], "loop": 0}

    def write(stream: Any) -> None:
        small[0].save(stream, "GIF", duration=10 * pause, disposal=1, **options)

    write_whole(path, write)


def _pictures(path: Path, images: Iterator[Image], film: Film) -> None:
    from PIL import Image as Pictures

    digits = max(4, len(str(film.frames)))
    with _beside(path) as folder:
        names = []
        for number, image in enumerate(images, start=1):
            name = f"{path.stem}_{number:0{digits}d}.png"
            Pictures.fromarray(image).save(folder / name, "PNG")
            names.append(name)
        for name in names:
            os.replace(folder / name, path.parent / name)


def _mp4(path: Path, images: Iterator[Image], film: Film) -> None:
    encoder = _encoder()
    assert encoder is not None
    with _beside(path) as folder:
        target = folder / "film.mp4"
        writer = None
        for image in images:
            # The codec wants even sides.
            frame = _on_white(image)[: image.shape[0] // 2 * 2, : image.shape[1] // 2 * 2]
            if writer is None:
                size = (frame.shape[1], frame.shape[0])
                writer = encoder.write_frames(
                    str(target), size, fps=film.fps, quality=8, macro_block_size=2
                )
                writer.send(None)
            writer.send(np.ascontiguousarray(frame))
        if writer is not None:
            writer.close()
        os.replace(target, path)


def _beside(path: Path) -> AbstractContextManager[Path]:
    """Return a hidden folder beside the target; what killed programs left there goes."""
    hidden.clean(path.parent)
    return hidden.new_folder(path.parent)


def _encoder() -> Any:
    try:
        import imageio_ffmpeg
    except ImportError:
        return None
    return imageio_ffmpeg


def _on_white(image: Image) -> Image:
    """Return RGB; what is transparent lies on white."""
    alpha = image[..., 3:].astype(np.uint16)
    return np.asarray((image[..., :3] * alpha + 255 * (255 - alpha)) // 255, dtype=np.uint8)
