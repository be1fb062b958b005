"""Fitting a document's profile to an arc of a circle, an ellipse or a superellipse."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.fitting import Deviation, Fit, Freedom, deviation, fit
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.edits.checks import checked
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit, TooManyToFit, TwoRadii
from sgb_core.values import dataclass

SUPERELLIPSE = 2.5
# Each further segment has about nine more unknowns; the work grows with their cube.
MOST_SEGMENTS = 10
MOST_STARTS = 12


@dataclass(frozen=True, slots=True)
class FitChoices:
    """The profile as it is against a target, and the best of each freedom."""

    target: SuperellipseArc
    present: Deviation
    fits: tuple[Fit, ...]


def arc_for(
    document: Document,
    *,
    a: float | None = None,
    b: float | None = None,
    centre: float | None = None,
    exponent: float = 2.0,
    circle: bool = False,
) -> SuperellipseArc:
    """Return the arc from pole to pole that the numbers name; what is None the profile says.

    For a closed profile it is the whole curve around the middle of its box, a torus's section.
    ``a`` is the half height: by default half the distance in height of the profile's ends, for
    a closed or level one half its height. ``b``, the half width, is the largest radius; a circle
    takes the one for the other. Raises EditError where the arc would have no size.
    """
    profile = document.profile
    low, high = profile.bounds()
    first, last = (
        float(h) for h in (profile.segments[0].points[0, 1], profile.segments[-1].points[3, 1])
    )
    if profile.closed or first == last:
        first, last = float(low[1]), float(high[1])
    width, radius = max(abs(float(low[0])), abs(float(high[0]))), None
    if profile.closed:
        width, radius = float(high[0] - low[0]) / 2.0, float(high[0] + low[0]) / 2.0
    if circle:
        if a is not None and b is not None and a != b:
            raise EditError(TwoRadii(a, b))
        a = b = next((value for value in (a, b) if value is not None), abs(last - first) / 2.0)
    half_height = abs(last - first) / 2.0 if a is None else a
    middle = (first + last) / 2.0 if centre is None else centre
    half_width = width if b is None else b
    return checked(lambda: SuperellipseArc(half_width, half_height, middle, exponent, radius))


def fit_profile(
    document: Document,
    target: SuperellipseArc,
    freedom: Freedom,
    *,
    keep_ends: bool = False,
    slide_poles: bool = False,
    squares: bool = False,
    report: Callable[[float], None] = lambda _: None,
) -> tuple[Document, Fit]:
    """Return the document with its profile fitted by least largest deviation, and the fit.

    With ``squares`` by least squares; see :func:`sgb_core.design.fitting.fit`. A joint that no
    longer is what its rule asks for gets the rule of what it is. Raises EditError for a closed
    profile with an open target and the other way round, for one with gaps, and where laws vary
    the parameters.
    """
    _check(document, target, freedom)
    # Many local minima are the trouble of few segments; many come near from anywhere.
    many = len(document.profile) if freedom is Freedom.POLYGON else 1
    starts = MOST_STARTS // many**2
    found = fit(
        document.profile,
        target,
        freedom,
        starts,
        keep_ends=keep_ends,
        slide_poles=slide_poles,
        squares=squares,
        report=report,
    )
    found = replace(found, profile=_with_true_rules(found.profile))
    return replace(document, profile=found.profile), found


def take_fit(document: Document, found: Fit) -> Document:
    """Return the document with a profile that was fitted for it."""
    return replace(document, profile=found.profile)


def fit_choices(
    document: Document,
    target: SuperellipseArc,
    *,
    keep_ends: bool = False,
    slide_poles: bool = False,
    squares: bool = False,
    report: Callable[[float], None] = lambda _: None,
) -> FitChoices:
    """Return what each freedom reaches; ``report`` is told the part that is done.

    Raises EditError as :func:`fit_profile` does.
    """
    freedoms = list(Freedom)
    fits = []
    for number, freedom in enumerate(freedoms):

        def tell(part: float, number: int = number) -> None:
            report((number + part) / len(freedoms))

        _, found = fit_profile(
            document,
            target,
            freedom,
            keep_ends=keep_ends,
            slide_poles=slide_poles,
            squares=squares,
            report=tell,
        )
        fits.append(found)
    return FitChoices(target, deviation(document.profile, target), tuple(fits))


def _check(document: Document, target: SuperellipseArc, freedom: Freedom) -> None:
    profile = document.profile
    if profile.closed and not target.closed:
        raise EditError(NoEdit.RING_HAS_NO_TARGET)
    if target.closed and not profile.closed:
        raise EditError(NoEdit.OPEN_AND_TARGET_CLOSED)
    if any(report.measured is JointClass.GAP for report in measure_joints(profile)):
        raise EditError(NoEdit.GAPS)
    if document.variation:
        raise EditError(NoEdit.LAWS)
    if freedom is Freedom.POLYGON and len(profile) > MOST_SEGMENTS:
        raise EditError(TooManyToFit(len(profile), MOST_SEGMENTS))


def _with_true_rules(profile: Profile) -> Profile:
    rules = []
    for report in measure_joints(profile):
        rule = report.rule
        if not report.holds:
            smooth = report.measured is not JointClass.G0
            rule = JointRule.G1 if smooth and rule is not JointRule.G1 else JointRule.G0
        rules.append(rule)
    return replace(profile, rules=tuple(rules))
