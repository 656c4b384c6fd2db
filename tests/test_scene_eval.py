"""Scene states of SceneEval: the keys its loader reads, and objects and walls where ours are."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from flat import flat_solution
from scenewright import cli
from scenewright.core.layout import corners
from scenewright.domains import scene_of
from scenewright.formats import write
from test_procthor import breaches

POINT = [float]
AXES = {"up": [float], "front": [float]}
CONTRACT: dict[str, Any] = {
    "format": str,
    "scene": {
        "version": str,
        "id": str,
        "unit": float,
        "assetSource": [str],
        **AXES,
        "arch": {
            "version": str,
            "id": str,
            "coords2d": [int],
            "scaleToMeters": float,
            "defaults": {"Wall": {"depth": float}, "Floor": {"depth": float}},
            "elements": [
                {
                    "id": int,
                    "type": str,
                    "roomId": str,
                    "points": [POINT],
                    "depth": float,
                    "materials": list,
                }
            ],
            "regions": [{"id": str, "type": str, "walls": [int]}],
            **AXES,
        },
        "object": [
            {
                "id": str,
                "index": int,
                "modelId": str,
                "parentId": str,
                "parentIndex": int,
                "transform": {
                    "rows": int,
                    "cols": int,
                    "data": [float],
                    "rotation": [float],
                    "translation": [float],
                    "scale": [float],
                },
            }
        ],
    },
}
"""What SceneEval's ``SceneState``, ``Architecture`` and ``Obj`` read."""


@pytest.fixture(scope="module")
def state(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    path = tmp_path_factory.mktemp("state") / "flat.sceneeval.json"
    write(flat_solution(), path)
    return dict(json.loads(path.read_text("utf-8")))


def test_the_state_is_what_the_loader_reads(state: dict[str, Any]) -> None:
    assert breaches(CONTRACT, state) == []
    assert state["format"] == "sceneState"
    assert state["scene"]["version"] == "scene@1.0.2"
    assert state["scene"]["arch"]["version"] == "arch@1.0.2"
    elements = state["scene"]["arch"]["elements"]
    assert {element["type"] for element in elements} == {"Floor", "Ceiling", "Wall"}
    assert [element["id"] for element in elements] == [*range(len(elements))]
    assert breaches(CONTRACT, state | {"scene": {}})


def test_objects_stand_where_our_pieces_stand(state: dict[str, Any]) -> None:
    """The corners of a box in the model's frame, y up and z to the front, moved by the matrix."""
    rows = {row["id"]: row for row in state["scene"]["object"]}
    pieces = flat_solution().pieces
    assert rows.keys() == {piece.id for piece in pieces}
    for piece in pieces:
        matrix = np.array(rows[piece.id]["transform"]["data"]).reshape(4, 4).T
        w, d, h = piece.size
        x, y, z, heading = piece.pose
        box = np.array(
            [(a * w / 2, b * h, c * d / 2, 1) for a in (-1, 1) for b in (0, 1) for c in (-1, 1)]
        )
        moved = (matrix @ box.T).T[:, :3]
        plan = shapely.Polygon(corners(np.array([x, y, heading, w, d])))
        hull = shapely.MultiPoint(moved[:, :2]).convex_hull
        assert hull.symmetric_difference(plan).area < 1e-6
        assert (moved[:, 2].min(), moved[:, 2].max()) == pytest.approx((z, z + h))
        front = matrix[:3, :3] @ (0, 0, 1)
        assert front == pytest.approx((np.cos(heading), np.sin(heading), 0), abs=1e-9)
        assert np.linalg.det(matrix[:3, :3]) == pytest.approx(1.0)


def test_quaternions_say_the_same_as_matrices(state: dict[str, Any]) -> None:
    for row in state["scene"]["object"]:
        matrix = np.array(row["transform"]["data"]).reshape(4, 4).T
        x, y, z, w = row["transform"]["rotation"]
        turn = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        assert np.allclose(turn, matrix[:3, :3], atol=1e-6)
        assert row["transform"]["translation"] == matrix[:3, 3].tolist()


def test_walls_enclose_rooms_and_openings_are_holes_in_them(state: dict[str, Any]) -> None:
    scene = scene_of(flat_solution())
    arch = state["scene"]["arch"]
    for space in scene.spaces:
        floor = shapely.Polygon(space.outline)
        walls = [e for e in arch["elements"] if e["type"] == "Wall" and e["roomId"] == space.id]
        assert [r["walls"] for r in arch["regions"] if r["id"] == space.id] == [
            [wall["id"] for wall in walls]
        ]
        length = 0.0
        for wall in walls:
            start, end = (np.array(point[:2]) for point in wall["points"])
            way = end - start
            length += float(np.linalg.norm(way))
            left = np.array([-way[1], way[0]]) / np.linalg.norm(way)
            assert floor.contains(shapely.Point((start + end) / 2 + 0.01 * left))
        assert length == pytest.approx(floor.length, abs=0.01)
    holes = {hole["id"]: hole for e in arch["elements"] for hole in e.get("holes", [])}
    assert holes.keys() == {one.id for one in scene.openings}
    for one in scene.openings:
        low, high = holes[one.id]["box"]["min"], holes[one.id]["box"]["max"]
        assert (high[0] - low[0], low[1], high[1]) == pytest.approx((one.width, one.sill, one.head))
        assert holes[one.id]["type"] == ("Window" if one.kind == "window" else "Door")


def test_a_village_has_no_rooms(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = str(tmp_path / "a.sceneeval.json")
    assert cli.run(["arrange", "sample:village-hamlet", "-o", target]) == 2
    assert "a village has no rooms" in capsys.readouterr().err
