"""The three kinds of scene of Cao, Cheng and Zhang (2024, tables 1 and 2, Fig. 7): an exhibition, a
shop, and a home laid out as a hall; and layouts of them drawn by hand.

The paper's scenes and volunteers are not published. The exhibition and the shop are the shipped
samples; of the home (``scenes/home-as-hall.json``) the rooms are zones, and walls between them are
built where cupboards need them. ``scenes/by-hand.json`` holds one layout of each, drawn by us
object by object as an architect draws, with the walls that stand in it; in degrees.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.layout import NamedBox
from scenewright.core.solution import Solution
from scenewright.domains import solution_of
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.formats import read

FOLDER = Path(__file__).parent / "scenes"
HOME = "home as a hall"
SCENES = {"sample:hall-exhibition": "exhibition", "sample:hall-shop": "shop", HOME: "home"}
"""The brief of each kind of scene, and what ``by-hand.json`` calls it."""
WALL = 0.15
"""Thickness of the walls drawn by hand, in metres."""


def read_scene(case: str) -> Brief:
    """The brief of a sample, or of the home laid out as a hall."""
    return read(str(FOLDER / "home-as-hall.json") if case == HOME else case)


def by_hand(case: str) -> Solution:
    """The layout of a scene drawn by hand."""
    brief = read_scene(case)
    document = json.loads((FOLDER / "by-hand.json").read_text(encoding="utf-8"))[SCENES[case]]
    walled = with_walls(brief, document["walls"])
    rows = [
        NamedBox(one.id, (x, y, math.radians(turn), size.width, size.depth - 2 * one.chairs))
        for one in collect_demands(walled, 0, (), shipped())
        for (x, y, turn), size in zip(document["places"][one.id], one.sizes, strict=True)
    ]
    return solution_of(walled, {brief.rooms[0].id: rows})


def with_walls(brief: Brief, walls: list[list[float]]) -> Brief:
    """A brief of one hall with walls (x, y, degrees, length) that stand."""
    document: dict[str, Any] = brief.model_dump()
    room = document["rooms"][0]
    room["fixed"] += [
        {
            "id": f"wall-{number}",
            "category": "partition",
            "at": (x, y),
            "heading": math.radians(turn),
            "size": (length, WALL, room["height"]),
        }
        for number, (x, y, turn, length) in enumerate(walls)
    ]
    return Brief.model_validate(document)
