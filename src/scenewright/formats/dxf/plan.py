"""Plans from CAD: DXF drawings of any program as briefs, by ezdxf (extra ``dxf``).

Walls may be double or single lines, polylines, hatches or blocks, on layers called anything in any
language; the unit is that of the header where it makes a building, else the one that does. Rooms
are what lines enclose once gaps are closed; several storeys may lie beside each other. What was
read and what was left aside is in the input report. Plans written by Scenewright are read as they
were.
"""

from __future__ import annotations

import os
from pathlib import Path

from scenewright.core.brief import Brief
from scenewright.core.isolated_reading import Allowance, read_apart
from scenewright.formats.drawn_plan import brief_of

ALLOWANCE = Allowance(memory=1024, per_size=16, seconds=60)


def read(path: str | os.PathLike[str], keep: bool = False, scale: float = 1.0) -> Brief:
    """The brief of a plan; ``keep`` changes nothing: furniture in drawings is left aside.
    ``scale`` multiplies the lengths of the stated unit, which then is taken as it is.

    Raises :class:`InputError` where the file holds no plan of a building, or none can be read.
    """
    del keep
    file = Path(path)
    found = read_apart("scenewright.formats.dxf.entities", file, ALLOWANCE, {"scale": scale})
    return brief_of(found, file, "DXF")
