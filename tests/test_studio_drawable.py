"""What the page draws from: changes of a state, symbols and meshes by key, and how little it is."""

from __future__ import annotations

import gzip
import json
import random
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import scenewright as sw
from scenewright.catalog.loading import catalog_of
from scenewright.core.solution import Solution
from scenewright.domains import scene_of

pytest.importorskip("starlette")
from starlette.testclient import TestClient

from scenewright.studio.delta import follow_change, tell_change
from scenewright.studio.guard import Keys, guarded
from scenewright.studio.server import Listeners, studio_app
from scenewright.studio.session import Session
from scenewright.studio.shapes import Shapes
from scenewright.studio.solid import tell_solid
from scenewright.workflow import project

PORT = 8420
HOME = f"http://127.0.0.1:{PORT}"


@pytest.fixture(scope="module")
def room() -> Solution:
    return sw.solve(sw.read("sample:home-room"), steps=300)


@pytest.fixture
def client(room: Solution, tmp_path: Path) -> Iterator[TestClient]:
    from scenewright.formats import solution_json

    db = project.open_project(tmp_path / "room.studio")
    project.add_version(db, 0, "arranged", solution_json.dumps(room))
    keys = Keys(PORT)
    session = Session(db, lambda _event: None)
    client = TestClient(guarded(studio_app(session, Listeners(), tmp_path), keys), base_url=HOME)
    client.get(f"/?token={keys.token}")
    yield client
    db.close()


def any_value(rng: random.Random, depth: int) -> Any:
    """JSON of every sort, with rows that have ids and rows that have none."""
    if not depth:
        return rng.choice([1, 2.5, "a", None, True, [], [1, 2]])
    kind = rng.randrange(3)
    if kind == 0:
        return {name: any_value(rng, depth - 1) for name in rng.sample("abcd", 2)}
    if kind == 1:
        ids = rng.sample(range(9), rng.randrange(6))
        return [{"id": str(one), "x": any_value(rng, depth - 1)} for one in ids]
    return [any_value(rng, depth - 1) for _ in range(rng.randrange(5))]


def test_of_any_two_states_the_change_leads_from_one_to_the_other() -> None:
    rng = random.Random(5)
    states = [any_value(rng, 3) for _ in range(120)]
    for one, other in pairwise(states):
        told = tell_change(one, other)
        assert follow_change(one, json.loads(json.dumps(told))) == other
        assert len(json.dumps(told)) < len(json.dumps(other)) + 100


def test_homes_of_two_palettes_share_every_mesh(room: Solution) -> None:
    told, scene = [], scene_of(room)
    for palette in ("retro/teal", "nordic/fjord"):
        shapes = Shapes()
        solid = tell_solid(replace(scene, palette=palette), catalog_of(room.brief.catalogs), shapes)
        told.append((solid, {key: shapes.mesh(key) for key, _ in solid["models"]}))
    (one, meshes), (other, same) = told
    assert meshes == same
    assert [m["color"] for m in one["materials"]] != [m["color"] for m in other["materials"]]


def test_meshes_are_what_the_scene_is_made_of(room: Solution) -> None:
    """Decoded as the page does it, everything has its corners where its model has them."""
    shapes = Shapes()
    scene = scene_of(room)
    solid = tell_solid(scene, catalog_of(room.brief.catalogs), shapes)
    boxes = {piece.id: piece for piece in scene.pieces}
    seen = 0
    for name, kind, _level, model, *place in solid["things"]:
        if kind != "piece" or boxes[name].footprint:
            continue
        points = decode(shapes.mesh(solid["models"][model][0]))
        size = boxes[name].size
        assert np.abs(points[:, :2]).max(0) == pytest.approx([size[0] / 2, size[1] / 2], abs=0.02)
        assert place[:2] == pytest.approx(boxes[name].pose[:2], abs=1e-4)
        seen += 1
    assert seen > 5
    assert {*solid["eyes"]} == {space.id for space in scene.spaces}


def decode(content: bytes) -> Any:
    """The corners of a mesh's bytes, (n, 3) in metres."""
    end = content.index(b"\n") + 1
    head = json.loads(content[:end])
    found = []
    for part in head["parts"]:
        count = part["corners"]
        grid = np.frombuffer(content, "<u2", 3 * count, end).reshape(3, count).T
        found.append(np.array(head["low"]) + np.array(head["step"]) * grid)
        wide = 4 if part.get("wide") else 2
        end += -(-6 * count // 4) * 4 + -(-3 * wide * part["faces"] // 4) * 4
    assert end == len(content)
    return np.concatenate(found)


def test_a_first_room_is_small_and_its_meshes_are_kept_for_good(client: TestClient) -> None:
    state = client.get("/state").json()
    rows = state["pieces"]
    assert len(gzip.compress(json.dumps(rows).encode())) < 5000
    looks = client.get(f"/symbols?of={','.join(row['is'] for row in rows)},x").json()
    assert {*looks} == {row["is"] for row in rows}
    solid = client.get("/solid").json()
    mesh = client.get(f"/mesh/{solid['models'][0][0]}")
    assert "immutable" in mesh.headers["cache-control"]
    assert mesh.headers["content-encoding"] == "gzip"
    assert client.get("/mesh/nothing").status_code == 404
    for row in solid["textures"].values():
        picture = client.get(row["picture"])
        assert picture.content[8:12] == b"WEBP"
        assert "immutable" in picture.headers["cache-control"]
    assert client.get("/texture/nothing.webp").status_code == 404
    assert client.get("/state").headers["cache-control"] == "no-store"
