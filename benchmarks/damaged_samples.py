"""Small sound files of every format a person hands in, as they are before they are damaged."""

from __future__ import annotations

import base64
import json
import struct
from typing import Any

Json = Any
WC: Json = {
    "name": "WC",
    "function": "toilet",
    "outline": [[0, 0], [1.6, 0], [1.6, 2], [0, 2]],
    "doors": [{"at": [0.8, 0], "width": 0.8, "swing": "out"}],
}
ROOM: Json = {
    "name": "Bedroom",
    "function": ["bedroom"],
    "outline": [[1.7, 0], [5, 0], [5, 3.4], [1.7, 3.4]],
    "doors": [{"at": [3, 0], "width": 0.9}],
    "windows": [{"at": [3, 3.4], "width": 1.2, "sill": 0.9, "height": 1.2}],
    "fixed": [{"category": "wardrobe", "at": [4.5, 3.0], "size": [0.8, 0.6, 2], "heading": 0}],
    "wishes": [{"what": "desk", "face": "window"}],
}
HOME: Json = {
    "name": "home",
    "levels": [{"id": "0", "elevation": 0, "height": 2.6}],
    "rooms": [WC, ROOM],
}
HALL: Json = {
    "domain": "hall",
    "rooms": [
        {
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
            "outline": [[0, 0], [120, 0], [120, 90], [0, 90]],
            "buildings": [{"model": "villa", "count": 3}],
        }
    ],
}
VILLAGE: Json = {
    "domain": "village",
    "blocks": [{"id": "b", "outline": [[0, 0], [46, -6], [88, 4], [60, 50]], "count": 3}],
    "lanes": [{"id": "road", "line": [[-20, -0.5], [0, -3.2], [46, -9.2], [89, 1.1]], "width": 5}],
}
XML = """<?xml version='1.0' encoding='UTF-8'?>
<home version='7000' wallHeight='250'>
<level id='l' name='Ground' elevation='0' floorThickness='12' height='250'/>
<room level='l' name='Bedroom'><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/>
<point x='0' y='300'/></room>
<wall id='w' level='l' xStart='0' yStart='0' xEnd='400' yEnd='0' height='250' thickness='10'/>
<wall id='v' level='l' xStart='400' yStart='0' xEnd='400' yEnd='300' height='250' thickness='10'/>
<doorOrWindow level='l' name='Door' x='200' y='0' width='90' depth='10' height='210'/>
<pieceOfFurniture level='l' name='Bed' x='200' y='200' width='90' depth='200' height='50'
 movable='false'/>
<furnitureGroup level='l' name='Pair' x='100' y='100' width='60' depth='60' height='70'>
<pieceOfFurniture name='Table' x='100' y='100' width='60'
 depth='60' height='70'/></furnitureGroup></home>"""
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
STL = "solid s\n" + "".join(
    "facet normal 0 0 0\nouter loop\n"
    + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners)
    + "endloop\nendfacet\n"
    for corners in (
        ((0, 0, 0), (0, 1, 0), (1, 0, 0)),
        ((0, 0, 0), (1, 0, 0), (0, 0, 1)),
        ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
        ((0, 1, 0), (0, 0, 0), (0, 0, 1)),
    )
) + "endsolid\n"  # fmt: skip
_CORNERS, _FACES = (0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1), (0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3)
_BODY = struct.pack("<12f12H", *_CORNERS, *_FACES)
_URI = "data:application/octet-stream;base64," + base64.b64encode(_BODY).decode()
GLTF: Json = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "table"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.4, 0.3, 1]}}],
    "buffers": [{"uri": _URI, "byteLength": len(_BODY)}],
    "bufferViews": [
        {"buffer": 0, "byteOffset": 0, "byteLength": 48},
        {"buffer": 0, "byteOffset": 48, "byteLength": 24},
    ],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
    ],
}
TABLE = (
    "id#1=x#table\nname#1=Table\ncategory#1=Tables\nmodel#1=/kit/table.obj\nwidth#1=100\n"
    "depth#1=60\nheight#1=74\nmovable#1=true\ndoorOrWindow#1=false\n"
)
CORRECTIONS = "id,category,width,depth,height,skip\ntable,dining_table,1.2,0.8,0.74,\n"


def square(west: float, south: float, side: float) -> Json:
    """A closed ring of degrees."""
    ring = [[west, south], [west + side, south], [west + side, south + side], [west, south + side]]
    return [[*ring, ring[0]]]


def feature(geometry: str, coordinates: Json, **tags: Json) -> Json:
    """A feature of GeoJSON."""
    shape = {"type": geometry, "coordinates": coordinates}
    return {"type": "Feature", "properties": tags, "geometry": shape}


INDOOR: Json = {
    "type": "FeatureCollection",
    "features": [
        feature("Polygon", square(8.0, 50.0, 1e-4), indoor="room", shop="books", level="0"),
        feature("Point", [8.00005, 50.0], door="yes", level="0"),
    ],
}
LAND: Json = {
    "type": "FeatureCollection",
    "features": [
        feature("Polygon", square(8.0, 50.0, 1e-3), landuse="residential"),
        feature("Polygon", square(8.0004, 50.0004, 1e-4), building="yes", height="9"),
        feature("LineString", [[7.999, 49.9999], [8.002, 49.9999]], highway="residential"),
    ],
}
CORNERS = [(0, 0), (0, 9), (9, 9), (9, 0)]
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
                        [[[0, 1, 2, 3]], [[4, 7, 6, 5]]]
                        + [[[k, k + 4, 4 + (k + 1) % 4, (k + 1) % 4]] for k in range(4)]
                    ],
                }
            ],
        }
    },
    "vertices": [[1000 * x, 1000 * y, z] for z in (0, 6000) for x, y in CORNERS],
}


def _city_line(name: str) -> Json:
    alone = {"b" + name: CITY["CityObjects"]["b"]}
    east = [[x + 20_000 * int(name), y, z] for x, y, z in CITY["vertices"]]
    return {"type": "CityJSONFeature", "id": "b" + name, "CityObjects": alone, "vertices": east}


CITY_LINES = "\n".join(
    json.dumps(line)
    for line in (CITY | {"CityObjects": {}, "vertices": []}, *map(_city_line, "0123"))
).encode()
IMDF: Json = {
    "type": "FeatureCollection",
    "features": [
        feature("Polygon", square(8.0, 50.0, 2e-4), category="unspecified", ordinal=0)
        | {"feature_type": "level", "id": "l"},
        feature("Polygon", square(8.0, 50.0, 1e-4), category="retail", level_id="l")
        | {"feature_type": "unit", "id": "u"},
        feature("Polygon", square(8.0001, 50.0, 1e-4), category="walkway", level_id="l")
        | {"feature_type": "unit", "id": "w"},
        feature("LineString", [[8.0001, 50.00004], [8.0001, 50.00006]], level_id="l")
        | {"feature_type": "opening", "id": "o"},
    ],
}
HOUSE = [[3, 3], [13, 3], [13, 11], [3, 11]]
BLOCKS: Json = [
    {
        "id": f"b{k}",
        "place": f"p{k % 3}",
        "place_kind": "village",
        "outline": [[0, 0], [60, 0], [60, 30], [0, 30]],
        "outline_on_street": [True, True, False, False],
        "houses": [{"polygon": [[x + 18 * n, y] for x, y in HOUSE], "levels": 2} for n in range(3)],
    }
    for k in range(4)
]
GROUPS: Json = {
    "format": "scenewright/groups",
    "version": 1,
    "rooms": 3,
    "cases": [
        {
            "function": "desk",
            "name": "desk",
            "width": 1.4,
            "depth": 1.4,
            "rooms": [8.0, 20.0],
            "members": [
                {"category": "desk", "x": 0.0, "y": -0.35, "size": [1.4, 0.7, 0.74]},
                {
                    "category": "office_chair",
                    "x": 0.0,
                    "y": 0.4,
                    "heading": 3.14,
                    "size": [0.5, 0.5, 0.9],
                },
            ],
        }
    ],
}
