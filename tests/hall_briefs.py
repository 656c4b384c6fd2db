"""Small halls as documents, as users write them, and what the quick preset makes of them."""

from __future__ import annotations

from typing import Any

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution

LIMIT = 20
"""Seconds within which every brief is answered, once the code is compiled."""

Room = dict[str, Any]


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def hall(**room: Any) -> Room:
    """A hall of 12 by 8 metres and 3 metres high with an entrance in the south."""
    doors = [{"id": "main", "at": [6, 0], "width": 1.6, "use": "entrance"}]
    return {"name": "Hall", "outline": box(0, 0, 12, 8), "height": 3.0, "doors": doors} | room


def asks(**demand: Any) -> Room:
    return hall(demands=[{"category": "showcase"} | demand])


def standing(count: int, **more: Any) -> list[dict[str, Any]]:
    """Showcases in a row that stand there already."""
    return [
        {
            "category": "showcase",
            "at": [1.5 + 2.4 * k, 4],
            "size": [1.2, 0.6, 2.0],
            "id": f"hall/showcase/showcase_{k + 1}",
            "group": "hall/showcase",
            "function": "showcase",
        }
        | more
        for k in range(count)
    ]


TWO = [{"id": "a", "outline": box(0, 0, 6, 8)}, {"id": "b", "outline": box(6, 0, 12, 8)}]
SMALL = {"outline": box(0, 0, 5, 4), "doors": [{"at": [2, 0]}]}
ROOMS_BESIDE = {"two halls of one place": [hall()]}


def document(name: str, room: Room) -> dict[str, Any]:
    return {"domain": "hall", "rooms": [*ROOMS_BESIDE.get(name, []), room]}


def answer(room: Room) -> Solution:
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, preset="quick", steps=400, threads=1)
