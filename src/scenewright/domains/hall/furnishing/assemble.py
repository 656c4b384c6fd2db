"""From halls laid out one by one to the solution of a brief."""

from __future__ import annotations

import hashlib
from typing import NamedTuple

from scenewright._version import __version__
from scenewright.core.brief import Brief
from scenewright.core.brief.zones import Demand
from scenewright.core.layout import NamedBox
from scenewright.core.scene import Piece
from scenewright.core.solution import STOPPED, LeftOut, Solution, TermValue
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.floors import least_energies
from scenewright.domains.hall.hall_layout import HallDetail, HallLayout, PlacedGroup, Tour, Zone
from scenewright.domains.hall.presets import PRESETS
from scenewright.engine.energy import Part


class Laid(NamedTuple):
    """One hall laid out; ``zones`` as they lie now and how far borders have moved (empty: as
    before); whether something was ``given_up`` though there is floor for it, for want of a way;
    and the ``picture`` of its objects for who watches."""

    pieces: tuple[Piece, ...]
    groups: tuple[PlacedGroup, ...]
    partitions: tuple[str, ...]
    parts: tuple[Part, ...]
    left_out: tuple[LeftOut, ...]
    energy: float
    evaluations: int
    tour: Tour | None
    zones: tuple[Zone, ...] = ()
    shifts: tuple[tuple[str, float], ...] = ()
    given_up: bool = False
    picture: tuple[NamedBox, ...] = ()


def assemble_solution(
    brief: Brief,
    halls: list[HallContext],
    laid: dict[int, Laid],
    preset: str,
    solver: str,
    seed: int,
    seconds: float,
) -> Solution:
    """The solution of all halls of a brief; those not in ``laid`` hold their fixed objects only."""
    found = [laid.get(number) for number in range(len(halls))]
    done = [answer for answer in found if answer is not None]
    pieces = [
        piece
        for hall, answer in zip(halls, found, strict=True)
        for piece in (*hall.fixed, *(answer.pieces if answer else ()))
    ]
    layout = _layout_of(halls, found)
    terms = tuple(
        TermValue(hall.space.id, part.item, part.term, part.value, part.weight, part.cost)
        for hall, answer in zip(halls, found, strict=True)
        for part in (answer.parts if answer else ())
    )
    printed = PRESETS[preset].settings.printed
    return Solution(
        brief=brief,
        pieces=tuple(pieces),
        patches=(),
        terms=terms,
        left_out=(
            *(out for answer in done for out in answer.left_out),
            *_list_untouched(brief, halls, laid),
        ),
        energies={
            hall.space.id: answer.energy
            for hall, answer in zip(halls, found, strict=True)
            if answer is not None
        },
        preset=preset,
        solver=solver,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=seconds,
        evaluations=sum(answer.evaluations for answer in done),
        detail=HallDetail(
            layout,
            tuple(answer.tour for answer in done if answer.tour is not None),
            tuple(least_energies(terms, layout, printed).items()),
            _shifts_of(halls, found),
        ),
    )


def _list_untouched(brief: Brief, halls: list[HallContext], laid: dict[int, Laid]) -> list[LeftOut]:
    """What halls that were not begun are to hold."""
    return [
        LeftOut(halls[k].space.id, _word(wish), STOPPED, wish.required)
        for k, room in enumerate(brief.rooms)
        for wish in room.demands
        if k not in laid
    ]


def _word(wish: Demand) -> str:
    return f"{wish.count or ''} {wish.name or wish.category.replace('_', ' ')}".strip()


def _layout_of(halls: list[HallContext], found: list[Laid | None]) -> HallLayout:
    """Zones, as they lie now, links, groups and partitions of all halls."""
    done = [answer for answer in found if answer is not None]
    return HallLayout(
        tuple(
            zone
            for hall, answer in zip(halls, found, strict=True)
            for zone in (answer.zones if answer and answer.zones else hall.plan.zones)
        ),
        tuple(link for hall in halls for link in hall.plan.links),
        tuple(group for answer in done for group in answer.groups),
        tuple(wall for answer in done for wall in answer.partitions),
    )


def _shifts_of(
    halls: list[HallContext], found: list[Laid | None]
) -> tuple[tuple[str, str, float], ...]:
    """How far borders of all halls have moved, by space and zones."""
    return tuple(
        (hall.space.id, name, metres)
        for hall, answer in zip(halls, found, strict=True)
        for name, metres in (answer.shifts if answer else ())
    )
