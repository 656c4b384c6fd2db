"""The catalog: kinds of object, the assets that draw them, and groups of them.

A *kind* states how an object is used (:mod:`scenewright.core.kind`); an *asset* is one model that
can be drawn at a range of sizes; a *group* is a set of members laid out to serve one function.
Assets are found by kind and size.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.core.footprint import Footprint
from scenewright.core.kind import Kind
from scenewright.core.scene import Piece, Size
from scenewright.geometry.joints import Joint, transform_joint

LONG = 3
"""Letters of words that do not count as the end of others: a scar is no car."""
OWN = "model:"
"""How the ids of assets begin that are models of a user's catalogues."""


@dataclass(frozen=True, slots=True)
class Material:
    """A plain physically based material: sRGB colour in [0, 1], roughness, metallic, opacity."""

    name: str
    color: tuple[float, float, float]
    roughness: float = 0.8
    metallic: float = 0.0
    opacity: float = 1.0
    emission: float = 0.0


@dataclass(frozen=True, slots=True)
class Part:
    """Triangles of one material: ``vertices`` (n, 3) float64, ``faces`` (m, 3) int64,
    counter-clockwise seen from outside; in the local frame described in
    :mod:`scenewright.core.scene`. Parts with the same ``joint`` are one body that moves by it;
    those without one stand still.
    """

    material: Material
    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    joint: Joint | None = None


def transform_part(part: Part, matrix: ArrayLike, shift: ArrayLike = 0.0) -> Part:
    """The part with each point p at ``matrix`` (3, 3) p + ``shift`` (3,), and its joint with it;
    a reflection turns its faces round, so that they still look outwards.

    >>> wedge = Part(Material("oak", (0.7, 0.5, 0.3)), np.eye(3), np.array([[0, 1, 2]]))
    >>> transform_part(wedge, np.diag([-1.0, 1.0, 1.0])).faces.tolist()
    [[2, 1, 0]]
    """
    turn = np.asarray(matrix, np.float64)
    faces = part.faces if np.linalg.det(turn) > 0 else part.faces[:, ::-1]
    joint = part.joint and transform_joint(part.joint, turn, shift)
    return Part(part.material, part.vertices @ turn.T + np.asarray(shift), faces, joint)


Mesher = Callable[[Size], tuple[Part, ...]]
Symbol = Callable[[Size], tuple[NDArray[np.float64], ...]]
Covering = Callable[[Size], Footprint]
OutlineMesher = Callable[[Size, Footprint], tuple[Part, ...]]


def covers_box(_size: Size) -> Footprint:
    """The footprint of what covers its whole box."""
    return ()


@dataclass(frozen=True, slots=True)
class Asset:
    """One model: its kind, the sizes it can take, how to draw it in 3D and in plan.

    ``mesh(size)`` gives parts that fill exactly ``[-w/2, w/2] x [-d/2, d/2] x [0, h]``;
    ``symbol(size)`` polylines ``(k, 2)`` in the same frame seen from above (closed ones repeat
    their first point). ``style`` and ``colour`` are words, where somebody stated them or they show.
    ``footprint(size)`` is the polygon it covers, empty where that is its box; ``over(size,
    footprint)``, if there is one, draws it over any other (nothing: it cannot). What is ``called``
    something draws only what is asked for by one of these words (a car, among islands). ``suit``
    is the set it is made to match (shelves of one fitting, of which a shop has one).
    """

    id: str
    category: str
    name: str
    smallest: Size
    usual: Size
    largest: Size
    mesh: Mesher
    symbol: Symbol
    licence: str = "Apache-2.0"
    author: str = "Scenewright"
    style: str = ""
    colour: str = ""
    footprint: Covering = covers_box
    over: OutlineMesher | None = None
    called: tuple[str, ...] = ()
    suit: str = ""


class Member(NamedTuple):
    """One object of a group, in the group's frame (origin in the middle of its footprint, front
    to +y): centre ``x, y``, height ``z`` of the underside, ``heading`` relative to the group's
    front, ``size``, ``on``, the index of the member it stands on (-1: none), and ``asset``, the
    model to draw it with (empty: any that suits)."""

    category: str
    x: float
    y: float
    z: float
    heading: float
    size: Size
    on: int = -1
    asset: str = ""


class Group(NamedTuple):
    """A furniture group: objects that serve one function together, with their footprint.

    ``width`` (local x) and ``depth`` (local y) include the free space the group needs inside.
    """

    function: str
    name: str
    width: float
    depth: float
    members: tuple[Member, ...]

    def __hash__(self) -> int:
        """A hash without the members, which take as long as what is looked up by it."""
        return hash(self[:4])


SHOWN_AS = ("diorama", "ジオラマ")
"""Words for how something is shown, not what it is."""


@dataclass(frozen=True, eq=False)
class Catalog:
    """Kinds by category and assets by id; for models of a user's own catalogues ``names``, other
    names in lower case with the ids they may mean, and ``broken``, why one could not be read."""

    kinds: dict[str, Kind] = field(default_factory=dict)
    assets: dict[str, Asset] = field(default_factory=dict)
    names: dict[str, tuple[str, ...]] = field(default_factory=dict)
    broken: dict[str, str] = field(default_factory=dict)

    def of(self, category: str) -> tuple[Asset, ...]:
        """All assets of a category, in table order (empty if there are none)."""
        return tuple(a for a in self.assets.values() if a.category == category)

    def choose(self, category: str, size: Size) -> Asset | None:
        """The asset of a category whose size range lies nearest to ``size``; ``None`` if none.
        Those that are ``called`` something are left aside."""
        return _chosen(self, category, size)

    def choose_called(self, category: str, name: str, number: int = 0) -> Asset | None:
        """Of the assets of a category called by a word of a ``name``, its last such word, the
        ``number``-th in turn; ``None`` if there are none. Of a *mammoth diorama* the mammoth
        is drawn: words for how something is shown count last."""
        found = _called(self, category, name)
        return found[number % len(found)] if found else None


@lru_cache(maxsize=8192)
def _chosen(catalog: Catalog, category: str, size: Size) -> Asset | None:
    found = [a for a in catalog.of(category) if not a.called]
    return min(found, key=lambda a: _misfit(a, size)) if found else None


@lru_cache(maxsize=8192)
def _called(catalog: Catalog, category: str, name: str) -> tuple[Asset, ...]:
    said = re.findall(r"[^\W\d_]+", name.casefold())[::-1]
    for word in sorted(said, key=lambda word: any(_means(word, w) for w in SHOWN_AS)):
        found = [a for a in catalog.of(category) if any(_means(word, w) for w in a.called)]
        if found:
            return tuple(found)
    return ()


def _misfit(asset: Asset, size: Size) -> float:
    limits = zip(asset.smallest, size, asset.largest, strict=True)
    outside = sum(max(low - wish, 0.0) + max(wish - high, 0.0) for low, wish, high in limits)
    return outside + 1e-3 * sum(abs(a - b) for a, b in zip(size, asset.usual, strict=True))


def _means(word: str, called: str) -> bool:
    """Whether a word is another one or its plural, or a compound that ends in it.

    >>> _means("longboats", "boat"), _means("cars", "car"), _means("carpet", "car")
    (True, True, False)
    """
    ends = (called, f"{called}s", f"{called}es", f"{called}e", f"{called}en")
    long = len(called) > LONG or not called.isascii()
    return word in ends or (long and word.endswith(ends))


def asset_of(piece: Piece, catalog: Catalog) -> Asset | None:
    """The asset that draws a piece: the one it names, else the nearest of its category."""
    return catalog.assets.get(piece.asset) or catalog.choose(piece.category, piece.size)


def footprint_of(asset: Asset | None, size: Size) -> Footprint:
    """The polygon a model covers at some size; empty for its box."""
    return asset.footprint(size) if asset else ()
