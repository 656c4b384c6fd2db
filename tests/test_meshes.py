"""Models against models: depth of solids in each other, what opens, what closed means."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from scenewright.catalog.assets import shipped
from scenewright.check.meshes import DEPTH, DrawnPiece, Moving, find_meetings, find_stops, position
from scenewright.check.solids import (
    Solid,
    distance,
    is_closed,
    penetration_depth,
    solids_of,
    winding,
)
from scenewright.cli.commands import run
from scenewright.core.scene import Piece, Pose, Size
from scenewright.formats import solution_json
from scenewright.geometry.mesh import Mesh, merge, rotate_mesh, translate_mesh
from scenewright.geometry.solids import ball, block, disc, pipe
from scenewright.workflow.arrange import arrange
from scenewright.workflow.meshes import check_meshes, draw_pieces

CUBE = block((0, 1), (0, 1), (0, 1))


def solid(mesh: Mesh) -> Solid:
    return Solid(mesh.vertices, mesh.faces)


def drawn(
    name: str, *meshes: Mesh, category: str = "sideboard", on: str | None = None
) -> DrawnPiece:
    piece = Piece(name, category, "", "room", Pose(0, 0, 0, 0), Size(1, 1, 1), on=on)
    return DrawnPiece(piece, "0", tuple(map(solid, meshes)))


@pytest.mark.parametrize("shift", [0.3, 0.004, 0.0])
def test_depth_of_boxes_is_the_shortest_move_that_parts_them(shift: float) -> None:
    moved = translate_mesh(CUBE, 1 - shift, 0.2, 0.1)
    depth = penetration_depth(solid(CUBE), solid(moved), DEPTH)
    assert depth == pytest.approx(shift if shift > DEPTH else 0.0, abs=1e-9)


def test_turned_boxes_are_parted_along_the_edges_that_meet() -> None:
    turned = rotate_mesh(block((-0.5, 0.5), (-0.5, 0.5), (0, 1)), "z", pi / 4)
    touching = translate_mesh(turned, 1 + np.sqrt(0.5) - 0.02, 0.5, 0)
    assert penetration_depth(solid(CUBE), solid(touching), DEPTH) == pytest.approx(0.02)
    corner = translate_mesh(turned, 1.48, 1.48, 0)
    assert penetration_depth(solid(CUBE), solid(corner), DEPTH) == 0.0, "boxes share, solids do not"


def test_what_stands_in_a_hollow_is_not_in_the_solid() -> None:
    vessel, rod = pipe(0.5, 0.4, (0, 1)), disc(0.1, (0.1, 0.9))
    assert not solid(vessel).convex
    assert penetration_depth(solid(vessel), solid(rod), DEPTH) == 0.0
    within = translate_mesh(rod, 0.45)
    depth = penetration_depth(solid(vessel), solid(within), DEPTH)
    assert depth == pytest.approx(0.048, abs=0.006), "the middle of a wall 0.1 thick"


def test_winding_and_distance_agree_with_a_ball() -> None:
    sphere = solid(ball(1, 1, 1, (0, 0, 0), 48, 24))
    rng = np.random.default_rng(0)
    points = rng.uniform(-1.2, 1.2, (200, 3))
    radius = np.linalg.norm(points, axis=1)
    clear = np.abs(radius - 1) > 0.02
    assert ((winding(points, sphere.corners) > 0.5) == (radius < 1))[clear].all()
    assert np.allclose(distance(points, sphere.corners), np.abs(radius - 1), atol=0.01)


def test_a_mesh_is_taken_apart_and_known_to_be_closed_or_not() -> None:
    both = merge([CUBE, translate_mesh(CUBE, 3)])
    pieces = list(solids_of(both.vertices, both.faces))
    assert [len(one.faces) for one in pieces] == [12, 12]
    assert is_closed(both.vertices, both.faces)
    assert not is_closed(both.vertices, both.faces[:-1])
    assert not is_closed(CUBE.vertices, np.concatenate([CUBE.faces[:-1], CUBE.faces[-1:, ::-1]]))


def test_pairs_are_found_but_for_what_gives_way() -> None:
    case, other = block((0, 1), (0, 1), (0, 1)), block((0.9, 2), (0, 1), (0, 1))
    found = find_meetings(
        [drawn("a", case), drawn("b", other), drawn("far", translate_mesh(case, 5))]
    )
    assert [(one.first, one.second) for one in found] == [(0, 1)]
    assert found[0].depth == pytest.approx(0.1)
    assert not find_meetings([drawn("a", case), drawn("b", other, category="curtain")])
    cushion = drawn("b", block((0.95, 2), (0, 1), (0, 1)), category="cushion", on="a")
    assert not find_meetings([drawn("a", case), cushion])


def test_a_door_opens_until_it_meets_something_that_stands() -> None:
    leaf = block((0, 0.6), (0, 0.02), (0, 1))
    axis, pivot = np.array([0.0, 0.0, 1.0]), np.zeros(3)
    door = Moving("door 1", "hinge", pivot, axis, pi / 2, (solid(leaf),))
    case = drawn("case", block((0, 0.6), (-0.5, 0), (0, 1)), leaf)._replace(moving=(door,))
    turn, shift = position(door, pi / 2)
    assert np.allclose(turn @ (0.6, 0, 0) + shift, (0, 0.6, 0))
    assert not find_stops([case])
    post = block((0.3, 0.35), (0.3, 0.35), (0, 1))
    (stop,) = find_stops([case, drawn("post", post)])
    assert (stop.body, stop.other) == ("door 1", 1)
    assert stop.free * 90 == pytest.approx(38, abs=5), "it lies 41 to 49 degrees round"
    assert not find_stops([case, drawn("chair", post, category="dining_chair")])
    assert not find_stops([case, drawn("high", translate_mesh(post, 0, 0, 1.1))])


def test_every_table_has_room_for_the_chairs_of_its_groups() -> None:
    """Chairs pushed in 0.2 m beside the corners and at the middle of each end, in every style."""
    catalog, chair = shipped(), shipped().assets["dining_chair"]
    tables = [asset for asset in catalog.of("dining_table") if not asset.called]
    size, seat = Size(1.2, 0.75, 0.74), Size(0.46, 0.5, 0.85)
    for asset in tables:
        name = ("t", "dining_table", asset.id, "room", Pose(0, 0, 0, pi / 2), size)
        pieces = [Piece(*name)]
        spots = [(0.3, 0.425, -pi / 2), (-0.3, 0.425, -pi / 2), (0.65, 0.0, pi)]
        pieces += [
            Piece(f"c{k}", "dining_chair", chair.id, "room", Pose(x, y, 0, turn), seat)
            for k, (x, y, turn) in enumerate(spots)
        ]
        scene = replace(solved_scene(), pieces=tuple(pieces))
        shapes, _ = draw_pieces(scene, catalog)
        found = [one for one in find_meetings(shapes) if one.first == 0]
        assert not found, f"{asset.id}: {found}"


def solved_scene():
    from scenewright.domains import scene_of

    return scene_of(arrange("sample:home-room", steps=50).solution)


def test_a_home_has_no_models_in_each_other_and_closed_meshes(tmp_path, capsys) -> None:
    solution = arrange("sample:home-child", steps=300).solution
    report = check_meshes(solution, clutter="some")
    assert report.findings == ()
    assert report.open == ()
    assert report.bodies
    desk = next(p for p in solution.pieces if p.category == "kids_desk")
    twin = replace(desk, id="twin", pose=desk.pose._replace(z=0.1))
    worse = check_meshes(replace(solution, pieces=(*solution.pieces, twin)))
    assert {(one.piece, one.other) for one in worse.findings} >= {(desk.id, "twin")}
    path = tmp_path / "home.json"
    solution_json.write(solution, path)
    run(["check", str(path), "--meshes", "--json"])
    assert '"meshes"' in capsys.readouterr().out
