"""Worktop beside hob and sink, read off the run of cabinets they stand in.

A fridge no higher than the worktop that stands in the run, touching a cabinet of it, has worktop
over it that one works at as over a dishwasher. By itself it is a fridge and no worktop, and a tall
one ends the worktop. The baseline has fridges of 1.85 m and more only, so its figures stand.
"""

from __future__ import annotations

from math import cos, hypot, remainder, sin, tau

from scenewright.core.scene import Piece

WORKTOP = (
    *("base_cabinet", "drawer_cabinet", "corner_cabinet", "filler_panel", "dishwasher"),
    "washing_machine",
)
RUN = (*WORKTOP[:-1], "sink_cabinet", "hob_cabinet")
UNDER = 0.95  # a fridge no higher is under the worktop, metres
TOUCH = 0.03  # cabinets nearer than this have one worktop, metres
RAISED = 0.3  # what begins so high is no unit of a run, metres
LEAST = 0.6  # of worktop in one piece, metres
BESIDE = 0.28  # of worktop beside a hob, metres


def _run_of(piece: Piece, pieces: list[Piece], side: int) -> float:
    """Metres of worktop that begin at one side of a piece: ``side`` +1 is its right."""
    length, at = 0.0, piece
    while True:
        following = next((p for p in pieces if p is not at and _touches(at, p, side)), None)
        if following is None or not _is_top(following, pieces):
            return length
        length, at = length + following.size.width, following


def _is_top(piece: Piece, pieces: list[Piece]) -> bool:
    """Whether a piece has worktop on it."""
    return (piece.category in WORKTOP and piece.pose.z < RAISED) or is_under(piece, pieces)


def is_under(piece: Piece, pieces: list[Piece]) -> bool:
    """Whether a piece is a fridge or a washing machine under the worktop of a run."""
    if piece.category not in ("fridge", "washing_machine") or piece.size.height > UNDER:
        return False
    run = [p for p in pieces if p.category in RUN]
    return any(neighbour(piece, run, side) is not None for side in (-1, 1))


def neighbour(piece: Piece, pieces: list[Piece], side: int) -> Piece | None:
    """What of the kitchen stands at one side of a cabinet in the same line."""
    return next((p for p in pieces if p is not piece and _touches(piece, p, side)), None)


def _touches(one: Piece, other: Piece, side: int) -> bool:
    corner = "corner_cabinet" in (one.category, other.category)  # its top lies along both walls
    turned = abs(remainder(one.pose.heading - other.pose.heading, tau / 4 if corner else tau)) > 0.1
    if turned or other.pose.z > RAISED:
        return False
    s, c = sin(one.pose.heading), cos(one.pose.heading)
    dx, dy = other.pose.x - one.pose.x, other.pose.y - one.pose.y
    along, ahead = side * (s * dx - c * dy), c * dx + s * dy
    gap = along - (one.size.width + other.size.width) / 2
    return abs(gap) < TOUCH and abs(ahead) < 0.3


def _first(pieces: list[Piece], category: str) -> Piece:
    return next(p for p in pieces if p.category == category)


def short_worktop(pieces: list[Piece]) -> bool:
    """Less than 0.6 m of worktop in one piece anywhere."""
    tops = [p for p in pieces if _is_top(p, pieces)]
    return not any(p.size.width + _run_of(p, pieces, 1) >= LEAST - 1e-6 for p in tops)


def hob_at_sink(pieces: list[Piece]) -> bool:
    """The hob stands next to the sink, with no worktop between."""
    hob, sink = _first(pieces, "hob_cabinet"), _first(pieces, "sink_cabinet")
    apart = hypot(hob.pose.x - sink.pose.x, hob.pose.y - sink.pose.y)
    return apart - (hob.size.width + sink.size.width) / 2 < BESIDE


def hob_at_end(pieces: list[Piece]) -> bool:
    """Less than 0.28 m of worktop on one side of the hob."""
    hob = _first(pieces, "hob_cabinet")
    return min(_run_of(hob, pieces, side) for side in (-1, 1)) < BESIDE
