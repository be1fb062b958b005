"""The menu of what can be done with the thing under the pointer, in editor and viewport."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu, QWidget

from app.commands.joint import choose_rule
from app.commands.joint_words import RULE_MEANINGS
from app.commands.segment import merge_at, split
from app.hand.features import Feature, Kind
from app.hand.hit_test import Handle, PointId, Target, twin
from app.state.presenter import Presenter
from app.state.window_reader import WINDOW
from sgb_core.bodies.solid import BodyKind, Rim, WallSide
from sgb_core.curves.constraints import earlier_yields
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import LAMBDAS, SYMBOLS
from sgb_core.document import edits


def remove(presenter: Presenter, segment: int) -> None:
    """Remove a segment."""
    presenter.do(f"Remove {WINDOW.segment(segment)}", lambda d: edits.remove_segment(d, segment))


def joint_of(profile: Profile, point: PointId) -> int | None:
    """Return the number of the joint at a control point, None where there is none."""
    segment, index = point
    if index == 3 and segment in profile.joints:
        return segment
    if index == 0:
        joint = (segment - 1) % len(profile)
        if joint in profile.joints and (segment > 0 or profile.closed):
            return joint
    return None


def build(
    parent: QWidget, presenter: Presenter, handle: Handle | None, fit: QAction | None = None
) -> QMenu:
    """Return the menu for what lies under the pointer."""
    menu = QMenu(parent)
    profile = presenter.document.profile
    if handle is not None and handle.target is Target.LEVEL:
        remove = menu.addAction("Take the fill line away")
        remove.triggered.connect(
            lambda: presenter.do("Take the fill line away", lambda d: edits.set_fill(d, None))
        )
        menu.addSeparator()
    elif handle is not None and handle.feature is not None:
        _add_feature(menu, presenter, handle.feature)
        menu.addSeparator()
    elif handle is not None:
        if handle.target is Target.POINT:
            joint = joint_of(profile, (handle.segment, handle.index))
            if joint is not None:
                _add_rules(menu, presenter, joint)
                _add_yielding(menu, presenter, joint)
        if handle.target is Target.QUARTIC:
            _add_reset(menu, presenter, handle)
        menu.addSeparator()
        _add_segment(menu, presenter, handle)
        menu.addSeparator()
    _add(
        menu,
        "&Append a segment",
        lambda: presenter.do("Append a segment", edits.append_segment),
    )
    if profile.closed:
        _add(menu, "&Open the profile", lambda: presenter.do("Open profile", edits.open_profile))
    else:
        _add(menu, "&Close the profile", lambda: presenter.do("Close profile", edits.close_profile))
    menu.addSeparator()
    if fit is not None:
        menu.addAction(fit)
    snap = menu.addAction("&Snap to the grid")
    snap.setCheckable(True)
    snap.setChecked(presenter.view.snap)
    snap.toggled.connect(lambda on: presenter.set_view(snap=on))
    return menu


def add_texture(menu: QMenu, presenter: Presenter, number: int) -> None:
    """Offer what can be done with a texture besides dragging it."""
    textures = presenter.document.appearance.textures
    left = tuple(each for k, each in enumerate(textures) if k != number)
    back = tuple(
        replace(each, offset=(0.0, 0.0)) if k == number else each for k, each in enumerate(textures)
    )
    _add(
        menu,
        "&Not shifted",
        lambda: presenter.do("Texture", lambda d: edits.set_appearance(d, textures=back)),
    )
    _add(
        menu,
        "&Remove the texture",
        lambda: presenter.do(
            "Remove the texture", lambda d: edits.set_appearance(d, textures=left)
        ),
    )


def _add_feature(menu: QMenu, presenter: Presenter, feature: Feature) -> None:
    """Offer what can be done with the wall, the floor or the look besides dragging it."""
    document = presenter.document
    if feature.kind is Kind.BAND:
        drawing = document.appearance.drawing
        left = tuple(each for k, each in enumerate(drawing) if k != feature.layer)
        _add(
            menu,
            "&Remove the paint",
            lambda: presenter.do(
                "Remove the paint", lambda d: edits.set_appearance(d, drawing=left)
            ),
        )
        return
    if feature.kind is Kind.TEXTURE:
        add_texture(menu, presenter, feature.layer)
        return
    inside = document.solid.side is WallSide.INSIDE
    side = WallSide.OUTSIDE if inside else WallSide.INSIDE
    rim = Rim.FLAT if document.solid.rim is Rim.ROUND else Rim.ROUND
    _add(
        menu,
        f"Wall &{side.value} the drawn line",
        lambda: presenter.do(f"Wall {side.value}", lambda d: edits.set_solid(d, side=side)),
    )
    _add(
        menu,
        f"Rim &{rim.value}",
        lambda: presenter.do(f"Rim {rim.value}", lambda d: edits.set_solid(d, rim=rim)),
    )
    _add(
        menu,
        "&Take the wall away",
        lambda: presenter.do("Bare surface", lambda d: edits.set_solid(d, kind=BodyKind.SURFACE)),
    )


def _add(menu: QMenu, text: str, action: Callable[[], object], key: str = "") -> QAction:
    # The key is shown, not bound: the editor itself listens for it.
    added = menu.addAction(text + (f"\t{key}" if key else ""))
    added.triggered.connect(lambda: action())
    return added


def _add_rules(menu: QMenu, presenter: Presenter, joint: int) -> None:
    profile = presenter.document.profile
    before, after = profile.neighbours(joint)
    rules = menu.addMenu(f"&Rule of {WINDOW.joint(before, after)}")
    group = QActionGroup(rules)
    for rule, text in RULE_MEANINGS.items():
        action = rules.addAction(text)
        action.setCheckable(True)
        action.setChecked(profile.rules[joint] is rule)
        group.addAction(action)
        action.triggered.connect(
            lambda _checked=False, rule=rule: choose_rule(presenter, joint, rule)
        )


def _add_yielding(menu: QMenu, presenter: Presenter, joint: int) -> None:
    profile = presenter.document.profile
    before, after = profile.neighbours(joint)
    earlier = earlier_yields(profile, joint)
    if profile.rules[joint] in (JointRule.G1, JointRule.C1, JointRule.G2) and before != after:
        mover = after if earlier else before
        _add(
            menu,
            f"Let {WINDOW.segment(mover)} &yield at {WINDOW.joint(before, after)}",
            lambda: presenter.do(
                f"Which side yields at {WINDOW.joint(before, after)}",
                lambda d: edits.set_yielding(d, joint, "later" if earlier else "earlier"),
            ),
        )


def _add_reset(menu: QMenu, presenter: Presenter, handle: Handle) -> None:
    name = LAMBDAS[handle.index]
    symbol = SYMBOLS[name]
    _add(
        menu,
        f"Reset {symbol}",
        lambda: presenter.do(
            f"Reset {symbol} of {WINDOW.segment(handle.segment)}",
            lambda d: edits.reset_shape(d, handle.segment, name),
        ),
    )


def _add_segment(menu: QMenu, presenter: Presenter, handle: Handle) -> None:
    profile, segment = presenter.document.profile, handle.segment
    number = WINDOW.number(segment)
    s = handle.s if handle.target is Target.CURVE else 0.5
    where = "here" if handle.target is Target.CURVE else "in the middle"
    _add(
        menu,
        f"S&plit segment {number} {where}",
        lambda: split(presenter, segment, s),
        "Double-click" if handle.target is Target.CURVE else "",
    )
    if segment < len(profile) - 1 and twin(profile, (segment, 3)) is not None:
        _add(
            menu,
            f"&Merge segments {number} and {WINDOW.number(segment + 1)}",
            lambda: merge_at(presenter, segment),
        )
    _add(
        menu,
        f"&Insert a segment before segment {number}",
        lambda: presenter.do(
            f"Insert a segment before {number}", lambda d: edits.insert_segment(d, segment)
        ),
    )
    _add(
        menu,
        f"Re&verse segment {number}",
        lambda: presenter.do(
            f"Reverse segment {number}", lambda d: edits.reverse_segment(d, segment)
        ),
    )
    _add(
        menu,
        f"Reset the &shape of segment {number}",
        lambda: presenter.do(
            f"Reset shape of segment {number}", lambda d: edits.reset_shape(d, segment, None)
        ),
    )
    removal = _add(menu, f"&Remove segment {number}", lambda: remove(presenter, segment), "Del")
    removal.setEnabled(len(profile) > 1)
