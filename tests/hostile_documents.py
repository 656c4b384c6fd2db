"""Documents nobody should write, drawn by a seed: sound ones with something broken in them."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Callable
from typing import Any

Json = Any
Draw = random.Random
Place = tuple[Any, Any]
"""A list or object, and the index or key of one value in it."""

WC = {
    "name": "WC",
    "function": "toilet",
    "outline": [[0, 0], [1.6, 0], [1.6, 2], [0, 2]],
    "doors": [{"at": [0.8, 0], "width": 0.8, "swing": "out"}],
}
HOME: Json = {
    "name": "home",
    "levels": [{"id": "0", "name": "Ground", "elevation": 0, "height": 2.6}],
    "rooms": [
        WC,
        {
            "id": "bed",
            "function": ["bedroom"],
            "outline": [[1.7, 0], [5, 0], [5, 3], [1.7, 3]],
            "holes": [[[2, 2], [2.3, 2], [2.3, 2.3], [2, 2.3]]],
            "main_wall": 2,
            "doors": [{"at": [1.7, 1], "width": 0.9, "swing": "in", "hinge": "left", "to": "wc"}],
            "windows": [{"at": [3, 3], "width": 1.2, "sill": 0.9, "height": 1.2}],
            "fixed": [
                {"category": "wardrobe", "at": [4.5, 2.6], "size": [0.8, 0.6, 2], "heading": 0}
            ],
            "outlets": [{"at": [5, 1], "kind": "power", "required": True}],
            "radiators": [{"at": [3, 3], "width": 1.0, "height": 0.6, "depth": 0.1, "z": 0.1}],
            "wishes": [
                {"what": "desk", "face": "window", "away_from": "door", "metres": 1.5},
                {"what": "wardrobe", "by": "wall", "near": "single_bed"},
            ],
            "ask": [{"group": "single", "count": 1, "required": True}],
        },
    ],
}
ATTIC: Json = {
    "name": "attic",
    "levels": [{"id": "0", "elevation": 0, "height": 2.6}, {"id": "1", "elevation": 2.9}],
    "rooms": [
        {
            "id": "hall",
            "level": "0",
            "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
            "function": "hall",
            "doors": [{"at": [4.4, 0], "width": 0.9}],
        },
        {
            "id": "up",
            "level": "1",
            "outline": [[0, 0], [5, 0], [5, 6], [0, 6]],
            "function": "study",
            "windows": [{"at": [2.5, 6], "width": 0.8, "sill": 1.2, "height": 1.0}],
            "slopes": [{"edge": 2, "knee": 0.9, "pitch": 0.7}],
        },
    ],
    "stairs": [
        {
            "at": [0.6, 0.8],
            "heading": 1.5708,
            "level": "0",
            "to": "1",
            "shape": "quarter",
            "turn": "right",
            "width": 0.9,
            "going": 0.26,
        }
    ],
}
HALL: Json = {
    "domain": "hall",
    "rooms": [
        {
            "id": "hall",
            "outline": [[0, 0], [14, 0], [14, 10], [0, 10]],
            "doors": [{"at": [7, 0], "width": 2, "swing": "out"}],
            "zones": [{"id": "a", "outline": [[1, 2], [13, 2], [13, 9], [1, 9]]}],
            "demands": [{"category": "showcase", "count": 4, "zone": "a"}],
        }
    ],
}
SITE: Json = {
    "domain": "site",
    "sites": [
        {
            "id": "s",
            "outline": [[0, 0], [120, 0], [120, 90], [0, 90]],
            "buildings": [{"model": "villa", "count": 3}],
        }
    ],
}
MAP: Json = {
    "type": "FeatureCollection",
    "features": [
        {
            "type": "Feature",
            "properties": {"indoor": "room", "shop": "books", "level": "0"},
            "geometry": {
                "type": "Polygon",
                "coordinates": [
                    [[8.0, 50.0], [8.0002, 50.0], [8.0002, 50.0001], [8.0, 50.0001], [8.0, 50.0]]
                ],
            },
        },
        {
            "type": "Feature",
            "properties": {"door": "yes", "level": "0"},
            "geometry": {"type": "Point", "coordinates": [8.0001, 50.0]},
        },
    ],
}
LAND: Json = {
    "type": "FeatureCollection",
    "features": [
        {
            "type": "Feature",
            "properties": {"landuse": "residential"},
            "geometry": {
                "type": "Polygon",
                "coordinates": [
                    [[8.0, 50.0], [8.002, 50.0], [8.002, 50.001], [8.0, 50.001], [8.0, 50.0]]
                ],
            },
        },
        {
            "type": "Feature",
            "properties": {"building": "yes", "height": "9"},
            "geometry": {
                "type": "Polygon",
                "coordinates": [
                    [[8.0005, 50.0004], [8.0007, 50.0004], [8.0007, 50.0005], [8.0005, 50.0004]]
                ],
            },
        },
    ],
}
CITY: Json = {
    "type": "CityJSON",
    "version": "1.1",
    "transform": {"scale": [0.001, 0.001, 0.001], "translate": [0, 0, 0]},
    "CityObjects": {
        "b": {
            "type": "Building",
            "geometry": [
                {
                    "type": "Solid",
                    "lod": "1",
                    "boundaries": [
                        [
                            [[0, 1, 2, 3]],
                            [[4, 7, 6, 5]],
                            [[0, 4, 5, 1]],
                            [[1, 5, 6, 2]],
                            [[2, 6, 7, 3]],
                            [[3, 7, 4, 0]],
                        ]
                    ],
                }
            ],
        }
    },
    "vertices": [
        [0, 0, 0],
        [0, 9000, 0],
        [9000, 9000, 0],
        [9000, 0, 0],
        [0, 0, 6000],
        [0, 9000, 6000],
        [9000, 9000, 6000],
        [9000, 0, 6000],
    ],
}
DOCUMENTS: dict[str, tuple[str, Json]] = {
    "home": (".json", HOME),
    "attic": (".json", ATTIC),
    "hall": (".json", HALL),
    "site": (".json", SITE),
    "indoor": (".geojson", MAP),
    "land": (".geojson", LAND),
    "city": (".cityjson", CITY),
}
"""Sound documents by name, each with the suffix it is read by."""

NUMBERS: tuple[Json, ...] = (
    0,
    -1,
    1e-300,
    1e9,
    -1e17,
    1e308,
    float("nan"),
    float("inf"),
    10**400,
    2**63,
    0.1 + 0.2,
)
ODD: tuple[Json, ...] = (
    None,
    True,
    "",
    "x" * 100_000,
    "../../../etc/passwd",
    "a\u0000b\u001b[31m\nsecond line",
    "\ud800",
    "𝔘𝔫𝔦\u202e",
    [],
    {},
    [[]],
    [None] * 9,
    {"": {}},
    "NaN",
    "1e999",
    "<!ENTITY x>",
)


def places(value: Json, found: list[Place] | None = None) -> list[Place]:
    """Every value below a document."""
    found = [] if found is None else found
    keys = value if isinstance(value, dict) else range(len(value))
    for key in keys:
        found.append((value, key))
        if isinstance(value[key], dict | list):
            places(value[key], found)
    return found


def broken(document: Json, draw: Draw) -> str:
    """The text of a document with one to three things broken in it."""
    changed = copy.deepcopy(document)
    for _ in range(draw.randint(1, 3)):
        draw.choice(BREAKS)(changed, draw)
    text = json.dumps(changed)
    return cut(text, draw) if draw.random() < 0.1 else text


def cut(text: str, draw: Draw) -> str:
    """Cut off, or with a few letters exchanged."""
    if draw.random() < 0.5:
        return text[: draw.randrange(len(text))]
    letters = list(text)
    for _ in range(draw.randint(1, 5)):
        letters[draw.randrange(len(letters))] = draw.choice('{}[]",:0e-x\\')
    return "".join(letters)


def _number(document: Json, draw: Draw) -> None:
    numbers = [(v, k) for v, k in places(document) if isinstance(v[k], int | float)]
    if numbers:
        value, key = draw.choice(numbers)
        value[key] = draw.choice(NUMBERS)


def _anything(document: Json, draw: Draw) -> None:
    value, key = draw.choice(places(document))
    value[key] = draw.choice(ODD + NUMBERS)


def _gone(document: Json, draw: Draw) -> None:
    value, key = draw.choice(places(document))
    del value[key]


def _often(document: Json, draw: Draw) -> None:
    lists = [v[k] for v, k in places(document) if isinstance(v[k], list) and v[k]]
    if lists:
        some = draw.choice(lists)
        some.extend(copy.deepcopy(draw.choice(some)) for _ in range(draw.choice((1, 2, 200))))


def _rings(document: Json) -> list[Json]:
    return [
        v[k]
        for v, k in places(document)
        if isinstance(v[k], list) and len(v[k]) > 2 and isinstance(v[k][0], list)
    ]


def _crossed(document: Json, draw: Draw) -> None:
    rings = _rings(document)
    if rings:
        draw.shuffle(draw.choice(rings))


def _scaled(document: Json, draw: Draw) -> None:
    by = draw.choice((100, 0.01, 1000, -1))
    for value, key in places(document):
        if isinstance(value, list) and isinstance(value[key], float | int):
            value[key] *= by if abs(value[key]) < 1e300 else 1


def _deep(document: Json, draw: Draw) -> None:
    value, key = draw.choice(places(document))
    inside: Json = 1
    for _ in range(draw.choice((3, 60, 400))):
        inside = [inside] if draw.random() < 0.5 else {"a": inside}
    value[key] = inside


def _unknown(document: Json, draw: Draw) -> None:
    objects = [v for v, _ in places(document) if isinstance(v, dict)]
    draw.choice(objects)[draw.choice(("__proto__", "walls", "", "a" * 5000))] = draw.choice(ODD)


def _catalog(document: Json, draw: Draw) -> None:
    document["catalogs"] = draw.choice(
        (["/etc/passwd"], ["../" * 40 + "etc"], [{"path": "."}], ["\u0000"], [3], "x")
    )


BREAKS: tuple[Callable[[Json, Draw], None], ...] = (
    _number,
    _number,
    _anything,
    _anything,
    _gone,
    _often,
    _crossed,
    _scaled,
    _deep,
    _unknown,
    _catalog,
)
