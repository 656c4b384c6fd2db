"""Halls from end to end: every sample is solved, judged, written and read back, wherever it lies
and whatever its parts are called."""

from __future__ import annotations

import json
import math
import struct
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall import solving as domain
from scenewright.domains.hall.demands.checked import ids_of, sizes_of
from scenewright.domains.hall.demands.companies import COMPANY_SIZE, FEWEST_SHOWN
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.formats import brief_json, solution_json
from thoroughness import few_or_many, only_thorough, spread

SAMPLES = ("exhibition", "shop", "reading-room", "auditorium", "irregular")
STEPS = 5000
"""Fewer than ``quick`` takes, the least that a user is offered by name."""
SEEDS, ENOUGH = 3, few_or_many(STEPS, 20_000)
"""Runs and steps for a median of energies that hardly depends on chance."""
EVERY = pytest.mark.parametrize(
    ("name", "seed"), [(n, s) for n in SAMPLES for s in range(few_or_many(1, 2))]
)


@cache
def brief_of(name: str) -> Brief:
    return scenewright.read(f"sample:hall-{name}")


@cache
def solved(name: str, seed: int, steps: int = STEPS) -> Solution:
    return answer(brief_of(name), seed, steps)


def answer(brief: Brief, seed: int = 0, steps: int = STEPS) -> Solution:
    return scenewright.solve(brief, preset="quick", steps=steps, seed=seed)


@cache
def usual_energy(name: str) -> float:
    found = [solved(name, seed, ENOUGH) for seed in range(SEEDS)]
    return float(np.median([sum(one.energies.values()) for one in found]))


def body(piece: Piece) -> shapely.Polygon:
    row = np.array([[piece.pose.x, piece.pose.y, piece.pose.heading, *piece.size[:2]]])
    return shapely.Polygon(corners(row)[0])


@EVERY
def test_every_sample_is_complete_and_valid(name: str, seed: int) -> None:
    found = solved(name, seed)
    assert found.left_out == ()
    report = scenewright.check(found)
    assert report.valid, report.findings
    room = found.brief.rooms[0]
    placed = Counter(piece.function for piece in found.pieces)
    for demand, number in zip(ids_of(room.demands), map(sizes_of, room.demands), strict=True):
        assert placed[demand] >= len(number), demand
    assert all(math.isfinite(value.cost) for value in found.terms)
    total = math.fsum(value.cost for value in found.terms)
    assert total == pytest.approx(math.fsum(found.energies.values()))


@EVERY
def test_the_scene_graph_tells_what_stands_there(name: str, seed: int) -> None:
    found = solved(name, seed)
    assert found.detail is not None
    pieces = {piece.id: piece for piece in found.pieces}
    assert len(pieces) == len(found.pieces)
    zones = {
        zone.id: shapely.Polygon(zone.outline, zone.holes) for zone in found.detail.layout.zones
    }
    demands = ids_of(found.brief.rooms[0].demands)
    listed = [name for group in found.detail.layout.groups for name in group.objects]
    assert len(set(listed)) == len(listed)
    for group in found.detail.layout.groups:
        assert group.demand in demands
        assert group.pattern in PATTERNS
        counts = [layer.number for part in group.parts for layer in part.layers]
        number = len(group.objects)
        shown = "plinth" in group.objects[0] and number >= FEWEST_SHOWN
        companies = round(number / COMPANY_SIZE) if shown else number
        assert sum(counts) in (number, companies)  # one by one where the brief says how they stand
        for name_ in group.objects:
            piece = pieces[name_]
            assert (piece.group, piece.function) == (group.id, group.demand)
            assert body(piece).difference(zones[group.zone]).area < 1e-3
    walls = {piece.id for piece in found.pieces if piece.category == "partition"}
    assert set(found.detail.layout.partitions) == walls
    objects = {p.id for p in found.pieces if p.function in demands}
    chairs = objects - set(listed)
    assert all(pieces[one].group in {g.id for g in found.detail.layout.groups} for one in chairs)
    links = {frozenset((link.first, link.second)) for link in found.detail.layout.links}
    assert {frozenset(link.between) for link in found.brief.rooms[0].links} <= links


@EVERY
def test_demands_stand_where_the_brief_wants_them(name: str, seed: int) -> None:
    found = solved(name, seed)
    assert found.detail is not None
    room = found.brief.rooms[0]
    for demand, name_ in zip(room.demands, ids_of(room.demands), strict=True):
        groups = [group for group in found.detail.layout.groups if group.demand == name_]
        wanted = [demand.zone] if isinstance(demand.zone, str) else demand.zone
        assert not wanted or {group.zone for group in groups} <= set(wanted)
        patterns = {group.pattern for group in groups if len(group.objects) > 1}
        assert not demand.patterns or patterns <= set(demand.patterns)
        sizes = Counter(tuple(size[:2]) for size in sizes_of(demand))
        ids = {one for group in groups for one in group.objects}
        placed = Counter(p.size[:2] for p in found.pieces if p.id in ids)
        assert placed == sizes


@pytest.mark.parametrize("name", spread(SAMPLES, 2))
def test_halls_are_written_and_read_back(name: str, tmp_path: Path) -> None:
    found = solved(name, 0)
    text = solution_json.dumps(found)
    back = solution_json.loads(text)
    assert (back.pieces, back.left_out, back.energies) == (
        found.pieces,
        found.left_out,
        found.energies,
    )
    assert solution_json.dumps(back) == text
    assert back.brief == found.brief
    again = brief_json.loads(brief_json.dumps(found.brief))
    assert again == found.brief
    for suffix in (".json", ".glb", ".svg", ".png"):
        scenewright.write(found, tmp_path / f"hall{suffix}")
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "hall.glb",
        "hall.json",
        "hall.png",
        "hall.svg",
    ]
    assert scenewright.read_solution(tmp_path / "hall.json").pieces == found.pieces
    assert (tmp_path / "hall.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    assert (tmp_path / "hall.svg").read_text().rstrip().endswith("</svg>")
    names = nodes(tmp_path / "hall.glb")
    assert {piece.id for piece in found.pieces} <= names


def nodes(path: Path) -> set[str]:
    """Ids of what the nodes of a GLB stand for."""
    data = path.read_bytes()
    magic, version, length = struct.unpack_from("<III", data)
    assert (magic, version, length) == (0x46546C67, 2, len(data))
    size = struct.unpack_from("<I", data, 12)[0]
    document: dict[str, Any] = json.loads(data[20 : 20 + size])
    return {node.get("extras", {}).get("id", node["name"]) for node in document["nodes"]}


def turned(brief: Brief, quarters: int, dx: float, dy: float) -> Brief:
    """A brief turned by quarter turns about the origin, then moved."""
    document = brief.model_dump(mode="json")
    c, s = round(math.cos(quarters * math.pi / 2)), round(math.sin(quarters * math.pi / 2))

    def moved(point: list[float]) -> list[float]:
        return [c * point[0] - s * point[1] + dx, s * point[0] + c * point[1] + dy]

    for room in document["rooms"]:
        rings = [room["outline"], *room["holes"]]
        rings += [zone["outline"] for zone in room["zones"] if zone["outline"]]
        for ring in rings:
            ring[:] = [moved(point) for point in ring]
        for thing in (*room["doors"], *room["windows"], *room["fixed"]):
            thing["at"] = moved(thing["at"])
        for item in room["fixed"]:
            item["heading"] = math.remainder(item["heading"] + quarters * math.pi / 2, math.tau)
    return Brief.model_validate(document)


@pytest.mark.parametrize(
    ("quarters", "dx", "dy"), [(1, -300.0, 41.3), pytest.param(2, 7.7, -9.1, marks=only_thorough)]
)
@pytest.mark.parametrize("name", spread(SAMPLES, 2))
def test_a_hall_elsewhere_is_as_good(name: str, quarters: int, dx: float, dy: float) -> None:
    brief = brief_of(name)
    assert turned(turned(brief, 4 - quarters, 0, 0), quarters, 0, 0) == brief
    elsewhere, energies = turned(brief, quarters, dx, dy), []
    for seed in range(SEEDS):
        found = answer(elsewhere, seed, ENOUGH)
        assert found.left_out == ()
        report = scenewright.check(found)
        assert report.valid, report.findings
        energies.append(sum(found.energies.values()))
    assert np.median(energies) < 1.5 * usual_energy(name)


def test_a_solution_that_is_turned_along_stays_valid() -> None:
    """Every piece where the turned hall has it: nothing depends on directions."""
    found = solved("exhibition", 0)
    assert found.detail is not None
    brief = turned(found.brief, 1, 7.0, -2.0)
    document = json.loads(solution_json.dumps(found))
    document["brief"] = brief.model_dump(mode="json")
    for piece in document["pieces"]:
        x, y, z, heading = piece["pose"]
        piece["pose"] = [7.0 - y, x - 2.0, z, math.remainder(heading + math.pi / 2, math.tau)]
    for zone in document["graph"]["zones"]:
        for ring in (zone["outline"], *zone["holes"]):
            ring[:] = [[7.0 - y, x - 2.0] for x, y in ring]
    for tour in document["tours"]:
        tour["points"] = [[7.0 - y, x - 2.0] for x, y in tour["points"]]
    before = scenewright.check(found)
    after = scenewright.check(solution_json.loads(json.dumps(document)))
    assert Counter(finding.kind for finding in after.findings) == Counter(
        finding.kind for finding in before.findings
    )
    assert after.valid


def renamed(brief: Brief, zones: dict[str, str], demands: dict[str, str]) -> Brief:
    document = brief.model_dump(mode="json")
    room = document["rooms"][0]
    for zone in room["zones"]:
        zone["id"] = zones[zone["id"]]
        zone["beside"] = [zones[name] for name in zone["beside"]]
    for link in room["links"]:
        link["between"] = [zones[name] for name in link["between"]]
    for demand, name in zip(room["demands"], ids_of(brief.rooms[0].demands), strict=True):
        demand["id"] = demands[name]
        where = demand["zone"]
        demand["zone"] = [zones[z] for z in where] if isinstance(where, list) else zones.get(where)
        demand["facing"] = demand["facing"] and demands[demand["facing"]]
    return Brief.model_validate(document)


@pytest.mark.parametrize("name", spread(SAMPLES, 2))
def test_names_change_names_only(name: str) -> None:
    brief, found = brief_of(name), solved(name, 0)
    zones, demands = (
        {word: f"{chr(122 - k)}{k:02d}" for k, word in enumerate(words)}
        for words in ([zone.id for zone in brief.rooms[0].zones], ids_of(brief.rooms[0].demands))
    )
    again = answer(renamed(brief, zones, demands))
    assert [p.pose for p in again.pieces] == [p.pose for p in found.pieces]
    assert [p.category for p in again.pieces] == [p.category for p in found.pieces]
    assert again.energies == found.energies
    assert found.detail is not None
    assert again.detail is not None
    old, new = found.detail.layout.groups, again.detail.layout.groups
    assert [demands[group.demand] for group in old] == [group.demand for group in new]
    assert [zones[group.zone] for group in old] == [group.zone for group in new]


def test_variants_are_halls_too() -> None:
    """A brief that leaves its zones open has several good answers."""
    room = brief_of("exhibition").rooms[0]
    zones = [zone.model_copy(update={"outline": None}) for zone in room.zones]
    open_room = room.model_copy(update={"zones": zones})
    brief = brief_of("exhibition").model_copy(update={"rooms": [open_room]})
    shapes = []
    for variant in range(2):
        found = domain.solve(brief, preset="quick", steps=STEPS, variant=variant)
        assert found.detail is not None
        shapes.append([zone.outline.tolist() for zone in found.detail.layout.zones])
        floor = shapely.Polygon(spaces(brief)[0].outline, spaces(brief)[0].holes)
        parts = [shapely.Polygon(zone.outline, zone.holes) for zone in found.detail.layout.zones]
        assert shapely.union_all(parts).area == pytest.approx(floor.area, rel=1e-3)
        assert sum(part.area for part in parts) == pytest.approx(floor.area, rel=1e-3)
    assert shapes[0] != shapes[1]
