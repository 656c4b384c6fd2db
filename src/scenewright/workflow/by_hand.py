"""Edits of single pieces where a domain has rules for them (its verb ``editing``)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import shapely

from scenewright.arranging.give_way import nearest_place
from scenewright.arranging.hand_rules import HandRules
from scenewright.building.palettes import MODERN, STYLES
from scenewright.core.catalog import Catalog
from scenewright.core.edits import Addition, Adjusted, Change, PieceEdits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import Edited, carry_pieces, frame_of, list_adjusted
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut, Solution

REMOVED, PUT_IN, EXCHANGED = "removed by hand", "put in by hand", "another model, by hand"
RESIZED = "another size, by hand"
BUILDING, GREEN = "building", "/green"
EXACT = 1e-6
"""Metres by which a size may differ from that asked for."""
FAR = 12.0
"""Metres from the wanted place within which a free one is looked for."""


def edit_by_rules(
    solution: Solution, plan: Plan, rules: HandRules, edits: PieceEdits, catalog: Catalog
) -> Adjusted:
    """Remove, exchange, resize, restyle, double and add, in this order; what is in the way of it
    then moves as little as it can."""
    hand = Hand(solution, plan, rules, catalog)
    for name in edits.remove:
        hand.remove(name)
    for name, model in edits.exchange.items():
        hand.exchange(name, model)
    for name, size in edits.resize.items():
        hand.resize(name, size)
    for name, style in edits.restyle.items():
        hand.restyle(name, style)
    for name in edits.duplicate:
        hand.duplicate(name)
    for asked in edits.add:
        hand.add(asked)
    return hand.settle()


class Hand:
    """The pieces of a solution while they are changed, and why each was."""

    def __init__(self, solution: Solution, plan: Plan, rules: HandRules, catalog: Catalog) -> None:
        self.solution, self.plan, self.rules, self.catalog = solution, plan, rules, catalog
        self.pieces = list(solution.pieces)
        self.left_out = list(solution.left_out)
        self.why: dict[str, str] = {}

    def remove(self, name: str) -> None:
        """Take something away with all that goes with it."""
        for piece in self.rules.find(self.pieces, name):
            self.pieces.remove(piece)
            self.why[piece.id] = REMOVED
            if piece.on is None:
                self._leave_out(piece, REMOVED)

    def exchange(self, name: str, model: str) -> None:
        """Another model in the place of a piece, as large as that where it comes in such a size."""
        piece = self.rules.find(self.pieces, name)[0]
        other = self.rules.make(model, piece.space, piece.pose)
        if piece.category != BUILDING:
            other = _fit(other, piece.size, self.catalog)
        same = other.category == piece.category != BUILDING
        function = piece.function if same else other.function
        kept = replace(other, id=piece.id, pose=piece.pose, group=piece.group, function=function)
        self._put(kept, EXCHANGED)
        if not same:
            self._leave_out(piece, EXCHANGED)

    def resize(self, name: str, size: Sequence[float]) -> None:
        """Another width, depth and height."""
        piece = self.rules.find(self.pieces, name)[0]
        self._put(resize_piece(piece, Size(*size), self.catalog), RESIZED)
        if piece.category == BUILDING:
            self._leave_out(piece, RESIZED)

    def restyle(self, name: str, style: str) -> None:
        """Models of a style, where there are any like those that stand there: of a piece, or of all
        in a space."""
        here = [p for p in self.pieces if p.space == name] or self.rules.find(self.pieces, name)
        for piece, model in list_restyled(here, name, style, self.catalog):
            built = piece.fixed or piece.category == BUILDING
            self.pieces[self.pieces.index(piece)] = replace(piece, asset=model, fixed=built)

    def duplicate(self, name: str) -> None:
        """The same once more, at the nearest free place."""
        first, *rest = self.rules.find(self.pieces, name)
        self._add(_rename([first, *rest], self.pieces))

    def add(self, asked: Addition) -> None:
        """A model at the free place nearest to where it is wanted."""
        at = shapely.Point(asked.x, asked.y)
        named = [s for s in self.plan.spaces if asked.space in ("", s.id)]
        space = next((s for s in named if shapely.Polygon(s.outline).covers(at)), None)
        if space is None:
            raise InputError(f"nothing can stand at ({asked.x:g}, {asked.y:g})", "choose a place")
        pose = Pose(asked.x, asked.y, 0.0, asked.heading or 0.0)
        piece = self.rules.make(asked.asset, space.id, pose)
        self._add(_rename([piece], self.pieces))

    def settle(self) -> Adjusted:
        """What follows from all of it, and every change with its reason."""
        known = {piece.id for piece in self.pieces}
        changed = frozenset(name for name in self.why if name in known)
        edited = Edited(tuple(self.pieces), changed, frozenset())
        after = self.rules.settle(edited)
        told = [o for o in self.left_out if o not in after.left_out]
        after = replace(after, left_out=(*after.left_out, *told))
        adjusted = list_adjusted(self.solution, after, edited, skip=GREEN)
        changes = [c._replace(reason=self.why.get(c.piece, c.reason)) for c in adjusted.changes]
        return Adjusted(after, (*changes, *self._list_exchanged(after, changes)))

    def _list_exchanged(self, after: Solution, told: Sequence[Change]) -> Iterator[Change]:
        """Pieces of another model that neither moved nor changed their size."""
        was, known = {p.id: p for p in self.solution.pieces}, {change.piece for change in told}
        for piece in after.pieces:
            before = was.get(piece.id)
            if piece.group.endswith(GREEN):
                continue
            if before and piece.id not in known and before.asset != piece.asset:
                yield Change(piece.id, piece.id, "exchanged", piece.space, EXCHANGED)

    def _leave_out(self, piece: Piece, why: str) -> None:
        self.left_out.append(LeftOut(piece.space, self.rules.owed(piece), why, False))

    def _put(self, piece: Piece, why: str) -> None:
        number = next(k for k, one in enumerate(self.pieces) if one.id == piece.id)
        self.pieces[number] = replace(piece, fixed=True)
        self.why[piece.id] = why

    def _add(self, new: Sequence[Piece]) -> None:
        """New pieces, the first leading, at the nearest place where nothing has to move."""
        ids = [piece.id for piece in new]
        wanted = frame_of(new[0])
        place = nearest_place([*self.pieces, *new], ids, wanted, self.rules.ways)
        if place is None:
            label = new[0].category.replace("_", " ")
            far = FAR * self.rules.ways.times
            raise InputError(
                f"no place within {far:g} m is free for the {label}", "clear one first"
            )
        self.pieces += carry_pieces(new, wanted, place)
        self.why |= dict.fromkeys(ids, PUT_IN)


def find_like(asset: str, style: str, catalog: Catalog) -> str:
    """The model of a ``style`` that is called most like another; empty if there is none. Usual
    models, which name no style, are the modern ones.

    >>> from scenewright.catalog.assets import shipped
    >>> find_like("sofa_nordic", "retro", shipped()), find_like("sofa_nordic", "modern", shipped())
    ('sofa_retro', 'sofa')
    """
    words = {*asset.split("_")}
    best, most = "", 0
    for name in catalog.assets:
        own = {*name.split("_")}
        if style in own and own - {style} <= words and len(own) > most:
            best, most = name, len(own)
    usual = "_".join(word for word in asset.split("_") if word not in STYLES)
    return best or (usual if style == MODERN and usual in catalog.assets else "")


def list_restyled(
    pieces: Sequence[Piece], name: str, style: str, catalog: Catalog
) -> list[tuple[Piece, str]]:
    """Pieces of another model in a style, and that; InputError where nothing is made in it."""
    word = style.casefold()
    named = next((one for one, others in STYLES.items() if word in others.split()), word)
    found = [(p, find_like(p.asset, named, catalog)) for p in pieces]
    if not any(model for _, model in found):
        fault = f"no model like those of '{name}' is made in '{style}'"
        raise InputError(fault, f"styles of furniture: {', '.join(STYLES)}")
    return [(p, model) for p, model in found if model and model != p.asset]


def resize_piece(piece: Piece, size: Size, catalog: Catalog) -> Piece:
    """A piece of another size; InputError where its model does not come in that."""
    if min(size) <= 0 or not all(map(math.isfinite, size)):
        raise InputError(f"{(*size,)} is no size", "give width, depth and height in metres")
    fit = _fit(piece, size, catalog)
    if max(abs(a - b) for a, b in zip(fit.size, size, strict=True)) > EXACT:
        text = " x ".join(f"{one:g}" for one in fit.size)
        raise InputError(f"'{piece.id}' does not come in that size", f"the nearest is {text} m")
    return fit


def _fit(piece: Piece, size: Size, catalog: Catalog) -> Piece:
    """A piece as near to a size as its model comes; buildings come in any."""
    asset = catalog.assets.get(piece.asset)
    if asset is not None and piece.category != BUILDING:
        rows = zip(asset.smallest, size, asset.largest, strict=True)
        size = Size(*(min(max(one, low), high) for low, one, high in rows))
    wide, deep = size.width / piece.size.width, size.depth / piece.size.depth
    footprint = tuple((x * wide, y * deep) for x, y in piece.footprint)
    return replace(piece, size=size, footprint=footprint)


def _rename(pieces: Sequence[Piece], others: Sequence[Piece]) -> list[Piece]:
    """Copies with ids that nothing else has."""
    taken, names = {piece.id for piece in others}, dict[str, str]()
    for piece in pieces:
        led = next((k for k in names if piece.id.startswith(f"{k}/")), "")
        start = names[led] + piece.id.removeprefix(led) if led else piece.id
        stem = start.rstrip("0123456789").removesuffix("_")
        tried = (f"{stem}_{k}" for k in range(1, len(taken) + 3))
        names[piece.id] = start if led else next(name for name in tried if name not in taken)
        taken.add(names[piece.id])
    return [replace(p, id=names[p.id], on=names.get(p.on or ""), fixed=True) for p in pieces]
