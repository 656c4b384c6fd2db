"""Metallic-roughness materials of a glTF document, and the pictures of their textures."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.catalog import Material
from scenewright.formats.gltf.sheet import Sheet, draw_sheet
from scenewright.render.colour import linear_of
from scenewright.render.textures.pictures import color_picture, normal_picture, to_webp
from scenewright.render.textures.table import Texture, texture_of

Json = dict[str, Any]
LINEAR, MIPMAPPED, REPEAT = 9729, 9987, 10497
NEAREST = 9728
SAMPLERS: list[Json] = [
    {"magFilter": LINEAR, "minFilter": MIPMAPPED, "wrapS": REPEAT, "wrapT": REPEAT},
    {"magFilter": NEAREST, "minFilter": NEAREST, "wrapS": REPEAT, "wrapT": REPEAT},
]
PNG = b"\x89PNG"
WEBP = "EXT_texture_webp"


class MaterialTable(NamedTuple):
    """Materials, and the files of the textures they refer to, with a name each."""

    materials: list[Json]
    pictures: dict[str, bytes]

    def document(self, views: list[Json], buffer: bytes, webp: bool = False) -> tuple[Json, bytes]:
        """The parts of a document, with the pictures added to its buffer and ``views``; as
        ``webp``, half as large."""
        found: Json = {"materials": self.materials}
        images: list[Json] = []
        for name, drawn in self.pictures.items():
            content = to_webp(drawn) if webp else drawn
            place = {"buffer": 0, "byteOffset": len(buffer), "byteLength": len(content)}
            kind = "image/png" if content.startswith(PNG) else "image/jpeg"
            kind = "image/webp" if webp else kind
            images.append({"name": name, "bufferView": len(views), "mimeType": kind})
            views.append(place)
            buffer += content + b"\0" * (-len(content) % 4)
        if images:
            small = [content.startswith(PNG) for content in self.pictures.values()]
            sources: list[Json] = [{"source": k} for k in range(len(images))]
            found["textures"] = [
                {"sampler": int(png)} | ({"extensions": {WEBP: source}} if webp else source)
                for png, source in zip(small, sources, strict=True)
            ]
            found |= {"samplers": SAMPLERS[: 1 + any(small)], "images": images}
        return found, buffer


def list_materials(materials: Iterable[Material | None], sheet: Sheet) -> MaterialTable:
    """The materials in glTF's words, with their textures, each once; None is the sheet."""
    pictures: dict[str, bytes] = {}
    listed = [
        _sheet_material(sheet, pictures) if one is None else _material(one, pictures)
        for one in materials
    ]
    return MaterialTable(listed, pictures)


def _sheet_material(sheet: Sheet, pictures: dict[str, bytes]) -> Json:
    """All woods and plain colours as one material; ``extras`` names them from above."""
    drawn = draw_sheet(sheet)
    surface: Json = {
        "baseColorTexture": {"index": _index(pictures, "sheet", drawn.color)},
        "metallicRoughnessTexture": {"index": _index(pictures, "sheet surfaces", drawn.surface)},
    }
    names = [material.name for material in (*sheet.bands, *sheet.cells)]
    found: Json = {"name": "sheet", "pbrMetallicRoughness": surface, "extras": {"holds": names}}
    if drawn.glow:
        found["emissiveTexture"] = {"index": _index(pictures, "sheet glow", drawn.glow)}
        found["emissiveFactor"] = [1.0, 1.0, 1.0]
    return found


def _material(material: Material, pictures: dict[str, bytes]) -> Json:
    """Plain metallic-roughness; sRGB colours become linear."""
    row = texture_of(material.name)
    linear = linear_of(np.array(material.color))
    surface: Json = {
        "baseColorFactor": [],
        "metallicFactor": float(material.metallic),
        "roughnessFactor": float(material.roughness),
    }
    found: Json = {"name": material.name, "pbrMetallicRoughness": surface}
    if row is not None:
        picture = color_picture(row.name)
        linear = np.minimum(linear * picture.factor, 1.0)
        surface["baseColorTexture"] = {"index": _index(pictures, row.name, picture.content)}
        found |= _relief(row, pictures)
    shares = [round(float(value), 5) for value in linear]
    surface["baseColorFactor"] = [*shares, float(material.opacity)]
    if material.opacity < 1:
        found["alphaMode"] = "BLEND"
    if material.emission > 0:
        glow = min(float(material.emission), 1.0)
        found["emissiveFactor"] = [round(value * glow, 5) for value in shares]
    return found


def _relief(row: Texture, pictures: dict[str, bytes]) -> Json:
    if not row.relief:
        return {}
    index = _index(pictures, f"{row.name} normals", normal_picture(row.name))
    return {"normalTexture": {"index": index}}


def _index(pictures: dict[str, bytes], name: str, content: bytes) -> int:
    pictures.setdefault(name, content)
    return list(pictures).index(name)
