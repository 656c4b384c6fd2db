"""What has an entity of its own in DXF: placed objects, rooms, their tags, dimensions."""

from __future__ import annotations

import re
from collections.abc import Hashable, Mapping
from typing import Any, NamedTuple

import numpy as np

from scenewright.drawing.dxf.entities import Canvas, draw_mark, plain_words
from scenewright.drawing.dxf.pens import inherit
from scenewright.drawing.dxf.place import local, local_of
from scenewright.drawing.marks import CopyMark, GroupMark, Mark, MeantMark, Stencil, Style
from scenewright.drawing.meanings import (
    DimensionMeaning,
    OpeningMeaning,
    PieceMeaning,
    RoomMeaning,
    TagMeaning,
)

ATTRIBUTES = ("ID", "KIND", "NAME", "SIZE", "PRICE")
"""Attributes of each placed object; the price is left to the user."""
METRES, MILLIMETRES = 6, 4
"""Codes of ``$INSUNITS``."""
LOOK = {
    "dimtxt": 1.3,
    "dimgap": 0.5,
    "dimtad": 1,
    "dimtsz": 0.8,
    "dimasz": 0.8,
    "dimdle": 1.2,
    "dimexo": 1.5,
    "dimexe": 1.0,
    "dimlunit": 2,
    "dimdsep": ord("."),
    "dimtih": 0,
    "dimtoh": 0,
    "dimclrd": 8,
    "dimclre": 8,
    "dimclrt": 8,
    "dimlwd": 13,
    "dimlwe": 13,
    "dimtmove": 2,
    "dimtix": 1,
}
"""Dimensions as plans have them: slashes, figures over the line; millimetres on paper."""
FIGURES = {METRES: {"dimdec": 2, "dimzin": 0}, MILLIMETRES: {"dimdec": 0, "dimzin": 8}}
"""Decimals by the unit of the file."""
WINDOWS = "A-GLAZ"
"""The layer of windows, which plans draw on that of doors."""
TAG, TAG_ATTRIBUTES = "ROOM_TAG", ("NAME", "AREA", "SIZE")
SMALL_TEXT = 0.05
"""Height in metres of the invisible attributes of objects."""
LONGEST_NAME = 80


class Blocks(NamedTuple):
    """The blocks of a document: those made of each symbol, and the symbols defined once of the
    drawing at hand. ``unit`` is units a metre."""

    document: Any
    made: dict[Hashable, str]
    stencils: Mapping[str, Stencil]
    unit: float


def draw_all(canvas: Canvas, blocks: Blocks, mark: Mark, style: Style) -> None:
    """Add a mark: what means something as an entity of that kind, the rest as drawn."""
    match mark:
        case GroupMark(marks, own):
            for part in marks:
                draw_all(canvas, blocks, part, inherit(style, own))
        case MeantMark(drawn, OpeningMeaning(kind)):
            layer = WINDOWS if kind == "window" else canvas.layer
            draw_mark(canvas._replace(layer=layer), drawn, style)
        case MeantMark(drawn, PieceMeaning() as piece):
            _insert(canvas, blocks, drawn, piece, style)
        case MeantMark(_, DimensionMeaning() as chain):
            _dimension(canvas, blocks, chain)
        case MeantMark(_, RoomMeaning() as room):
            _room(canvas, room)
        case MeantMark(drawn, TagMeaning() as tag):
            _tag(canvas, blocks, drawn, tag, style)
        case CopyMark():
            return
        case _:
            draw_mark(canvas, mark, style)


def _insert(canvas: Canvas, blocks: Blocks, drawn: Mark, piece: PieceMeaning, style: Style) -> None:
    """A block for each symbol, and an insert with its attributes for each object."""
    name = blocks.made.get(piece.symbol)
    if name is None:
        name = _free_name(blocks.document, _block_name(piece))
        _define(canvas, blocks, name, drawn, piece, style)
        blocks.made[piece.symbol] = name
    turn = round(-piece.turn % 360.0, 9)
    at = canvas.placing.points(piece.at).tolist()
    insert = canvas.space.add_blockref(
        name, at, dxfattribs={"layer": canvas.layer, "rotation": turn}
    )
    size = " x ".join(f"{side:.3f}" for side in piece.size)
    words = (piece.id, piece.kind, piece.name, f"{size} m", "")
    insert.add_auto_attribs(
        {tag: plain_words(text) for tag, text in zip(ATTRIBUTES, words, strict=True)}
    )


def _define(
    canvas: Canvas, blocks: Blocks, name: str, drawn: Mark, piece: PieceMeaning, style: Style
) -> None:
    """The symbol as a block around its origin, on layer 0, so that it takes the insert's layer."""
    block = blocks.document.blocks.new(name)
    size = canvas.placing.size
    if isinstance(drawn, CopyMark):
        drawn, placing = GroupMark(blocks.stencils[drawn.stencil].marks, {}), local(size)
    else:
        placing = local_of(piece.at, piece.turn, size)
    inside = canvas._replace(space=block, layer="0", placing=placing, filled=False)
    draw_mark(inside, drawn, style)
    _define_attributes(block, ATTRIBUTES, canvas.text_style, blocks.unit)


def _block_name(piece: PieceMeaning) -> str:
    """A model and its size in centimetres, as a name of a block.

    >>> _block_name(PieceMeaning("a", "bed", "Bed", "bed/plain", (0.9, 2.0, 0.5), (0, 0), 0, 1))
    'bed-plain 90x200x50'
    """
    size = "x".join(f"{100 * side:.0f}" for side in piece.size)
    return f"{name_part(piece.model or piece.kind)} {size}"


def name_part(words: str) -> str:
    """Words as part of a name of a table of DXF, which holds few signs.

    >>> name_part("oak/table: 2*3")
    'oak-table-2-3'
    """
    return re.sub(r"[<>/\\\":;?*|=`,'\s]+", "-", words).strip("-")[:LONGEST_NAME] or "object"


def _free_name(document: Any, name: str) -> str:
    names = (name if k == 1 else f"{name} ({k})" for k in range(1, len(document.blocks) + 2))
    return next(name for name in names if name not in document.blocks)


def _room(canvas: Canvas, room: RoomMeaning) -> None:
    """The floor as closed polylines; the outer one carries the room's id and name."""
    for number, ring in enumerate(room.rings):
        points = canvas.placing.points(ring).tolist()
        line = canvas.space.add_lwpolyline(points, close=True, dxfattribs={"layer": canvas.layer})
        if number == 0:
            words = plain_words(room.id)[:250], plain_words(room.name)[:250]
            line.set_xdata("SCENEWRIGHT", [(1000, text) for text in words])


def _tag(canvas: Canvas, blocks: Blocks, drawn: Mark, tag: TagMeaning, style: Style) -> None:
    """The label as drawn, and an insert that holds its words as attributes."""
    draw_mark(canvas, drawn, style)
    _define_tag(canvas, blocks)
    at = canvas.placing.points(tag.at).tolist()
    insert = canvas.space.add_blockref(TAG, at, dxfattribs={"layer": canvas.layer})
    words = zip(TAG_ATTRIBUTES, (tag.name, tag.area, tag.size), strict=True)
    insert.add_auto_attribs({name: plain_words(text) for name, text in words})


def _define_tag(canvas: Canvas, blocks: Blocks) -> None:
    if TAG not in blocks.document.blocks:
        block = blocks.document.blocks.new(TAG)
        block.add_point((0, 0), dxfattribs={"layer": "DEFPOINTS"})
        _define_attributes(block, TAG_ATTRIBUTES, canvas.text_style, blocks.unit)


def _define_attributes(block: Any, tags: tuple[str, ...], style: str, unit: float) -> None:
    """Invisible attributes of a block, one below the other."""
    height = SMALL_TEXT * unit
    for row, tag in enumerate(tags):
        look = {"height": height, "style": style, "layer": "0"}
        definition = block.add_attdef(tag, (0, -1.4 * row * height), "", dxfattribs=look)
        definition.is_invisible = True
        definition.dxf.prompt = tag.capitalize()


def _dimension(canvas: Canvas, blocks: Blocks, chain: DimensionMeaning) -> None:
    """One dimension for each length of a chain; where the figure has no room it shows none."""
    style = dimension_style(blocks.document, canvas)
    measured, foots = canvas.placing.points(chain.measured), canvas.placing.points(chain.foots)
    for k, words in enumerate(chain.words):
        made = canvas.space.add_linear_dim(
            base=foots[k].tolist(),
            p1=measured[k].tolist(),
            p2=measured[k + 1].tolist(),
            angle=chain.turn,
            text="<>" if words else " ",
            dimstyle=style,
            dxfattribs={"layer": canvas.layer},
        )
        made.render()


def dimension_style(document: Any, canvas: Canvas) -> str:
    """The style of dimensions at a scale: slashes, figures above the line, in the file's unit."""
    size = canvas.placing.size
    name = f"SCENEWRIGHT-{float(np.round(size, 6)):g}"
    if name not in document.dimstyles:
        style = document.dimstyles.new(name)
        style.dxf.dimtxsty = canvas.text_style
        figures = FIGURES[document.units] | {"dimscale": size}
        style.update_dxf_attribs(LOOK | figures)
        if "$DIMSCALE" not in document.header or document.header["$DIMSCALE"] == 1.0:
            _set_header(document, figures)
    return name


def _set_header(document: Any, figures: Mapping[str, float]) -> None:
    """The same in the header: programs that read no styles take it from there."""
    for key, value in {**LOOK, **figures}.items():
        document.header[f"${key.upper()}"] = value
