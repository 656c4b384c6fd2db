"""Houses of ProcTHOR: what its loader takes, what is read back, and what theirs become."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright as sw
from flat import flat_solution
from scenewright import cli
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution, unfurnished
from scenewright.domains import scene_of
from scenewright.formats import read, write

VECTOR = {"x": float, "y": float, "z": float}
COLOR = {"r": float, "g": float, "b": float, "a": float}
MATERIAL = {"name": str, "color": COLOR}
POSE = {"position": VECTOR, "rotation": VECTOR, "horizon": int}
HOLE = {
    "id": str,
    "assetId": str,
    "room0": str,
    "room1": str,
    "wall0": str,
    "wall1": str,
    "holePolygon": [VECTOR],
    "assetPosition": VECTOR,
    "scale": VECTOR,
    "openable": bool,
    "openness": float,
}
OBJECT = {
    "id": str,
    "assetId": str,
    "position": VECTOR,
    "rotation": VECTOR,
    "kinematic": bool,
    "children": list,
}
CONTRACT: dict[str, Any] = {
    "rooms": [{"id": str, "roomType": str, "floorPolygon": [VECTOR], "floorMaterial": MATERIAL}],
    "walls": [{"id": str, "roomId": str, "polygon": [VECTOR], "material": MATERIAL, "empty": bool}],
    "doors": [HOLE],
    "windows": [HOLE],
    "objects": [OBJECT],
    "proceduralParameters": {
        "ceilingMaterial": MATERIAL,
        "floorColliderThickness": float,
        "receptacleHeight": float,
        "skyboxId": str,
        "reflections": list,
        "lights": [
            {
                "id": str,
                "type": str,
                "position": VECTOR,
                "intensity": float,
                "rgb": COLOR,
                "shadow": {"type": str, "strength": float, "bias": float},
            }
        ],
    },
    "metadata": {"schema": str, "agent": POSE, "agentPoses": {"default": POSE, "arm": POSE}},
}
"""The keys that AI2-THOR 5.0 reads (``Thor.Procedural.Data``), and their types."""


def breaches(contract: Any, value: Any, place: str = "house") -> list[str]:
    """Where a document is not what a loader takes."""
    if isinstance(contract, dict):
        if not isinstance(value, dict):
            return [f"{place} is no object"]
        missing = [f"{place}.{key} is missing" for key in contract.keys() - value.keys()]
        known = [(key, rule) for key, rule in contract.items() if key in value]
        return missing + [b for k, rule in known for b in breaches(rule, value[k], f"{place}.{k}")]
    if isinstance(contract, list):
        if not isinstance(value, list):
            return [f"{place} is no list"]
        return [
            b for k, one in enumerate(value) for b in breaches(contract[0], one, f"{place}[{k}]")
        ]
    kinds = (int, float) if contract is float else contract
    wrong = not isinstance(value, kinds) or (contract is not bool and isinstance(value, bool))
    return [f"{place} is {value!r}, not {contract.__name__}"] if wrong else []


@pytest.fixture(scope="module")
def solution() -> Solution:
    return sw.arrange("sample:home-flat", steps=200, seed=3).solution


@pytest.fixture(scope="module")
def path(solution: Solution, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("house") / "flat.procthor.json"
    write(solution, file)
    return file


@pytest.fixture(scope="module")
def house(path: Path) -> dict[str, Any]:
    return dict(json.loads(path.read_text("utf-8")))


def test_the_document_is_what_the_loader_takes(house: dict[str, Any]) -> None:
    assert breaches(CONTRACT, house) == []
    assert {room["roomType"] for room in house["rooms"]} == {
        "Kitchen",
        "LivingRoom",
        "Bedroom",
        "Bathroom",
    }
    for rows in ("rooms", "walls", "doors", "windows"):
        ids = [row["id"] for row in house[rows]]
        assert len(set(ids)) == len(ids)
    walls = {wall["id"]: wall for wall in house["walls"]}
    rooms = {room["id"] for room in house["rooms"]}
    for hole in [*house["doors"], *house["windows"]]:
        assert {hole["room0"], hole["room1"]} <= rooms
        assert walls[hole["wall0"]]["roomId"] == hole["room0"]
        assert walls[hole["wall1"]]["roomId"] in (hole["room1"], "exterior")


@pytest.mark.parametrize(
    ("key", "value"), [("walls", None), ("rooms", [{"id": 3}]), ("objects", [{"id": "a"}])]
)
def test_a_breach_of_the_contract_is_found(house: dict[str, Any], key: str, value: Any) -> None:
    assert breaches(CONTRACT, house | {key: value})


def test_walls_enclose_their_rooms_seen_from_inside(house: dict[str, Any]) -> None:
    """The pieces of wall of a room go once round its floor, which lies on their right."""
    for room in house["rooms"]:
        floor = shapely.Polygon([(p["x"], p["z"]) for p in room["floorPolygon"]])
        mine = [wall["polygon"] for wall in house["walls"] if wall["roomId"] == room["id"]]
        ends = [((a["x"], a["z"]), (b["x"], b["z"])) for a, b, *_ in mine]
        assert sum(np.linalg.norm(np.subtract(*e)) for e in ends) == pytest.approx(
            floor.length, abs=0.01
        )
        for start, end in ends:
            way = np.subtract(end, start)
            right = np.array([way[1], -way[0]]) / np.linalg.norm(way)
            assert floor.contains(shapely.Point(np.mean([start, end], axis=0) + 0.01 * right))


def test_both_sides_of_a_hole_face_each_other(house: dict[str, Any], solution: Solution) -> None:
    walls = {wall["id"]: wall["polygon"] for wall in house["walls"]}
    known = {one.id: one for one in scene_of(solution).openings}
    for hole in [*house["doors"], *house["windows"]]:
        one = known[hole["scenewright"]["id"]]
        low, high = hole["holePolygon"]
        assert (high["x"] - low["x"], low["y"], high["y"]) == pytest.approx(
            (one.width, one.sill, one.head), abs=1e-3
        )
        centres = []
        for name in (hole["wall0"], hole["wall1"]):
            start, end = (np.array([p["x"], p["z"]]) for p in walls[name][:2])
            length = float(np.linalg.norm(end - start))
            assert length / 2 == pytest.approx((low["x"] + high["x"]) / 2, abs=1e-3)
            centres.append((start + end) / 2)
        assert np.mean(centres, axis=0) == pytest.approx((one.x, one.y), abs=0.01)


def difference(one: Scene, two: Scene) -> float:
    """How far outlines and openings of two scenes are apart, in metres, where both have them."""
    assert [space.id for space in one.spaces] == [space.id for space in two.spaces]
    away = [
        shapely.hausdorff_distance(shapely.Polygon(a.outline), shapely.Polygon(b.outline))
        for a, b in zip(one.spaces, two.spaces, strict=True)
    ]
    there = {opening.id: opening for opening in two.openings}
    assert there.keys() == {opening.id for opening in one.openings}
    for a in one.openings:
        b = there[a.id]
        assert (a.kind, {*a.spaces}) == (b.kind, {*b.spaces})
        same = a.ux * b.ux + a.uy * b.uy
        assert (a.hinge, a.swing) == (round(same) * b.hinge, round(same) * b.swing)
        sides = ("x", "y", "width", "sill", "head")
        away += [abs(getattr(a, side) - getattr(b, side)) for side in sides]
    return float(max(away))


def test_rooms_doors_and_windows_are_read_back(solution: Solution, path: Path) -> None:
    again = read(path)
    assert difference(scene_of(solution), scene_of(unfurnished(again))) < 0.01
    before, after = (scene_of(one).spaces for one in (solution, unfurnished(again)))
    assert [(s.name, s.functions) for s in before] == [(s.name, s.functions) for s in after]
    assert again.input_report is not None
    assert again.input_report.complete


def test_objects_are_read_back_where_they_stand(solution: Solution, path: Path) -> None:
    found = {item.id: item for room in read(path, keep=True).rooms for item in room.fixed}
    assert found.keys() == {piece.id for piece in solution.pieces}
    for piece in solution.pieces:
        item = found[piece.id]
        assert (item.category, item.on) == (piece.category, piece.on)
        assert (*item.at, item.z) == pytest.approx(piece.pose[:3], abs=0.01)
        assert abs(np.angle(np.exp(1j * (item.heading - piece.pose.heading)))) < 0.01
        assert item.size == pytest.approx(piece.size, abs=1e-3)


def test_a_house_is_arranged_again(path: Path) -> None:
    again = sw.arrange(str(path), steps=100)
    assert again.report.valid
    assert len(again.solution.pieces) > 40


def test_same_solution_same_bytes(solution: Solution, path: Path, tmp_path: Path) -> None:
    other = tmp_path / "b.procthor.json"
    write(solution, other)
    assert other.read_bytes() == path.read_bytes()


def corner(x: float, z: float, y: float = 0.0) -> dict[str, float]:
    return {"x": x, "y": y, "z": z}


def wall(room: str, start: tuple[float, float], end: tuple[float, float], **more: Any) -> Any:
    low = [corner(*start), corner(*end)]
    high = [corner(*start, 2.7), corner(*end, 2.7)]
    return {"id": f"wall|{room}|{start}", "roomId": room, "polygon": [*low, *high]} | more


def two_rooms(**more: Any) -> dict[str, Any]:
    """A house as ProcTHOR makes them: two rooms that share the middle of a wall."""
    bed = [(0, 0), (0, 4), (4, 4), (4, 0)]
    bath = [(4, 0), (4, 4), (6, 4), (6, 0)]
    ends = {"room|2": [*zip(bed, bed[1:] + bed[:1], strict=True)]}
    ends["room|3"] = [*zip(bath, bath[1:] + bath[:1], strict=True)]
    return {
        "rooms": [
            {
                "id": name,
                "roomType": kind,
                "floorPolygon": [corner(*start) for start, _ in ends[name]],
            }
            for name, kind in (("room|2", "Bedroom"), ("room|3", "Bathroom"))
        ],
        "walls": [wall(name, *both) for name, rows in ends.items() for both in rows],
        "doors": [
            {
                "id": "door|2|3",
                "assetId": "Doorway_1",
                "room0": "room|2",
                "room1": "room|3",
                "wall0": "wall|room|2|(4, 4)",
                "wall1": "wall|room|3|(4, 0)",
                "holePolygon": [corner(0.5, 0), {"x": 1.5, "y": 2.1, "z": 0}],
            }
        ],
        "windows": [],
        "objects": [
            {
                "id": "Bed|2|0",
                "assetId": "Bed_9",
                "position": corner(1.0, 2.9, 0.45),
                "rotation": {"x": 0, "y": 180.0, "z": 0},
                "children": [
                    {"id": "Pillow|2|1", "position": corner(1.0, 3.6, 0.95), "assetId": "pillow_22"}
                ],
            }
        ],
        "metadata": {"schema": "1.0.0"},
    } | more


def read_house(folder: Path, document: Any, keep: bool = False) -> Brief:
    path = folder / "a.procthor.json"
    path.write_text(document if isinstance(document, str) else json.dumps(document))
    return read(path, keep=keep)


def test_a_house_of_theirs_is_read(tmp_path: Path) -> None:
    brief = read_house(tmp_path, two_rooms(), keep=True)
    assert brief.outlines == "centre"
    assert [(room.function, room.height) for room in brief.rooms] == [
        (["bedroom"], 2.7),
        (["bathroom"], 2.7),
    ]
    (door,) = brief.rooms[0].doors
    assert door.at == pytest.approx((4.0, 3.0))
    assert (door.width, door.height) == (1.0, 2.1)
    assert door.to == "room|3"
    bed, pillow = brief.rooms[0].fixed
    assert (bed.category, bed.size[2]) == ("double_bed", 0.9)
    assert bed.heading == pytest.approx(-np.pi / 2)
    assert (pillow.category, pillow.on) == ("obstacle", "Bed|2|0")
    read_house(tmp_path, two_rooms())
    again = sw.arrange(str(tmp_path / "a.procthor.json"), steps=100)
    assert {"double_bed", "toilet"} <= {piece.category for piece in again.solution.pieces}


def test_a_house_before_schema_1_is_read(tmp_path: Path) -> None:
    house = two_rooms()
    low, high = house["doors"][0].pop("holePolygon")
    house["doors"][0]["boundingBox"] = {"min": low, "max": high}
    (door,) = read_house(tmp_path, house).rooms[0].doors
    assert door.at == pytest.approx((4.0, 3.0))
    assert (door.width, door.height) == (1.0, 2.1)


def test_an_open_wall_is_a_passage(tmp_path: Path) -> None:
    house = two_rooms(doors=None)
    for row in house["walls"]:
        row["empty"] = row["id"] in ("wall|room|2|(4, 4)", "wall|room|3|(4, 0)")
    (passage,) = [door for room in read_house(tmp_path, house).rooms for door in room.doors]
    assert (passage.swing, passage.at) == ("none", (4.0, 2.0))
    assert passage.width == pytest.approx(3.8)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"rooms": []}, "rooms"),
        ({"rooms": [{"id": "a", "floorPolygon": [corner(0, 0)]}]}, "floorPolygon"),
        ({"walls": [{"id": "w", "polygon": [{"x": "a"}, {}]}]}, "walls[0].polygon"),
        ({"objects": [{"id": "o", "position": corner(1e9, 0)}]}, "objects[0].position"),
        ({"doors": [{"id": "d", "boundingBox": {}}]}, "doors[0].boundingBox"),
    ],
)
def test_what_is_no_house_is_one_line(tmp_path: Path, change: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError) as caught:
        read_house(tmp_path, two_rooms() | change)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_house_under_another_name_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "house.json"
    path.write_text(json.dumps(two_rooms()))
    assert cli.run(["plan", str(path), "-o", str(tmp_path / "a.svg")]) == 2
    assert "is a ProcTHOR house; name it .procthor.json" in capsys.readouterr().err


def test_a_site_is_no_house(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = str(tmp_path / "a.procthor.json")
    assert cli.run(["arrange", "sample:site-30", "-o", target]) == 2
    assert "a site has no rooms" in capsys.readouterr().err


def test_a_door_in_no_wall_is_lost_and_said(tmp_path: Path) -> None:
    house = two_rooms()
    house["doors"][0]["wall0"] = "nowhere"
    house["doors"][0]["room0"] = "nowhere"
    report = read_house(tmp_path, house).input_report
    assert report is not None
    assert not report.complete


def test_the_flat_of_two_rooms_is_written(tmp_path: Path) -> None:
    write(flat_solution(), tmp_path / "a.procthor.json")
    house = json.loads((tmp_path / "a.procthor.json").read_text())
    assert breaches(CONTRACT, house) == []
