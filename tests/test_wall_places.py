"""Places along walls, found all at once, against one box after another."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.building.plan import plan_rooms
from scenewright.catalog.assets import shipped
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.places.stretches import longest_stretch, reach_of
from scenewright.domains.home.furnishing.furnish import SLACK, world
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.grounds.wall_places import along_walls, free_boxes
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.formats import read
from scenewright.geometry.fit import faults

STEP = 0.1
FULL = ("wardrobe", "kitchen", "single")
"""Groups that stand at their wall all along."""


@pytest.mark.parametrize("group", ["wardrobe", "kitchen", "single", "seating"])
def test_free_boxes_are_those_on_which_nothing_has_a_fault(group: str) -> None:
    """As each member tells alone; and a case wider than the longest stretch has none."""
    brief, catalog = read("sample:home-flat"), shipped()
    rooms, placed = plan_rooms(brief).spaces, solve(brief, steps=400, threads=1).pieces
    tasks, _ = prepare_rooms(brief, rooms, catalog, PRESETS["default"], "anneal", 0)
    seen = 0
    for task in tasks:
        here = tuple(p for p in placed if p.space == task.space.id)
        standing = standing_of(here[: len(here) // 2], flat_kinds(catalog))
        for case in cases(group).groups[::4]:
            rest = (task.ground, standing, catalog, task.space.height)
            found = free_boxes(case, *rest, STEP, whole=True)
            members = tuple(m for m in case.members if m.on < 0 and m.z < RAISED)
            boxes = along_walls(case, task.ground, STEP)
            sound = []
            for box in boxes:
                parts = world(members, box, catalog)
                room = (task.ground.edges, task.ground.keep_free, task.ground.windows)
                codes, _ = faults(*parts, *room, standing.boxes, standing.spans, SLACK)
                sound.append(not codes.any())
            assert np.array_equal(found, boxes[np.array(sound, bool)])
            widest = longest_stretch(task.ground, standing, reach_of(case))
            if group in FULL and case.width > widest:
                assert not len(found)
            seen += len(found)
    assert seen
