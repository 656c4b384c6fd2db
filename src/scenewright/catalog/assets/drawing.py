"""How the models of a kind are drawn, and the assets that makes of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.assets.symbols import plain
from scenewright.core.catalog import (
    Asset,
    Covering,
    Mesher,
    OutlineMesher,
    Part,
    Symbol,
    covers_box,
    transform_part,
)
from scenewright.core.errors import InputError
from scenewright.core.footprint import Footprint, scale_footprint
from scenewright.core.kind import Kind, SizeRange
from scenewright.core.scene import Size

Parts = tuple[Part, ...]
ODD = 1.5
"""Beyond how many times the usual range of its kind's sizes a thing is stretched, not built."""


LETTERS = "abcdefghijklmnopqrstuvwxyz"
"""How models of one kind are told apart that hold other things; those in other colours have
numbers."""


class Drawing(NamedTuple):
    """How one model of a kind is drawn: its mesh and its symbol. Of several models of a kind each
    but the first has an ``id`` of its own (left out: the category), a ``name`` (left out: the
    kind's) and the ``sizes`` it can take (left out: the kind's). ``footprint`` is what it covers
    (left out: its box), ``over`` what it looks like over another footprint (left out: a prism);
    ``style`` the style it is made in, if any; ``called`` the words, in the singular and small
    letters; it must be asked for by one of them; ``suit`` what it is made to match."""

    category: str
    mesh: Mesher
    symbol: Symbol = plain
    id: str = ""
    name: str = ""
    sizes: SizeRange | tuple[()] = ()
    footprint: Covering = covers_box
    over: OutlineMesher | None = None
    style: str = ""
    called: tuple[str, ...] = ()
    suit: str = ""


def buildable(size: Size, small: Size, large: Size) -> Size:
    """The size at which a thing of an odd size is built before it is stretched to it: each side
    at most :data:`ODD` times below the smallest and above the largest of its kind. So a shelf a
    hundred metres long holds no more books than a long one.

    >>> buildable(Size(30.0, 0.4, 30.0), Size(0.5, 0.2, 0.5), Size(2.0, 0.4, 2.0))
    Size(width=3.0, depth=0.4, height=3.0)
    """
    limits = zip(size, small, large, strict=True)
    return Size(*(min(max(side, low / ODD), ODD * high) for side, low, high in limits))


def _stretch(mesh: Mesher, small: Size, large: Size) -> Mesher:
    def built(size: Size) -> Parts:
        near = buildable(size, small, large)
        if near == size:
            return mesh(size)
        scale = np.array(size) / np.array(near)
        return tuple(transform_part(p, np.diag(scale)) for p in mesh(near))

    return built


def _stretch_symbol(symbol: Symbol, small: Size, large: Size) -> Symbol:
    def drawn(size: Size) -> tuple[NDArray[np.float64], ...]:
        near = buildable(size, small, large)
        if near == size:
            return symbol(size)
        scale = np.array(size[:2]) / np.array(near[:2])
        return tuple(line * scale for line in symbol(near))

    return drawn


def _stretch_footprint(footprint: Covering, small: Size, large: Size) -> Covering:
    def covering(size: Size) -> Footprint:
        return scale_footprint(footprint(buildable(size, small, large)), *size[:2])

    return covers_box if footprint is covers_box else covering


def asset_of(drawing: Drawing, kind: Kind) -> Asset:
    """The asset a drawing of a kind makes; what it leaves out is the kind's.

    >>> from scenewright.core.kind import size_range
    >>> crate = Kind("fruit_crate", sizes=size_range("30 40 60", "20 30 40", "15 20 30"))
    >>> asset_of(Drawing("fruit_crate", lambda size: ()), crate).name
    'Fruit crate'
    """
    name = drawing.name or kind.name[:1].upper() + kind.name[1:]
    identity = drawing.id or drawing.category
    sizes = drawing.sizes or kind.sizes
    if not sizes:
        raise InputError(f"the kind '{kind.category}' has no sizes", "state them in its row")
    small, usual, large = sizes
    mesh = _stretch(drawing.mesh, small, large)
    symbol = _stretch_symbol(drawing.symbol, small, large)
    return Asset(
        identity,
        drawing.category,
        name,
        small,
        usual,
        large,
        mesh,
        symbol,
        style=drawing.style,
        footprint=_stretch_footprint(drawing.footprint, small, large),
        over=drawing.over,
        called=drawing.called,
        suit=drawing.suit,
    )


def letter_models(
    category: str,
    symbol: Symbol,
    meshes: Iterable[Mesher],
    own: str = "",
    name: str = "",
    sizes: SizeRange | tuple[()] = (),
    called: str = "",
) -> Iterator[Drawing]:
    """Models of one kind and size that hold other things."""
    for mesh, letter in zip(meshes, LETTERS, strict=False):
        label = f"{name or category.replace('_', ' ').capitalize()}, {letter}"
        stem = own or category
        identity = stem if letter == "a" and not called else f"{stem}_{letter}"
        words = tuple(called.split())
        yield Drawing(category, mesh, symbol, identity, label, sizes, called=words)
