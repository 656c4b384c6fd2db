"""Which material wears which texture: a row each, with its size in metres and in pixels."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache, lru_cache
from hashlib import blake2b
from pathlib import Path
from typing import Any, Literal, NamedTuple
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from scenewright.render.textures import generators as g
from scenewright.render.textures import noise
from scenewright.render.textures import printed as q
from scenewright.render.textures.kept import keep_arrays

Laying = Literal["grain", "upright", "whole"]
"""``grain``: the texture runs along the longest side of each board of a part; ``upright``: across
level lines of the face, so that courses of bricks and tiles lie level; ``whole``: once over each
board, as a picture fills its frame."""


@dataclass(frozen=True, slots=True)
class Texture:
    """One repeat: the generator and what it is given, metres and pixels (down, across), how it is
    laid, how strong its normal map is (0: none), and whether things wear it ``always``, be it
    a small share of them: what is printed or painted."""

    name: str
    draw: Callable[..., g.Surface]
    metres: tuple[float, float]
    pixels: tuple[int, int]
    laying: Laying = "grain"
    relief: float = 0.0
    always: bool = False
    settings: Mapping[str, Any] = field(default_factory=dict, hash=False)

    @property
    def banded(self) -> bool:
        """Whether it is a band of the sheet: woods and the backs of books."""
        return self.pixels == SHEET


class Baked(NamedTuple):
    """A texture as drawn: multipliers of linear colour (h, w, 3) of mean 1, and heights (h, w) in
    metres."""

    tone: NDArray[np.float32]
    height: NDArray[np.float32]


SHEET = (256, 1024)
WOOD = (0.5, 2.0)
_ROWS = (
    Texture("oak", g.wood, WOOD, SHEET),
    Texture("walnut", g.wood, WOOD, SHEET, settings={"rings": 18.0, "contrast": 0.2}),
    Texture("pine", g.wood, WOOD, SHEET, settings={"rings": 34.0, "pores": 0.3, "knots": 5}),
    Texture("teak", g.wood, WOOD, SHEET, settings={"rings": 30.0, "contrast": 0.16, "pores": 1.4}),
    Texture("planks", g.boards, (1.28, 2.56), (512, 1024), settings={"long": 1.28}),
    Texture(
        "wide boards", g.boards, (1.32, 3.6), (512, 1024), settings={"wide": 0.22, "long": 1.8}
    ),
    Texture("strips", g.boards, (0.84, 1.8), (256, 512), settings={"wide": 0.07, "long": 0.6}),
    Texture("herringbone", g.herringbone, (0.96, 0.96), (512, 512)),
    Texture(
        "deck",
        g.boards,
        (1.12, 2.4),
        (512, 1024),
        settings={"wide": 0.14, "long": 2.4, "joint": 0.006, "contrast": 0.15, "deep": 0.8},
    ),
    Texture("slabs", g.tiles, (1.2, 1.2), (512, 512), relief=1.0,
            settings={"wide": 0.6, "long": 0.6, "joint": 0.003, "contrast": 0.04}),
    Texture("tiles", g.tiles, (1.2, 1.2), (512, 512), relief=1.0),
    Texture("mosaic", g.tiles, (0.4, 0.4), (256, 256), relief=1.0,
            settings={"wide": 0.05, "long": 0.05, "joint": 0.003, "vary": 0.05}),
    Texture("terrazzo", g.terrazzo, (0.8, 0.8), (512, 512)),
    Texture("stone", g.stone, (1.0, 1.0), (256, 256)),
    Texture("concrete", g.rough, (2.0, 2.0), (256, 256), settings={"contrast": 0.05}),
    Texture("plaster", g.rough, (1.0, 1.0), (256, 256), "upright",
            settings={"contrast": 0.008, "grain": 0.012, "spot": 0.006}),
    Texture("weave", g.weave, (0.192, 0.192), (256, 256)),
    Texture("cane", g.weave, (0.16, 0.16), (256, 256), settings={"thread": 0.01}),
    Texture("leather", g.leather, (0.3, 0.3), (256, 256)),
    Texture("carpet", g.carpet, (0.6, 0.6), (256, 256)),
    Texture("bricks", g.bricks, (1.0, 1.0), (512, 512), "upright", 1.0),
    Texture("ashlar", g.bricks, (1.8, 2.4), (512, 512), "upright", 1.0,
            settings={"wide": 0.3, "long": 0.6, "vary": 0.09, "mortar": 0.06}),
    Texture("roof tiles", g.roof_tiles, (1.92, 1.92), (512, 512), "upright", 1.0),
    Texture("shingles", g.tiles, (1.6, 1.6), (512, 512), "upright", 0.8,
            settings={"wide": 0.2, "long": 0.2, "shift": 0.5, "vary": 0.12, "joint": 0.008}),
    Texture("boarding", g.boards, (1.28, 2.56), (512, 1024), "upright",
            settings={"long": 2.56, "joint": 0.008, "contrast": 0.14}),
    Texture("asphalt", g.grit, (0.8, 0.8), (512, 512), "upright", settings={"vary": 0.2}),
    Texture("gravel", g.grit, (1.2, 1.2), (512, 512), "upright",
            settings={"size": 0.024, "vary": 0.3}),
    Texture("paving", g.tiles, (1.6, 1.6), (512, 512), "upright",
            settings={"wide": 0.4, "long": 0.4, "joint": 0.008, "contrast": 0.05, "vary": 0.05}),
    Texture("setts", g.tiles, (0.96, 0.96), (512, 512), "upright", 0.8,
            settings={"wide": 0.12, "long": 0.16, "joint": 0.012, "shift": 0.5, "vary": 0.1,
                      "deep": 0.5}),
    Texture("grass", g.grass, (1.5, 1.5), (512, 512), "upright"),
    Texture("leaves", g.leaves, (1.5, 1.5), (256, 256), "upright"),
    Texture("labels", q.labels, (0.64, 0.96), (512, 1024), "upright", always=True),
    Texture("spines", q.spines, (0.32, 0.96), (256, 1024), "upright", always=True),
    Texture("landscape", q.landscape, (1.0, 1.0), (512, 512), "whole", always=True),
    Texture("evening", q.landscape, (1.0, 1.0), (512, 512), "whole", always=True,
            settings={"warm": 1.0}),
    Texture("fields", q.fields, (1.0, 1.0), (256, 256), "whole", always=True),
    Texture("strokes", q.strokes, (1.0, 1.0), (512, 512), "whole", always=True),
    Texture("sitter", q.ovals, (1.0, 1.0), (512, 512), "whole", always=True),
    Texture("fruit", q.ovals, (1.0, 1.0), (512, 512), "whole", always=True,
            settings={"rows": q.FRUIT}),
    Texture("poster", q.poster, (1.0, 1.0), (512, 512), "whole", always=True),
    Texture("tapestry", q.tapestry, (1.0, 1.0), (512, 512), "whole", always=True),
)  # fmt: skip
TEXTURES: dict[str, Texture] = {row.name: row for row in _ROWS}
"""All textures, by name."""

_WORN = """
oak          oak; door oak; threshold; smoked oak
walnut       walnut; dark timber
pine         pine
teak         teak
planks       oak floor
herringbone  oak floor/classic; oak floor/retro
wide boards  oak floor/nordic; oak floor/industrial
wide boards  pine floor; larch floor; hickory floor
strips       oak floor/japandi; cedar floor; hinoki floor
deck         deck floor
slabs        stone floor; slate floor; limestone floor
tiles        tile floor; terracotta floor; quarry tile floor
mosaic       turquoise tiles; mosaic floor; penny tile floor
terrazzo     terrazzo floor
stone        light stone; slate
concrete     concrete; slab concrete; screed floor
plaster      plaster; wall plaster; white render; pale rose render; ochre render
plaster      garden wall, white; lime wash; clay wall
weave        warm grey fabric; light fabric; linen; duvet; terracotta fabric; sage fabric
weave        denim; navy fabric; mustard fabric; charcoal fabric; burgundy velvet; sheer curtain
cane         rattan; tatami floor
leather      cognac leather
carpet       wool; carpet, grey; carpet, sand; carpet, sage; carpet floor
bricks       brick
ashlar       limestone; sandstone; grey masonry; garden wall, stone
roof tiles   clay tiles; glazed tiles
shingles     dark tiles; tile coping
boarding     larch wall
asphalt      asphalt; lane; parking; roofing felt
gravel       gravel path; yard
paving       pavement; garden walk
setts        cobbles
grass        grass; meadow; court lawn; park lawn
leaves       hedge; crown; light crown; needles
labels       printed card
spines       book spines
landscape    painting 1
evening      painting 2
fields       painting 3
strokes      painting 4
sitter       painting 5
fruit        painting 6
poster       printed board
tapestry     knotted carpet
"""
WORN: dict[str, str] = {
    material.strip(): line[:13].strip()
    for line in _WORN.strip().splitlines()
    for material in line[13:].split(";")
}
"""The texture of each material; ``material/style`` is worn in homes of a style."""


@lru_cache(4096)
def texture_of(material: str) -> Texture | None:
    """The texture a material wears by its name, None if it is plain. What stands after a comma is
    the palette of a home, a style may wear another texture, numbers at the end are tints.

    >>> texture_of("oak, retro teal").name, texture_of("oak floor, retro teal").name
    ('oak', 'herringbone')
    >>> texture_of("brick 3").name, texture_of("chrome")
    ('bricks', None)
    """
    plain, _, palette = material.rstrip("0123456789 ").partition(", ")
    style = palette.partition(" ")[0]
    for name in (material, f"{plain}/{style}", plain):
        if name in WORN:
            return TEXTURES[WORN[name]]
    return None


@lru_cache(maxsize=len(TEXTURES))
def bake(name: str) -> Baked:
    """Draw a texture once, its noise seeded by its name; kept in the user's cache folder.

    >>> tone, height = bake("mosaic")
    >>> tone.shape, tone.mean((0, 1)).round(2).tolist()
    ((256, 256, 3), [1.0, 1.0, 1.0])
    """
    row = TEXTURES[name]
    facts = (name, row.draw.__name__, row.metres, row.pixels, sorted(row.settings.items()))
    return Baked(*keep_arrays(f"{facts} {_version()}", lambda: _draw(row)))


def _draw(row: Texture) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    rng = np.random.default_rng(crc32(row.name.encode()))
    drawn = row.draw(rng, row.pixels, row.metres, **row.settings)
    tone = np.maximum(drawn.tone, 0.02)
    return (tone / tone.mean((0, 1))).astype(np.float32), drawn.height.astype(np.float32)


@cache
def _version() -> str:
    """Changes with what draws textures: their sources, and numpy."""
    texts = (Path(module.__file__ or "").read_bytes() for module in (g, q, noise))
    return blake2b(b"".join(texts) + np.__version__.encode(), digest_size=8).hexdigest()
