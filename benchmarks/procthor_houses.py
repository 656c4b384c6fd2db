"""Houses by ProcTHOR's own generator, without Unity: run by :mod:`benchmarks.procthor_peer`.

``python procthor_houses.py FOLDER COUNT`` writes ``N.procthor.json`` a house that was made, with
the size of each object as ProcTHOR's database has it, and ``seconds.json``. Nothing of Scenewright
is imported: it runs in an environment of its own.
"""

from __future__ import annotations

import json
import random
import signal
import sys
from collections.abc import Iterator
from itertools import count
from pathlib import Path
from time import process_time
from types import SimpleNamespace
from typing import Any

CORNERS = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
SIDES = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1]
SIDES += [2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3]
"""A box of side 1 and its triangles."""
LONGEST = 60.0
"""Seconds of the processor after which a house is given up: some never end."""


class BoxController:
    """What stands in for Unity: of an asset that was spawned the geometry is its box."""

    def __init__(self, sizes: dict[str, dict[str, float]]) -> None:
        self.sizes = sizes
        self.spawned: dict[str, Any] = {}

    def reset(self, **_: Any) -> None:
        self.spawned = {}

    def step(self, action: str, **given: Any) -> Any:
        if action == "SpawnAsset":
            self.spawned[given["generatedId"]] = given
        found = None
        if action == "GetInSceneAssetGeometry":
            found = [self._box(self.spawned[given["objectId"]])]
        return SimpleNamespace(metadata={"actionReturn": found})

    def _box(self, asset: dict[str, Any]) -> dict[str, Any]:
        from math import cos, radians, sin

        size, at = self.sizes[asset["assetId"]], asset["position"]
        turn = radians(asset["rotation"]["y"])
        points = []
        for x, y, z in CORNERS:
            right, away = x * size["x"], z * size["z"]
            points.append(
                {
                    "x": at["x"] + right * cos(turn) + away * sin(turn),
                    "y": at["y"] + y * size["y"],
                    "z": at["z"] - right * sin(turn) + away * cos(turn),
                }
            )
        return {"vertices": points, "triangles": SIDES}


def make_house(seed: int, controller: BoxController) -> dict[str, Any] | None:
    """One house: structure, doors, walls, furniture on the floor and on walls."""
    from procthor import generation as g

    maker = g.HouseGenerator(
        split="train",
        seed=seed,
        room_spec_sampler=g.PROCTHOR10K_ROOM_SPEC_SAMPLER,
        controller=controller,
    )
    spec, drawn = maker.room_spec_sampler.sample(), g.SamplingVars.sample()
    for _ in range(10):
        try:
            built = g.sample_house_structure(
                interior_boundary=None,
                room_ids=set(spec.room_type_map),
                room_spec=spec,
                interior_boundary_scale=drawn.interior_boundary_scale,
            )
            break
        except g.InvalidFloorplan:
            continue
    else:
        return None
    house = g.PartialHouse.from_structure_and_room_spec(house_structure=built, room_spec=spec)
    doors = g.add_doors(partial_house=house, split="train")
    floors = g.get_floor_polygons(xz_poly_map=built.xz_poly_map)
    g.add_exterior_walls(partial_house=house, boundary_groups=built.boundary_groups)
    g.add_rooms(
        partial_house=house,
        floor_polygons=floors,
        room_type_map=spec.room_type_map,
        split="train",
        door_polygons=doors,
        controller=controller,
    )
    g.add_floor_objects(partial_house=house, max_floor_objects=drawn.max_floor_objects)
    g.add_wall_objects(
        partial_house=house,
        rooms=house.rooms,
        boundary_groups=built.boundary_groups,
        split="train",
        room_type_map=spec.room_type_map,
        ceiling_height=built.ceiling_height,
    )
    return dict(house.to_house_dict())


def label(objects: list[Any], known: dict[str, Any], numbers: Iterator[int]) -> None:
    """The type of each object before a number of its own, as in ProcTHOR's sets of houses, and its
    size beside it, for a reader that has no such database."""
    for one in objects:
        asset = known[one["assetId"]]
        size = asset["boundingBox"]
        one["id"] = f"{asset['objectType']}|{next(numbers)}"
        one["scenewright"] = {"size": [size["x"], size["z"], size["y"]]}
        label(one.get("children") or [], known, numbers)


def give_up(*_: Any) -> None:
    """End a house that takes too long."""
    raise TimeoutError(f"not made in {LONGEST:.0f} s")


def main(folder: Path, number: int) -> None:
    """Write the houses of the first seeds and how long each took."""
    from procthor.databases import asset_id_database

    sizes = {name: row["boundingBox"] for name, row in asset_id_database.items()}
    controller, seconds = BoxController(sizes), []
    signal.signal(signal.SIGPROF, give_up)
    for seed in range(number):
        random.seed(seed)
        before = process_time()
        signal.setitimer(signal.ITIMER_PROF, LONGEST)
        try:
            house = make_house(seed, controller)
        except Exception as error:  # its own faults: counted as no house
            print(seed, type(error).__name__, error, file=sys.stderr)
            house = None
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        if house is not None:
            seconds.append(process_time() - before)
            label(house["objects"], asset_id_database, count())
            text = json.dumps(house, default=float)
            (folder / f"{seed:04}.procthor.json").write_text(text, encoding="utf-8")
    (folder / "seconds.json").write_text(json.dumps(seconds), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]))
