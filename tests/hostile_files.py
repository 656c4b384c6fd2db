"""Files nobody should send, drawn by a seed: archives, XML, models; and the worst there are."""

from __future__ import annotations

import io
import json
import random
import struct
import zipfile
from collections.abc import Callable

Draw = random.Random
Files = dict[str, bytes]

XML = """<?xml version='1.0' encoding='UTF-8'?>
<home version='7000' wallHeight='250'>
<level id='l' name='Ground' elevation='0' floorThickness='12' height='250'/>
<room level='l' name='Bedroom'><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/>
<point x='0' y='300'/></room>
<wall id='w' level='l' xStart='0' yStart='0' xEnd='400' yEnd='0' height='250' thickness='10'/>
<doorOrWindow level='l' name='Door' x='200' y='0' width='90' depth='10' height='210'/>
<pieceOfFurniture level='l' name='Bed' x='200' y='200' width='90' depth='200' height='50'
 movable='false'/>
<furnitureGroup level='l' name='Pair'><pieceOfFurniture name='Table' x='100' y='100' width='60'
 depth='60' height='70'/></furnitureGroup></home>"""
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
STL = (
    "solid s\n"
    + "".join(
        "facet normal 0 0 1\nouter loop\n"
        f"{''.join(f'vertex {x} {y} {z}' + chr(10) for x, y, z in t)}"
        "endloop\nendfacet\n"
        for t in (
            ((0, 0, 0), (0, 1, 0), (1, 0, 0)),
            ((0, 0, 0), (1, 0, 0), (0, 0, 1)),
            ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
            ((0, 1, 0), (0, 0, 0), (0, 0, 1)),
        )
    )
    + "endsolid s\n"
)
TABLE = (
    "id#1=x#table\nname#1=Table\ncategory#1=Tables\nmodel#1=/kit/table.obj\nwidth#1=100\n"
    "depth#1=60\nheight#1=74\nmovable#1=true\ndoorOrWindow#1=false\n"
)
HOSTILE = ("nan", "inf", "-1", "1e999", "1e38", "0", "x", "", "9" * 400, "../../x", "%00")


def zipped(entries: Files) -> bytes:
    """A zip archive of some entries."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            archive.writestr(name, content)
    return stream.getvalue()


def glb() -> bytes:
    """A tetrahedron as binary glTF."""
    points = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
    faces = struct.pack("<12H", 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3)
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": [0, 0, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [0, 0, 0],
                "max": [1, 1, 1],
            },
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 24},
        ],
        "buffers": [{"byteLength": 72}],
    }
    return glb_of(json.dumps(document).encode(), points + faces)


def glb_of(document: bytes, binary: bytes) -> bytes:
    """The two parts of a binary glTF put together."""
    document += b" " * (-len(document) % 4)
    body = struct.pack("<II", len(document), 0x4E4F534A) + document
    body += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(body)) + body


def _text(source: str, draw: Draw) -> bytes:
    """A text with numbers or names exchanged, cut off, doubled or not of its coding."""
    parts = source.replace("'", " ' ").split(" ")
    for _ in range(draw.randint(1, 4)):
        parts[draw.randrange(len(parts))] = draw.choice(HOSTILE)
    data = " ".join(parts).replace(" ' ", "'").encode()
    return _bytes(data, draw) if draw.random() < 0.5 else data


def _numbers(source: str, draw: Draw) -> bytes:
    """A text with some of its numbers exchanged."""
    found = [i for i, letter in enumerate(source) if letter.isdigit()]
    for at in sorted(draw.sample(found, min(draw.randint(1, 5), len(found))), reverse=True):
        source = source[:at] + draw.choice(HOSTILE) + source[at + 1 :]
    return source.encode()


def _bytes(data: bytes, draw: Draw) -> bytes:
    """Bytes cut off, turned over, doubled, or with rubbish in them."""
    kind, changed = draw.randrange(4), bytearray(data)
    if kind == 0:
        return data[: draw.randrange(len(data))]
    if kind == 1:
        for _ in range(draw.randint(1, 40)):
            changed[draw.randrange(len(changed))] = draw.randrange(256)
    if kind == 2:
        at = draw.randrange(len(changed))
        changed[at:at] = draw.randbytes(draw.randint(1, 3000))
    if kind == 3:
        changed += changed[draw.randrange(len(changed)) :]
    return bytes(changed)


def _either(source: str, draw: Draw) -> bytes:
    return draw.choice((_text, _numbers))(source, draw)


def _sh3d(draw: Draw) -> bytes:
    if draw.random() < 0.3:
        return _bytes(zipped({"Home.xml": XML.encode()}), draw)
    return zipped({"../../x": b"x", "Home.xml": _either(XML, draw)})


def _sh3f(draw: Draw) -> bytes:
    kind = draw.randrange(3)
    table = _either(TABLE, draw) if kind == 0 else TABLE.encode()
    body = _either(OBJ, draw) if kind == 1 else OBJ.encode()
    whole = zipped({"PluginFurnitureCatalog.properties": table, "kit/table.obj": body})
    return _bytes(whole, draw) if kind == 2 else whole


def _glb(draw: Draw) -> bytes:
    sound = glb()
    if draw.random() < 0.4:
        return _bytes(sound, draw)
    length = struct.unpack_from("<I", sound, 12)[0]
    return glb_of(_numbers(sound[20 : 20 + length].decode(), draw), sound[28 + length :])


FILES: dict[str, tuple[str, Callable[[Draw], bytes]]] = {
    "home": (".sh3d", _sh3d),
    "xml": (".xml", lambda draw: _either(XML, draw)),
    "library": (".sh3f", _sh3f),
    "glb": (".glb", _glb),
    "obj": (".obj", lambda draw: _either(OBJ, draw)),
    "stl": (".stl", lambda draw: _either(STL, draw)),
}
"""Broken files by name: their suffix, and what draws one."""


def _rooms(count: int) -> str:
    """A brief of as many rooms in a grid."""
    ring = [(0, 0), (2, 0), (2, 2), (0, 2)]
    return json.dumps(
        {
            "rooms": [
                {"outline": [[x + 2.1 * (k % 100), y + 2.1 * (k // 100)] for x, y in ring]}
                for k in range(count)
            ]
        }
    )


def _laughs() -> bytes:
    levels = "".join(f"<!ENTITY a{k} '{f'&a{k - 1};' * 10}'>" for k in range(1, 12))
    return (
        f"<?xml version='1.0'?><!DOCTYPE home [<!ENTITY a0 'ha'>{levels}]>"
        "<home version='7000'><room name='&a11;'/></home>"
    ).encode()


def _outside(what: str) -> bytes:
    return (
        f"<?xml version='1.0'?><!DOCTYPE home [<!ENTITY x SYSTEM '{what}'>]>"
        "<home version='7000'><room name='&x;'/></home>"
    ).encode()


def _ring(count: int) -> str:
    return json.dumps({"rooms": [{"outline": [[k % 7, k] for k in range(count)]}]})


def worst() -> Files:
    """The files most costly to be fooled by, each with the name it is read under."""
    blank = b"<?xml version='1.0'?><home version='7000'>" + b" " * 300_000_000 + b"</home>"
    groups = "<furnitureGroup name='g'>" * 50_000
    vast = json.loads(glb()[20 : 20 + struct.unpack_from("<I", glb(), 12)[0]])
    vast["accessors"][0] |= {"count": 2**31 - 1}
    loop = json.loads(json.dumps(vast))
    loop["accessors"][0]["count"], loop["nodes"][0]["children"] = 4, [0]
    binary = glb()[-72:]
    return {
        "zip-bomb.sh3d": zipped({"Home.xml": blank}),
        "zip-bomb.sh3f": zipped(
            {
                "PluginFurnitureCatalog.properties": TABLE.encode(),
                "kit/table.obj": b"#" * 300_000_000,
            }
        ),
        "laughs.xml": _laughs(),
        "laughs.sh3d": zipped({"Home.xml": _laughs()}),
        "outside.xml": _outside("file:///etc/passwd"),
        "network.xml": _outside("http://192.0.2.1/x"),
        "climbing.sh3f": zipped(
            {
                "PluginFurnitureCatalog.properties": TABLE.replace(
                    "/kit/table.obj", "/../../etc/passwd"
                ).encode()
            }
        ),
        "deep.xml": f"<home version='7000'>{groups}".encode(),
        "deep.json": b'{"rooms":' + b"[" * 3_000_000,
        "deep.geojson": b'{"type":"FeatureCollection","features":' + b"[" * 1_000_000,
        "rooms.json": _rooms(10_000).encode(),
        "corners.json": _ring(200_000).encode(),
        "numbers.json": b'{"rooms": [{"outline": [[' + b"9" * 3_000_000 + b", 0]]}]}",
        "vast.glb": glb_of(json.dumps(vast).encode(), binary),
        "loop.glb": glb_of(json.dumps(loop).encode(), binary),
        "vast.stl": b"\0" * 80 + struct.pack("<I", 2**32 - 1) + b"\0" * 100,
        "faces.obj": (OBJ + "f " + " ".join("1" for _ in range(500_000))).encode(),
        "far.obj": (OBJ + "f 1 2 99999999999999999999\n").encode(),
        "cities.cityjson": json.dumps(
            {
                "type": "CityJSON",
                "version": "1.1",
                "vertices": [[0, 0, 0]] * 9,
                "CityObjects": {
                    str(k): {
                        "type": "Building",
                        "geometry": [
                            {"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2]]] * 20}
                        ],
                    }
                    for k in range(5000)
                },
            }
        ).encode(),
        "features.geojson": json.dumps(
            {
                "type": "FeatureCollection",
                "features": [
                    {
                        "type": "Feature",
                        "properties": {"building": "yes"},
                        "geometry": {
                            "type": "Polygon",
                            "coordinates": [
                                [
                                    [8 + k * 1e-5, 50],
                                    [8 + k * 1e-5, 50.1],
                                    [8.1, 50],
                                    [8 + k * 1e-5, 50],
                                ]
                            ],
                        },
                    }
                    for k in range(20_000)
                ],
            }
        ).encode(),
    }
