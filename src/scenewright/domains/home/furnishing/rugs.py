"""Which rug lies where: one of a home's style before its sofa, quiet ones in other rooms.

A pattern that returns in every room, the bath included, is the first thing a visitor sees. So a
rug that lies before no sofa is drawn by a model of its place: a bath mat beside what is washed in,
a runner where it lies alone and is long and narrow, else a rug in two cloths of the palette.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from scenewright.catalog.classes import SOFAS
from scenewright.core.scene import Piece

RUG, RUNNER, BATH_MAT, QUIET = "rug", "rug_runner", "rug_bath", "rug_quiet"
WET = frozenset(("bathtub", "shower", "toilet"))
SLENDER = 1.9
"""Ratio of length to width from which a rug is a runner."""


def match_rugs(pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """Pieces whose rugs are drawn by the models of their places; a rug that came with the brief
    and a model of a user's own stay as they are.

    >>> from scenewright.core.scene import Pose, Size
    >>> at, size = Pose(0, 0, 0, 0), Size(2.0, 0.8, 0.012)
    >>> rug = Piece("hall/mat", "rug", "rug", "hall", at, size, "hall")
    >>> [piece.asset for piece in match_rugs([rug])]
    ['rug_runner']
    """
    known = tuple(pieces)
    seated = {place for p in known if p.category in SOFAS for place in (p.space, p.group)}
    wet = {p.space for p in known if p.category in WET}
    return tuple(
        replace(p, asset=_model_of(p, p.space in wet))
        if p.asset == RUG and not p.fixed and p.group not in seated
        else p
        for p in known
    )


def _model_of(rug: Piece, wet: bool) -> str:
    if wet:
        return BATH_MAT
    long, short = max(rug.size[:2]), min(rug.size[:2])
    return RUNNER if rug.group == rug.space and long >= SLENDER * short else QUIET
