"""Walls under slopes: closed, as high as the ceiling beside them, cut level; lines in plan."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
import shapely

from scenewright.building.ceiling import heights, planes
from scenewright.building.gables import height_at
from scenewright.building.plan import levels, spaces
from scenewright.building.shell import shell
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Part
from scenewright.core.scene import Prism, Scene
from scenewright.drawing import rooms
from scenewright.drawing.slopes import contours
from scenewright.drawing.svg import write_svg
from scenewright.geometry.mesh import volume
from scenewright.render.items import things

ROOM = {
    "name": "Attic",
    "outline": [[0, 0], [6, 0], [6, 4], [0, 4]],
    "height": 2.4,
    "slopes": [
        {"edge": 0, "knee": 0.9, "pitch": 0.7},
        {"edge": 2, "knee": 1.3, "pitch": 0.5},
        {"edge": 0, "knee": 1.8, "pitch": 0.2},
    ],
    "windows": [{"at": [0, 2], "width": 1.2, "sill": 0.8, "height": 1.2}],
    "doors": [{"at": [6, 2], "width": 0.9}],
}


def home(turn: float = 0.0) -> Brief:
    cos, sin = np.cos(turn), np.sin(turn)
    room = dict(ROOM)
    axes = np.array([[cos, sin], [-sin, cos]])
    room["outline"] = (np.array(ROOM["outline"]) @ axes).tolist()
    for kind in ("windows", "doors"):
        room[kind] = [
            opening | {"at": (np.array(opening["at"]) @ axes).tolist()} for opening in ROOM[kind]
        ]
    return Brief.model_validate({"rooms": [room]})


def scene_of(brief: Brief) -> Scene:
    rooms = spaces(brief)
    walls, openings = shell(brief, rooms)
    return Scene("home", levels(brief), rooms, walls, openings, ())


def prisms_of(scene: Scene) -> list[Prism]:
    return [prism for wall in scene.walls for prism in wall.prisms]


def parts_of(scene: Scene, cut: float | None = None) -> list[tuple[str, list[Part]]]:
    found = things(scene, catalog_of([]), cut)
    return [(thing.name, list(thing.parts)) for thing in found if thing.kind == "wall"]


@pytest.mark.parametrize("turn", [0.0, 0.4, 2.0])
def test_walls_are_as_high_as_the_ceiling_beside_them(turn: float) -> None:
    scene = scene_of(home(turn))
    space, prisms = scene.spaces[0], prisms_of(scene)
    rings = [shapely.Polygon(prism.outline, prism.holes) for prism in prisms]
    random = np.random.default_rng(1)
    walls = shapely.union_all(rings)
    points = random.uniform(*np.array(walls.bounds).reshape(2, 2), (3000, 2))
    points = points[shapely.contains_xy(walls.buffer(-0.002), points)]
    solid = shapely.union_all([ring for ring, p in zip(rings, prisms, strict=True) if p.base > 0])
    points = points[~shapely.intersects_xy(solid.buffer(0.01), points)]
    found = np.zeros(len(points))
    for ring, prism in zip(rings, prisms, strict=True):
        inside = shapely.intersects_xy(ring, points)
        top = prism.top if prism.tilt is None else height_at(prism.tilt, points)
        found = np.where(inside & (prism.top > 0.85), np.maximum(found, top), found)
    wanted = heights(points, planes(space), space.height)
    full = found > 0
    assert full.sum() > 200
    assert np.allclose(found[full], wanted[full], atol=1e-6)
    assert {round(float(h), 2) for h in wanted} >= {0.9, 1.3}


@pytest.mark.parametrize("cut", [None, 2.0, 1.1])
def test_walls_are_closed_and_cut_level(cut: float | None) -> None:
    for name, parts in parts_of(scene_of(home(0.3)), cut):
        offset, rows, faces = 0, [], []
        for part in parts:
            rows.append(part.vertices)
            faces.append(part.faces + offset)
            offset += len(part.vertices)
        vertices, triangles = np.vstack(rows), np.vstack(faces)
        assert vertices[:, 2].max() <= (cut or 2.4) + 1e-9
        keys = [tuple(row) for row in np.round(vertices, 6)]
        edges: Counter[tuple] = Counter()
        for face in triangles:
            for a, b in zip(face, np.roll(face, -1), strict=True):
                edges[keys[a], keys[b]] += 1
        assert all(count == edges[b, a] for (a, b), count in edges.items()), name
        assert volume(type("M", (), {"vertices": vertices, "faces": triangles})()) > 0


def test_level_ceilings_leave_walls_as_they_were() -> None:
    brief = home()
    plain = brief.rooms[0].model_copy(update={"slopes": []})
    walls, _ = shell(brief, spaces(brief.model_copy(update={"rooms": [plain]})))
    assert all(prism.tilt is None for wall in walls for prism in wall.prisms)


def test_plans_show_where_the_ceiling_is_one_and_two_metres_high() -> None:
    scene = scene_of(home())
    (low,) = contours(scene.spaces[0], 1.0)
    ys = shapely.get_coordinates(low)[:, 1]
    assert np.allclose(ys, 0.1 / np.tan(0.7))
    lines = [shapely.get_coordinates(part)[:, 1] for part in contours(scene.spaces[0], 2.0)]
    assert sorted(round(float(line[0]), 3) for line in lines) == pytest.approx(
        [max(1.1 / np.tan(0.7), 0.2 / np.tan(0.2)), 4 - 0.7 / np.tan(0.5)], abs=0.002
    )
    text = write_svg(rooms.plan(scene, catalog_of([])))
    assert text.count("2.0 m<") >= 2
    assert text.count("1.0 m<") >= 1
    assert "living area" in text


def test_many_slopes_make_no_more_parts_than_show() -> None:
    """The prisms are the cells of the lowest planes, however many planes lie above these."""
    walls = np.random.default_rng(0)
    slopes = [
        {
            "edge": int(walls.integers(4)),
            "knee": float(walls.uniform(0.3, 2.0)),
            "pitch": float(walls.uniform(0.1, 1.5)),
        }
        for _ in range(20)
    ]
    brief = Brief.model_validate(
        {"rooms": [ROOM | {"height": 10.0, "slopes": slopes, "windows": [], "doors": []}]}
    )
    scene = scene_of(brief)
    assert len(prisms_of(scene)) < 60
    (room,) = scene.spaces
    for prism in prisms_of(scene):
        inside = np.array(shapely.Polygon(prism.outline).representative_point().coords)
        assert prism.tilt is not None
        assert height_at(prism.tilt, inside) == pytest.approx(
            heights(inside, planes(room), room.height)
        )
