"""Materials of OBJ files (.mtl): the diffuse colour, opacity and texture of each name.

Wavefront Technologies, *MTL material format* (1995). Everything else is about light we do not
have; texture options are passed over.
"""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import NamedTuple

from scenewright.catalog.models.model import PLAIN, clean
from scenewright.core.catalog import Material
from scenewright.core.errors import InputError

MOST_BYTES = 16 * 2**20
MOST_MATERIALS = 10_000
FAINTEST = 0.05
"""Least opacity: exporters write 0 for what is meant to be seen."""


class MtlMaterial(NamedTuple):
    """A material and the name of its texture ('': none)."""

    material: Material
    texture: str = ""


def coats(content: bytes) -> dict[str, MtlMaterial]:
    """Every material by its name.

    >>> brick = coats(b"newmtl brick\\nKd 0.8 0.3 0.2\\nd 0.5\\nmap_Kd -s 1 1 1 old wall.png")["brick"]
    >>> brick.material.color, brick.material.opacity, brick.texture
    ((0.8, 0.3, 0.2), 0.5, 'old wall.png')
    """  # noqa: E501
    found: dict[str, MtlMaterial] = {}
    name = ""
    for number, line in enumerate(content.decode("utf-8", "replace").splitlines(), 1):
        word, _, rest = line.strip().partition(" ")
        if word == "newmtl":
            name = rest.strip()
            if len(found) >= MOST_MATERIALS:
                raise InputError(f"has more than {MOST_MATERIALS:,} materials", "simplify it")
            found[name] = MtlMaterial(replace(PLAIN, name=clean(name, "plain")))
        elif name in found:
            found[name] = _change_material(found[name], word, rest.split(), f"line {number}")
    return found


def _change_material(coat: MtlMaterial, word: str, values: list[str], place: str) -> MtlMaterial:
    if word == "Kd" and values and values[0] not in ("spectral", "xyz"):
        red, green, blue = (_share(value, place) for value in (values * 3)[:3])
        return coat._replace(material=replace(coat.material, color=(red, green, blue)))
    if word in ("d", "Tr") and values:
        given = _share(values[-1], place)
        opacity = given if word == "d" else 1.0 - given
        return coat._replace(material=replace(coat.material, opacity=max(opacity, FAINTEST)))
    if word.lower() == "map_kd":
        return coat._replace(texture=_texture(values))
    return coat


def _share(text: str, place: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        fault = f"'{clean(text)}' is not a number"
        raise InputError(fault, "export the materials again", place=place)
    return min(max(value, 0.0), 1.0)


def _texture(words: list[str]) -> str:
    """The file name after options like ``-s 1 1 1`` or ``-clamp on``.

    Of an absolute path, which was right where the model was made, only the last part counts.

    >>> _texture(["-s", "1", "1", "1", "C:\\\\wood\\\\oak", "1.png"])
    'oak 1.png'
    """
    k = 0
    while k < len(words) and words[k].startswith("-") and len(words[k]) > 1:
        k += 1
        while k < len(words) - 1 and _is_value(words[k]):
            k += 1
    name = " ".join(words[k:])
    if re.match(r"[A-Za-z]:[\\/]|[\\/]", name):
        return re.split(r"[\\/]+", name)[-1]
    return name


def _is_value(word: str) -> bool:
    return (
        word in ("on", "off", "r", "g", "b", "m", "l", "z")
        or word.lstrip("+-").replace(".", "", 1).isdigit()
    )
