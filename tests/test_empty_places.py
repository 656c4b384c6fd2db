"""Places that hold nothing are answered: levels without walls, streets along a border, lots of no
width, sites whose ground is all taken."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.building.masonry import walls_from_brief
from scenewright.domains.extend.streets import continue_streets
from scenewright.domains.site.courts import _as_areas
from scenewright.ground.buildings.built import BuiltRoad

GROUND = [(0, 0), (60, 0), (60, 40), (0, 40)]


def test_a_level_without_walls_has_none(tmp_path):
    room = {"id": "a", "level": "0", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    loft = {"id": "b", "level": "1", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    brief = sw.Brief.model_validate(
        {
            "levels": [{"id": "0"}, {"id": "1", "elevation": 3.0}],
            "rooms": [room, loft],
            "walls": [{"start": [0, 0], "end": [4, 0], "level": "0", "thickness": 0.2}],
        }
    )
    assert len(walls_from_brief(brief, "0", 2.6, "0")) == 1
    assert walls_from_brief(brief, "1", 2.6, "0") == ()
    sw.write(sw.solve(brief, preset="quick", steps=50), tmp_path / "plan.svg")


@pytest.mark.parametrize(
    "line",
    [
        [(-60, 0), (-3, 0)],
        [(0, 0), (60, 0)],
        [(-30, -30), (0, 0)],
        [(60, -50), (60, -2)],
        [(-20, 40), (80, 40)],
    ],
)
def test_streets_along_the_border_of_an_area_are_continued_or_not(line):
    street = BuiltRoad(np.array(line, float), 6.0)
    found = continue_streets([street], shapely.Polygon(GROUND), [], [])
    assert all(len(road.line) > 1 for road in found)


def test_a_court_too_narrow_to_draw_is_left_out():
    assert _as_areas(shapely.box(0, 0, 60, 0.9)) == []
    assert len(_as_areas(shapely.box(0, 0, 20, 10))) == 1


def test_a_site_all_taken_by_a_building_that_stays_has_no_court():
    """No block is left that the form of the brief could be asked of."""
    brief = sw.Brief.model_validate(
        {
            "domain": "site",
            "sites": [
                {
                    "id": "g",
                    "outline": GROUND,
                    "setback": 1,
                    "court_gap": 5,
                    "blocks": [{"at": (30, 20), "form": "peripheral"}],
                    "fixed": [
                        {"id": "f", "model": "point_tower", "at": (30, 20), "size": (56, 36, 30)}
                    ],
                }
            ],
        }
    )
    solution = sw.solve(brief, preset="quick")
    assert [p.id for p in solution.pieces if p.category == "building"] == ["f"]
    assert all(f.given for f in sw.check(solution).findings)
