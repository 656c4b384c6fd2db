"""Open spaces: rooms that touch without a wall between them.

A plan may draw one open floor as several rooms: living, dining and kitchen side by side, or the
two halves of a living room. What joins them is a passage as wide as their common border.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import shapely

from scenewright.core.space import Opening, Space

WIDE = 1.2
"""Least width of what opens one room to another, in metres; narrower is a doorway."""
OPEN_SHARE = 0.6
"""Least part of the common border of two rooms that is open, so that they are one space."""
SLACK = 0.05
"""How much farther apart than the thickness of their wall two rooms may be, in metres."""


def find_open_spaces(spaces: Sequence[Space]) -> tuple[frozenset[str], ...]:
    """The ids of rooms that are one open space, two or more together; other rooms are not named,
    nor are those that ``spaces`` does not list.

    Two rooms are one where open passages between them are at least 1.2 m wide in all and at least
    0.6 of their common border; so are rooms that both are one with a third.

    >>> from scenewright.core.brief import Brief
    >>> from scenewright.building.plan import spaces
    >>> side = {"at": [4, 1.5], "width": 2.8, "swing": "none"}
    >>> rooms = [{"id": "a", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "doors": [side]},
    ...          {"id": "b", "outline": [[4, 0], [7, 0], [7, 3], [4, 3]]}]
    >>> [sorted(ids) for ids in find_open_spaces(spaces(Brief.model_validate({"rooms": rooms})))]
    [['a', 'b']]
    """
    parts: dict[str, frozenset[str]] = {}
    by_id = {space.id: space for space in spaces}
    for (first, second), passages in _passages(spaces).items():
        known = first in by_id and second in by_id
        if known and _is_open(by_id[first], by_id[second], passages):
            joined = parts.get(first, frozenset((first,))) | parts.get(second, frozenset((second,)))
            parts.update(dict.fromkeys(joined, joined))
    return tuple(dict.fromkeys(parts.values()))


def _passages(spaces: Sequence[Space]) -> dict[tuple[str, str], list[Opening]]:
    """The passages between every two rooms."""
    openings = {opening.id: opening for space in spaces for opening in space.openings}
    found: dict[tuple[str, str], list[Opening]] = defaultdict(list)
    for opening in openings.values():
        if opening.kind == "passage" and len(opening.spaces) == 2:
            found[opening.spaces[0], opening.spaces[1]].append(opening)
    return found


def _is_open(first: Space, second: Space, passages: Sequence[Opening]) -> bool:
    width = sum(passage.width for passage in passages)
    reach = max(passage.thickness for passage in passages) + SLACK
    return width >= WIDE and width >= OPEN_SHARE * common_border(first, second, reach)


def common_border(first: Space, second: Space, reach: float) -> float:
    """Metres of the first room's outline and holes that lie within ``reach`` of the second."""
    floor = shapely.Polygon(second.outline, list(second.holes))
    near = floor.buffer(reach, join_style="mitre")
    border = shapely.Polygon(first.outline, list(first.holes)).boundary
    return float(border.intersection(near).length)
