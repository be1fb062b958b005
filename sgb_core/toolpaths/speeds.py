"""How fast the nozzle moves: the part's speed, within flow, layer time and the auger's pace."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.toolpaths.printer import Feeding, Printer
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Moves


def speeds(printer: Printer, moves: Moves) -> Floats:
    """Return the speed of each move in mm/s, shape (k,).

    An auger pushes at its own pace, and the nozzle moves as fast as the bead's cross-section asks
    for. Else a part has its speed, less where more would flow than can, and less where a layer
    would take less time than it needs to set.
    """
    parts, layers, volumes, lengths = moves.parts, moves.layers, moves.volumes, moves.lengths
    own = printer.speeds
    found = np.full(len(parts), own.wall)
    found[parts == Part.TRAVEL] = own.travel
    found[(parts == Part.FLOOR) | (parts == Part.SKIRT)] = own.floor
    prints = parts != Part.TRAVEL
    area = np.where(lengths > 0.0, volumes / np.where(lengths > 0.0, lengths, 1.0), 0.0)
    flows = prints & (area > 0.0)
    most = printer.feed.flow if printer.feed.unit is Feeding.NONE else own.largest_flow
    if printer.feed.unit is Feeding.NONE:
        found[flows] = most / area[flows]
        found[prints] = np.clip(found[prints], own.slowest, max(own.wall, own.floor))
    elif most > 0.0:
        found[flows] = np.minimum(found[flows], most / area[flows])
    if own.layer_time > 0.0:
        times = np.bincount(layers[prints], (lengths / found)[prints], int(layers.max()) + 1)
        share = np.minimum(times / own.layer_time, 1.0)[layers]
        found[prints] = np.maximum(found * share, np.minimum(found, own.slowest))[prints]
    return np.asarray(found)
