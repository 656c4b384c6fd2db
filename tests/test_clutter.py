"""Small objects: where models carry, where they are put, and that they stand."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from scenewright import domains
from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.materials import OAK
from scenewright.clutter.rows import AMOUNTS, ROWS
from scenewright.clutter.stability import keep_standing, measure_standing
from scenewright.clutter.surfaces import CELL, surfaces_of
from scenewright.clutter.tops import to_level, to_local
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError
from scenewright.core.scene import CLUTTER, Piece, Pose, Scene, Size
from scenewright.core.solution import Solution
from scenewright.formats.solution_json import dumps, loads
from scenewright.geometry.mesh import merge
from scenewright.geometry.solids import block
from scenewright.workflow.arrange import arrange


@cache
def solved() -> Solution:
    return arrange("sample:home-child", steps=300, clutter="lived-in").solution


@cache
def scene() -> Scene:
    return domains.scene_of(solved())


def small(of: Scene) -> list[Piece]:
    return [piece for piece in of.pieces if piece.function == CLUTTER]


def boxes(*solids: tuple[tuple[float, float], tuple[float, float], tuple[float, float]]) -> Part:
    return Part(OAK, *merge([block(*one) for one in solids]))


def test_levels_of_a_rack_are_its_boards_with_the_headroom_between() -> None:
    rack = boxes(
        ((-0.4, 0.4), (-0.15, 0.15), (0.0, 0.02)),
        ((-0.4, 0.4), (-0.15, 0.15), (0.5, 0.52)),
        ((-0.4, -0.38), (-0.15, 0.15), (0.02, 0.5)),
    )
    high, low = surfaces_of([rack]).levels
    assert (high.z, low.z) == (0.52, 0.02)
    assert np.isinf(high.headroom[high.free]).all()
    assert np.allclose(low.headroom[low.free], 0.48)
    assert high.free.sum() == 80 * 30
    assert low.free.sum() == 78 * 30, "no cell under the upright carries"


def test_a_shelf_behind_a_door_carries_nothing_and_touching_solids_leave_no_shelf() -> None:
    board, lid = ((-0.3, 0.3), (-0.2, 0.2), (0.0, 0.02)), ((-0.3, 0.3), (-0.2, 0.2), (0.5, 0.52))
    door = ((-0.3, 0.3), (0.18, 0.2), (0.02, 0.5))
    assert [one.z for one in surfaces_of([boxes(board, lid, door)]).levels] == [0.52]
    core = ((-0.3, 0.3), (-0.2, 0.2), (0.02, 0.5))
    assert [one.z for one in surfaces_of([boxes(board, core, lid)]).levels] == [0.52]


def test_cells_are_counted_once_where_triangles_meet() -> None:
    """A plate of 0.2 m² between cell borders: each middle belongs to one triangle alone."""
    level = surfaces_of([boxes(((0, 0.5), (0, 0.4), (0, 0.1)))]).levels[0]
    assert level.free.sum() * CELL**2 == pytest.approx(0.2)


def test_frames_of_pieces_undo_each_other() -> None:
    piece = Piece("a", "desk", "", "room", Pose(1.0, 2.0, 0.0, 0.7), Size(1, 1, 1))
    points = np.array([[0.3, -0.2], [1.0, 4.0]])
    assert np.allclose(to_local(piece, to_level(piece, points)), points)
    assert np.allclose(
        to_level(piece, np.array([[0.0, 1.0]])), [[1 + np.cos(0.7), 2 + np.sin(0.7)]]
    )


def test_every_small_object_stands_on_a_piece_of_its_room() -> None:
    found = small(scene())
    pieces = {piece.id: piece for piece in scene().pieces}
    assert len(found) >= 15
    assert len(pieces) == len(scene().pieces), "ids are unique"
    assert all(pieces[piece.on or ""].space == piece.space for piece in found)
    standing = measure_standing(scene(), shipped())
    assert len(standing) == len(found)
    assert all(one.stable for one in standing)


def test_what_hangs_over_an_edge_is_left_out_with_what_stands_on_it() -> None:
    table = next(p for p in solved().pieces if p.category.endswith("desk"))
    half = table.size.width / 2
    top = max(one.z for one in surfaces_of(shipped().assets[table.asset].mesh(table.size)).levels)

    def book(name: str, x: float, z: float, on: str) -> Piece:
        spot = to_level(table, np.array([[x, 0.0]]))[0]
        pose = Pose(float(spot[0]), float(spot[1]), z, table.pose.heading)
        size = shipped().assets["book"].usual
        return Piece(name, "book", "book", table.space, pose, size, "", CLUTTER, on)

    thick = shipped().assets["book"].usual.height
    safe = book("safe", -half + 0.2, top, table.id)
    over = book("over", half + 0.02, top, table.id)
    upper = book("upper", half + 0.02, top + thick, "over")
    kept = keep_standing(solved().pieces, [safe, over, upper], shipped())
    assert [piece.id for piece in kept] == ["safe"]


def test_small_objects_do_not_run_into_each_other() -> None:
    on = Counter(piece.on for piece in small(scene()))
    for carrier, count in on.items():
        found = [p for p in small(scene()) if p.on == carrier and p.category != "cushion"]
        if count < 2:
            continue
        for k, a in enumerate(found):
            for b in found[k + 1 :]:
                apart = np.hypot(a.pose.x - b.pose.x, a.pose.y - b.pose.y)
                level = abs(a.pose.z - b.pose.z) < 0.01
                least = (min(a.size[:2]) + min(b.size[:2])) / 2
                assert not level or apart >= least - 1e-9, f"{a.id} and {b.id}"


def test_none_is_as_without_and_amounts_rise() -> None:
    plain = replace(solved(), clutter="none")
    assert "clutter" not in dumps(plain).replace('"function": "clutter"', "")
    counts = [len(small(domains.scene_of(replace(plain, clutter=amount)))) for amount in AMOUNTS]
    assert counts[0] == 0
    assert counts == sorted(counts)
    assert counts[1] < counts[2]


def test_the_amount_is_saved_and_the_same_seed_gives_the_same_scene() -> None:
    again = loads(dumps(solved()))
    assert again.clutter == "lived-in"
    assert small(domains.scene_of(again)) == small(scene())
    other = domains.scene_of(replace(solved(), seed=5))
    assert [p.pose for p in small(other)] != [p.pose for p in small(scene())]


def test_what_stands_on_a_piece_comes_along_with_it() -> None:
    found = small(scene())
    carrier = next(p for p in solved().pieces if any(s.on == p.id for s in found))
    moved = replace(carrier, pose=carrier.pose._replace(x=carrier.pose.x + 0.002))
    pieces = tuple(moved if p is carrier else p for p in solved().pieces)
    after = {p.id: p for p in small(domains.scene_of(replace(solved(), pieces=pieces)))}
    for before in (p for p in found if p.on == carrier.id):
        assert after[before.id].pose.x == pytest.approx(before.pose.x + 0.002, abs=1e-6)


def test_rows_name_kinds_there_are_and_nothing_one_must_keep_free() -> None:
    kinds = shipped().kinds
    for row in ROWS:
        assert row.what in kinds
        assert kinds[row.what].support == "top"
        assert not set(row.on) - kinds.keys(), row
        assert not {"hob_cabinet", "dining_chair", "office_chair", "stool"} & set(row.on)
        assert row.some <= row.lived


def test_an_unknown_amount_is_refused_by_name() -> None:
    with pytest.raises(
        InputError, match="unknown clutter 'lots'; use one of: none, some, lived-in"
    ):
        arrange("sample:home-room", steps=10, clutter="lots")
