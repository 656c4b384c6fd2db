"""Homes bred room by room: a genome says for each room from which of many answers it is taken."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from threading import Lock

from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.home.alternatives import compose_home
from scenewright.domains.home.features import RoomFeatures, combine_rooms, measure_room
from scenewright.domains.home.solving import solve

ANSWERS = 240
"""Whole homes that rooms are taken from."""
WHOLE = 4
"""Of them as many as are shown as they are, first of all."""


def make_breeder(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """Genes of a home, one a room: whole homes are solved around other walls and with other
    groups (as for alternatives) when a genome first names them, then put together anew."""
    solved: dict[int, Solution] = {}
    busy = [Lock() for _ in range(ANSWERS)]

    def answer(number: int) -> Solution:
        with busy[number]:
            if number not in solved:
                solved[number] = solve(
                    brief, plan=plan, seed=seed + number, variant=number, threads=1
                )
            return solved[number]

    @cache
    def measured(place: int, number: int) -> tuple[RoomFeatures, int]:
        room, solution = plan.spaces[place], answer(number)
        lacking = sum(o.required for o in solution.left_out if o.space == room.id)
        return measure_room(solution, room), lacking

    def measure(genome: Genome) -> tuple[dict[str, float], int]:
        rooms = [measured(place, number) for place, number in enumerate(genome)]
        return combine_rooms([room for room, _ in rooms]), sum(lacking for _, lacking in rooms)

    genes = tuple(Gene(room.id, ANSWERS) for room in plan.spaces)
    whole = tuple((number,) * len(genes) for number in range(WHOLE))
    return Breeder(genes, partial(_develop, plan, answer), measure, whole)


def _develop(plan: Plan, answer: Callable[[int], Solution], genome: Genome) -> Solution:
    """The home with each room taken from the answer its gene names."""
    numbers = sorted(set(genome))
    parts = [answer(number) for number in numbers]
    return compose_home(parts, [numbers.index(number) for number in genome], plan.spaces)
