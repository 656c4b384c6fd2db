"""A set of sheets as one document of DXF: the plans side by side in the model at true size, a
layout a sheet with its frame, title block and a window on the model to scale."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import ezdxf
from ezdxf.document import Drawing

from scenewright.drawing.dxf.entities import Canvas
from scenewright.drawing.dxf.layers import HATCHES, PAPER, layer_row
from scenewright.drawing.dxf.pens import LineTypes
from scenewright.drawing.dxf.place import Placing, on_paper, true_size
from scenewright.drawing.dxf.placed_entities import (
    METRES,
    MILLIMETRES,
    WINDOWS,
    Blocks,
    draw_all,
    name_part,
)
from scenewright.drawing.layers import PlanDrawing
from scenewright.drawing.marks import FillPattern, PaperView, Stencil
from scenewright.drawing.sheet import EDGE, drawing_area

TEXT_STYLE, FONT = "SCENEWRIGHT", "arial.ttf"
APART = 1.2
"""Distance between sheets in the model, in widths of a sheet."""
SVG_DEFAULTS = {"stroke": "none", "fill": "#000000"}


class Unit(NamedTuple):
    """The unit of the model: its code in ``$INSUNITS`` and how many a metre is."""

    code: int
    per_metre: float


UNITS = {"m": Unit(METRES, 1.0), "mm": Unit(MILLIMETRES, 1000.0)}


def make_document(sheets: Sequence[PlanDrawing], unit: Unit) -> Drawing:
    """The document of sheets; the first plan keeps its own coordinates, the others lie east of it.

    Raises nothing: every drawing can be written.
    """
    document = new_document(unit)
    types = LineTypes(document.linetypes)
    made: dict[Any, str] = {}
    east = 0.0
    for number, sheet in enumerate(sheets):
        view = sheet.view or _paper_as_plan(sheet)
        model = true_size(view, unit.per_metre, east if number else 0.0)
        _draw_sheet(document, sheet, model, types, made, unit)
        if number + 1 < len(sheets):
            reach = model.points([sheet.sheet.width, 0.0])[0]
            east = _next_east(float(reach), sheet, sheets[number + 1], unit)
    _tidy(document)
    return document


def new_document(unit: Unit) -> Drawing:
    """An empty document in a unit, always of the same bytes."""
    ezdxf.options.write_fixed_meta_data_for_testing = True
    document = ezdxf.new("R2010")
    document.units = unit.code
    document.header["$MEASUREMENT"] = 1
    document.header["$LUNITS"], document.header["$LUPREC"] = 2, 3
    document.header["$PSLTSCALE"], document.header["$LWDISPLAY"] = 0, 1
    document.styles.new(TEXT_STYLE, dxfattribs={"font": FONT})
    document.appids.new("SCENEWRIGHT")
    for name in (WINDOWS, WINDOWS + HATCHES):
        document.layers.add(name).description = "Windows"
    return document


def _paper_as_plan(sheet: PlanDrawing) -> PaperView:
    """Where a sheet shows several plans, or none, its lower left corner is the origin."""
    return PaperView(1000 / sheet.sheet.scale, 0.0, sheet.sheet.height)


def _next_east(reach: float, here: PlanDrawing, after: PlanDrawing, unit: Unit) -> float:
    """How far east the next plan is moved, so that no sheet's window shows another's plan."""
    wide = here.sheet.width * here.sheet.scale / 1000 * unit.per_metre
    view = after.view or _paper_as_plan(after)
    return reach + (APART - 1.0) * wide + view.x / view.scale * unit.per_metre


def _draw_sheet(
    document: Drawing,
    sheet: PlanDrawing,
    model: Placing,
    types: LineTypes,
    made: dict[Any, str],
    unit: Unit,
) -> None:
    patterns = {d.id: d for d in sheet.definitions if isinstance(d, FillPattern)}
    stencils = {d.id: d for d in sheet.definitions if isinstance(d, Stencil)}
    blocks = Blocks(document, made, stencils, unit.per_metre)
    layout = _layout(document, sheet, model)
    for layer in sheet.layers:
        row = layer_row(layer.name)
        for name in (row.name, row.name + HATCHES):
            if name not in document.layers:
                document.layers.add(name, color=row.colour).description = layer.name
        space, placing = document.modelspace(), model
        if layer.name in PAPER:
            space, placing = layout, on_paper(sheet.sheet.height)
        canvas = Canvas(space, row.name, placing, types, patterns, TEXT_STYLE)
        draw_all(canvas, blocks, layer.mark, SVG_DEFAULTS)


def _layout(document: Drawing, sheet: PlanDrawing, model: Placing) -> Any:
    """A layout of the sheet's size with a window on its drawing at its scale."""
    paper = sheet.sheet
    name = _free_layout(document, name_part(sheet.name or "Plan"))
    layout = document.layouts.new(name)
    layout.page_setup(size=(paper.width, paper.height), margins=(0, 0, 0, 0), units="mm")
    wide, high = drawing_area(paper)
    middle = (EDGE + wide / 2, EDGE + high / 2)
    window = layout.add_viewport(
        center=(middle[0], paper.height - middle[1]),
        size=(wide, high),
        view_center_point=model.points(middle).tolist(),
        view_height=high * model.size,
    )
    window.dxf.layer = "A-ANNO-NPLT"
    return layout


def _free_layout(document: Drawing, name: str) -> str:
    taken = {layout.upper() for layout in document.layouts.names()}
    short = name[:200]
    names = (short if k == 1 else f"{short} ({k})" for k in range(1, len(taken) + 2))
    return next(name for name in names if name.upper() not in taken)


def _tidy(document: Drawing) -> None:
    """Without the empty first layout and layers nothing lies on; the view shows all."""
    document.layers.add("A-ANNO-NPLT", color=8).dxf.plot = 0
    document.layouts.delete("Layout1")
    used = {entity.dxf.layer for layout in document.layouts for entity in layout}
    used |= {"0", "DEFPOINTS", "A-ANNO-NPLT"}
    for layer in [row.dxf.name for row in document.layers]:
        if layer not in used and layer.upper() not in used:
            document.layers.remove(layer)
    from ezdxf import bbox

    found = bbox.extents(document.modelspace(), fast=True)
    if found.has_data:
        middle, size = found.center, found.size
        document.set_modelspace_vport(1.1 * max(size.y, 0.6 * size.x, 1.0), middle.vec2)
        document.header["$EXTMIN"], document.header["$EXTMAX"] = found.extmin, found.extmax
