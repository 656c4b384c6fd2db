"""How much too small or too large a plan is drawn, read off what is of one size everywhere.

Doors that hang on hinges, the rooms of toilets and bathtubs hardly vary. Each one in a plan gives
the factor by which its length would have to be multiplied to be usual; their median is the answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log
from statistics import median
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_leaves import TWO
from scenewright.core.brief import Brief
from scenewright.core.brief.units import UNITS
from scenewright.core.space import Space

USUAL = {"door": (0.75, 0.9), "toilet": (0.75, 2.0), "bathtub": (1.0, 2.0)}
"""Usual widths of hinged doors and of toilets, and lengths of bathtubs, in metres."""
LEAST_DOORS = 2
NEAR_UNIT = 1.1
"""By how much doors may differ from usual ones in the unit a plan is said to be drawn in."""
DOUBTFUL = 1.2
"""A factor of more than this, or of less than its inverse, is no longer within what is built: a
median leaf under 0.625 m (leaves under some 0.61 m are made for cupboards only) or over 1.08 m."""


class DrawnScale(NamedTuple):
    """``factor`` is what all lengths in plan are to be multiplied by (2: drawn half as large as it
    is), ``doors`` the number of hinged doors and ``width`` their median width, 0 if none."""

    factor: float
    doors: int
    width: float

    @property
    def is_doubtful(self) -> bool:
        """Whether the plan is hardly at its true scale, by two hinged doors at least."""
        return self.doors >= LEAST_DOORS and abs(log(self.factor)) > log(DOUBTFUL)

    def describe(self, given: float = 1.0) -> str:
        """What is wrong and what helps, for a plan that was already read with a scale ``given``.

        >>> DrawnScale(2.1429, 6, 0.35).describe()[:73]
        'hinged doors measure 0.35 m (median of 6): the plan seems drawn 2.1 times'
        >>> DrawnScale(0.5, 3, 1.8).describe(given=3.0)[-52:]
        'drawn 2 times too large; arrange it with --scale 1.5'
        """
        large = self.factor < 1.0
        times = f"{max(self.factor, 1.0 / self.factor):.2g}"
        return (
            f"hinged doors measure {self.width:.2f} m (median of {self.doors}): the plan seems "
            f"drawn {times} times too {'large' if large else 'small'}; "
            f"arrange it with --scale {_name_scale(self.width, self.factor, given)}"
        )


def _name_scale(width: float, factor: float, given: float) -> str:
    """The factor in all, or the metres of the unit in which doors so wide are usual.

    >>> _name_scale(2.8, 0.32, 1.0), _name_scale(0.35, 2.14, 1.0)
    ('0.3048 if it is drawn in feet', '2.1')
    """
    low, high = USUAL["door"][0] / NEAR_UNIT, USUAL["door"][1] * NEAR_UNIT
    units = [(word, m) for word, m in UNITS.items() if given == 1.0 and low < width * m < high]
    return f"{units[0][1]:g} if it is drawn in {units[0][0]}" if units else f"{given * factor:.2g}"


def estimate_scale(brief: Brief, spaces: Sequence[Space]) -> DrawnScale | None:
    """The scale of a plan by its hinged doors, toilets and fixed bathtubs; ``None`` without any.

    With n lengths l_i and their usual ranges [a_i, b_i] it is the median of a_i / l_i where l_i is
    less than a_i, b_i / l_i where it is more than b_i, and else 1; of two in the middle the one
    nearer to 1.

    >>> from scenewright.building.plan import spaces
    >>> doors = [{"at": [x, 0], "width": 0.5} for x in (1, 2, 3)]
    >>> room = {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "doors": doors}
    >>> brief = Brief.model_validate({"rooms": [room]})
    >>> estimate_scale(brief, spaces(brief))
    DrawnScale(factor=1.5, doors=3, width=0.5)
    """
    doors = _list_leaves(spaces)
    lengths = [("door", width) for width in doors]
    lengths += [("toilet", width) for width in _list_toilets(spaces)]
    lengths += [("bathtub", length) for length in _list_tubs(brief)]
    if not lengths:
        return None
    factors = sorted(_find_factor(kind, length) for kind, length in lengths)
    middle = factors[(len(factors) - 1) // 2], factors[len(factors) // 2]
    return DrawnScale(
        min(middle, key=lambda factor: abs(log(factor))),
        len(doors),
        median(doors) if doors else 0.0,
    )


def _find_factor(kind: str, length: float) -> float:
    least, most = USUAL[kind]
    return min(max(length, least), most) / length


def _list_leaves(spaces: Sequence[Space]) -> list[float]:
    """Widths of the doors on hinges, but for doors of two leaves to the outside: those of gardens
    and entrances come in all widths."""
    openings = {opening.id: opening for space in spaces for opening in space.openings}
    return [
        door.width
        for door in openings.values()
        if door.kind == "door" and door.hinge and (door.width < TWO or len(door.spaces) > 1)
    ]


def _list_toilets(spaces: Sequence[Space]) -> Iterator[float]:
    """The least widths of rooms that are toilets and nothing else."""
    for space in spaces:
        if space.functions == ("toilet",):
            box = np.array(shapely.Polygon(space.outline).minimum_rotated_rectangle.exterior.coords)
            yield float(np.linalg.norm(np.diff(box[:3], axis=0), axis=1).min())


def _list_tubs(brief: Brief) -> list[float]:
    fixed = (item for room in brief.rooms for item in room.fixed)
    return [max(item.size[:2]) for item in fixed if item.category == "bathtub"]
