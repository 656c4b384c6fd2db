"""Pieces put in, taken away, doubled, exchanged, resized or restyled by hand.

What is put in is locked, so that whatever is solved afterwards goes round it; what is taken away
is listed as left out. The referee judges the answer as any other.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice

import numpy as np
import shapely

from scenewright.catalog.loading import catalog_of, find_asset
from scenewright.core.catalog import Asset, Catalog, footprint_of
from scenewright.core.edits import Addition, Adjusted, Change, PieceEdits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import carry_pieces, find_piece, frame_of
from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut, Solution
from scenewright.core.space import Space
from scenewright.domains import adjust, check, plan_of
from scenewright.workflow.by_hand import (
    EXCHANGED,
    PUT_IN,
    REMOVED,
    RESIZED,
    edit_by_rules,
    list_restyled,
    resize_piece,
)
from scenewright.workflow.judging import Part, narrow

STEP, FAR = 0.1, 3.0
"""Metres between places that are tried for a piece, and how far from the wanted one."""
APART, TRIED = 0.3, 12
"""Metres between free places of which more than the nearest are looked at, and how many are."""
TURNS = (0.0, math.pi / 2, -math.pi / 2, math.pi)
"""How a piece may be turned there, in this order."""
AT_ONCE = 100
"""Places that are looked at together."""
TOUCH = 0.005
"""Metres by which things beside one another may overlap."""
ALONE = "fixed"
"""Group and function of what belongs to no furniture group."""


def edit_pieces(
    solution: Solution,
    *,
    plan: Plan | None = None,
    add: Sequence[Addition] = (),
    remove: Sequence[str] = (),
    duplicate: Sequence[str] = (),
    exchange: Mapping[str, str] | None = None,
    resize: Mapping[str, Sequence[float]] | None = None,
    restyle: Mapping[str, str] | None = None,
) -> Adjusted:
    """Put in, take away, double, exchange, resize (to width, depth and height in metres) or restyle
    pieces of any scene by hand, in this order: remove, exchange (for a model of the catalog, or one
    like another that stands there), resize, restyle (a piece or a space), duplicate, add. Pieces
    are named as in :func:`scenewright.domains.adjust`.

    What is added or doubled stands at the nearest free place: in homes, within 3 m of the wanted
    one, that breaks no rule, if there is one among the first few. What lies on a piece goes, and is
    doubled, with it. What a piece in another size runs into gives way as little as it can. Raises
    :class:`InputError` for a name there is not, a place outside, or where nothing is free.
    """
    made = plan or plan_of(solution.brief)
    edits = PieceEdits(remove, exchange or {}, resize or {}, restyle or {}, duplicate, add)
    catalog, domain = catalog_of(solution.brief.catalogs), domain_of(solution.brief.domain)
    if domain.has("editing"):
        rules = domain.verb("editing")(solution, made)
        return edit_by_rules(solution, made, rules, edits, catalog)
    if not domain.rooms:
        raise InputError(f"a {solution.brief.domain} takes no pieces by hand", "change the brief")
    return _edit_home(solution, made, edits, catalog)


def _edit_home(solution: Solution, made: Plan, edits: PieceEdits, catalog: Catalog) -> Adjusted:
    pieces = list(solution.pieces)
    changes: list[Change] = []
    left_out = list(solution.left_out)
    for name in edits.remove:
        for piece in _with_carried(pieces, name):
            pieces.remove(piece)
            if piece.on is None:
                left_out.append(LeftOut(piece.space, piece.category, REMOVED, False))
            changes.append(Change(piece.id, piece.id, "gone", piece.space, REMOVED))
    changes += _alter(pieces, edits, catalog)
    for free in _list_new(pieces, made, catalog, edits.duplicate, edits.add):
        new = _choose(replace(solution, left_out=tuple(left_out)), made, pieces, free)
        pieces += new
        changes.append(Change(new[0].id, "", "new", new[0].space, PUT_IN))
    edited = replace(solution, pieces=tuple(pieces), left_out=tuple(left_out))
    grown = [name for name in edits.resize if name] and _find_crowding(solution, edited, made)
    if grown:
        poses = {p.id: (*p.pose[:2], p.pose.heading) for p in pieces if p.id in grown}
        edited, more = adjust(edited, plan=made, move=poses)
        changes += [c for c in more if c.piece not in grown]
    return Adjusted(edited, tuple(changes))


def _alter(pieces: list[Piece], edits: PieceEdits, catalog: Catalog) -> Iterator[Change]:
    """Exchange, resize and restyle among ``pieces``, which are changed in place."""
    wanted = [(name, find_asset(catalog, model)) for name, model in edits.exchange.items()]
    for name, model in wanted:
        piece = _named(pieces, name)
        yield _replace_piece(pieces, piece, _exchanged(piece, model), EXCHANGED)
    for name, size in edits.resize.items():
        piece = _named(pieces, name)
        other = replace(resize_piece(piece, Size(*size), catalog), fixed=True)
        yield _replace_piece(pieces, piece, other, RESIZED)
    for name, style in edits.restyle.items():
        here = [p for p in pieces if p.space == name] or [_named(pieces, name)]
        for piece, like in list_restyled(here, name, style, catalog):
            other = replace(piece, asset=like)
            yield _replace_piece(pieces, piece, other, EXCHANGED)


def _replace_piece(pieces: list[Piece], piece: Piece, other: Piece, why: str) -> Change:
    for one in _with_carried(pieces, piece.id):
        pieces[pieces.index(one)] = other if one is piece else _lifted(one, piece, other)
    return Change(piece.id, piece.id, "exchanged", piece.space, why)


def _find_crowding(before: Solution, after: Solution, plan: Plan) -> list[str]:
    """Pieces that were changed and now run into others."""
    was = {piece.id: piece for piece in before.pieces}
    changed = {p.id for p in after.pieces if p.id in was and was[p.id].size != p.size}
    report = check(after, plan=plan, figures=False)
    named = {n for f in report.of("collision") for n in (f.piece, *f.other.split(","))}
    return sorted(changed & named)


def _list_new(
    pieces: Sequence[Piece],
    plan: Plan,
    catalog: Catalog,
    duplicate: Sequence[str],
    add: Sequence[Addition],
) -> Iterator[Iterator[list[Piece]]]:
    """For each doubling and addition the places it may take among ``pieces``, which grow: what is
    put in, the piece itself first."""
    for name in duplicate:
        first, *carried = _with_carried(pieces, name)
        if first.on or catalog.kinds[first.category].support != "floor":
            raise InputError(f"'{first.id}' does not stand on a floor", "choose one that does")
        space = next(space for space in plan.spaces if space.id == first.space)
        new = _renamed([first, *carried], pieces)
        yield _list_free(new, first.pose, space, pieces, catalog)
    for asked in add:
        piece, space = _make(asked, plan, catalog, pieces)
        yield _list_free([piece], piece.pose, space, pieces, catalog)


def _choose(
    solution: Solution, plan: Plan, pieces: Sequence[Piece], free: Iterator[list[Piece]]
) -> list[Piece]:
    """The first of a few free places where no more rules are broken than without, else the
    nearest. A place is judged in its room first, then, if nothing is wrong there, in the home."""

    def faults(part: Part, new: Sequence[Piece]) -> int:
        tried = replace(part.solution, pieces=(*part.solution.pieces, *new))
        return sum(found.is_blamed for found in part._replace(solution=tried).judge())

    nearest = next(free)
    whole = Part(replace(solution, pieces=tuple(pieces)), plan)
    room = narrow(*whole, frozenset({nearest[0].space}))
    parts = [(part, faults(part, ())) for part in (room, whole)]
    for new in (nearest, *islice(free, TRIED)):
        if all(faults(part, new) <= before for part, before in parts):
            return new
    return nearest


def _named(pieces: Sequence[Piece], name: str) -> Piece:
    known = next((piece for piece in pieces if piece.id == name), None)
    return known or find_piece(pieces, name, lambda piece: piece.on is None)


def _with_carried(pieces: Sequence[Piece], name: str) -> list[Piece]:
    """A piece and all that lies on it, or on that."""
    found = [_named(pieces, name)]
    for piece in found:
        found += [one for one in pieces if one.on == piece.id and one not in found]
    return found


def _exchanged(piece: Piece, asset: Asset) -> Piece:
    """A model in the place of a piece: as large as that, where it comes in such a size."""
    size = _fit(asset, piece.size)
    footprint = footprint_of(asset, size)
    model = replace(piece, category=asset.category, asset=asset.id, size=size)
    return replace(model, footprint=footprint, fixed=True)


def _lifted(one: Piece, before: Piece, after: Piece) -> Piece:
    """What stands on top of a piece at the height of the one that takes its place."""
    top, rise = before.pose.z + before.size.height, after.size.height - before.size.height
    on_top = one.pose.z >= top - TOUCH
    return replace(one, pose=one.pose._replace(z=one.pose.z + rise)) if on_top else one


def _fit(asset: Asset, wanted: Size) -> Size:
    rows = zip(asset.smallest, wanted, asset.largest, strict=True)
    return Size(*(min(max(size, low), high) for low, size, high in rows))


def _make(
    asked: Addition, plan: Plan, catalog: Catalog, others: Sequence[Piece]
) -> tuple[Piece, Space]:
    """A model as a piece of the space it is put in."""
    asset = find_asset(catalog, asked.asset)
    kind = catalog.kinds.get(asset.category)
    if kind is None or kind.support != "floor":
        raise InputError(f"'{asset.name}' does not stand on a floor", "choose one that does")
    at = shapely.Point(asked.x, asked.y)
    named = [s for s in plan.spaces if asked.space in ("", s.id)]
    found = next((s for s in named if shapely.Polygon(s.outline).covers(at)), None)
    if found is None:
        raise InputError(f"no room is at ({asked.x:g}, {asked.y:g})", "choose a place in one")
    heading = _from_wall(found, at) if asked.heading is None else asked.heading
    name = f"{found.id}/{asset.category}"
    pose = Pose(asked.x, asked.y, 0.0, heading)
    piece = Piece(name, asset.category, asset.id, found.id, pose, asset.usual, ALONE, ALONE)
    piece = replace(piece, fixed=True, footprint=footprint_of(asset, asset.usual))
    return _renamed([piece], others)[0], found


def _from_wall(space: Space, at: shapely.Point) -> float:
    """The heading of what has its back to the nearest wall of a space."""
    corners = space.outline
    ends = np.roll(corners, -1, axis=0)
    edges = shapely.linestrings(np.stack([corners, ends], axis=1))
    nearest = int(np.argmin(shapely.distance(edges, at)))
    along = ends[nearest] - corners[nearest]
    return math.atan2(float(along[0]), -float(along[1]))


def _renamed(pieces: Sequence[Piece], others: Sequence[Piece]) -> list[Piece]:
    """Copies with ids of their own, that belong to no furniture group."""
    taken, names = {piece.id for piece in others}, {}
    for piece in pieces:
        stem = piece.id.rstrip("0123456789").removesuffix("_")
        tried = (f"{stem}_{k}" if k > 1 else stem for k in range(1, len(taken) + 3))
        names[piece.id] = next(name for name in tried if name not in taken)
        taken.add(names[piece.id])
    return [
        replace(p, id=names[p.id], group=ALONE, function=ALONE, on=names.get(p.on or ""))
        for p in pieces
    ]


def _list_free(
    new: Sequence[Piece], wanted: Pose, space: Space, others: Sequence[Piece], catalog: Catalog
) -> Iterator[list[Piece]]:
    """Pieces at the free places around the one wanted, the nearest first, each some way from those
    before. InputError where there is none."""
    first = replace(new[0], pose=wanted)
    floor = shapely.Polygon(space.outline, [*space.holes]).buffer(TOUCH)
    taken = _union_standing(first, space, others, catalog)
    shapely.prepare([floor, taken])
    around = np.arange(-FAR, FAR + STEP, STEP).tolist()
    shifts = np.array(sorted((math.hypot(x, y), x, y) for x in around for y in around))[:, 1:]
    turned = [replace(first, pose=wanted._replace(heading=wanted.heading + t)) for t in TURNS]
    outlines = np.array([outline_of(one) for one in turned])
    listed: list[tuple[float, float]] = []
    for some in np.array_split(shifts, len(shifts) // AT_ONCE):
        shapes = shapely.polygons(outlines[None] + some[:, None, None])
        fits = shapely.covers(floor, shapes) & ~shapely.intersects(taken, shapes)
        for k in np.flatnonzero(fits.any(1)).tolist():
            dx, dy = some[k].tolist()
            if any(math.dist((dx, dy), other) < APART for other in listed):
                continue
            listed.append((dx, dy))
            there = turned[int(fits[k].argmax())]
            x, y, _ = frame_of(there)
            yield list(carry_pieces(new, frame_of(new[0]), (x + dx, y + dy, there.pose.heading)))
    if not listed:
        label = first.category.replace("_", " ")
        raise InputError(f"no place within {FAR:g} m is free for the {label}", "clear one first")


def _union_standing(
    piece: Piece, space: Space, others: Sequence[Piece], catalog: Catalog
) -> shapely.Geometry:
    """The floor that other things take which a piece would run into: nothing for a rug."""
    flat = {kind.category for kind in catalog.kinds.values() if kind.flat}
    top = piece.pose.z + piece.size.height
    obstacles = [
        shapely.Polygon(outline_of(one)).buffer(-TOUCH)
        for one in others
        if one.space == space.id and one.on is None and one.category not in flat
        if one.pose.z < top
    ]
    return shapely.union_all(obstacles if piece.category not in flat else [])
