"""Whether those who sit see what they are to look at: a stage, a screen, a lectern."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.kinds import name_of
from scenewright.check.bodies import Bodies, Indices
from scenewright.core.brief import Room
from scenewright.core.report import Note
from scenewright.core.space import Space
from scenewright.domains.hall.classes import TABLE_CHAIRS, is_audience_seat
from scenewright.domains.hall.demands.checked import ids_of, usual_size
from scenewright.domains.hall.seats.audience import find_shows

TURNED, SHARE = 60.0, 0.1
"""Degrees by which a seat looks past what it is to look at, and the share of the seats of one
demand that may."""


def note_seats_turned_away(
    bodies: Bodies, spaces: tuple[Space, ...], wishes: Mapping[str, Room]
) -> list[Note]:
    """A note for each demand with over a tenth of its seats looking past their stage, screen or
    lectern by over 60 degrees."""
    notes = []
    for space in spaces:
        demands = wishes[space.id].demands if space.id in wishes else []
        ids = ids_of(demands)
        for demand, name, show in zip(demands, ids, find_shows(demands, ids), strict=True):
            shown = demand.facing or show
            seats, stages = _rows(bodies, space.id, name), _rows(bodies, space.id, shown)
            watching = is_audience_seat(demand.category, usual_size(demand)[0])
            if not (watching or demand.category in TABLE_CHAIRS) or not shown or not len(stages):
                continue
            away = int((_measure_turns(bodies, seats, stages) > TURNED).sum())
            if away > SHARE * len(seats):
                what, where = name_of(demand.category), bodies.pieces[stages[0]].category
                text = f"{space.id}: {away} of {len(seats)} seats ({what}) look away from the "
                notes.append(Note(space.id, name, shown, f"{text}{name_of(where)}"))
    return notes


def _rows(bodies: Bodies, space: str, function: str) -> Indices:
    """The rows of the pieces of one demand."""
    rows = [k for k, p in enumerate(bodies.pieces) if p.space == space and p.function == function]
    return np.array(rows if function else [], np.int64)


def _measure_turns(bodies: Bodies, seats: Indices, stages: Indices) -> NDArray[np.float64]:
    """Degrees between where each seat looks and the nearest of what it is to look at (n,)."""
    whole = shapely.union_all(bodies.footprints[stages])
    poses = np.array([bodies.pieces[k].pose for k in seats], float).reshape(-1, 4)
    points = shapely.points(poses[:, :2])
    ends = shapely.get_coordinates(shapely.shortest_line(points, whole)).reshape(-1, 2, 2)
    x, y = (ends[:, 1] - ends[:, 0]).T
    off = np.arctan2(y, x) - poses[:, 3]
    return np.degrees(np.abs(np.arctan2(np.sin(off), np.cos(off))))
