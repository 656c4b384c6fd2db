"""Walls that are built in halls, and what stays when a zone's floor or wall is short."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import scenewright
from hall_chains import SLACK, answer, boxes_of, posed, ring, rules_broken, two_zones
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.domains.hall.shortfall.unplaceable import drop_unplaceable
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.walls.partitions import wall_needed
from scenewright.domains.hall.zoning.assign import Unit
from scenewright.engine.draws import streams


def lengths(pieces: tuple[Piece, ...]) -> float:
    return sum(piece.size.width for piece in pieces if piece.category == "partition")


def test_walls_are_built_only_where_walls_are_short() -> None:
    few, many = (
        answer(
            two_zones(
                {
                    "id": "art",
                    "category": "wall_exhibit",
                    "count": count,
                    "size": [1.2, 0.1, 1.5],
                    "zone": "east",
                }
            )
        )
        for count in (6, 26)
    )
    assert lengths(few.pieces) == 0.0
    assert lengths(many.pieces) > 0.0
    assert many.left_out == ()
    walls = [body(piece) for piece in many.pieces if piece.category == "partition"]
    art = [piece for piece in many.pieces if piece.function == "art"]
    beside = [piece for piece in art if min(body(piece).distance(w) for w in walls) < 0.02]
    assert beside, "nothing hangs on the walls that were built"
    for piece in beside:
        wall = min(walls, key=body(piece).distance)
        assert back(piece).distance(wall) < 0.02
    for piece in art:
        hung = [*walls, shapely.Polygon(ring(0, 0, 20, 10)).exterior]
        assert min(back(piece).distance(wall) for wall in hung) < 0.02


def body(piece: Piece) -> shapely.Polygon:
    row = np.array([[piece.pose.x, piece.pose.y, piece.pose.heading, *piece.size[:2]]])
    return shapely.Polygon(corners(row)[0])


def back(piece: Piece) -> shapely.Point:
    """The middle of a piece's back edge."""
    front = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    return shapely.Point(np.array(piece.pose[:2]) - front * piece.size.depth / 2)


@pytest.mark.parametrize("seed", range(4))
def test_walls_never_close_the_only_passage(seed: int) -> None:
    brief = two_zones(
        {
            "id": "art",
            "category": "wall_exhibit",
            "count": 30,
            "size": [1.2, 0.1, 1.5],
            "zone": "east",
        }
    )
    found = answer(brief, seed=seed)
    built = [body(piece) for piece in found.pieces if piece.category == "partition"]
    assert built
    border = shapely.LineString([(10, 0), (10, 10)])
    left = border.difference(shapely.union_all([wall.buffer(1e-6) for wall in built]))
    assert max(part.length for part in shapely.get_parts(left)) >= brief.passage_width
    report = scenewright.check(found)
    assert report.valid, report.findings


def test_walls_are_as_long_as_the_paper_says() -> None:
    """100 (M + 1) + Σ l centimetres for M objects of lengths l."""
    demand = {
        "id": "art",
        "category": "wall_exhibit",
        "count": 14,
        "size": [1.2, 0.1, 1.5],
        "zone": "east",
    }
    needed = 15 * 1.0 + 14 * 1.2
    wishes = collect_demands(two_zones(demand), 0, (), shipped())
    assert wall_needed(wishes[0], 14, True) == pytest.approx(needed)
    beside = wishes[0]._replace(clearance=(0.6, 0.0, 0.0, 0.0))
    assert wall_needed(beside, 14, False) < wall_needed(beside, 14, True)
    windows = [{"at": [x, 10], "width": 2.0, "sill": 1.0} for x in (11.5, 14.0, 16.5, 18.9)]
    for count in (10, 12, 14):
        brief = two_zones(demand | {"count": count}, windows=windows)
        found = posed(brief, "paper")
        east = found.hall.names.index("east")
        walls = sum(np.hypot(w.x1 - w.x0, w.y1 - w.y0) for w in found.hall.walls[east])
        lack = (count + 1) * 1.0 + count * 1.2 - walls
        built = sum(host.span[1] - host.span[0] for host in found.fitted.hosts)
        assert lack > 1.2
        longest = 10.0 - 2 * (brief.passage_width + 0.3)  # a way round both ends
        assert built >= min(lack, longest) - 1e-9
        for _, (low, high), (least, most), _ in found.fitted.hosts:
            assert least <= low < high <= most
            assert min(least, 10.0 - most) >= brief.passage_width
        assert found.fitted.units == [Unit(0, east, 0, count)]


def test_what_has_no_place_in_the_end_is_left_out() -> None:
    """Were there only one look for places, what stays would still stand where it was put."""
    art = {"id": "art", "category": "wall_exhibit", "count": 26, "size": [1.2, 0.1, 1.5]}
    cases = [
        {
            "id": f"case {k}",
            "category": "showcase",
            "count": 3,
            "size": [3.0, 2.0, 1.0],
            "clearance": 0.1,
        }
        for k in range(9)
    ]
    brief = two_zones(art, *cases)
    asked = 26 + 27
    found = posed(brief, most_rounds=1).fitted
    chain = begin_chain(found.problem, found.start, streams(0, 1)[0])
    placed = len(boxes_of(chain))
    assert 0 < placed < asked
    assert placed == sum(unit.last - unit.first for unit in found.units)
    assert rules_broken(found.problem, chain) < SLACK


@pytest.mark.parametrize("share", [0.1, 0.5, 1.0])
def test_no_zone_is_asked_to_hold_more_than_its_floor(share: float) -> None:
    """By more than one object, whatever the groups are."""
    benches = [
        {
            "id": f"b{k}",
            "category": "bench",
            "size": [1.2, 0.5, 0.5],
            "clearance": 0.5,
            "count": 1 + k % 3,
            "required": k % 4 > 0,
        }
        for k in range(400)
    ]
    found = posed(two_zones(*benches, {"id": "all", "category": "showcase", "count": 5000}))
    wishes, hall = found.wishes, found.hall
    whole = [Unit(k, k % 2, 0, len(wish.sizes)) for k, wish in enumerate(wishes)]
    stay = drop_unplaceable(hall, wishes, whole, share)
    assert all(unit.last <= whole[unit.demand].last for unit in stay)
    for zone in range(2):
        taken = [0.0]
        for unit in (unit for unit in stay if unit.zone == zone):
            front, left, back, right = (share * depth for depth in wishes[unit.demand].clearance)
            size = wishes[unit.demand].sizes[0]
            one = (size.width + left + right) * (size.depth + front + back)
            taken += [one] * (unit.last - unit.first)
        assert 90.0 < sum(taken) <= 100.0 + 2 * max(taken)


def test_wall_rows_come_before_what_can_stand_elsewhere() -> None:
    zone = {"id": "z", "outline": [[0, 0], [13, 0], [13, 10], [0, 10]]}
    demands = [
        {"id": "pictures", "category": "wall_exhibit", "count": 9, "zone": "z", "place": "wall"},
        {"id": "cases", "category": "showcase", "count": 10, "zone": "z"},
        {"id": "plinths", "category": "plinth", "count": 8, "zone": "z"},
        {"id": "benches", "category": "bench", "count": 4, "zone": "z"},
    ]
    outline = [[-9, 0], [22, 0], [22, 19], [-9, 19]]
    room = {
        "id": "hall",
        "outline": outline,
        "height": 4.0,
        "zones": [zone],
        "demands": demands,
        "doors": [{"id": "d", "at": [-9, 9], "width": 1.8}],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    for seed in range(10):
        fitted = posed(brief, seed=seed).fitted
        assert [u.last for u in fitted.units if u.demand == 0] == [9], "the row is whole"
