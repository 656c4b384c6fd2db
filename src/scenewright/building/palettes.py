"""Palettes: what colours a home of a style is painted in, and how one is chosen.

Six palettes a style, each nine colours; the others follow from them (a duvet is the sofa's cloth
mixed with white). Models name materials (:mod:`scenewright.catalog.assets.materials`); a palette
says which material replaces which, so that every model, whatever its style, goes with
the home it stands in.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import NamedTuple
from zlib import crc32

from scenewright.building.finishes import PLASTER, WOOD_FLOOR
from scenewright.building.regions import REGIONS, region_of
from scenewright.catalog.assets import materials as m
from scenewright.core.catalog import Material, Part

Colour = tuple[float, float, float]
MODERN = "modern"
"""The style whose furniture is the usual one of every kind."""
STEP = 5
"""Places on in the list of palettes from one seed to the next; prime to their number, and no
multiple of the number of styles, so that neighbours are of different styles."""

STYLES: dict[str, str] = {
    MODERN: "contemporary plain",
    "nordic": "scandinavian scandi hygge",
    "classic": "traditional english elegant",
    "industrial": "loft factory urban",
    "japandi": "japanese zen minimal minimalist wabi-sabi",
    "retro": "midcentury mid-century sixties vintage",
    "boho": "bohemian eclectic ethnic",
}
"""The styles, and other words for each."""


class Palette(NamedTuple):
    """Nine colours of a home as hexadecimal sRGB: ``wood`` and ``dark`` wood, the ``cloth`` of
    sofas, the ``second`` cloth of armchairs, three accents (``first``, ``other``, ``deep``),
    kitchen ``fronts`` and walls; ``hues`` are the words that ask for it."""

    style: str
    name: str
    hues: str
    wood: str
    dark: str
    cloth: str
    second: str
    first: str
    other: str
    deep: str
    fronts: str
    wall: str

    @property
    def id(self) -> str:
        """Its name with its style's.

        >>> PALETTES["nordic/fjord"].id
        'nordic/fjord'
        """
        return f"{self.style}/{self.name}"


_ROWS = """
modern     sage     green       c7a880 6e4a33 aba194 87997f c0704f d4a14a 334766 99a88f f4f1ec
modern     slate    grey,blue   b79b78 574334 8d9297 5d7285 d08c4a e2c27a 2f4156 5c6b78 f1f2f2
modern     clay     red,orange  cdaf88 71492f c9b9a5 b06a4c a84b32 dfae6b 5b3a33 b98a70 f6f0e8
modern     night    blue,black  8e6f52 3c2c22 4a5568 b8a88f c9a227 a34a3a 1c2637 2c3a4c efede8
modern     linen    beige,white d8c3a0 8a6a4c d9cfc0 b9b09c c2a27c e0cda4 7a6f60 e4ddcf faf7f1
modern     moss     green       a9855c 55392a 73785a b39a6b c98f3d dcc68a 39442f 57623f f2f0e6
nordic     fjord    blue        dcc6a0 9a744e c9d0d4 7f9bb0 2f5d7c e3c567 24405a e9ecec f5f7f7
nordic     birch    white       e6d4b2 a88460 e3ddd2 b8b3a8 d98e73 e8d08f 5d6b70 f3f0ea fbfaf7
nordic     lichen   green       d8c49a 927049 b9c2b0 87a08a d9a441 efe0b0 3f5a4d b5c4b1 f4f6f0
nordic     blush    pink        e0caa6 a27b58 dcc3bb c48f88 b4564f f0d9a8 6d4a52 ecdcd5 faf4f1
nordic     storm    grey        cdb48c 7d5d40 8b949b 5f6b73 e0a13b d7dbdd 2b343b 9aa4ab f1f3f4
nordic     rowan    red         d9bf94 8d6443 cfc6b8 a9b3b0 b8402f e6b45a 31525b dfd9cb f7f4ee
classic    library  green,brown 9c6b43 5a3320 5f6f5a 7b2e2e 8c3b2e c29b4e 223a30 33493c efe8d8
classic    pearl    cream,white b58b60 6b4229 e2d6c2 b9a58a 9f7f5a d9c08c 5e5346 ece4d3 f8f3e7
classic    royal    blue        99673f 4f2d1c 34486f b79a6a c09a3e e4d3a4 1d2a4a 2f4468 f1ece2
classic    rose     pink,red    a9784d 66402a c9a49a 8f4a4f a33e46 e0bf8d 55303a d8c4b8 f7eee8
classic    duck     blue,green  a5734a 5f3923 7d9a9a c2b08e b6743a e3cd9b 27474d 86a3a2 f3f1e8
classic    claret   red         8f5c3a 48271a 6e2f35 b89b74 c49440 dcc9a5 33181d 5b2b30 f2e9dd
industrial brick    red,brown   a67c52 4c3526 7b6a5b 5a5a58 a8482f c88b3a 2b2b2c 4a4a4a e4ded6
industrial steel    grey        9a8266 44362c 6f757a 8a6a4c c56a33 d8b36a 23282c 5f676c e6e7e7
industrial rust     orange      b0835a 553a29 93725a 6b625a bf5a26 d99a45 30302f 7c4a31 e9e1d8
industrial petrol   blue,green  a98660 4a3729 3f5c63 8f7a62 c97b34 d6b677 1b3238 2c4a50 e7e6e1
industrial soot     black       8b6e52 352a22 4b4a49 77695c b57f42 cfc5b5 171718 262627 dedbd6
industrial khaki    green       a98a62 4f3d2b 767358 8c7a5f b9622f d3ae5f 30352a 595c46 e8e5da
japandi    ash      beige       cbb592 7c6248 d3c9b8 a79f8e a2684d c9b184 4d4a44 c9bba3 f3efe6
japandi    matcha   green       c6b08a 75593e c4c4b0 8f9a77 7a8b5a d6c9a0 3d4636 a5ad8c f2f1e7
japandi    indigo   blue        c9b491 6f563f c8c6c0 5b6b86 3c4f78 d1bd95 232f4a 8791a0 f2f1ed
japandi    ink      black,grey  a68c6a 3f332a a9a49b 6b6862 8b4a3b c4b08a 201f1f 45423e efece5
japandi    plum     red,pink    c0a684 6b5140 cbbdb4 927680 7d4553 d4bd98 40303a a9958f f3ede9
japandi    straw    yellow      c8b088 7a6040 d9cfba a8a088 a8813f d9c79a 4f4838 cfc2a4 f5f1e7
retro      teal     blue,green  a8713f 6b3f22 2f7a7a d08a2e d2691e e8b33f 1f4b4e 3e8581 f5efe0
retro      tangerine orange     b07a45 70431f d9a066 5f7a6a cf5a24 eabf4e 54382a d98b4a f7eedd
retro      olive    green       a5753f 643c1f 7f7b3e c07a35 c9572e e2b748 3a3a1e 8b8b4f f3eedb
retro      mustard  yellow      b37f47 6d4424 c99a2e 4f6f78 b8502d f0cf6a 27424a d6b04a f8f1dc
retro      cherry   red         9c5f36 57301b a63d33 3f6a6a d77f34 ecc65c 2a2f3a b0483c f6ecdf
retro      lagoon   blue        ab7843 6a4223 5b93a8 e0a95a dd6a45 f0d07a 1f3f56 7fb0bd f3f2e6
boho       desert   orange      c79a66 80553a d9b99a b5694a c1572f e0a84a 5e3a4a d2a27c f8efe2
boho       jungle   green       b98f5c 6e4a2e 8ba07a 3f6b52 cf7a3a e3c25f 1f4236 6d8a66 f5f2e2
boho       bazaar   red,pink    bf8d5a 744a30 b5485a 3f6f7c d9822b ecc04f 55264a a8566a f9eee4
boho       sea      blue        cda874 86613f 9fc0c2 e3d3b0 2f7f8c eac77c 1c4a63 b6d3d0 f4f6f0
boho       sunset   yellow      c99a62 7b5236 e3b778 c76b5a d2503f f2cf63 6a2f4f e0b06a fbf1df
boho       terra    brown       b98459 69422b b79478 8d6a4f a84f30 d3a256 46302a a57a5c f5ebdf
"""

PALETTES: dict[str, Palette] = {
    row.id: row for row in (Palette(*line.split()) for line in _ROWS.strip().splitlines())
}
"""All palettes, by style and name."""


def colour_of(code: str) -> Colour:
    """The colour of a hexadecimal code.

    >>> colour_of("ff8000")
    (1.0, 0.502, 0.0)
    """
    red, green, blue = (round(int(code[k : k + 2], 16) / 255, 3) for k in (0, 2, 4))
    return red, green, blue


def mix(one: Colour, other: Colour, share: float) -> Colour:
    """A colour with so large a share of another.

    >>> mix((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 0.25)
    (0.25, 0.25, 0.25)
    """
    red, green, blue = (
        round((1 - share) * a + share * b, 3) for a, b in zip(one, other, strict=True)
    )
    return red, green, blue


WARM: Colour = (0.97, 0.96, 0.93)
SANDED: Colour = (0.74, 0.67, 0.57)


@cache
def list_coats(palette: Palette) -> Mapping[Material, Material]:
    """Which material replaces which in homes of a palette.

    >>> coats = list_coats(PALETTES["nordic/fjord"])
    >>> coats[m.OAK].name, coats[m.OAK].roughness == m.OAK.roughness
    ('oak, nordic fjord', True)
    """
    wood, dark, cloth, second, first, other, deep, fronts, wall = map(colour_of, palette[3:])
    colours = {
        m.OAK: wood,
        m.PINE: mix(wood, WARM, 0.3),
        m.OAK_DARK: mix(wood, dark, 0.5),
        m.WALNUT: dark,
        m.FABRIC: cloth,
        m.FABRIC_LIGHT: mix(cloth, WARM, 0.35),
        m.DUVET: mix(cloth, WARM, 0.45),
        m.WOOL: mix(cloth, WARM, 0.6),
        m.SHEER: mix(wall, cloth, 0.35),
        m.SAGE_FABRIC: second,
        m.TERRACOTTA: first,
        m.CLAY: mix(first, dark, 0.2),
        m.MUSTARD: other,
        m.NAVY: deep,
        m.SAGE: fronts,
        m.CREAM: mix(fronts, WARM, 0.72),
        m.GREIGE: mix(fronts, WARM, 0.5),
        m.LEATHER: mix(dark, first, 0.35),
        m.STONE: mix(mix(wood, deep, 0.3), WARM, 0.72),
        PLASTER: wall,
        WOOD_FLOOR: mix(mix(wood, dark, 0.12), SANDED, 0.5),
    }
    return {material: _coat(material, colour, palette) for material, colour in colours.items()}


def _coat(material: Material, colour: Colour, palette: Palette) -> Material:
    rest = (material.roughness, material.metallic, material.opacity, material.emission)
    return Material(f"{material.name}, {palette.style} {palette.name}", colour, *rest)


def paint(parts: tuple[Part, ...], palette: str) -> tuple[Part, ...]:
    """Parts in the colours of a palette by its id, in the finishes of the region that stands after
    it; as they are for none.

    >>> chair = (Part(m.OAK, None, None), Part(m.STEEL, None, None))
    >>> [part.material.name for part in paint(chair, "retro/teal")]
    ['oak, retro teal', 'brushed steel']
    """
    name, _, region = palette.partition(" ")
    if name not in PALETTES:
        return parts
    coats = list_coats(PALETTES[name])
    if region in REGIONS:
        coats = {**coats, **REGIONS[region].finishes}
    return tuple(
        replace(part, material=coats[part.material]) if part.material in coats else part
        for part in parts
    )


def style_of(words: str) -> str:
    """The style some words ask for; empty if none.

    >>> style_of("Scandinavian, light"), style_of("cosy")
    ('nordic', '')
    """
    asked = set(words.casefold().replace(",", " ").replace("/", " ").split())
    return next((k for k, also in STYLES.items() if asked & {k, *also.split()}), "")


def answers(words: str) -> bool:
    """Whether some words name a style, a region, a palette or its hue.

    >>> answers("Scandinavian, light"), answers("fjord"), answers("cosy")
    (True, True, False)
    """
    asked = set(words.casefold().replace(",", " ").replace("/", " ").split())
    hues = {word for row in PALETTES.values() for word in (row.name, *row.hues.split(","))}
    return bool(style_of(words) or region_of(words) or asked & hues)


def choose_palette(style: str, colour: str, name: str, seed: int) -> Palette:
    """The palette of a home: of the style and hue its words ask for, among those by its name and
    seed. A style may name its palette (``nordic fjord``).

    >>> [choose_palette("", "", "home", seed).id for seed in range(3)]
    ['boho/sunset', 'japandi/straw', 'classic/library']
    >>> choose_palette("japandi", "dark blue", "home", 0).name
    'indigo'
    """
    asked = style_of(style)
    words = set(f"{style} {colour}".casefold().replace(",", " ").replace("/", " ").split())
    known = [row for row in PALETTES.values() if not asked or row.style == asked]
    hued = [row for row in known if words & {row.name, *row.hues.split(",")}]
    named = [row for row in known if row.name in words]
    rows = named or hued or known
    styles = list(dict.fromkeys(row.style for row in rows))
    each = [[row for row in rows if row.style == one] for one in styles]
    place = crc32(name.encode()) + STEP * seed
    some = each[place % len(styles)]
    return some[place // len(styles) % len(some)]
