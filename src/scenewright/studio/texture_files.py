"""Textures as the page gets them: pictures by key, and how they are laid."""

from __future__ import annotations

import io
from functools import lru_cache

from PIL import Image

from scenewright.render.textures.pictures import color_picture, normal_picture
from scenewright.render.textures.table import TEXTURES, Texture
from scenewright.studio.shapes import Json, key_of

QUALITY = 72
RELIEF = "-relief"
"""How names of pictures of normals end."""


def describe_texture(row: Texture) -> Json:
    """Metres of a repeat (across, up), how it is laid, by what its colours are multiplied (linear
    light), and the addresses of its pictures."""
    down, across = row.metres
    told: Json = {"metres": [across, down], "laying": row.laying}
    told["factor"] = [round(value, 4) for value in color_picture(row.name).factor]
    told["picture"] = _address(row.name)
    return told | ({"relief": _address(row.name + RELIEF)} if row.relief else {})


def _address(name: str) -> str:
    return f"/texture/{name.replace(' ', '_')}.webp?{key_of(texture_file(name))}"


@lru_cache(maxsize=64)
def texture_file(name: str) -> bytes:
    """A picture of a texture by name, as WebP; empty if there is none.

    >>> texture_file("mosaic")[8:12], texture_file("x")
    (b'WEBP', b'')
    """
    plain = name.removesuffix(RELIEF)
    if plain not in TEXTURES:
        return b""
    made = normal_picture(plain) if plain != name else color_picture(plain).content
    kept = io.BytesIO()
    Image.open(io.BytesIO(made)).save(kept, "WEBP", quality=QUALITY, method=4)
    return kept.getvalue()
