"""The verbs of ``sgb-studio edit``: one table of words, arguments and edits."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

from sgb_core.values import dataclass

if TYPE_CHECKING:
    from sgb_core.document.model import Document
    from sgb_core.findings.finding import Finding

# An edit gives the new document, and what is to be said of it: how far the curve moved where it is
# not exact, what a rule moved.
Applied: TypeAlias = "tuple[Document, Finding | None]"


# A smaller part of the size is rounding: such an edit is exact.
EXACT = 1e-12
# A split that moves the curve by a larger part of the size, as laws can make it, is refused: nobody
# is there to be asked.
MOST_MOVED = 0.01


@dataclass(frozen=True, slots=True)
class Argument:
    """A word after the verb: its name, how it is read, and which words there are if few.

    One whose name begins with two dashes is a switch, or with choices may be left out.
    """

    name: str
    read: Callable[[str], object] = str
    choices: tuple[str, ...] | None = None


@dataclass(frozen=True, slots=True)
class Verb:
    """One edit: its name, what it does in words, its arguments and its function."""

    name: str
    text: str
    arguments: tuple[Argument, ...]
    apply: Callable[[Document, argparse.Namespace], Applied]


def add_verbs(parser: argparse.ArgumentParser, program: str) -> None:
    """Add the verbs as commands of their own below ``edit``, which is typed as ``program``."""
    verbs = parser.add_subparsers(metavar="VERB", dest="verb", prog=program, required=True)
    for verb in VERBS.values():
        below = verbs.add_parser(
            verb.name, help=verb.text, description=verb.text, allow_abbrev=False
        )
        for argument in verb.arguments:
            if argument.name.startswith("--") and argument.choices is None:
                below.add_argument(argument.name, action="store_true")
                continue
            if argument.name.startswith("--"):
                below.add_argument(argument.name, choices=argument.choices)
                continue
            below.add_argument(
                argument.name,
                metavar=argument.name.upper(),
                type=argument.read,
                choices=argument.choices,
                help=None if argument.choices is None else ", ".join(argument.choices),
            )


def _with_deviation(document: Document, edited: Document, deviation: float) -> Applied:
    from sgb_core.findings.edits import Deviation

    if deviation <= EXACT * document.profile.size:
        return edited, None
    return edited, Deviation(deviation, document.unit.value)


def _set(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    edited = edits.set_shape_parameter(document, options.segment, options.parameter, options.value)
    return edited, None


def _reverse(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return edits.reverse_segment(document, options.segment), None


def _scale(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return edits.scale(document, options.factor), None


def _split(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits
    from sgb_core.findings.edits import TooLarge

    halves, deviation = edits.split_segment(document, options.segment, options.s)
    size = document.profile.size
    if deviation > MOST_MOVED * size:
        raise edits.EditError(TooLarge(deviation, document.unit.value, size, MOST_MOVED))
    return _with_deviation(document, halves, deviation)


def _merge(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return _with_deviation(document, *edits.merge_segments(document, options.segment))


def _rule(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    ruled = edits.set_rule(document, options.joint, options.rule)
    moves = edits.rule_moves(document, ruled, options.joint)
    return ruled, moves if moves.moved else None


def _close(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return edits.close_profile(document), None


def _open(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return edits.open_profile(document), None


def _fill(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    if options.level is None:
        return edits.set_fill(document), None
    if options.below_rim:
        return edits.set_fill(document, below_rim=options.level), None
    return edits.set_fill(document, options.level), None


def _level(text: str) -> float | None:
    return None if text == "none" else float(text)


def _set_twist(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return edits.set_twist(document, turns=options.turns, ease=options.ease), None


def _lock(document: Document, options: argparse.Namespace) -> Applied:
    return _locked(document, options.dimension, True), None


def _unlock(document: Document, options: argparse.Namespace) -> Applied:
    return _locked(document, options.dimension, False), None


def _locked(document: Document, name: str, locked: bool) -> Document:
    from app.cli.dimension_names import number_of
    from sgb_core.document import edits

    return edits.set_lock(*number_of(document, name), locked)


def _dimension(document: Document, options: argparse.Namespace) -> Applied:
    from app.cli.dimension_names import number_of, value_in
    from sgb_core.document import edits

    told, number = number_of(document, options.dimension)
    value = value_in(told, told.dimensions[number], options.value)
    reached = edits.set_dimension(told, number, value)
    return reached.document, reached.in_the_way


def _cut_outs(document: Document, options: argparse.Namespace) -> Applied:
    from app.cli.cut_out_words import with_patterns

    edited = with_patterns(document, options.patterns)
    if edited.cut_outs:
        # Nobody is there to be shown what cannot be cut: making it tells.
        edited.body().pierced  # noqa: B018
    return edited, None


def _relief(document: Document, options: argparse.Namespace) -> Applied:
    from app.cli.relief_words import relieved

    edited = relieved(document, options.part, options.settings)
    # Nobody is there to be shown what cannot be made: making it tells.
    edited.body().worked  # noqa: B018
    return edited, None


def _add_layer(document: Document, options: argparse.Namespace) -> Applied:
    from app.cli.layer_words import with_layer

    edited = with_layer(document, options.layer)
    # Nobody is there to be shown what cannot be made: making it tells.
    edited.body().worked  # noqa: B018
    return edited, None


def _remove_layer(document: Document, options: argparse.Namespace) -> Applied:
    from sgb_core.document import edits

    return edits.remove_layer(document, options.layer), None


_SEGMENT = Argument("segment", int)
_DIMENSION = Argument("dimension")
_PARAMETER = Argument("parameter", choices=("lambda1", "lambda2", "lambda3", "omega"))

VERBS = {
    verb.name: verb
    for verb in (
        Verb(
            "set",
            "set a shape parameter of a segment; the joints keep their rules",
            (_SEGMENT, _PARAMETER, Argument("value", float)),
            _set,
        ),
        Verb("reverse", "run a segment backwards; its shape stays", (_SEGMENT,), _reverse),
        Verb("scale", "scale the profile", (Argument("factor", float),), _scale),
        Verb(
            "split",
            "split a segment in two at its parameter s; the shape stays (laws: within 1 %%)",
            (_SEGMENT, Argument("s", float)),
            _split,
        ),
        Verb("merge", "make one segment of this and the next", (_SEGMENT,), _merge),
        Verb(
            "rule",
            "choose what editing keeps at a joint",
            (
                Argument("joint", int),
                Argument("rule", choices=("free", "G0", "G1", "C1", "G2")),
            ),
            _rule,
        ),
        Verb(
            "fill",
            "set the fill line to a height of the profile, or to so far below the rim; or none",
            (Argument("level", _level), Argument("--below-rim")),
            _fill,
        ),
        Verb(
            "set-twist",
            "turn the top against the foot by so many turns; volumes and sections keep their size",
            (Argument("turns", float), Argument("--ease", choices=("linear", "smooth"))),
            _set_twist,
        ),
        Verb(
            "set-cut-outs",
            "cut rows of holes through a vessel's wall: circle, ellipse, slot, hexagon, text or "
            "picture with settings, such as slot,width=5,height=20,rows=2,around=16 or "
            "text,text=LIGHT,font=serif-bold,height=20 or picture,picture=leaves.png,width=60; "
            "several with + between them; or none",
            (Argument("patterns"),),
            _cut_outs,
        ),
        Verb(
            "add-layer",
            "paint over what is there: band, rings, stripes, gradient, segments or text with "
            "settings, such as text,text=LIGHT,font=serif-bold,from=0.4,to=0.5,relief=1",
            (Argument("layer"),),
            _add_layer,
        ),
        Verb("remove-layer", "remove a layer of paint", (Argument("layer", int),), _remove_layer),
        Verb(
            "set-relief",
            "raise what a layer of the drawing or a texture paints, or sink it: layer-0 or "
            "texture-0, with settings such as depth=1.5,edge=2,raised=dark",
            (Argument("part"), Argument("settings")),
            _relief,
        ),
        Verb("close", "join the profile's end to its start: a ring", (), _close),
        Verb(
            "dimension",
            "give a dimension, such as rim_diameter, a value with its unit, by the mildest change "
            "that keeps the locks",
            (_DIMENSION, Argument("value")),
            _dimension,
        ),
        Verb("lock", "lock a dimension at its present value", (_DIMENSION,), _lock),
        Verb("unlock", "let a locked dimension only tell again", (_DIMENSION,), _unlock),
        Verb("open", "open a ring where its last segment meets the first", (), _open),
    )
}
