"""Furniture of public halls: how it is placed by default, and that it stays light."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.public.wares import TRADES, levels_of, stock
from scenewright.catalog.kinds import ELSE, KINDS, hall_use
from scenewright.core.scene import Size
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.render.lighter import box_small_bodies

SIDES = ("front", "left", "back", "right")
USE = {name: kind.hall for name, kind in KINDS.items() if kind.hall}


@pytest.mark.parametrize("category", USE)
def test_every_row_stands_on_the_floor_in_known_patterns(category: str) -> None:
    use = USE[category]
    assert KINDS[category].support == "floor"
    assert use.patterns
    assert set(use.patterns) <= set(PATTERNS)
    assert len(set(use.patterns)) == len(use.patterns)
    assert all(0 <= depth <= 2 for depth in use.clearance)
    assert (use.place == "wall") == (use.patterns == ("wall",))
    if use.place == "wall":
        assert use.clearance[2] == 0


@pytest.mark.parametrize("category", USE)
def test_what_must_be_reached_has_the_room_for_it(category: str) -> None:
    """Some side people use is kept as clear as they need, alone or with the aisle it shares."""
    kind, clearance = KINDS[category], dict(zip(SIDES, USE[category].clearance, strict=True))
    if kind.access:
        assert 2 * max(clearance[side] for side in kind.access) >= kind.reach


@pytest.mark.parametrize("category", ["gondola", "book_stack", "wall_shelving", "ring_shelf"])
def test_two_facing_shelves_make_an_aisle(category: str) -> None:
    use = hall_use(category)
    assert 1.2 <= 2 * use.clearance[0] <= 1.5
    assert use.clearance[1] == use.clearance[3] == 0


def test_what_has_no_row_stands_free() -> None:
    assert hall_use("obstacle") == ELSE == ("free", (0.6,) * 4, ("chain", "grid", "single"))
    assert "partition" not in USE


def _triangles(category: str, size: Size | None = None) -> int:
    asset = shipped().choose(category, size or shipped().of(category)[0].usual)
    assert asset is not None
    return sum(len(part.faces) for part in asset.mesh(size or asset.usual))


def test_what_halls_hold_many_of_is_light() -> None:
    """Where there are very many, goods are boxes: as heavy as the shelves that carry them."""
    for category in ("auditorium_seat", "reading_chair", "lounge_seat"):
        assert _triangles(category) <= 250, category
    for width in (0.5, 1.25, 2.5):
        for height in (1.2, 1.6, 2.4):
            for category in ("gondola", "wall_shelving", "ring_shelf", "book_stack"):
                asset = shipped().of(category)[0]
                far = [box_small_bodies(part) for part in asset.mesh(Size(width, 0.8, height))]
                assert sum(len(part.faces) for part in far) <= 3300, (category, width, height)
    assert _triangles("partition", Size(30, 0.15, 4)) <= 30


@pytest.mark.parametrize("category", ["showcase", "plinth"])
def test_variants_are_chosen_by_size(category: str) -> None:
    rows = shipped().of(category)
    assert len(rows) > 1
    chosen = [shipped().choose(category, row.usual) for row in rows]
    assert [one and one.usual for one in chosen] == [row.usual for row in rows]


@pytest.mark.parametrize("trade", TRADES)
@pytest.mark.parametrize("turned", [False, True])
def test_goods_stand_on_their_shelf_and_fit_below_the_next(trade: str, turned: bool) -> None:
    levels = levels_of(0.1, 2.1, 5)
    for wide, seed in ((0.4, 3), (1.2, 9), (2.4, 0)):
        found = stock(trade, (-wide, wide), (0.0, 0.4), levels, seed, 4000, turned)
        drawn = [mesh.vertices for meshes in found.values() for mesh in meshes]
        assert drawn
        for points in drawn:
            low, high = points.min(0), points.max(0)
            shelf = next(z for z in levels if z[0] - 1e-6 <= low[2] < z[1])
            assert high[2] <= shelf[1] + 0.005
            assert (np.abs(points[:, 0]) <= wide + 0.02).all()
            assert low[1] >= -0.01
            assert high[1] <= 0.41


def test_a_long_partition_is_hatched_all_along() -> None:
    lines = shipped().of("partition")[0].symbol(Size(30.0, 0.2, 3.0))
    starts = sorted(line[0, 0] for line in lines[1:])
    assert starts[0] < -14.6
    assert starts[-1] > 14.4
    assert max(b - a for a, b in pairwise(starts)) < 0.3
