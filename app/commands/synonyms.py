"""What users call things: words by which the palette finds an action that is named otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

# By the name of an action.
SYNONYMS: Mapping[str, str] = MappingProxyType(
    {
        "tool_pen": "draw sketch pencil line curve stroke",
        "tool_measure": "ruler distance length angle radius caliper gauge thickness dimension",
        "new_blank": "draw start empty sheet scratch sketch",
        "gallery": "start presets shapes templates examples library",
        "open": "import load file photo picture trace svg dxf",
        "save": "write keep store",
        "save_as": "write keep store rename copy",
        "undo": "back revert mistake step",
        "redo": "again forward repeat",
        "preferences": "settings options units inch mm language font size snap theme keys",
        "drawing": "blueprint plan workshop dimensions section archaeologist plate template rib "
        "gauge paper pdf scale title block",
        "compare_curves": "cubic quartic rational bezier energy deviation difference paper",
        "copy_profile": "inkscape illustrator vector clipboard",
        "copy_table": "spreadsheet excel csv coordinates clipboard",
        "export_mesh": "print stl step 3mf obj glb slicer mesh send save as",
        "film": "video animation turntable gif mp4 movie",
        "screenshot": "photo image render snapshot png picture save",
        "copy_picture": "photo image snapshot clipboard",
        "figure_studio": "plate paper pdf figure illustration",
        "make_fair": "smooth fair even curvature bumps wobble",
        "reach_targets": "solve goal capacity volume mass weight height width exactly",
        "make_fair_by": "smooth fair even curvature bumps",
        "guide_upright": "guideline ruler helper line vertical snap",
        "guide_level": "guideline ruler helper line horizontal snap",
        "remove_guides": "guidelines clear ruler helper lines",
        "show_dimensions": "measures sizes lines arrows diameter height 3d",
        "live_fair": "smooth fair automatic follow while dragging sliders move",
        "variants": "alternatives versions ideas explore options suggestions family",
        "joints_g1": "smooth tangent kink corner round",
        "joints_g2": "smooth curvature highlight",
        "fit_ellipse": "circle sphere round",
        "append_segment": "add extend longer new piece",
        "insert_segment": "add new piece between",
        "split_segment": "cut divide add point knot",
        "merge_segment": "join combine simplify",
        "remove_segment": "delete erase",
        "close_profile": "ring torus loop closed",
        "mirror": "flip upside down turn over",
        "mirror_image": "symmetric double reflect",
        "scale_selection": "resize larger smaller stretch",
        "snap": "grid magnet",
        "reset_shape": "neutral plain cubic",
        "viewport_alone": "fullscreen maximise focus",
        "editor_alone": "fullscreen maximise focus",
        "fit": "zoom all frame centre",
        "fit_profile": "zoom all frame centre",
        "parallel": "orthographic perspective camera",
        "cut_half": "section inside cutaway slice",
        "cut_section": "section inside cutaway slice",
        "curvature_plot": "smooth comb analyse",
        "shortcuts": "keys keyboard help hotkeys",
        "tour": "help learn tutorial introduction lambda",
        "hints": "help tips",
        "panel_profile": "draw curve editor outline",
        "panel_points": "coordinates numbers table exact",
        "panel_joints": "smooth continuity kink corner g1 g2",
        "panel_shape": "lambda omega sliders belly fullness",
        "panel_turn": "diameter height size units inch mm cm axis angle sweep rotate twist scale",
        "panel_vary": "lobes flutes waves twist spout law petals facets angle",
        "panel_solid": "thick thickness wall floor base vessel pot rim foot drain hole",
        "panel_measures": "measure volume capacity ml litre ounces weight mass fill clay shrinkage "
        "glaze area stability units hold",
        "panel_look": "colour color material glaze texture photo picture paint light map "
        "decoration",
        "panel_states": "versions variants snapshots compare",
        "panel_history": "undo steps back versions",
    }
)
