"""Scenes for engines: levels of detail, collision meshes, and what an older reader sees of them."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Material, Part, transform_part
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.space import Level
from scenewright.formats.glb import document_of
from scenewright.formats.gltf.handover import END, LOD
from scenewright.geometry.prisms import box
from scenewright.geometry.solids import ball
from scenewright.render.coarse_parts import count_faces, list_coarser, obstacle_of

Document = dict[str, Any]
PIECES = (
    ("building", "villa", Size(14.0, 12.0, 9.0), 0.0),
    ("building", "house_rural_gabled", Size(10.5, 8.5, 7.8), 30.0),
    ("tree", "tree", Size(7.0, 7.0, 9.0), 60.0),
    ("lamp_post", "lamp_post", Size(0.3, 1.4, 6.0), 80.0),
)


@cache
def written(for_engines: bool = True) -> Document:
    """Two houses, a tree and a lamp in a row."""
    pieces = tuple(
        Piece(f"{asset} 1", kind, asset, "", Pose(x, 5.0, 0.0, 0.5), size)
        for kind, asset, size, x in PIECES
    )
    scene = Scene("row", (Level("", "ground", 0.0, 3.0),), (), (), (), pieces)
    return document_of(scene, catalog_of([]), "site", False, for_engines)[0]


def named(name: str) -> Document:
    return next(node for node in written()["nodes"] if node["name"] == name)


def triangles(node: Document) -> int:
    document = written()
    rows = document["meshes"][node["mesh"]]["primitives"]
    return sum(document["accessors"][row["indices"]]["count"] // 3 for row in rows)


def span(node: Document) -> Any:
    """Lengths (3,) of what a node draws, in glTF's axes."""
    document = written()
    rows = [
        document["accessors"][row["attributes"]["POSITION"]]
        for row in document["meshes"][node["mesh"]]["primitives"]
    ]
    return np.max([row["max"] for row in rows], 0) - np.min([row["min"] for row in rows], 0)


def in_tree() -> set[int]:
    nodes, found, left = written()["nodes"], set[int](), [0]
    while left:
        found.add(number := left.pop())
        left += nodes[number].get("children", [])
    return found


@pytest.mark.parametrize("asset", ["villa", "house_rural_gabled", "tree"])
def test_each_form_has_fewer_triangles_and_about_the_size_and_place_of_the_model(
    asset: str,
) -> None:
    node, nodes = named(f"{asset} 1"), written()["nodes"]
    forms = [nodes[number] for number in node["extensions"][LOD]["ids"]]
    assert [form["name"] for form in forms] == [f"{asset} 1_LOD1", f"{asset} 1_LOD2"]
    counts = [triangles(one) for one in (node, *forms)]
    assert counts[0] > 1.25 * counts[1] > 1.5 * counts[2]
    for form in forms:
        assert form["translation"] == node["translation"]
        assert form["rotation"] == node["rotation"]
        np.testing.assert_allclose(span(form), span(node), rtol=0.2)
    assert len(node["extras"]["MSFT_screencoverage"]) == len(forms) + 1
    assert node["extras"]["MSFT_screencoverage"] == sorted(
        node["extras"]["MSFT_screencoverage"], reverse=True
    )


def test_a_reader_that_knows_no_levels_sees_each_model_once() -> None:
    plain, document = written(for_engines=False), written()
    forms = {n for node in document["nodes"] for n in _forms_of(node)}
    assert forms
    assert not forms & in_tree()
    seen = [document["nodes"][k] for k in sorted(in_tree())]
    drawn = [n["name"] for n in seen if "mesh" in n and not n["name"].endswith(END)]
    assert drawn == [n["name"] for n in plain["nodes"] if "mesh" in n]
    assert "extensionsRequired" not in document
    names = [node["name"] for node in document["nodes"]]
    assert len(set(names)) == len(names)


def _forms_of(node: Document) -> list[int]:
    return [*node.get("extensions", {}).get(LOD, {}).get("ids", [])]


def test_collision_meshes_hang_below_a_hidden_node_and_are_what_one_runs_into() -> None:
    nodes = written()["nodes"]
    hidden = next(n for n in nodes if n.get("extras", {}).get("layer") == "collision")
    assert hidden["extensions"] == {"KHR_node_visibility": {"visible": False}}
    below = {nodes[k]["name"] for k in hidden["children"]}
    assert {f"{asset} 1{END}" for _, asset, _, _ in PIECES} <= below
    house, coarse = named(f"villa 1{END}"), named("villa 1_LOD2")
    assert house["mesh"] == coarse["mesh"]
    assert house["translation"] == coarse["translation"]
    stem = span(named(f"tree 1{END}"))
    assert max(stem[0], stem[2]) < 1.0 < stem[1]


def test_a_post_stays_however_thin_and_a_bar_goes() -> None:
    metal = Material("metal", (0.1, 0.1, 0.1))
    post = Part(metal, *box((-0.05, -0.05, 0), (0.05, 0.05, 6)))
    lamp = Part(metal, *ball(0.2, 0.2, 0.2, (0, 0, 6))[:2])
    bars = [
        transform_part(Part(metal, *box((-0.4, 0, 0), (0.4, 0.02, 0.02))), np.eye(3), (0, 0, z))
        for z in np.linspace(1, 5, 30)
    ]
    ((_, near), *_) = list_coarser([post, lamp, *bars])
    assert count_faces(near) <= 12 + 36
    assert max(float(np.ptp(part.vertices[:, 2])) for part in near) >= 6.0


def test_what_hangs_is_no_obstacle() -> None:
    crown = Part(Material("leaf", (0.1, 0.5, 0.1)), *box((-2, -2, 3), (2, 2, 6)))
    assert obstacle_of([crown]) == ()
