"""Everything that can be done to a document: pure functions Document -> Document.

Each returns a document that a file can hold, the very same one where nothing changes, and raises
EditError, one clear sentence, for what is not allowed.
"""

from __future__ import annotations

from sgb_core.document.edits.appearance import (
    add_picture,
    apply_look,
    replace_appearance,
    set_appearance,
    with_texture,
    without_paint,
)
from sgb_core.document.edits.chain import (
    append_segment,
    head_to_tail,
    insert_segment,
    prepend_segment,
    remove_segment,
    reverse_profile,
    reverse_segment,
)
from sgb_core.document.edits.cut_outs import (
    cut_out_picture,
    remove_cut_out,
    set_cut_out,
    set_cut_outs,
    usual_cut_out,
)
from sgb_core.document.edits.dimensions import (
    add_dimension,
    keep_locks,
    remove_dimension,
    set_dimension,
    set_lock,
)
from sgb_core.document.edits.draw import draw_first, draw_on
from sgb_core.document.edits.guides import add_guide, move_guide, remove_guide, remove_guides
from sgb_core.document.edits.joints import (
    close_profile,
    merge_segments,
    open_profile,
    rule_moves,
    set_rule,
    set_yielding,
    smooth_joints,
    split_segment,
)
from sgb_core.document.edits.laws import (
    add_law,
    as_keyframes,
    move_law,
    remove_law,
    replace_law,
    with_key,
    with_key_moved,
    with_parameter,
    with_shape,
    with_strength,
    with_strength_moved,
    without_key,
    without_strength,
)
from sgb_core.document.edits.layers import add_layer, remove_layer, usual_layer
from sgb_core.document.edits.manufacture import (
    for_export,
    move_fill,
    set_fill,
    set_material,
    set_shrinkage,
)
from sgb_core.document.edits.mending import (
    fit_wall,
    flat_rim,
    no_drain_hole,
    no_foot_ring,
    push_inside_axis,
)
from sgb_core.document.edits.pictures import with_picture
from sgb_core.document.edits.plate import set_plate
from sgb_core.document.edits.points import move_point, move_points, place_points, scale_points
from sgb_core.document.edits.relief import set_relief
from sgb_core.document.edits.segments import (
    append_kind,
    append_mirror_image,
    mirror_segment,
    move_segment,
)
from sgb_core.document.edits.shape import (
    omega_law,
    reset_shape,
    set_leg_fraction,
    set_shape_parameter,
    slide_shape_parameter,
    wakes,
)
from sgb_core.document.edits.source import (
    add_profile,
    change_reference,
    set_reference,
    take_profile,
)
from sgb_core.document.edits.states import (
    delete_state,
    duplicate_state,
    rename_state,
    store_state,
    switch_state,
)
from sgb_core.document.edits.stroke import draw_stroke
from sgb_core.document.edits.whole import (
    enlarged,
    mirror_height,
    rename,
    scale,
    set_height,
    set_largest_diameter,
    set_placement,
    set_revolution,
    set_solid,
    set_twist,
    set_unit,
    set_variation,
)
from sgb_core.document.errors import EditError

__all__ = [
    "EditError",
    "add_dimension",
    "add_guide",
    "add_law",
    "add_layer",
    "add_picture",
    "add_profile",
    "append_kind",
    "append_mirror_image",
    "append_segment",
    "apply_look",
    "as_keyframes",
    "change_reference",
    "close_profile",
    "cut_out_picture",
    "delete_state",
    "draw_first",
    "draw_on",
    "draw_stroke",
    "duplicate_state",
    "enlarged",
    "fit_wall",
    "flat_rim",
    "for_export",
    "head_to_tail",
    "insert_segment",
    "keep_locks",
    "merge_segments",
    "mirror_height",
    "mirror_segment",
    "move_fill",
    "move_guide",
    "move_law",
    "move_point",
    "move_points",
    "move_segment",
    "no_drain_hole",
    "no_foot_ring",
    "omega_law",
    "open_profile",
    "place_points",
    "prepend_segment",
    "push_inside_axis",
    "remove_cut_out",
    "remove_dimension",
    "remove_guide",
    "remove_guides",
    "remove_law",
    "remove_layer",
    "remove_segment",
    "rename",
    "rename_state",
    "replace_appearance",
    "replace_law",
    "reset_shape",
    "reverse_profile",
    "reverse_segment",
    "rule_moves",
    "scale",
    "scale_points",
    "set_appearance",
    "set_cut_out",
    "set_cut_outs",
    "set_dimension",
    "set_fill",
    "set_height",
    "set_largest_diameter",
    "set_leg_fraction",
    "set_lock",
    "set_material",
    "set_placement",
    "set_plate",
    "set_reference",
    "set_relief",
    "set_revolution",
    "set_rule",
    "set_shape_parameter",
    "set_shrinkage",
    "set_solid",
    "set_twist",
    "set_unit",
    "set_variation",
    "set_yielding",
    "slide_shape_parameter",
    "smooth_joints",
    "split_segment",
    "store_state",
    "switch_state",
    "take_profile",
    "usual_cut_out",
    "usual_layer",
    "wakes",
    "with_key",
    "with_key_moved",
    "with_parameter",
    "with_picture",
    "with_shape",
    "with_strength",
    "with_strength_moved",
    "with_texture",
    "without_key",
    "without_paint",
    "without_strength",
]
