"""A scene in words: what an agent is told of it, short."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from scenewright.studio.shapes import Json

MOST = 20
"""Lines of one kind that are told before the rest is counted."""
MOST_PIECES = 100
"""Pieces that are told at once."""


def tell_scene(state: Json) -> str:
    """Rooms and what is in them, the verdict, what is wrong and what was left out.

    >>> tell_scene({"version": 0, "history": [], "running": False})
    'nothing is open; use open or begin'
    """
    if not state["version"]:
        return "nothing is open; use open or begin"
    lines = [f"{state['name']}, a {state.get('domain', 'plan')}: version {state['version']}"]
    if state["running"]:
        lines.append("a search is running")
    lines += shorten([*_rooms(state)])
    lines += shorten([f"to mend: {one['message']}" for one in state.get("faults", ())])
    return "\n".join([*lines, *tell_verdict(state)])


def tell_verdict(state: Json) -> list[str]:
    """What the referee says of the scene shown, and what has no place in it."""
    findings = [f"finding: {one['message']}" for one in state.get("findings", ())]
    left = [
        f"left out: {one['what'].replace('_', ' ')} ({one['space']}): {one['reason']}"
        for one in state.get("left_out", ())
    ]
    verdict = state.get("verdict", "").partition("\n")[0]
    return [*([verdict] if verdict else []), *shorten(findings), *shorten(left)]


def tell_pieces(state: Json, space: str = "", first: int = 0) -> str:
    """Pieces of a room or of all, :data:`MOST_PIECES` from the ``first`` on: id, what it is, where
    it stands, its size.

    >>> one = {"id": "bed", "name": "double bed", "space": "r", "pose": [1, 2, 0, 3.14159265],
    ...        "size": [1.6, 2, 0.5], "locked": True, "level": ""}
    >>> tell_pieces({"pieces": [one]})
    'bed · double bed · in r · at 1.00, 2.00, turned 180° · 1.60 x 2.00 m · locked'
    """
    told = [
        " · ".join(
            [
                one["id"],
                one["name"],
                f"in {one['space']}",
                f"at {one['pose'][0]:.2f}, {one['pose'][1]:.2f}, "
                f"turned {round(math.degrees(one['pose'][3])) % 360}°",
                f"{one['size'][0]:.2f} x {one['size'][1]:.2f} m",
                *(["locked"] if one["locked"] else []),
            ]
        )
        for one in state.get("pieces", ())
        if space in ("", one["space"])
    ]
    rest = len(told) - first - MOST_PIECES
    more = [f"and {rest} more, first: {first + MOST_PIECES}"] if rest > 0 else []
    return "\n".join([*told[first : first + MOST_PIECES], *more]) or "no pieces"


def tell_changes(changes: Sequence[Json]) -> list[str]:
    """What was changed and why."""
    return shorten([f"{one['piece']} {one['change']}: {one['reason']}" for one in changes])


def tell_sheet(bred: Json) -> str:
    """The layouts of the sheet shown, by their places."""
    if "shown" not in bred:
        return "no sheet yet; use breed"
    lines = [f"sheet {bred['sheet']}; predictions: {bred['trust']}"]
    for place, one in enumerate(bred["shown"], 1):
        chosen = " · your choice" if one["number"] == bred["champion"] else ""
        predicted = one["predicted"]
        guess = "" if predicted is None else f" · predicted {100 * predicted:.0f} % to be picked"
        faults = f" · {one['faults']}" if one["faults"] else ""
        lines.append(f"{place}: layout {one['number']}{chosen}{guess}{faults}")
    return "\n".join([*lines, f"reasons: {', '.join(bred['reasons'])}"])


def shorten(lines: Sequence[str]) -> list[str]:
    """The first lines, and how many more there are.

    >>> shorten(["a"] * 22)[19:]
    ['a', 'and 2 more']
    """
    rest = len(lines) - MOST
    return [*lines[:MOST], *([f"and {rest} more"] if rest > 0 else [])]


def _rooms(state: Json) -> Iterator[str]:
    held = Counter(piece["space"] for piece in state.get("pieces", ()))
    for level in state.get("levels", ()):
        for one in level["spaces"]:
            where = f" on {level['name']}" if len(state["levels"]) > 1 and level["name"] else ""
            yield f"space {one['id']} ({one['name']}){where}: {held[one['id']]} pieces"
