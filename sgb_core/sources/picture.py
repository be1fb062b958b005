"""Pictures: the outline of a dark or plain object, or a line of a drawing followed by clicks."""

from __future__ import annotations

import io
import warnings
from math import cos, hypot, sin

import numpy as np

from sgb_core.arrays import Floats, Singles
from sgb_core.findings.finding import Finding
from sgb_core.findings.sources import NoSource, PictureSize, Sides, TinyPicture, TooMuch, Unreadable
from sgb_core.sources.errors import SourceError
from sgb_core.sources.ink import follow
from sgb_core.sources.options import Options
from sgb_core.sources.reading import Frame, Half, Reading
from sgb_core.sources.silhouette import Outline, largest_outline, sides_of, upright
from sgb_core.values import dataclass

LARGEST_SIDE, LARGEST_AREA = 20_000, 50_000_000
_SMALLEST_SIDE = 8


def read_picture(grey: Singles, options: Options) -> Reading:
    """Return the profile that a picture of this brightness shows, shape (rows, columns).

    Pixels count from the top left, a pixel's middle being a whole number; r = 0 is the axis and
    h = 0 the lowest point traced. Without clicks the largest outline is taken, its axis found by
    its symmetry (it may lean: the picture is turned upright by it) unless ``axis`` is given. With
    clicks the ink between them is followed; then the axis must be given. Raises SourceError
    where it shows nothing, and where its scale is not given.
    """
    if options.height is None and options.scale is None and options.scale_bar is None:
        raise SourceError(NoSource.NO_SCALE)
    axis = options.upright_axis()
    if options.clicks:
        if axis is None:
            raise SourceError(NoSource.NO_AXIS)
        line = follow(grey, options.clicks)
        middle = (len(grey) - 1) / 2.0
        sides = _side_of_line(_uprighted(line, axis, middle, options.lean))
        return _scaled(*sides, _Axis(axis, middle, options.lean), options, ())
    outline = largest_outline(grey, options.threshold)
    place, lean = upright(outline) if axis is None else (axis, options.lean)
    turned = _uprighted(outline.points, place, outline.middle, lean)
    right, left, cut = sides_of(Outline(turned, outline.at_edge, 0.0))
    notes = (Sides.CUT,) if cut else ()
    return _scaled(right, left, _Axis(place, outline.middle, lean), options, notes)


@dataclass(frozen=True, slots=True)
class _Axis:
    """The abscissa of an axis at the row half way up, and its lean in radians."""

    place: float
    middle: float
    lean: float


def parse_picture(data: bytes) -> Singles:
    """Return the brightness in [0, 1] of a PNG or JPEG, shape (rows, columns); clear is white.

    Raises SourceError for what is no picture or too large.
    """
    # Imported late: only this reader needs it.
    from PIL import Image, ImageOps, UnidentifiedImageError

    try:
        with warnings.catch_warnings():
            # Its own limit is a warning; ours below is stricter.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            picture: Image.Image = Image.open(io.BytesIO(data), formats=["PNG", "JPEG"])
            width, height = picture.size
            if max(width, height) > LARGEST_SIDE or width * height > LARGEST_AREA:
                raise SourceError(PictureSize(width, height, LARGEST_SIDE, LARGEST_AREA))
            if min(width, height) < _SMALLEST_SIDE:
                raise SourceError(TinyPicture(width, height))
            picture = ImageOps.exif_transpose(picture)
            if picture.mode in ("RGBA", "LA", "PA") or "transparency" in picture.info:
                over = Image.new("RGBA", picture.size, (255, 255, 255, 255))
                picture = Image.alpha_composite(over, picture.convert("RGBA"))
            grey = np.asarray(picture.convert("L"), dtype=np.float32) / np.float32(255.0)
    except UnidentifiedImageError:
        raise SourceError(Unreadable("PNG or JPEG picture", "")) from None
    except Image.DecompressionBombError:
        raise SourceError(TooMuch("pixels", LARGEST_AREA)) from None
    except (OSError, SyntaxError, ValueError, EOFError) as error:
        if isinstance(error, SourceError):
            raise
        raise SourceError(Unreadable("PNG or JPEG picture", str(error))) from None
    return grey


def _side_of_line(line: Floats) -> tuple[Floats | None, Floats | None]:
    """Return a line beside r = 0 as the right or the left side, (r, h) in pixels, foot to rim."""
    right = float(np.median(line[:, 0])) >= 0.0
    side = line if right else line * np.array([-1.0, 1.0])
    side = side if side[0, 1] <= side[-1, 1] else side[::-1]
    return (side, None) if right else (None, side)


def _uprighted(points: Floats, place: float, middle: float, lean: float) -> Floats:
    """Return points of a picture with the axis upright at r = 0, heights upwards."""
    turn = np.array([[cos(lean), -sin(lean)], [sin(lean), cos(lean)]])
    return np.asarray((points - np.array([place, middle])) @ turn.T * np.array([1.0, -1.0]))


def _scaled(
    right: Floats | None,
    left: Floats | None,
    axis: _Axis,
    options: Options,
    notes: tuple[Finding, ...],
) -> Reading:
    """Return both sides in the unit, the lowest point at h = 0."""
    sides = [side for side in (right, left) if side is not None]
    if not sides:
        raise SourceError(NoSource.NO_SIDE)
    low = min(float(side[:, 1].min()) for side in sides)
    high = max(float(side[:, 1].max()) for side in sides)
    if options.scale is not None:
        scale = options.scale
    elif options.scale_bar is not None:
        scale = options.scale_bar.length / options.scale_bar.pixels
    else:
        assert options.height is not None  # One of the three is given.
        scale = options.height / (high - low) if high > low else 0.0
    if not (scale > 0.0 and hypot(scale, 1.0) < np.inf):
        raise SourceError(NoSource.NO_HEIGHT)

    def half(side: Floats | None) -> Half | None:
        return None if side is None else Half(scale * (side - np.array([0.0, low])))

    frame = Frame((axis.place, -axis.middle), 1.0, axis.lean)
    x, y = frame.placed(np.array([0.0, low])).tolist()
    frame = Frame((x, y), scale, axis.lean)
    return Reading(half(right), half(left), (axis.place,), scale, notes, frame)
