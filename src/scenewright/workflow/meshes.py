"""Models judged as they are drawn: whether they are in each other, and whether they open."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.check.meshes import (
    DrawnPiece,
    Moving,
    describe_meetings,
    describe_stops,
    find_meetings,
    find_stops,
)
from scenewright.check.solids import Floats, Solid, is_closed, solids_of
from scenewright.core.catalog import Catalog, Part
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Note, Report
from scenewright.core.scene import STAIRS, Piece, Scene
from scenewright.core.solution import Solution
from scenewright.geometry.mesh import Mesh, merge
from scenewright.render.bodies import Body, split_bodies
from scenewright.render.items import parts_of


class MeshReport(NamedTuple):
    """What was found of the models of a scene: ``findings`` of pairs deeper in each other than
    5 mm, what is ``said`` of bodies that do not open all the way, how many ``pieces``, ``solids``
    and moving ``bodies`` there are, and the ids of pieces whose mesh is ``open``."""

    findings: tuple[Finding, ...]
    said: tuple[str, ...]
    pieces: int
    solids: int
    bodies: int
    open: tuple[str, ...]


class _Model(NamedTuple):
    """The solids of a model in its own frame, those of each body, and whether all are closed."""

    solids: tuple[Solid, ...]
    bodies: tuple[tuple[Body, tuple[Solid, ...]], ...]
    closed: bool


def check_meshes(
    solution: Solution, plan: Plan | None = None, clutter: str | None = None
) -> MeshReport:
    """Judge the models of a solution's scene, with its small objects or with another amount.

    >>> from scenewright.domains import solve
    >>> from scenewright.formats import read
    >>> report = check_meshes(solve(read("sample:home-room"), steps=200))
    >>> report.findings, report.open
    ((), ())
    """
    asked = solution if clutter is None else replace(solution, clutter=clutter)
    scene, catalog = domains.scene_of(asked, plan), catalog_of(solution.brief.catalogs)
    drawn, unclosed = draw_pieces(scene, catalog)
    return MeshReport(
        tuple(describe_meetings(drawn, find_meetings(drawn))),
        tuple(describe_stops(drawn, find_stops(drawn))),
        len(drawn),
        sum(len(one.solids) for one in drawn),
        sum(len(one.moving) for one in drawn),
        unclosed,
    )


def add_meshes(report: Report, solution: Solution, plan: Plan | None = None) -> Report:
    """The referee's report with what is found of the models: pairs as findings, bodies that do not
    open all the way as notes, and the numbers as the figure ``meshes``."""
    found = check_meshes(solution, plan)
    space_of = {piece.id: piece.space for piece in solution.pieces}
    notes = [Note(space_of.get(line.split(":")[0], ""), "", "opening", line) for line in found.said]
    figures = {
        "pieces": found.pieces,
        "solids": found.solids,
        "bodies": found.bodies,
        "open": list(found.open),
    }
    return replace(
        report,
        findings=(*report.findings, *found.findings),
        notes=(*report.notes, *notes),
        figures={**report.figures, "meshes": figures},
    )


def draw_pieces(scene: Scene, catalog: Catalog) -> tuple[tuple[DrawnPiece, ...], tuple[str, ...]]:
    """The pieces of a scene as solids on their level, and the ids of those with an open mesh."""
    level_of = {space.id: space.level for space in scene.spaces}
    known: dict[object, _Model] = {}
    drawn, unclosed = [], []
    for piece in scene.pieces:
        if piece.function == STAIRS:
            continue
        key = (piece.asset or piece.category, piece.size, piece.footprint)
        if key not in known:
            known[key] = _model_of(parts_of(piece, catalog))
        if known[key].solids:
            drawn.append(_place(piece, level_of.get(piece.space, ""), known[key]))
            unclosed += [] if known[key].closed else [piece.id]
    return tuple(drawn), tuple(unclosed)


def _model_of(parts: tuple[Part, ...]) -> _Model:
    still, bodies = split_bodies(parts)
    own = [(body, tuple(_solids(body.parts))) for body in bodies]
    solids = (*_solids(still), *(solid for _, some in own for solid in some))
    closed = all(is_closed(part.vertices, part.faces) for part in parts)
    return _Model(solids, tuple(own), closed)


def _solids(parts: tuple[Part, ...]) -> Iterator[Solid]:
    if parts:
        mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
        yield from solids_of(mesh.vertices, mesh.faces)


def _place(piece: Piece, level: str, model: _Model) -> DrawnPiece:
    turn, shift = frame_of(piece)
    moving = tuple(
        Moving(
            body.joint.body,
            body.joint.kind,
            turn @ np.array(body.joint.pivot) + shift,
            turn @ np.array(body.joint.axis),
            body.joint.upper,
            tuple(solid.moved(turn, shift) for solid in solids),
        )
        for body, solids in model.bodies
        if body.joint.body.startswith(OPENING)
    )
    solids = tuple(solid.moved(turn, shift) for solid in model.solids)
    return DrawnPiece(piece, level, solids, moving)


OPENING = ("door", "drawer", "flap", "panel", "lid")
"""How the names of bodies begin that open what people reach into."""


def frame_of(piece: Piece) -> tuple[Floats, Floats]:
    """The turn (3, 3) and shift (3,) from the frame of a piece to that of its level."""
    x, y, z, heading = piece.pose
    sine, cosine = float(np.sin(heading)), float(np.cos(heading))
    turn = np.array([[sine, cosine, 0.0], [-cosine, sine, 0.0], [0.0, 0.0, 1.0]])
    return turn, np.array([x, y, z])
