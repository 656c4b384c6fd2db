"""Outlets: is what has to be connected near enough to a socket or tap?

Only where a room lists outlets of a kind is anything judged. Measured in plan, from the nearest
outlet of the kind to the footprint of the piece; how far leads and hoses reach is stated in the
piece's kind.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import shapely

from scenewright.check.bodies import TOLERANCE, Bodies, Rooms
from scenewright.core.kind import Service
from scenewright.core.report import Finding, Note


class Connection(NamedTuple):
    """A piece (row of the bodies), what it needs, how far the nearest such outlet is, and whether
    outlets of this kind must be used."""

    piece: int
    need: Service
    metres: float
    required: bool

    @property
    def reached(self) -> bool:
        """Whether its lead or hose is long enough."""
        return self.metres <= self.need.reach + TOLERANCE


def connections_of(bodies: Bodies, rooms: Rooms) -> list[Connection]:
    """Everything that needs an outlet of a kind its room lists."""
    found = []
    for i, kind in enumerate(bodies.kinds):
        outlets = rooms.spaces[bodies.room[i]].outlets
        for need in kind.services:
            mine = [o for o in outlets if o.kind == need.outlet]
            if mine:
                at = shapely.points([(o.x, o.y) for o in mine])
                far = float(shapely.distance(at, bodies.footprints[i]).min())
                found.append(Connection(i, need, far, any(o.required for o in mine)))
    return found


def connections_told(
    found: list[Connection], bodies: Bodies, rooms: Rooms
) -> tuple[list[Finding], list[Note], list[dict[str, Any]]]:
    """What is out of reach, as violations where the outlet is required and else as notes, and the
    figures of everything."""
    findings, notes, figures = [], [], []
    for each in found:
        piece, outlet = bodies.pieces[each.piece], each.need.outlet
        figures.append(
            {
                "space": piece.space,
                "piece": piece.id,
                "outlet": outlet,
                "metres": round(each.metres, 3),
                "reach": each.need.reach,
                "within": each.reached,
            }
        )
        text = f"{piece.id} stands {each.metres:.2f} m from the nearest {outlet} outlet, "
        text += f"its {each.need.by} reaches {each.need.reach:g} m"
        if not each.reached and each.required:
            level = rooms.levels[bodies.level[each.piece]]
            over = round(each.metres - each.need.reach, 4)
            findings.append(
                Finding(
                    "unserved", level, piece.space, piece.id, outlet, text, over, given=piece.fixed
                )
            )
        elif not each.reached:
            notes.append(Note(piece.space, piece.function, outlet, text))
    return findings, notes, figures
