"""Where planters, totems, baskets and pianos of a hall stand."""

from __future__ import annotations

import math
from functools import partial
from itertools import combinations, pairwise
from typing import Any

import numpy as np
import pytest

import scenewright as sw
from hall_chains import posed, two_zones
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains.hall.seats.low_tables import keep_reached
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import lacking, measure_among
from scenewright.engine.draws import streams

WIDE, DEEP, DOOR = 16.0, 10.0, 6.0
"""The room of all tests, and where along its south wall the middle of its door is, in metres."""


def solve(*demands: dict[str, Any], steps: int = 1500, **options: Any) -> Solution:
    outline = [[0, 0], [WIDE, 0], [WIDE, DEEP], [0, DEEP]]
    door = {"id": "front", "at": [DOOR, 0], "width": 2.0, "swing": "slide"}
    room = {"name": "Hall", "outline": outline, "doors": [door], "demands": list(demands)}
    brief = {"domain": "hall", "name": "Hall", "rooms": [{**room, "height": 4.0}]}
    return sw.solve(Brief.model_validate(brief), steps=steps, threads=1, **options)


def of_kind(solution: Solution, category: str) -> list[Piece]:
    return [piece for piece in solution.pieces if piece.category == category]


def off_walls(piece: Piece) -> float:
    """Metres from the back edge of a piece to the nearest wall."""
    out = 0.5 * piece.size.depth
    x = piece.pose.x - out * math.cos(piece.pose.heading)
    y = piece.pose.y - out * math.sin(piece.pose.heading)
    return min(x, y, WIDE - x, DEEP - y)


SHOWCASES = {"category": "showcase", "count": 6}


@pytest.fixture(scope="module")
def foyer() -> Solution:
    planters = {"category": "planter", "count": 4}
    return solve(SHOWCASES, planters, {"category": "sign_totem"}, {"category": "basket_stack"})


def test_all_small_objects_stand_and_the_hall_is_valid(foyer: Solution) -> None:
    counts = [len(of_kind(foyer, kind)) for kind in ("planter", "sign_totem", "basket_stack")]
    assert counts == [4, 1, 1]
    assert not foyer.left_out
    assert sw.check(foyer).valid


def test_planters_stand_at_walls(foyer: Solution) -> None:
    assert max(off_walls(piece) for piece in of_kind(foyer, "planter")) < 0.05


def test_two_planters_frame_the_door_alike() -> None:
    planters = of_kind(solve(SHOWCASES, {"category": "planter", "count": 2}), "planter")
    aside = sorted(piece.pose.x - DOOR for piece in planters)
    assert aside[0] == pytest.approx(-aside[1])
    assert 1.0 < aside[1] < 2.5
    assert all(piece.pose.y < 0.5 for piece in planters)


def test_a_planter_by_itself_does_not_stand_beside_the_door_as_half_a_pair() -> None:
    (planter,) = of_kind(solve(SHOWCASES, {"category": "planter"}), "planter")
    assert off_walls(planter) < 0.05
    assert abs(planter.pose.x - DOOR) > 2.5 or planter.pose.y > 1.0


def test_a_totem_looks_at_who_comes_in_and_stands_off_the_way(foyer: Solution) -> None:
    (totem,) = of_kind(foyer, "sign_totem")
    assert math.sin(totem.pose.heading) == pytest.approx(-1.0)
    assert 1.0 < totem.pose.y < 4.0
    assert abs(totem.pose.x - DOOR) - 0.5 * totem.size.width > 1.0


def test_baskets_stand_at_the_wall_beside_the_door(foyer: Solution) -> None:
    (stack,) = of_kind(foyer, "basket_stack")
    assert off_walls(stack) < 0.05
    assert abs(stack.pose.x - DOOR) < 3.0


def test_stacks_of_baskets_stand_side_by_side() -> None:
    solution = solve(SHOWCASES, {"category": "basket_stack", "count": 3})
    places = sorted(piece.pose.x for piece in of_kind(solution, "basket_stack"))
    wide = of_kind(solution, "basket_stack")[0].size.width
    assert max(b - a for a, b in pairwise(places)) < wide + 0.1


def test_small_objects_with_a_pattern_of_their_own_keep_it() -> None:
    rows = {"category": "planter", "count": 6, "patterns": ["grid"]}
    solution = solve(SHOWCASES, rows)
    patterns = {group.demand: group.pattern for group in solution.detail.layout.groups}
    assert patterns["planter"] == "grid"


def test_small_objects_stand_in_their_zone() -> None:
    outline = [[0, 0], [WIDE, 0], [WIDE, DEEP], [0, DEEP]]
    zones = [
        {"id": "south", "outline": [[0, 0], [WIDE, 0], [WIDE, 5], [0, 5]]},
        {"id": "north", "outline": [[0, 5], [WIDE, 5], [WIDE, DEEP], [0, DEEP]]},
    ]
    demands = [{**SHOWCASES, "zone": "south"}, {"category": "planter", "count": 3, "zone": "north"}]
    room = {"name": "Hall", "outline": outline, "zones": zones, "demands": demands, "height": 4}
    door = {"id": "front", "at": [DOOR, 0], "width": 2.0, "swing": "slide"}
    brief = {"domain": "hall", "name": "Hall", "rooms": [{**room, "doors": [door]}]}
    solution = sw.solve(Brief.model_validate(brief), steps=1500, threads=1)
    assert min(piece.pose.y for piece in of_kind(solution, "planter")) > 5.0
    assert [g.zone for g in solution.detail.layout.groups if g.demand == "planter"] == ["north"]


def test_as_printed_small_objects_are_laid_out_with_the_rest() -> None:
    planters = {"category": "planter", "count": 4}
    solution = solve(SHOWCASES, planters, preset="paper-repaired", steps=200)
    patterns = {group.demand: group.pattern for group in solution.detail.layout.groups}
    assert patterns["planter"] != "single"


STAGE = {"category": "stage", "size": [7, 3, 0.6]}


def test_a_piano_stands_on_the_stage_and_who_plays_sits_on_it_too() -> None:
    solution = solve(STAGE, {"category": "piano"}, {"category": "lectern"})
    (piano,), (stage,) = of_kind(solution, "piano"), of_kind(solution, "stage")
    (lectern,) = of_kind(solution, "lectern")
    assert piano.on == stage.id
    turn = piano.pose.heading - stage.pose.heading
    assert abs(math.sin(turn)) == pytest.approx(1.0)

    def aside(piece: Piece) -> float:
        c, s = math.cos(stage.pose.heading), math.sin(stage.pose.heading)
        return (piece.pose.x - stage.pose.x) * s - (piece.pose.y - stage.pose.y) * c

    assert aside(piano) * aside(lectern) < 0.0
    assert aside(piano) * math.sin(turn) > 0.0
    assert abs(aside(piano)) + 0.5 * piano.size.depth <= 3.5
    assert sw.check(solution).valid


def test_a_piano_without_a_stage_stands_at_a_wall() -> None:
    (piano,) = of_kind(solve(SHOWCASES, {"category": "piano"}), "piano")
    assert off_walls(piano) < 0.05


@pytest.mark.parametrize(("at", "width", "count"), [(2.6, 0.5, 6), (3.2, 0.8, 10), (4.5, 0.5, 16)])
def test_racks_do_not_stand_before_one_another_in_corners(
    at: float, width: float, count: int
) -> None:
    racks = {"category": "coat_rack", "count": count, "size": [width, 0.5, 1.7]}
    door = {"id": "front", "at": [at, 0], "width": 1.6, "swing": "slide"}
    room = {"name": "Hall", "outline": [[0, 0], [9, 0], [9, 7], [0, 7]], "height": 4.0}
    demands = [{"category": "showcase", "count": 3}, racks]
    brief = {"domain": "hall", "rooms": [{**room, "doors": [door], "demands": demands}]}
    found = sw.solve(Brief.model_validate(brief), steps=600, threads=1, seed=1)
    assert len(of_kind(found, "coat_rack")) == count
    report = sw.check(found)
    assert report.valid, report.findings


def test_passages_are_measured_past_what_stands_on_floor_that_objects_have_for_it() -> None:
    """As chairs on the floor of their table: what comes later in the hall counts all the same."""
    tables = {"id": "tables", "category": "reading_table", "count": 2, "zone": "west"}
    shown = {"id": "shown", "category": "showcase", "count": 4, "zone": "east"}
    fitted = posed(two_zones(tables, shown)).fitted
    layout = layout_of(begin_chain(fitted.problem, fitted.start, streams(0, 1)[0]))
    chair = [*layout.boxes[0, :2], 0.0, 0.4, 0.4]
    fence = [10.0, 5.0, 0.0, 9.6, 0.2]
    p, s, _ = measure_among(fitted.problem, layout, np.array([chair]))
    assert lacking(p, s) == 0.0
    p, s, _ = measure_among(fitted.problem, layout, np.array([chair, fence]))
    assert lacking(p, s) > 0.5


def test_a_low_table_that_would_close_a_passage_is_left_out() -> None:
    """Others leave one way between two zones, 3 m wide: a table in its middle narrows it."""
    brief = two_zones({"category": "showcase", "count": 4, "zone": "west"})
    fitted = posed(brief).fitted
    fence = np.array([[10.0, 1.75, 0.0, 3.5, 0.2], [10.0, 8.25, 0.0, 3.5, 0.2]])
    ground = fitted.problem.ground
    ground = ground._replace(obstacles=np.concatenate([ground.obstacles.reshape(-1, 5), fence]))
    problem = fitted.problem._replace(ground=ground)
    layout = layout_of(begin_chain(problem, fitted.start, streams(0, 1)[0]))
    assert layout.lacking == 0.0
    size, none = Size(1.1, 1.6, 0.4), ()
    at = [Pose(10.0, 5.0, 0.0, 0.0), Pose(14.0, 5.0, 0.0, 0.0)]
    tables = tuple(
        Piece(f"t{k}", "coffee_table", "", "hall", pose, size, "", "", none)
        for k, pose in enumerate(at)
    )
    assert [table.id for table in keep_reached(problem, layout, tables)] == ["t1"]


def test_bins_stand_beside_doors_and_machines_not_in_a_row() -> None:
    machines = {"category": "vending_machine", "count": 2}
    solution = solve(SHOWCASES, machines, {"category": "litter_bin", "count": 2})
    bins, sources = of_kind(solution, "litter_bin"), of_kind(solution, "vending_machine")
    assert len(bins) == 2
    assert math.dist(bins[0].pose[:2], bins[1].pose[:2]) > 4.0
    near = [[DOOR, 0.0], *(piece.pose[:2] for piece in sources)]
    assert min(math.dist(piece.pose[:2], at) for at in near for piece in bins) < 2.2
    assert max(off_walls(piece) for piece in bins) < 0.05
    assert sw.check(solution).valid


def test_trees_in_pots_frame_the_door_alike() -> None:
    trees = of_kind(solve(SHOWCASES, {"category": "potted_tree", "count": 2}), "potted_tree")
    aside = sorted(piece.pose.x - DOOR for piece in trees)
    assert aside[0] == pytest.approx(-aside[1])
    assert aside[1] < 2.5


def test_boards_of_a_zone_without_a_way_in_stand_beside_its_islands() -> None:
    outline = [[0, 0], [WIDE, 0], [WIDE, DEEP], [0, DEEP]]
    zones = [
        {"id": "south", "outline": [[0, 0], [WIDE, 0], [WIDE, 4], [0, 4]]},
        {"id": "north", "outline": [[0, 4], [WIDE, 4], [WIDE, DEEP], [0, DEEP]]},
    ]
    cars = {"category": "exhibit_island", "count": 2, "size": [3.5, 1.8, 1.5], "zone": "north"}
    boards = {"category": "sign_totem", "count": 2, "zone": "north"}
    room = {"name": "Hall", "outline": outline, "zones": zones, "demands": [cars, boards]}
    door = {"id": "front", "at": [DOOR, 0], "width": 2.0, "swing": "slide"}
    brief = {"domain": "hall", "name": "Hall", "rooms": [{**room, "doors": [door]}]}
    solution = sw.solve(Brief.model_validate(brief), steps=1500, threads=1)
    islands = of_kind(solution, "exhibit_island")
    beside = [
        [k for k, island in enumerate(islands) if math.dist(island.pose[:2], totem.pose[:2]) < 3.2]
        for totem in of_kind(solution, "sign_totem")
    ]
    assert sorted(beside) == [[0], [1]]


def test_nothing_is_hidden_behind_a_desk() -> None:
    """A desk stands before a wall with room behind it; of eight trees none stands there."""
    desk = {"category": "info_desk", "at": [14.2, 8.0], "heading": math.pi, "size": [1.8, 0.8, 1.1]}
    outline = [[0, 0], [WIDE, 0], [WIDE, DEEP], [0, DEEP]]
    door = {"id": "front", "at": [DOOR, 0], "width": 2.0, "swing": "slide"}
    demands = [SHOWCASES, {"category": "potted_tree", "count": 8}]
    room = {"name": "Hall", "outline": outline, "doors": [door], "height": 4.0}
    room |= {"demands": demands, "fixed": [desk]}
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    trees = of_kind(sw.solve(brief, steps=1500, threads=1), "potted_tree")
    assert len(trees) == 8
    assert not any(tree.pose.x > 14.6 and 7.1 < tree.pose.y < 8.9 for tree in trees)


def test_benches_stand_apart_before_the_pictures_they_look_at() -> None:
    pictures = {"id": "paintings", "category": "wall_exhibit", "count": 14}
    solution = solve(pictures, {"category": "bench", "count": 3})
    benches, hung = of_kind(solution, "bench"), of_kind(solution, "wall_exhibit")
    assert len(benches) == 3
    assert all(min(map(partial(off_sight, bench), hung)) < 0.05 for bench in benches)
    ways = [math.dist(a.pose[:2], b.pose[:2]) for a, b in combinations(benches, 2)]
    assert min(ways) > 3.0
    assert sw.check(solution).valid


def off_sight(bench: Piece, picture: Piece) -> float:
    """How far a bench is from a place 2 to 3 m before a picture that looks at it, metres and
    radians."""
    x, y = bench.pose.x - picture.pose.x, bench.pose.y - picture.pose.y
    c, s = math.cos(picture.pose.heading), math.sin(picture.pose.heading)
    far = x * c + y * s - 0.5 * picture.size.depth
    turned = abs(math.remainder(bench.pose.heading - picture.pose.heading - math.pi, math.tau))
    return abs(y * c - x * s) + max(2.0 - far, far - 3.0, 0.0) + turned


def test_benches_where_no_picture_is_keep_their_rows() -> None:
    solution = solve(SHOWCASES, {"category": "bench", "count": 4})
    assert {g.pattern for g in solution.detail.layout.groups if g.demand == "bench"} != {"single"}


def test_ropes_stand_round_the_exhibit_they_guard() -> None:
    island = {"category": "exhibit_island", "size": [4, 2, 2]}
    solution = solve(island, SHOWCASES, {"category": "rope_barrier", "count": 6})
    ropes, (guarded,) = of_kind(solution, "rope_barrier"), of_kind(solution, "exhibit_island")
    assert len(ropes) == 6
    c, s = math.cos(guarded.pose.heading), math.sin(guarded.pose.heading)
    offs = [(r.pose.x - guarded.pose.x, r.pose.y - guarded.pose.y) for r in ropes]
    ahead, aside = np.array([(x * c + y * s, y * c - x * s) for x, y in offs]).T
    out = np.maximum(np.abs(ahead) - 1.0, np.abs(aside) - 2.0)
    assert (np.abs(out - 1.0) < 0.3).all()
    assert (
        len({(round(x), round(y)) for x, y in zip(np.sign(ahead), np.sign(aside), strict=True)}) > 2
    )
    assert sw.check(solution).valid
