"""What makes two layouts of one brief different, in words."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Mapping

from scenewright.catalog.loading import catalog_of
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.engine.preference.features import stands_on_floor

MOST = 10
"""Lines that are told, the greatest differences first."""
MOVED, TURNED = 0.5, 0.3
"""Metres and radians from which a piece counts as standing elsewhere."""
NOTED = 0.1
"""How much of the larger of two figures they differ by before it is told."""
WORDS = {
    "density": ("fuller", "emptier"),
    "open": ("more open floor", "less open floor"),
    "from_edge": ("more in the middle", "more along the edges"),
    "enclosure": ("more enclosed", "less enclosed"),
    "mixing": ("more mixed", "less mixed"),
    "term daylight": ("less daylight where it is wanted", "more daylight where it is wanted"),
    "term sun": ("more sun", "less sun"),
    "trees": ("more trees", "fewer trees"),
    "height": ("taller", "lower"),
    "floor area": ("larger buildings", "smaller buildings"),
    "tour": ("a longer way round", "a shorter way round"),
}
"""What a figure means where it is higher, and where it is lower."""


def describe_differences(
    one: Solution, other: Solution, figures: Mapping[str, float], others: Mapping[str, float]
) -> list[str]:
    """At most :data:`MOST` lines on what ``one`` is or has against ``other``: pieces only one of
    them has, pieces that stand elsewhere, and what their ``figures`` say."""
    mine, theirs = _group(one), _group(other)
    kinds = catalog_of(one.brief.catalogs).kinds
    counts: dict[str, Counter[str]] = {"also": Counter(), "without": Counter()}
    moves = []
    for space, category in sorted({*mine, *theirs}):
        name = kinds[category].name if category in kinds else category.replace("_", " ")
        here, there = mine[space, category], theirs[space, category]
        more = len(here) - len(there)
        if more:
            counts["also" if more > 0 else "without"][f"{name} ({space})"] += abs(more)
        elif len(here) == 1 and (told := _tell_move(here[0], there[0])):
            moves.append((_area(here[0]), f"{space}: {name} {told}"))
    rows = [f"{word} {_list(found)}" for word, found in counts.items() if found]
    moved = [text for _, text in sorted(moves, key=lambda row: -row[0])]
    compared = _compare_figures(figures, others)
    return [*rows, *compared[: MOST // 2], *moved][:MOST]


def _group(solution: Solution) -> defaultdict[tuple[str, str], list[Piece]]:
    found: defaultdict[tuple[str, str], list[Piece]] = defaultdict(list)
    for piece in solution.pieces:
        if stands_on_floor(piece):
            found[piece.space, piece.category].append(piece)
    return found


def _area(piece: Piece) -> float:
    return piece.size[0] * piece.size[1]


def _tell_move(piece: Piece, before: Piece) -> str:
    """How far a piece stands from where it does in the other; empty if it stands there."""
    x, y = piece.pose.x - before.pose.x, piece.pose.y - before.pose.y
    turn = abs(math.remainder(piece.pose.heading - before.pose.heading, math.tau))
    far = math.hypot(x, y)
    told = [f"{far:.1f} m away"] if far >= MOVED else []
    if turn >= TURNED:
        told.append(f"turned by {round(math.degrees(turn))}°")
    return ", ".join(told)


def _list(found: Counter[str]) -> str:
    return ", ".join(name if count == 1 else f"{count} × {name}" for name, count in found.items())


def _compare_figures(figures: Mapping[str, float], others: Mapping[str, float]) -> list[str]:
    """What figures say, the greatest difference first.

    >>> _compare_figures({"open": 0.4, "desk to window": 0.2}, {"open": 0.3, "desk to window": 0.8})
    ['desk nearer the window', 'more open floor']
    """
    found = []
    for name in figures.keys() & others.keys():
        a, b = float(figures[name]), float(others[name])
        share = abs(a - b) / max(abs(a), abs(b), 1e-9)
        thing, _, place = name.replace("reading", "reading chair").partition(" to ")
        if place:
            way = f"{thing} nearer the {place}", f"{thing} further from the {place}"
            words = way[::-1]
        else:
            words = WORDS.get(name, ("", ""))
        if words[0] and math.isfinite(share) and share >= NOTED:
            found.append((-share, words[0] if a > b else words[1]))
    return [text for _, text in sorted(found)]
