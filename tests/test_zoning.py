"""Proposed zonings: exact shares, no overlaps, wishes met, the same wherever the hall lies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from deadline import within
from scenewright.building.outlines import polygon
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.space import Points, Space
from scenewright.domains.hall.hall_layout import Zone, ZoneLink
from scenewright.domains.hall.zoning import ZoneWish, proposals, propose
from scenewright.domains.hall.zoning.borders import border_lengths, floor_of, shared_borders
from scenewright.domains.hall.zoning.cuts import area_below, cut, frame_of
from scenewright.domains.hall.zoning.trees import every_tree, leaves

GRID = 1e-8
ELL = [[0, 0], [20, 0], [20, 8], [9, 8], [9, 18], [0, 18]]
BIG = [[0, 0], [24, 0], [24, 16], [0, 16]]
U = [[0, 0], [24, 0], [24, 16], [18, 16], [18, 6], [6, 6], [6, 16], [0, 16]]
T = np.linspace(0, 2 * np.pi, 61)[:-1]
OVAL = np.column_stack([10 * np.cos(T), 8 * np.sin(T)]).tolist()
SKEW = [[0, 0], [20, 3], [22, 14], [6, 17], [-2, 9]]


def column(x: float, y: float, side: float = 0.5) -> list[list[float]]:
    return [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]


def hall(outline: Any, holes: Any = (), doors: Any = ()) -> Space:
    listed = [{"id": f"d{k}", "at": at, "width": 1.6} for k, at in enumerate(doors)]
    room = {"id": "hall", "outline": outline, "holes": list(holes), "doors": listed}
    return spaces(Brief.model_validate({"domain": "hall", "rooms": [room]}))[0]


HALLS = {
    "rectangle": hall(BIG, [column(7, 5), column(16, 11)], [[12, 0], [24, 8]]),
    "ell": hall(ELL, [column(4, 4), column(12, 4)], [[15, 0], [4, 18]]),
    "oval": hall(OVAL, [column(0, 0, 0.8)], [[0, -8], [10, 0]]),
    "u": hall(U, [], [[12, 0], [3, 16]]),
    "skew": hall(SKEW, [column(9, 8)], [[10, 1.5], [21, 8.5]]),
}
CHAIN = (
    ZoneWish("entry", area=20, door="d0"),
    ZoneWish("a", area=60, beside=("entry",)),
    ZoneWish("b", area=50, beside=("a",)),
    ZoneWish("c", area=50, beside=("b",)),
    ZoneWish("d", area=40),
    ZoneWish("shop", area=30, door="d1"),
)


def shape(zone: Zone) -> shapely.Polygon:
    return shapely.Polygon(zone.outline, zone.holes)


def assert_divides(space: Space, wishes: Any, zones: tuple[Zone, ...]) -> None:
    """Zones fill the floor, do not overlap and have the shares wished for. Points within a
    millimetre are one in an outline, so that a sliver along an edge may be lost."""
    shapes, floor = [shape(zone) for zone in zones], floor_of(space)
    assert [zone.id for zone in zones] == [wish.id for wish in wishes]
    assert all(one.is_valid for one in shapes)
    assert sum(one.area for one in shapes) == pytest.approx(floor.area, rel=1e-4)
    filled = shapely.union_all(shapes, grid_size=GRID)
    assert filled.symmetric_difference(floor, grid_size=GRID).area < 1e-4 * floor.area
    total = sum(wish.area for wish in wishes)
    for one, wish in zip(shapes, wishes, strict=True):
        assert one.area == pytest.approx(floor.area * wish.area / total, rel=0.01)


def lengths(zones: tuple[Zone, ...]) -> dict[tuple[str, str], float]:
    found = border_lengths(shared_borders(zones))
    return {(zones[i].id, zones[j].id): length for (i, j), length in found.items()}


@pytest.mark.parametrize("count", [2, 3, 6])
@pytest.mark.parametrize("name", HALLS)
def test_the_floor_is_shared_exactly(name: str, count: int) -> None:
    for zones in proposals(HALLS[name], CHAIN[:count], 2, seed=1):
        assert_divides(HALLS[name], CHAIN[:count], zones)


@pytest.mark.parametrize("name", ["rectangle", "oval", "skew", "ell"])
def test_neighbours_meet_and_zones_lie_at_their_doors(name: str) -> None:
    space = HALLS[name]
    zones = propose(space, CHAIN)
    met = lengths(zones)
    for pair in (("entry", "a"), ("a", "b"), ("b", "c")):
        assert met.get(pair, 0.0) >= 1.2, pair
    for zone, opening in ((zones[0], "d0"), (zones[5], "d1")):
        door = next(o for o in space.openings if o.id == opening)
        assert shape(zone).distance(shapely.Point(door.x, door.y)) < door.thickness / 2 + 0.01


@pytest.mark.parametrize("name", HALLS)
def test_no_door_is_cut_and_no_zone_is_a_sliver(name: str) -> None:
    space = HALLS[name]
    zones = propose(space, CHAIN)
    for door in space.openings:
        along = np.array([door.ux, door.uy]) * (door.width / 2 - 0.05)
        middle = np.array([door.x, door.y])
        ends = [shapely.Point(middle + side * along) for side in (-1, 1)]
        nearest = [min(zones, key=lambda z, end=end: shape(z).distance(end)).id for end in ends]
        assert nearest[0] == nearest[1]
    for zone in zones:
        core = shapely.Polygon(zone.outline).buffer(-0.6, join_style="mitre")
        assert isinstance(core, shapely.Polygon)
        assert core.area > 0.25 * shape(zone).area


def test_everything_can_be_walked_to() -> None:
    for space in HALLS.values():
        zones = propose(space, CHAIN)
        reached = {"entry"}
        for _ in zones:
            reached |= {
                b
                for pair, length in lengths(zones).items()
                if length >= 1.2 and reached & set(pair)
                for b in pair
            }
        assert reached == {zone.id for zone in zones}


def test_links_come_before_shape() -> None:
    wishes = [ZoneWish(name) for name in "abcdef"]
    pairs = ("ab", "bc", "cd", "de", "ef", "ad")
    links = [ZoneLink("hall", one, two, 1.5) for one, two in pairs]
    for seed in range(3):
        met = lengths(propose(HALLS["rectangle"], wishes, seed, links))
        assert all(met.get((one, two), 0.0) >= 1.5 for one, two in pairs)


def test_zones_that_have_an_outline_stay() -> None:
    space = HALLS["ell"]
    stage = Zone("stage", "Stage", "hall", np.array([[0, 8], [9, 8], [9, 12], [0, 12]], float))
    wishes = [ZoneWish("a", area=2), ZoneWish("stage", zone=stage), ZoneWish("b", area=1)]
    zones = propose(space, wishes)
    assert zones[1] is stage
    assert all(
        shape(zone).intersection(shape(stage), grid_size=GRID).area < 1e-9 for zone in zones[::2]
    )
    areas = [shape(zone).area for zone in zones]
    assert areas == pytest.approx([160 - 0.5, 36, 54], rel=0.01)
    whole = ZoneWish("stage", zone=Zone("stage", "", "hall", space.outline, space.holes))
    with pytest.raises(InputError, match="leave no floor for zone 'a'"):
        propose(space, [ZoneWish("a"), whole])


def test_proposals_differ_and_follow_the_seed() -> None:
    space = HALLS["rectangle"]
    found = proposals(space, CHAIN, 4, seed=3)
    assert len(found) == 4
    for k, one in enumerate(found):
        for other in found[:k]:
            same = sum(
                shape(a).intersection(shape(b), grid_size=GRID).area
                for a, b in zip(one, other, strict=True)
            )
            assert same < 0.85 * floor_of(space).area
    again = proposals(space, CHAIN, 4, seed=3)
    assert all(
        np.array_equal(a.outline, b.outline)
        for one, two in zip(found, again, strict=True)
        for a, b in zip(one, two, strict=True)
    )
    assert proposals(space, CHAIN, 1, seed=3)[0][0].outline.tolist() == found[0][0].outline.tolist()


@pytest.mark.parametrize("quarters", [1, 2, 3])
@pytest.mark.parametrize("name", HALLS)
def test_turning_and_moving_the_hall_turns_and_moves_its_zones(name: str, quarters: int) -> None:
    space = HALLS[name]
    cos, sin = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters]

    def moved(points: Points) -> Points:
        return points @ np.array([[cos, sin], [-sin, cos]], float) + [13.25, -7.5]

    outer = [o for o in space.openings if o.kind != "window"]
    faces = [
        np.array([o.x, o.y]) - [o.uy * o.thickness / 2, -o.ux * o.thickness / 2] for o in outer
    ]
    other = hall(
        moved(space.outline).tolist(),
        [moved(hole).tolist() for hole in space.holes],
        [moved(face).tolist() for face in faces],
    )
    for one, two in zip(propose(space, CHAIN), propose(other, CHAIN), strict=True):
        turned = shapely.Polygon(moved(one.outline), [moved(hole) for hole in one.holes])
        assert turned.symmetric_difference(shape(two), grid_size=GRID).area < 0.02


@st.composite
def floors(draw: st.DrawFn) -> Space:
    """Star-shaped outlines of 20 to 800 square metres, some with a column."""
    count = draw(st.integers(3, 12))
    parts = np.array(draw(st.lists(st.floats(0.5, 1.0), min_size=count, max_size=count)))
    radii = np.array(draw(st.lists(st.floats(6.0, 14.0), min_size=count, max_size=count)))
    angles = np.cumsum(parts) / parts.sum() * 2 * np.pi
    corners = radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    hole = [column(-0.3, -0.3)] if draw(st.booleans()) else []
    try:
        floor = polygon(corners.tolist(), hole)
    except InputError:
        hole, floor = [], polygon(corners.tolist())
    del floor
    return hall(corners.tolist(), hole)


@given(floors(), st.lists(st.floats(1.0, 5.0), min_size=2, max_size=7), st.integers(0, 5))
@settings(max_examples=25, deadline=None)
def test_any_floor_is_shared(space: Space, areas: list[float], seed: int) -> None:
    wishes = [ZoneWish(f"z{k}", area=area) for k, area in enumerate(areas)]
    assert_divides(space, wishes, propose(space, wishes, seed))


@given(floors(), st.floats(0.02, 0.98), st.sampled_from([0, 1]))
def test_a_cut_leaves_two_pieces_of_exact_area(space: Space, share: float, axis: int) -> None:
    floor = floor_of(space)
    made = cut(floor, axis, share * floor.area)
    if made is None:
        return
    low, high = made
    assert low.area == pytest.approx(share * floor.area, rel=1e-3)
    assert low.area + high.area == pytest.approx(floor.area)
    assert low.intersection(high, grid_size=GRID).area < 1e-6


@given(floors(), st.floats(-14, 14))
def test_area_below_agrees_with_clipping(space: Space, at: float) -> None:
    rings = [np.vstack([ring, ring[:1]]) for ring in (space.outline, *space.holes)]
    edges = [tuple(row) for ring in rings for row in np.hstack([ring[:-1], ring[1:]]).tolist()]
    clipped = floor_of(space).intersection(shapely.box(-99, -99, at, 99))
    assert area_below(edges, at) == pytest.approx(clipped.area, abs=1e-9)


def test_an_arm_is_cut_alone_where_the_line_falls_apart() -> None:
    made = cut(shapely.Polygon(U), 1, 264.0 - 30.0)
    assert made is not None
    assert np.round(made[1].bounds, 6).tolist() in [[0, 11, 6, 16], [18, 11, 24, 16]]
    assert made[0].area == pytest.approx(234.0)


def test_cuts_are_parallel_to_the_walls() -> None:
    angle = 0.4
    turned = np.array(BIG, float) @ np.array(
        [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]
    )
    frame = frame_of(hall(turned.tolist()))
    assert (frame.cos, frame.sin) == pytest.approx((np.cos(angle), np.sin(angle)))
    for zone in propose(hall(turned.tolist()), CHAIN[1:4]):
        assert len(zone.outline) == 4


def test_all_trees_are_tried_where_there_are_few() -> None:
    trees = list(every_tree((0, 1, 2)))
    assert len(trees) == len(set(trees)) == 48
    assert all(sorted(leaves(tree)) == [0, 1, 2] for tree in trees)


def test_eight_zones_take_little_time() -> None:
    wishes = [ZoneWish(f"z{k}", area=1 + k % 3) for k in range(8)]
    with within(60):
        assert_divides(HALLS["ell"], wishes, propose(HALLS["ell"], wishes, 1))


def test_many_zones_and_many_corners_are_bearable() -> None:
    wishes = [ZoneWish(f"z{k}", area=1 + k % 3) for k in range(60)]
    with within(60):
        assert_divides(HALLS["ell"], wishes, propose(HALLS["ell"], wishes))
    angle = np.linspace(0, 2 * np.pi, 2001)[:-1]
    radius = 12 + np.sin(7 * angle)
    flower = hall(np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]).tolist())
    with within(60):
        assert_divides(flower, CHAIN[1:5], propose(flower, CHAIN[1:5]))
