"""The same home in many looks: style and colours, time of day, how far doors stand open, how much
lies about; and how many live there, which is drawn with the home itself.

Each is drawn by a stream of random numbers of its own (of plan, seed, number of the look and the
name of what is varied), so that leaving one out changes none of the others. What is drawn becomes
part of the brief: a scene of a look is that brief arranged with that seed.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple
from zlib import crc32

import numpy as np

from scenewright.clutter.rows import AMOUNTS
from scenewright.core.brief import Brief, Door, Room
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution
from scenewright.render.daylight import HOURS
from scenewright.workflow.manifest import plan_hash

OF_LOOKS = ("style", "light", "doors", "poses", "clutter")
"""What is varied from look to look."""
OF_HOMES = ("residents",)
"""What is varied from seed to seed, if named."""
WIDE_OPEN = 1.55
"""How far a door stands open at most, in radians: its swing is kept free up to there."""
SHUT, OPEN = 0.3, 0.6
"""Share of doors that are shut, and up to which they are wide open; others stand in between."""
BEDS = {"double_bedroom": 2, "bedroom": 2}
"""Who sleeps in a bedroom at most, where more than one does."""


class Look(NamedTuple):
    """One look of a home: the seed of the home, the number of the look from 1 (0: as it is asked
    for), and what is varied."""

    seed: int
    number: int
    vary: tuple[str, ...]


def check_vary(vary: Sequence[str]) -> tuple[str, ...]:
    """What is to be varied, each once. Raises :class:`InputError` for what cannot be.

    >>> check_vary(["doors", "doors"])
    ('doors',)
    """
    for name in vary:
        if name not in OF_LOOKS + OF_HOMES:
            known = ", ".join(OF_LOOKS + OF_HOMES)
            raise InputError(f"--vary '{name[:40]}' is nothing that varies", f"choose of: {known}")
    return tuple(dict.fromkeys(vary))


def stream_of(brief: Brief, look: Look, what: str) -> np.random.Generator:
    """The random numbers of one thing varied in a look of a plan."""
    number = 0 if what in OF_HOMES else look.number
    drawn = f"{what} {plan_hash(brief)}"
    return np.random.default_rng([look.seed, number, crc32(drawn.encode())])


def vary_brief(brief: Brief, look: Look) -> Brief:
    """The brief of a look; what its author states of residents and hour stays as it is.

    >>> from scenewright.formats import read
    >>> varied = vary_brief(read("sample:home-room"), Look(0, 1, ("style", "light")))
    >>> varied.style, varied.hour
    ('japandi plum', 'dusk')
    """
    changed: dict[str, object] = {}
    if "residents" in look.vary and brief.residents is None:
        changed["residents"] = _draw_residents(brief.rooms, stream_of(brief, look, "residents"))
    if look.number and "style" in look.vary:
        changed["style"] = _draw_style(brief, stream_of(brief, look, "style"))
    if look.number and "light" in look.vary and not brief.hour:
        changed["hour"] = [*HOURS][int(stream_of(brief, look, "light").integers(len(HOURS)))]
    if look.number and "doors" in look.vary:
        changed["rooms"] = _open_doors(brief.rooms, stream_of(brief, look, "doors"))
    return brief.model_copy(update=changed)


def draw_clutter(brief: Brief, look: Look | None, asked: str) -> str:
    """How many small objects are about: as ``asked`` for, unless a look draws it."""
    if look is None or not look.number or "clutter" not in look.vary:
        return asked
    return AMOUNTS[int(stream_of(brief, look, "clutter").integers(len(AMOUNTS)))]


def _draw_style(brief: Brief, rng: np.random.Generator) -> str:
    """A palette with its style, among those that the brief's style leaves; its own style where its
    domain has no palettes."""
    domain = domain_of(brief.domain)
    listed = domain.verb("styles")() if domain.has("styles") else []
    asked = set(re.split(r"[\s,/]+", brief.style.casefold()))
    rows = [row for row in listed if row["palettes"]]
    kept = [row for row in rows if asked & {row["name"], *row["also"].split()}] or rows
    every = [(row["name"], name) for row in kept for name in row["palettes"].split()]
    named = [row for row in every if row[1] in asked] or every
    return " ".join(named[int(rng.integers(len(named)))]) if named else brief.style


def _draw_residents(rooms: Sequence[Room], rng: np.random.Generator) -> int | None:
    """From one to as many as the bedrooms are for; None where there are none."""
    named = [(r.function,) if isinstance(r.function, str) else r.function or () for r in rooms]
    sleeping = [[f for f in each if f.endswith("bedroom")] for each in named]
    most = sum(max(BEDS.get(f, 1) for f in each) for each in sleeping if each)
    return int(rng.integers(1, most + 1)) if most else None


def _open_doors(rooms: Sequence[Room], rng: np.random.Generator) -> list[Room]:
    """The rooms with every leaf that turns as far open as is drawn."""
    return [
        room.model_copy(update={"doors": [_open_door(door, rng) for door in room.doors]})
        for room in rooms
    ]


def _open_door(door: Door, rng: np.random.Generator) -> Door:
    share, between = rng.random(2)
    if door.swing not in ("in", "out"):
        return door
    ajar = 0.0 if share < SHUT else WIDE_OPEN if share < OPEN else 0.1 + 1.4 * between
    return door.model_copy(update={"ajar": round(float(ajar), 3)})


def describe_look(solution: Solution) -> dict[str, object]:
    """What a look has drawn, as its solution says; of doors by room, in radians."""
    brief, clutter = solution.brief, solution.clutter
    doors = {
        room.id or room.name or str(number): [door.ajar for door in room.doors]
        for number, room in enumerate(brief.rooms)
        if any(door.ajar is not None for door in room.doors)
    }
    said: dict[str, object] = {
        "style": brief.style,
        "hour": brief.hour,
        "residents": brief.residents,
    }
    said |= {"doors": doors, "clutter": clutter if clutter != AMOUNTS[0] else ""}
    return {key: value for key, value in said.items() if value}
