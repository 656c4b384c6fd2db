"""A scene with small objects on what carries them, by the rows of a table and a seed."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from math import pi
from zlib import crc32

import numpy as np

from scenewright.clutter.rows import ENOUGH, ROWS, SHARE, Row
from scenewright.clutter.spots import (
    Spot,
    find_spot,
    foot_spot,
    lean_spots,
    set_apart,
    take,
    turned_box,
)
from scenewright.clutter.stability import keep_standing
from scenewright.clutter.surfaces import Surfaces, surfaces_of
from scenewright.clutter.sweeps import Box, sweeps_of
from scenewright.clutter.tops import Carrier, Measure, carrier_of, to_level, to_local
from scenewright.core.catalog import Asset, Catalog
from scenewright.core.scene import CLUTTER, Piece, Pose, Scene, Size
from scenewright.core.space import Space
from scenewright.render.items import parts_of

SIZES = (0.92, 1.0, 1.06)
"""Shares of the usual size that small objects of a kind come in."""
ROUNDS = 2
"""How often what makes a room up comes round again."""
REACH = 0.8
"""Metres from a table within which a chair looks at it."""


def with_clutter(scene: Scene, catalog: Catalog, amount: str, seed: int = 0) -> Scene:
    """The scene with small objects, in rooms with a ceiling or without; the same for the same seed.

    What stands on one piece is drawn by the seed and its id, so that it comes along when the piece
    is moved and stays as it is when another one is.
    """
    if amount == "none":
        return scene
    found: list[Piece] = []
    measured: dict[tuple[str, Size, object], Surfaces] = {}

    def measure(piece: Piece) -> Surfaces:
        key = (piece.asset or piece.category, piece.size, piece.footprint)
        if key not in measured:
            measured[key] = surfaces_of(parts_of(piece, catalog))
        return measured[key]

    @cache
    def sweeps(piece: Piece) -> tuple[Box, ...]:
        return sweeps_of(piece, parts_of(piece, catalog))

    level_of = {space.id: space.level for space in scene.spaces}
    by_level: dict[str, list[Piece]] = defaultdict(list)
    for piece in scene.pieces:
        by_level[level_of.get(piece.space, "")].append(piece)
    for space in scene.spaces:
        found += _furnish(space, by_level[space.level], catalog, amount, seed, measure, sweeps)
    return replace(scene, pieces=(*scene.pieces, *keep_standing(scene.pieces, found, catalog)))


def _furnish(
    space: Space,
    pieces: Sequence[Piece],
    catalog: Catalog,
    amount: str,
    seed: int,
    measure: Measure,
    sweeps: Callable[[Piece], tuple[Box, ...]],
) -> Iterator[Piece]:
    """The small objects of a room."""
    rows = [row for row in ROWS if not row.rooms or set(row.rooms) & set(space.functions)]
    kinds = {kind for row in rows for kind in row.on}
    windows = [one for one in space.openings if one.kind == "window"]
    here = [piece for piece in pieces if piece.space == space.id and piece.category in kinds]
    names: dict[str, int] = {}
    count = 0
    carriers = []
    for piece in here:
        near = [o for o in _near(piece, pieces) if not _is_flat(o, catalog)]
        seats = _seats(piece, near, catalog)
        carriers.append(carrier_of(piece, near, windows, seats, measure, sweeps))
    left = {row: row.most for row in rows}
    for carrier in carriers:
        rng = np.random.default_rng([seed, crc32(carrier.piece.id.encode())])
        for row in rows:
            if row.fill or carrier.piece.category not in row.on:
                continue
            number = min(_number(carrier, row, amount, rng), left[row])
            made = [*_of_row(carrier, row, number, catalog, rng, names, measure)]
            left[row] -= len(made)
            count += len(made)
            yield from made
    if amount == "lived-in":
        rng = np.random.default_rng([seed, crc32(space.id.encode())])
        yield from _make_up(carriers, rows, ENOUGH - count, catalog, rng, names, measure)


def _make_up(
    carriers: Sequence[Carrier],
    rows: Sequence[Row],
    missing: int,
    catalog: Catalog,
    rng: np.random.Generator,
    names: dict[str, int],
    measure: Measure,
) -> Iterator[Piece]:
    """One after another of what makes a room up, until it has enough or holds no more."""
    left = {
        (n, k): ROUNDS * int(row.lived)
        for n, row in enumerate(rows)
        if row.fill
        for k, carrier in enumerate(carriers)
        if carrier.piece.category in row.on
    }
    while missing > 0 and left:
        for n, k in list(left):
            made = list(_of_row(carriers[k], rows[n], 1, catalog, rng, names, measure))
            missing -= len(made)
            yield from made
            left[n, k] -= 1
            if not made or not left[n, k] or _is_full(carriers[k]):
                del left[n, k]
            if missing <= 0:
                return


def _is_full(carrier: Carrier) -> bool:
    """Whether what is taken of a carrier's levels is more than a share of them."""
    whole = sum(level.free.sum() for level in carrier.surfaces.levels)
    return bool(sum(top.free.sum() for top in carrier.tops) < (1 - SHARE) * whole)


def _near(piece: Piece, pieces: Sequence[Piece]) -> Iterator[Piece]:
    """Other pieces whose footprint may reach over a piece's."""
    reach = np.hypot(*piece.size[:2]) / 2
    for other in pieces:
        apart = np.hypot(other.pose.x - piece.pose.x, other.pose.y - piece.pose.y)
        if other.id != piece.id and apart < reach + np.hypot(*other.size[:2]) / 2 + REACH:
            yield other


def _is_flat(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(piece.category)
    return kind is not None and kind.flat


def _seats(piece: Piece, near: Sequence[Piece], catalog: Catalog) -> np.ndarray:
    """Chairs at a piece, in its frame: their middle and the way they look (k, 4)."""
    found = []
    for other in near:
        kind = catalog.kinds.get(other.category)
        if kind is None or piece.category not in kind.under or other.group != piece.group:
            continue
        at = to_local(piece, np.array([other.pose[:2]]))[0]
        turn = other.pose.heading - piece.pose.heading
        found.append([*at, -np.sin(turn), np.cos(turn)])
    return np.array(found).reshape(-1, 4)


def _number(carrier: Carrier, row: Row, amount: str, rng: np.random.Generator) -> int:
    """How many of a row stand on a carrier."""
    wanted = row.some if amount == "some" else row.lived
    whole = int(wanted) + (rng.random() < wanted - int(wanted))
    return whole * (len(carrier.seats) if row.where in ("seat", "beside", "behind") else 1)


def _of_row(
    carrier: Carrier,
    row: Row,
    number: int,
    catalog: Catalog,
    rng: np.random.Generator,
    names: dict[str, int],
    measure: Measure,
) -> Iterator[Piece]:
    """The small objects of one row on one carrier; those for which there is no room are left."""
    assets = catalog.of(row.what)
    first = int(rng.integers(len(assets)))
    scale = SIZES[int(rng.integers(len(SIZES)))]
    for k in range(number):
        same = row.where in ("seat", "beside", "behind") or (row.pile > 1 and row.what == "plate")
        asset = assets[first if same else int(rng.integers(len(assets)))]
        size = _size(asset, 1.0 if same else scale, row, carrier)
        facing = row.where == "seat" or row.where in ("beside", "behind")
        turn = _turn_at_seat(carrier, k) if facing else rng.uniform(-row.turn, row.turn)
        spot = _spot(carrier, row, k, size, turn, rng)
        if spot is None:
            return
        base = _placed(carrier, row, asset, size, spot, turn, names, carrier.piece.id)
        yield base
        for _ in range(int(rng.integers(1, row.pile + 1)) - 1):
            size = Size(size.width * 0.97, size.depth * 0.97, size.height) if not same else size
            asset = asset if same else assets[int(rng.integers(len(assets)))]
            up = (*spot[:2], base.pose.z - carrier.piece.pose.z + measure(base).deck)
            off = 0.0 if same else rng.uniform(-0.12, 0.12)
            base = _placed(carrier, row, asset, size, up, turn + off, names, base.id)
            yield base


def _turn_at_seat(carrier: Carrier, number: int) -> float:
    """How what lies before a seat is turned: its front away from the sitter."""
    if not len(carrier.seats):
        return 0.0
    _, _, ux, uy = carrier.seats[number % len(carrier.seats)]
    return float(np.arctan2(-ux, uy))


def _size(asset: Asset, scale: float, row: Row, carrier: Carrier) -> Size:
    if row.where == "foot":
        return Size(min(0.8 * carrier.piece.size.width, 1.6), 0.5, 0.06)
    return Size(*(round(side * scale, 3) for side in asset.usual))


def _spot(
    carrier: Carrier, row: Row, k: int, size: Size, turn: float, rng: np.random.Generator
) -> Spot | None:
    """A free spot for the ``k``-th object of a row, which is taken then."""
    start = carrier.surfaces.start
    if row.where == "foot":
        return foot_spot(carrier, size.depth) if k == 0 else None
    if row.where == "lean":
        spots = set_apart(lean_spots(carrier, size.width, size.depth), size.width)
        return spots[k] if k < len(spots) else None
    wide, deep = turned_box(size.width, size.depth, turn)
    tall = size.height * (row.pile if row.what != "plate" else 4)
    found = find_spot(carrier, row.where, k, (wide, deep, tall), rng)
    if found is None:
        return None
    level, spot = found
    take(carrier.tops[level], *spot[:2], wide + 2 * row.gap, deep + 2 * row.gap, start)
    return spot


def _placed(
    carrier: Carrier,
    row: Row,
    asset: Asset,
    size: Size,
    spot: Spot,
    turn: float,
    names: dict[str, int],
    on: str,
) -> Piece:
    piece = carrier.piece
    group = piece.group or piece.space
    name = f"{group}/{row.what}"
    names[name] = names.get(name, 0) + 1
    identity = name if names[name] == 1 else f"{name}_{names[name]}"
    x, y = to_level(piece, np.array([spot[:2]]))[0]
    heading = (piece.pose.heading + turn + pi) % (2 * pi) - pi
    pose = Pose(float(x), float(y), piece.pose.z + spot[2], heading)
    return Piece(identity, row.what, asset.id, piece.space, pose, size, piece.group, CLUTTER, on)
