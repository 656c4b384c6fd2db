"""What makes a GLB file a scene: few draws with all names, ceilings, lights, cameras, one sheet."""

from __future__ import annotations

import io
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
import shapely
from PIL import Image

from scenewright import read
from scenewright.catalog.loading import catalog_of
from scenewright.catalog.models.gltf import open_scene, scene_bodies
from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.solution import Solution
from scenewright.domains import scene_of, solve
from scenewright.formats.glb import document_of, encode_scene
from scenewright.formats.gltf.cameras import EYE
from scenewright.formats.gltf.sheet import draw_sheet, keep_textures, lay_out, places_on
from scenewright.formats.gltf.surfaces import QUANTISED
from scenewright.geometry.prisms import box
from scenewright.render.colour import linear_of
from scenewright.render.items import things
from scenewright.render.light_rows import LUX
from scenewright.render.public_rooms import GREEN, fittings
from test_glb import node_id, numbers

Document = dict[str, Any]
INSTANCING = "EXT_mesh_gpu_instancing"


@cache
def solved(sample: str) -> tuple[Solution, Scene]:
    solution = solve(read(f"sample:{sample}"), steps=50)
    return solution, scene_of(solution)


@cache
def written(sample: str, batched: bool = True) -> tuple[Document, bytes]:
    solution, scene = solved(sample)
    catalog = catalog_of(solution.brief.catalogs)
    return document_of(scene, catalog, solution.brief.domain, batched)


def no_file(_name: str, _most: int) -> None:
    """Nothing lies beside a GLB file."""


def draws_of(document: Document) -> int:
    """Primitives by the nodes that draw them."""
    meshes = document["meshes"]
    return sum(len(meshes[n["mesh"]]["primitives"]) for n in document["nodes"] if "mesh" in n)


@pytest.mark.parametrize(("sample", "share"), [("site-courtyards", 0.5), ("hall-shop", 0.8)])
def test_many_equal_pieces_are_drawn_at_once_and_keep_their_names_and_places(
    sample: str, share: float
) -> None:
    document, buffer = written(sample)
    apart, _ = written(sample, batched=False)
    assert draws_of(document) <= min(150, share * draws_of(apart))
    assert {node_id(n) for n in apart["nodes"]} <= {node_id(n) for n in document["nodes"]}
    assert document["extensionsRequired"] == [INSTANCING, QUANTISED]
    assert "extensionsRequired" not in apart
    for node in document["nodes"]:
        if INSTANCING in node.get("extensions", {}):
            rows = node["extensions"][INSTANCING]["attributes"]
            places = numbers(document, buffer, rows["TRANSLATION"])
            turns = numbers(document, buffer, rows["ROTATION"])
            assert len(places) == len(turns) == node["extras"]["instances"] >= 2
            named = [
                n["translation"]
                for n in document["nodes"]
                if "mesh" not in n and n.get("extras", {}).get("asset") == node["extras"]["asset"]
            ]
            for place in places:
                assert np.abs(np.array(named) - place).sum(1).min() < 1e-4


def test_textures_as_webp_are_half_as_large_and_nothing_else_changes() -> None:
    solution, scene = solved("home-room")
    catalog = catalog_of(solution.brief.catalogs)
    usual, buffer = document_of(scene, catalog)
    small, packed = document_of(scene, catalog, webp=True)
    assert "EXT_texture_webp" in small["extensionsRequired"]
    assert [image["name"] for image in small["images"]] == [i["name"] for i in usual["images"]]
    first = usual["bufferViews"][usual["images"][0]["bufferView"]]["byteOffset"]
    assert packed[:first] == buffer[:first]
    assert len(packed) - first < 0.7 * (len(buffer) - first)
    for texture in small["textures"]:
        image = small["images"][texture["extensions"]["EXT_texture_webp"]["source"]]
        view = small["bufferViews"][image["bufferView"]]
        content = packed[view["byteOffset"] :][: view["byteLength"]]
        assert (content[:4], content[8:12]) == (b"RIFF", b"WEBP")


def test_our_own_reader_finds_the_same_triangles_in_instances_and_apart() -> None:
    solution, scene = solved("hall-shop")
    catalog = catalog_of(solution.brief.catalogs)
    bounds, areas = [], []
    for batched in (True, False):
        content = encode_scene(scene, catalog, "hall", batched)
        parts = [p for b in scene_bodies(open_scene(content, no_file)) for p in b.parts]
        points = np.vstack([part.vertices for part in parts])
        bounds.append((points.min(0), points.max(0)))
        corners = [part.vertices[part.faces] for part in parts]
        sides = np.vstack([np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]) for c in corners])
        areas.append(np.linalg.norm(sides, axis=1).sum())
    assert np.allclose(bounds[0], bounds[1], atol=1e-4)
    assert areas[0] == pytest.approx(areas[1], rel=1e-4)


def test_ceilings_look_down_and_are_one_layer_with_a_node_a_room() -> None:
    document, buffer = written("home-house")
    _, scene = solved("home-house")
    layers = [n for n in document["nodes"] if n.get("extras", {}).get("layer") == "ceilings"]
    assert len(layers) == len(scene.levels)
    for layer, level in zip(layers, scene.levels, strict=True):
        below = {node_id(document["nodes"][k]) for k in layer["children"]}
        rooms = {s.id for s in scene.spaces if s.level == level.id and "balcony" not in s.functions}
        assert below == {f"{room} ceiling" for room in rooms}
        (primitive,) = document["meshes"][layer["mesh"]]["primitives"]
        points = numbers(document, buffer, primitive["attributes"]["POSITION"])
        rows = numbers(document, buffer, primitive["indices"]).reshape(-1, 3)
        a, b, c = (points[rows[:, k]] for k in range(3))
        assert (np.cross(b - a, c - a)[:, 1] < 0).all()
    assert not [n for n in written("site-courtyards")[0]["nodes"] if "ceiling" in n["name"]]


def test_every_room_has_a_camera_in_it_and_two_see_the_whole() -> None:
    document, _ = written("home-house")
    _, scene = solved("home-house")
    nodes = {node_id(n): n for n in document["nodes"]}
    for space in scene.spaces:
        node = nodes.get(f"camera {space.id}")
        if node is not None:
            x, y, z = node["translation"]
            assert y == EYE
            assert shapely.Polygon(space.outline).contains(shapely.Point(x, -z))
            assert document["cameras"][node["camera"]]["perspective"]["yfov"] < 1.2
    assert sum(f"camera {space.id}" in nodes for space in scene.spaces) >= len(scene.spaces) - 2
    corners = [(*p, z) for s in scene.spaces for p in s.outline.tolist() for z in (0.0, s.height)]
    for name, kind in (("camera dollhouse", "perspective"), ("camera plan", "orthographic")):
        node = nodes[name]
        camera = document["cameras"][node["camera"]]
        assert camera["type"] == kind
        seen = _seen_from(node, np.array(corners))
        if kind == "perspective":
            high = np.tan(camera[kind]["yfov"] / 2) * -seen[:, 2]
            wide = high * camera[kind]["aspectRatio"]
        else:
            high, wide = camera[kind]["ymag"], camera[kind]["xmag"]
        assert (np.abs(seen[:, 1]) < high).all()
        assert (np.abs(seen[:, 0]) < wide).all()
        assert max((np.abs(seen[:, 0]) / wide).max(), (np.abs(seen[:, 1]) / high).max()) > 0.8


def _seen_from(node: Document, points: np.ndarray) -> np.ndarray:
    """Points (n, 3), z up, in the frame of a camera."""
    x, y, z, w = node["rotation"]
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    return (points[:, [0, 2, 1]] * [1, 1, -1] - node["translation"]) @ turn


def test_a_large_hall_without_lamps_has_rows_of_lights_of_its_illuminance() -> None:
    document, _ = written("hall-shop")
    _, scene = solved("hall-shop")
    lights = document["extensions"]["KHR_lights_punctual"]["lights"]
    held = [n for n in document["nodes"] if "light row light" in n["name"]]
    assert 4 <= len(held) <= 12
    total = 0.0
    for node in held:
        light = lights[node["extensions"]["KHR_lights_punctual"]["light"]]
        total += (
            light["intensity"] * float(np.dot([0.2126, 0.7152, 0.0722], light["color"])) * np.pi
        )
    area = shapely.Polygon(scene.spaces[0].outline).area
    assert total / area == pytest.approx(LUX, rel=0.01)
    assert any(n["name"].startswith("light rows of") and "mesh" in n for n in document["nodes"])


def test_rooms_of_the_public_have_signs_at_their_exits_and_homes_have_none() -> None:
    document, _ = written("hall-shop")
    _, scene = solved("hall-shop")
    green = next(p for item in fittings(scene) for p in item.parts if p.material == GREEN)
    exits = [o for o in scene.openings if o.kind == "door" and o.use != "entrance"]
    for sign in np.split(green.vertices, len(green.vertices) // 8):
        middle = sign.mean(0)
        near = min(exits, key=lambda o: np.hypot(o.x - middle[0], o.y - middle[1]))
        assert np.hypot(near.x - middle[0], near.y - middle[1]) < near.thickness
        assert near.head < sign[:, 2].min() < sign[:, 2].max() < scene.spaces[0].height
    assert any(n["name"].startswith("signs of") and "mesh" in n for n in document["nodes"])
    assert not [*fittings(solved("home-house")[1]), *fittings(solved("site-courtyards")[1])]


def test_no_skirting_stands_in_a_door() -> None:
    document, buffer = written("home-house", batched=False)
    _, scene = solved("home-house")
    boards = [n for n in document["nodes"] if n.get("extras", {}).get("category") == "skirting"]
    assert len([n for n in boards if "mesh" in n]) >= 8
    doors = [o for o in scene.openings if o.kind == "door"]
    for node in (n for n in boards if "mesh" in n):
        (primitive,) = document["meshes"][node["mesh"]]["primitives"]
        points = numbers(document, buffer, primitive["attributes"]["POSITION"])
        assert points[:, 1].max() < 0.1
        for door in doors:
            if node["extras"]["space"] in door.spaces:
                along = np.array([door.ux, door.uy])
                away = np.column_stack([points[:, 0], -points[:, 2]]) - (door.x, door.y)
                inside = (np.abs(away @ along) < door.width / 2 - 0.01) & (
                    np.abs(away @ [-along[1], along[0]]) < door.thickness / 2 + 0.1
                )
                assert not inside.any()


def test_the_sheet_holds_every_colour_where_its_faces_look_it_up() -> None:
    cube = box((0, 0, 0), (0.4, 0.3, 0.2))
    materials = [
        Material(f"paint {k}", (k / 40, 1 - k / 40, (k % 7) / 7), k / 40, k % 2) for k in range(40)
    ]
    glowing = Material("glow", (1.0, 0.9, 0.8), 0.5, 0.0, 1.0, 0.8)
    parts = [Part(one, *cube) for one in (*materials, glowing, Material("oak", (0.7, 0.5, 0.3)))]
    sheet = lay_out(parts)
    drawn = draw_sheet(sheet)
    color, surface, glow = (
        np.asarray(Image.open(io.BytesIO(content)).convert("RGB"), float) / 255 for content in drawn
    )
    for part in parts:
        places = places_on(sheet, part)
        high, wide = color.shape[:2]
        rows, columns = (places[..., 1] * high).astype(int), (places[..., 0] * wide).astype(int)
        seen = linear_of(color[rows.clip(0, high - 1), columns % wide])
        expected = linear_of(np.array(part.material.color))
        if part.material.name != "oak":
            assert np.abs(seen - expected).max() < 0.03
            assert surface[rows // 16, columns // 16 % 64, 1].max() == pytest.approx(
                part.material.roughness, abs=0.003
            )
            assert surface[rows // 16, columns // 16 % 64, 2].max() == part.material.metallic
        else:
            band = linear_of(color[rows.min() : rows.max()]).mean((0, 1))
            assert np.abs(band - expected).max() < 0.02
        shines = linear_of(glow[rows // 16, columns // 16 % 64]).max()
        assert (shines > 0.5) == (part.material.name == "glow")


def test_boards_keep_within_their_band_and_along_it_are_in_metres() -> None:
    parts = [
        Part(Material(name, (0.7, 0.5, 0.3)), *box((0, 0, 0), (3.0, wide, 0.02)))
        for name, wide in (("oak", 0.3), ("walnut", 0.9))
    ]
    sheet = lay_out(parts)
    for number, part in enumerate(parts):
        places = places_on(sheet, part)
        rows = places[..., 1] * sheet.height
        assert rows.min() >= 288 * number + 16 - 1e-9
        assert rows.max() <= 288 * number + 272 + 1e-9
        assert np.ptp(places[..., 0], axis=1).max() == pytest.approx(3.0 / 2.0)


def test_a_book_in_cloth_is_no_reason_for_another_draw() -> None:
    shelf = Part(Material("oak", (1, 1, 1)), *box((0, 0, 0), (1, 0.3, 2)))
    books = Part(Material("navy fabric", (0, 0, 1)), *box((0, 0, 0), (0.8, 0.15, 0.2)))
    seat = Part(Material("navy fabric", (0, 0, 1)), *box((0, 0, 0), (2, 0.9, 0.4)))
    pane = Part(Material("glass", (1, 1, 1), opacity=0.3), *box((0, 0, 0), (0.1, 0.01, 0.1)))
    assert keep_textures([shelf, books, pane]) == [False, False, True]
    assert keep_textures([shelf, seat]) == [False, True]


def test_pieces_say_how_large_they_are_and_the_root_what_it_is() -> None:
    document, _ = written("hall-shop")
    _, scene = solved("hall-shop")
    nodes = {node_id(n): n for n in document["nodes"]}
    assert document["nodes"][0]["extras"]["category"] == "hall"
    for piece in scene.pieces:
        extras = nodes[piece.id]["extras"]
        assert extras["dimensions"] == pytest.approx(list(piece.size), abs=1e-3)
        assert {"category", "space", "licence"} <= set(extras)
    assert len(things(scene, catalog_of([]))) < len(nodes)


def test_small_things_of_a_room_are_drawn_as_one_where_they_lie() -> None:
    _, scene = solved("home-house")
    room = scene.spaces[0]
    spot = shapely.Polygon(room.outline).representative_point()
    things_here = tuple(
        Piece(
            f"{room.id}/bowl-{k}",
            "bowl",
            "",
            room.id,
            Pose(spot.x + 0.02 * k, spot.y, 0.4, 0.3 * k),
            Size(0.2 + 0.01 * k, 0.2 + 0.01 * k, 0.1),
        )
        for k in range(9)
    )
    one = replace(scene, pieces=things_here)
    document, buffer = document_of(one, catalog_of([]))
    nodes = {node_id(n): n for n in document["nodes"]}
    whole = nodes[f"small things of {room.id}"]
    assert whole["extras"]["holds"] == 9
    assert not [n for p in things_here for n in (nodes[p.id],) if "mesh" in n]
    rows = document["meshes"][whole["mesh"]]["primitives"]
    points = np.vstack([numbers(document, buffer, r["attributes"]["POSITION"]) for r in rows])
    assert points[:, 1].min() == pytest.approx(0.4, abs=1e-5)
    assert points[:, 0].min() == pytest.approx(spot.x - 0.1, abs=0.02)
    assert points[:, 0].max() == pytest.approx(spot.x + 0.16 + 0.14, abs=0.02)
    few = replace(scene, pieces=things_here[:1])
    assert (
        "mesh"
        in {node_id(n): n for n in document_of(few, catalog_of([]))[0]["nodes"]}[things_here[0].id]
    )
