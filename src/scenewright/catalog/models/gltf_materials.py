"""Materials of a glTF file: base colours, with textures and vertex colours looked up by face."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models import colours
from scenewright.catalog.models import gltf_accessors as gltf_numbers
from scenewright.catalog.models.gltf_accessors import Store, pick_row
from scenewright.catalog.models.gltf_record import GltfMaterial, Primitive, Roughness, TextureInfo
from scenewright.catalog.models.model import PLAIN, clean, part_of
from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_PICTURES = 64
FAINTEST = 0.05


class SurfacePaint(NamedTuple):
    """A material and, if it has a texture, its pixels, its set of coordinates and how those are
    moved (2, 3)."""

    material: Material
    pixels: colours.Pixels | None = None
    layer: int = 0
    shift: Floats = np.eye(3)[:2]


def paints(held: Store) -> tuple[SurfacePaint, ...]:
    """Every material of the document; few pictures are kept, each once."""
    pictures: dict[int, colours.Pixels | None] = {}
    return tuple(_paint(held, coat, pictures) for coat in held.document.materials)


def assign_materials(
    held: Store, primitive: Primitive, points: Floats, faces: Ints, coats: tuple[SurfacePaint, ...]
) -> list[Part]:
    """The faces of a primitive in their material, or in several where colours differ.

    ``points`` (n, 3) in metres, ``faces`` (m, 3).
    """
    paint = SurfacePaint(PLAIN)
    if primitive.material is not None:
        paint = pick_row(coats, primitive.material, "materials")
    shades = _shades(held, primitive, len(points), faces, paint)
    if shades is None or not len(faces):
        return [part_of(paint.material, points, faces)]
    return colours.by_colour(paint.material, points, faces, shades)


def _shades(
    held: Store, primitive: Primitive, count: int, faces: Ints, paint: SurfacePaint
) -> Floats | None:
    """Colours of the faces, None if the material's own will do."""
    spots = primitive.attributes.get(f"TEXCOORD_{paint.layer}")
    tints = primitive.attributes.get("COLOR_0")
    found: Floats | None = None
    if paint.pixels is not None and spots is not None:
        places = gltf_numbers.floats(held, spots, 2)
        _check_length(places, count)
        moved = places @ paint.shift[:, :2].T + paint.shift[:, 2]
        found = colours.looked_up(paint.pixels, moved[faces]) * np.array(paint.material.color)
    if tints is not None:
        kind = pick_row(held.document.accessors, tints, "accessors").type
        own = gltf_numbers.floats(held, tints, 4 if kind == "VEC4" else 3)[:, :3]
        _check_length(own, count)
        light = np.clip(np.nan_to_num(own)[faces].mean(1), 0.0, 1.0) ** (1 / 2.2)
        found = light * (np.array(paint.material.color) if found is None else found)
    return found


def _check_length(rows: Floats, count: int) -> None:
    if len(rows) != count:
        raise InputError(
            f"{len(rows)} texture places or colours for {count} corners", "export the model again"
        )


def _paint(
    held: Store, coat: GltfMaterial, pictures: dict[int, colours.Pixels | None]
) -> SurfacePaint:
    look = coat.pbrMetallicRoughness or Roughness()
    opacity = min(max(look.baseColorFactor[3], FAINTEST), 1.0)
    metallic = 0.0 if look.metallicRoughnessTexture else min(max(look.metallicFactor, 0.0), 1.0)
    material = Material(
        clean(coat.name, "plain"),
        colours.srgb(look.baseColorFactor),
        min(max(look.roughnessFactor, 0.0), 1.0),
        metallic,
        opacity if coat.alphaMode == "BLEND" else 1.0,
    )
    info = look.baseColorTexture
    if info is None:
        return SurfacePaint(material)
    source = pick_row(held.document.textures, info.index, "textures").source
    if source is None:
        return SurfacePaint(material)
    if source not in pictures:
        pictures[source] = _pixels(held, source) if len(pictures) < MOST_PICTURES else None
    pixels = pictures[source]
    if pixels is None:
        return SurfacePaint(replace(material, color=_replace_texture_tone(material.color)))
    return SurfacePaint(material, pixels, *_read_transform(info))


def _pixels(held: Store, number: int) -> colours.Pixels | None:
    image = pick_row(held.document.images, number, "images")
    if image.uri is not None:
        content = gltf_numbers.fetch_bytes(image.uri, held.beside, colours.MOST_BYTES)
    elif image.bufferView is not None:
        buffer, start, length, _ = gltf_numbers.view(held, image.bufferView)
        content = buffer[start : start + length]
    else:
        content = None
    return colours.picture(content) if content else None


def _read_transform(info: TextureInfo) -> tuple[int, Floats]:
    """The set of coordinates and the extension KHR_texture_transform: scaled, turned, shifted."""
    given = info.extensions.get("KHR_texture_transform")
    if not isinstance(given, dict):
        return info.texCoord, np.eye(3)[:2]
    layer = given.get("texCoord", info.texCoord)
    x, y = _pair(given.get("offset"), 0.0)
    u, v = _pair(given.get("scale"), 1.0)
    angle = given.get("rotation")
    turn = _modest(angle, 0.0)
    cos, sin = np.cos(turn), np.sin(turn)
    shift = np.array([[cos * u, sin * v, x], [-sin * u, cos * v, y]])
    return layer if isinstance(layer, int) else 0, shift


def _pair(given: object, otherwise: float) -> tuple[float, float]:
    if isinstance(given, list) and len(given) == 2:
        first, second = given
        return _modest(first, otherwise), _modest(second, otherwise)
    return otherwise, otherwise


def _modest(given: object, otherwise: float) -> float:
    """A number of a size that makes sense for shares of a picture."""
    return float(given) if isinstance(given, int | float) and abs(given) < 1e6 else otherwise


def _replace_texture_tone(colour: tuple[float, float, float]) -> tuple[float, float, float]:
    """The colour over :data:`PLAIN`, for what had a texture that is missing."""
    red, green, blue = (own * plain for own, plain in zip(colour, PLAIN.color, strict=True))
    return red, green, blue
