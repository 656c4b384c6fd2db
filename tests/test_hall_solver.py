"""Chains of halls: energies that add up, rules that hold, answers that repeat, walls that serve."""

from __future__ import annotations

import importlib
import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall import solving as domain
from scenewright.domains.hall.assign import Unit
from scenewright.domains.hall.build_problem import HallContext, hall_of
from scenewright.domains.hall.fit import Fitted, fit
from scenewright.domains.hall.holdings import HallDemand, collect_demands
from scenewright.domains.hall.partitions import wall_needed
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.shortfall import drop_unplaceable
from scenewright.domains.hall.solvers.chains import (
    HallChain,
    advance,
    anneal_hall,
    begin_chain,
    gd_mh,
    layout_of,
)
from scenewright.domains.hall.solvers.guided_metropolis import count_missed
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.table import REACH
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.domains.hall.zones import borders_of, zones_of
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget
from scenewright.formats import solution_json

SAMPLES = ("exhibition", "shop", "reading-room", "auditorium", "irregular")
SLACK = 5e-4
"""Square metres a footprint may stand over an edge."""


class Posed(NamedTuple):
    hall: HallContext
    wishes: list[HallDemand]
    fitted: Fitted


def posed(brief: Brief, preset: str = "default", seed: int = 0) -> Posed:
    space = spaces(brief)[0]
    plan = zones_of(brief, 0, space)
    found = hall_of(space, plan, borders_of(plan, space), (), brief.route_width)
    wishes = collect_demands(brief, 0, (), shipped())
    row = PRESETS[preset]
    return Posed(found, wishes, fit(found, wishes, row.weights, shipped(), seed, row.whole))


def sample(name: str) -> Brief:
    return scenewright.read(f"sample:hall-{name}")


def ring(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def two_zones(*demands: dict[str, Any], **room: Any) -> Brief:
    """A hall of 20 by 10 metres in two equal zones, joined by the default link."""
    return Brief.model_validate(
        {
            "domain": "hall",
            "rooms": [
                {
                    "id": "hall",
                    "outline": ring(0, 0, 20, 10),
                    "height": 3.2,
                    "doors": [{"id": "in", "at": [5, 0], "width": 1.8}],
                    "zones": [
                        {"id": "west", "outline": ring(0, 0, 10, 10)},
                        {"id": "east", "outline": ring(10, 0, 20, 10)},
                    ],
                    "demands": list(demands),
                }
                | room
            ],
        }
    )


def fresh(chain: HallChain) -> float:
    """The energy of where a chain stands, measured from nothing."""
    base, free, reached = chain.bits
    lost = count_missed(chain.p, chain.s, chain.grid, base, free, reached, chain.inset)
    return float(measure_all(chain.p, chain.s, chain.work) + chain.p.weights[REACH] * lost)


def boxes_of(chain: HallChain) -> np.ndarray:
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    return boxes


def rules_broken(problem: HallProblem, chain: HallChain) -> float:
    """The largest area by which footprints leave their zone, share floor, or stand in solids."""
    shapes = shapely.polygons(corners(boxes_of(chain)))
    ground, worst = problem.ground, 0.0
    for u, (first, last) in enumerate(problem.units.spans):
        a, b = ground.zone_spans[problem.units.zones[u]]
        zone = shapely.polygonize(
            [shapely.LineString(edge.reshape(2, 2)) for edge in ground.zone_edges[a:b]]
        )
        floor = max(zone.geoms, key=lambda part: part.envelope.area)
        worst = max(worst, *shapely.area(shapely.difference(shapes[first:last], floor)))
    walls = chain.s.walls[chain.s.walls[:, 4] > 0.0]
    built = np.column_stack([walls[:, :2], walls[:, 7], 2 * walls[:, 4], 2 * walls[:, 5]])
    rows = np.vstack([ground.obstacles, ground.keep_free, built])
    solids = shapely.union_all(shapely.polygons(corners(rows))) if len(rows) else shapely.Point()
    worst = max(worst, *shapely.area(shapely.intersection(shapes, solids)))
    first, second = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    pairs = first < second
    shared = shapely.area(shapely.intersection(shapes[first[pairs]], shapes[second[pairs]]))
    return float(max(worst, shared.max(initial=0.0)))


@pytest.mark.parametrize("name", SAMPLES)
def test_energies_add_up_and_no_rule_is_broken_along_a_chain(name: str) -> None:
    problem, start = (one := posed(sample(name)).fitted).problem, one.start
    chain = begin_chain(problem, start, streams(7, 1)[0])
    assert chain.tally[0] == pytest.approx(fresh(chain), abs=1e-9)
    begun, made = float(chain.tally[2]), 0
    for _ in range(8):
        advance(chain, np.array([0.05, 20.0, 3200.0, 0.6]), made, 400)
        made += 400
        assert chain.tally[0] == pytest.approx(fresh(chain), abs=1e-6)
        assert rules_broken(problem, chain) < SLACK
    assert chain.tally[3] > 100, "hardly a move was accepted"
    assert chain.tally[2] <= begun
    best = layout_of(chain)
    assert best.energy == pytest.approx(chain.tally[2], abs=1e-6)
    assert best.energy == pytest.approx(fresh(chain), abs=1e-9)
    assert rules_broken(problem, chain) < SLACK


@pytest.mark.parametrize("solve", [anneal_hall, gd_mh])
def test_the_best_is_never_worse_than_the_start(solve: Any) -> None:
    for name, preset in (("exhibition", "default"), ("auditorium", "paper")):
        fitted = posed(sample(name), preset).fitted
        begun = begin_chain(fitted.problem, fitted.start, streams(0, 1)[0]).tally[2]
        energies = []
        for steps in (32, 600):
            found = solve(fitted.problem, fitted.start, Budget(steps=steps, threads=1), 3)
            energies.append(found.layouts[0].energy)
            assert [layout.energy for layout in found.layouts] == sorted(
                layout.energy for layout in found.layouts
            )
        assert max(energies) <= begun + 1e-9
        assert energies[1] < begun


def test_gd_mh_makes_a_thousand_iterations() -> None:
    brief = sample("shop")
    found = scenewright.solve(brief, preset="paper", seed=1)
    assert (found.solver, found.evaluations) == ("gd-mh", 1000)
    assert {value.term for value in found.terms} == {"space", "fill", "access", "proportion"}
    fitted = posed(brief, "paper").fitted
    assert gd_mh(fitted.problem, fitted.start, Budget(), 1).evaluations == 1000


def answer(brief: Brief, **more: Any) -> Solution:
    asked: dict[str, Any] = {"preset": "quick", "steps": 1200, "seed": 4}
    return scenewright.solve(brief, **asked | more)


@pytest.mark.parametrize("solver", ["anneal", "gd-mh"])
def test_the_same_seed_gives_the_same_hall_on_any_number_of_threads(solver: str) -> None:
    brief = sample("exhibition")
    one, two = (answer(brief, threads=n, solver=solver, steps=600) for n in (1, 2))
    assert one.pieces == two.pieces
    assert one.energies == two.energies
    assert one.detail is not None
    assert two.detail is not None
    assert one.detail.layout.groups == two.detail.layout.groups
    assert answer(brief, threads=2, solver=solver, steps=600, seed=5).pieces != one.pieces


def test_two_halls_do_not_depend_on_each_other() -> None:
    room = sample("shop").rooms[0]
    moved = room.model_copy(
        update={
            "id": "twin",
            "outline": [(x, y + 40) for x, y in room.outline],
            "doors": [],
            "windows": [],
            "zones": [],
            "links": [],
        }
    )
    demands = [one.model_copy(update={"zone": None}) for one in room.demands]
    moved = moved.model_copy(update={"demands": demands})
    brief = sample("shop")
    pair = brief.model_copy(update={"rooms": [room, moved]})
    alone, both = answer(brief, steps=200, threads=1), answer(pair, steps=200, threads=2)
    assert alone.pieces == tuple(piece for piece in both.pieces if piece.space == "shop")
    assert set(both.energies) == {"shop", "twin"}


def test_progress_is_heard_and_cancelling_keeps_what_was_found() -> None:
    brief, shares = sample("exhibition"), list[float]()
    whole = answer(brief, steps=20_000, threads=1, progress=lambda share, _: shares.append(share))
    assert shares == sorted(shares)
    assert 0.0 <= shares[0] < 0.2
    assert shares[-1] == 1.0
    heard = iter(range(10))
    part = answer(brief, steps=20_000, threads=1, cancel=lambda: next(heard, None) is None)
    assert 0 < part.evaluations < whole.evaluations
    assert len(part.pieces) == len(whole.pieces)
    nothing = answer(brief, cancel=lambda: True)
    assert (nothing.evaluations, nothing.energies) == (0, {})


def test_seconds_are_kept() -> None:
    found = answer(sample("irregular"), steps=None, seconds=0.6, threads=1)
    assert 0.3 < found.seconds < 4.0
    assert found.evaluations > 100


def test_locked_objects_stay_and_count(tmp_path: Path) -> None:
    """A piece locked in the file stays to the bit; its group is no larger than before."""
    path = tmp_path / "hall.json"
    first = answer(sample("exhibition"))
    scenewright.write(first, path)
    document = json.loads(path.read_text())
    kept = [p for p in document["pieces"] if p["function"] in ("finds", "boat")]
    for piece in kept:
        piece["fixed"] = True
    path.write_text(json.dumps(document))
    again = answer(scenewright.read(path), seed=11)
    pieces = {piece.id: piece for piece in again.pieces}
    assert len(pieces) == len(again.pieces)
    for piece in kept:
        assert list(pieces[piece["id"]].pose) == piece["pose"]
        assert pieces[piece["id"]].fixed
    assert by_function(again) == by_function(first)
    assert again.pieces != first.pieces
    assert scenewright.check(again).valid
    assert again.detail is not None
    assert {"hall/finds", "hall/boat"} <= {group.id for group in again.detail.layout.groups}
    assert solution_json.loads(solution_json.dumps(again)).pieces == again.pieces


def by_function(found: Solution) -> dict[str, int]:
    names = [p.function for p in found.pieces if p.function not in ("partition", "fixed")]
    return {name: names.count(name) for name in sorted(set(names))}


def test_one_locked_object_of_many_leaves_room_for_the_others() -> None:
    """Only the one is fixed (as a brief may say): five of six are still to be placed."""
    fixed = {
        "category": "showcase",
        "at": [15, 5],
        "size": [1.2, 0.6, 2.0],
        "function": "cases",
        "group": "hall/cases",
        "id": "hall/cases/showcase_1",
    }
    sizes = [[1.2, 0.6, 2.0], [2.0, 0.6, 1.0], [1.6, 0.6, 1.4]]
    brief = two_zones(
        {"id": "cases", "category": "showcase", "sizes": sizes, "zone": "east"}, fixed=[fixed]
    )
    found = answer(brief)
    mine = [piece for piece in found.pieces if piece.function == "cases"]
    assert sorted(piece.size.width for piece in mine) == [1.2, 1.6, 2.0]
    assert len({piece.id for piece in mine}) == 3
    assert scenewright.check(found).valid


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
    assert wall_needed(wishes[0], 14, False) < needed
    windows = [{"at": [x, 10], "width": 2.0, "sill": 1.0} for x in (11.5, 14.0, 16.5, 18.9)]
    for count in (10, 12, 14):
        brief = two_zones(demand | {"count": count}, windows=windows)
        found = posed(brief, "paper")
        east = found.hall.names.index("east")
        walls = sum(np.hypot(w.x1 - w.x0, w.y1 - w.y0) for w in found.hall.walls[east])
        lack = (count + 1) * 1.0 + count * 1.2 - walls
        built = sum(high - low for _, (low, high) in found.fitted.hosts)
        assert lack > 1.2
        longest = 10.0 - 2 * (brief.passage_width + 0.3)  # a way round both ends
        assert built >= min(lack, longest) - 1e-9
        for _, (low, high) in found.fitted.hosts:
            assert min(low, 10.0 - high) >= brief.passage_width
        assert found.fitted.units == [Unit(0, east, 0, count)]


def test_what_has_no_place_in_the_end_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Were there only one look for places, what stays would still stand where it was put."""
    module = importlib.import_module("scenewright.domains.hall.fit")
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
    monkeypatch.setattr(module, "MOST_ROUNDS", 1)
    found = posed(brief).fitted
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


def test_no_hall_no_energy() -> None:
    """A hall without demands is an answer too."""
    found = domain.solve(two_zones())
    assert (found.pieces, found.left_out, found.evaluations) == ((), (), 0)
    assert found.detail is not None
    assert [zone.id for zone in found.detail.layout.zones] == ["west", "east"]


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
