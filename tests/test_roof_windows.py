"""Openings under slopes: windows that lie in them, and what a slope leaves of the others."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.space import Opening
from scenewright.domains import scene_of
from scenewright.domains.home import solving as home
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.drawing import rooms
from scenewright.drawing.svg import write_svg

STEEP = {"edge": 0, "knee": 0.9, "pitch": 1.1}
SLOPE = {"edge": 0, "knee": 1.0, "pitch": math.pi / 4}


def brief(*slopes: dict, doors: tuple = (), turned: bool = False, **window: float) -> Brief:
    at = [2, 0] if "x" not in window else [window.pop("x"), window.pop("y")]
    outline = [[0, 0], [4, 0], [4, 4], [0, 4]]
    listed = [{"at": at, "width": 0.8, **window}] if window else []
    room = {"name": "Bedroom", "outline": outline, "height": 2.5, "slopes": list(slopes)}
    room |= {"windows": listed, "doors": [{"at": [4, 3], "width": 0.9}, *doors]}
    return Brief.model_validate({"rooms": [room]})


def window_of(found: Brief) -> Opening:
    return next(o for o in spaces(found)[0].openings if o.kind == "window")


def test_a_window_above_the_knee_lies_in_the_slope() -> None:
    asked = brief(SLOPE, sill=1.2, height=1.0)
    window = window_of(asked)
    half = math.sqrt(0.5)
    assert window.roof == pytest.approx((0.2, 0.2 + half))
    assert window.head == pytest.approx(1.2 + half)
    ground = ground_of(spaces(asked)[0], (), 12.0)
    x, y, heading, width, depth, top = ground.windows[0]
    assert (x, y, heading) == pytest.approx((2.0, 0.2 + half / 2, math.pi / 2))
    assert (width, depth, top) == pytest.approx((0.8, half, 1.24))


def test_of_a_mansard_the_slope_that_is_there_counts() -> None:
    window = window_of(brief(STEEP, SLOPE | {"knee": 1.6, "pitch": 0.3}, sill=1.0, height=0.8))
    assert window.roof is not None
    assert window.roof[0] == pytest.approx(0.1 / math.tan(1.1))


def test_windows_in_gables_and_knee_walls_end_below_the_slope() -> None:
    gable = window_of(brief(SLOPE, x=0, y=1.2, sill=0.9, height=1.4))
    assert gable.roof is None
    assert gable.head == pytest.approx(1.8)  # over its lower end, 0.8 m from the knee wall
    knee = window_of(brief(SLOPE, sill=0.2, height=1.0))
    assert knee.head == 1.0


@pytest.mark.parametrize(
    ("window", "words"),
    [
        ({"sill": 0.8, "height": 1.4}, "leaves only 0.20 m"),
        ({"sill": 1.2, "height": 2.4}, "beyond the slope"),
        ({"sill": 2.5, "height": 0.5}, "beyond the slope"),
        ({"x": 0.0, "y": 0.5, "sill": 1.5, "height": 0.5}, "above the ceiling"),
    ],
)
def test_windows_that_do_not_fit_are_told(window: dict, words: str) -> None:
    with pytest.raises(InputError, match=words) as told:
        spaces(brief(SLOPE, **window))
    assert "windows[0]" in str(told.value)


def test_a_door_needs_a_ceiling_over_it() -> None:
    low = {"at": [0, 0.5], "width": 0.8}
    with pytest.raises(InputError, match="the slope over it is only") as told:
        spaces(brief(SLOPE, doors=(low,)))
    assert "doors[1]" in str(told.value)
    assert "1.10 m" in str(told.value)
    spaces(brief(SLOPE, doors=(low | {"at": [0, 1.4]},)))


def test_a_roof_window_is_drawn_and_has_neither_hole_nor_curtain() -> None:
    asked = brief(SLOPE, sill=1.2, height=1.0)
    solution = home.solve(asked, steps=500)
    assert not [p for p in solution.pieces if p.category == "curtain"]
    scene = scene_of(solution)
    wall = next(w for w in scene.walls if w.id.endswith("wall-0"))
    assert np.isclose(max(p.top for p in wall.prisms if p.base == 0), 1.0)
    assert all(p.base == 0 for p in wall.prisms)
    plain = scene_of(home.solve(brief(SLOPE), steps=500))
    dashed = 'stroke-dasharray="1 0.7"'
    drawn = [write_svg(rooms.plan(s, catalog_of([]))).count(dashed) for s in (scene, plain)]
    assert drawn[0] == drawn[1] + 1


def test_a_door_ends_below_the_slope_of_the_room_it_leads_to() -> None:
    def head(knee: float, listed: int) -> float:
        door = {"at": [1, 2.06], "height": 2.1, "to": ["hall", "attic"][1 - listed]}
        slope = {"edge": 0, "knee": knee, "pitch": 0.5}
        rooms: list[dict[str, Any]] = [
            {"id": "hall", "outline": [[0, 0], [4, 0], [4, 2], [0, 2]]},
            {"id": "attic", "outline": [[0, 2.12], [4, 2.12], [4, 6], [0, 6]], "slopes": [slope]},
        ]
        rooms[listed]["doors"] = [door]
        (opening,) = spaces(Brief.model_validate({"rooms": rooms}))[listed].openings
        return opening.head

    for listed in (0, 1):
        assert head(1.8, listed) == pytest.approx(1.8)
        assert head(2.3, listed) == pytest.approx(2.1)
        with pytest.raises(InputError, match="the slope over it is only"):
            head(0.6, listed)
