"""The home after a change: new in the rooms it touched, as it was in all others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain

from scenewright.catalog.loading import catalog_of
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.home.changes.belonging import consistent
from scenewright.domains.home.changes.edits import EditedHome
from scenewright.domains.home.changes.lacking import moved_out, still_missing
from scenewright.domains.home.changes.lights import completed_as_before
from scenewright.domains.home.changes.revised import Revised, list_placed
from scenewright.domains.home.furnishing.look import apply_style
from scenewright.domains.home.reasons import left_out, patches, terms
from scenewright.domains.home.walking.home_floor import HomeFloor
from scenewright.domains.home.walking.kept_ways import find_barring_screens


def assemble_home(
    solution: Solution,
    rooms: tuple[Space, ...],
    floors: Sequence[HomeFloor],
    found: Mapping[str, Revised],
    change: EditedHome,
    seconds: float,
) -> Solution:
    """The whole solution: new in the touched rooms, as it was in all others."""
    pieces, drawn, values, missing = [], [], [], []
    order = {piece.id: number for number, piece in enumerate(solution.pieces)}
    energies = {k: v for k, v in solution.energies.items() if k not in found}
    for space in rooms:
        if space.id not in found:
            pieces += [p for p in change.pieces if p.space == space.id]
            drawn += [p for p in solution.patches if p.space == space.id]
            values += [t for t in solution.terms if t.space == space.id]
            missing += [o for o in solution.left_out if o.space == space.id]
            continue
        revised = found[space.id]
        here = [p for p in solution.pieces if p.space == space.id]
        standing = list_placed(revised)
        furnished = completed_as_before(revised.task, standing, here)
        pieces += sorted(furnished, key=lambda p: order.get(p.id, len(order)))
        answer = revised.rest.answer
        whole = answer._replace(placed=(*revised.held, *answer.placed))
        costs = terms(revised.bare, whole)
        drawn += patches(revised.bare, whole)
        values += costs
        energies[space.id] = sum(value.cost for value in costs)
        missing += [
            *still_missing(solution, space.id, whole),
            *moved_out(revised.bare, rooms, standing, solution.pieces, change),
            *left_out(revised.bare, answer),
            *revised.given_up,
        ]
    catalog = catalog_of(solution.brief.catalogs)
    placed = chain(*(list_placed(revised) for revised in found.values()))
    narrow = find_barring_screens(placed, pieces, rooms, floors, catalog)
    return replace(
        solution,
        pieces=apply_style(
            consistent([narrow.get(p.id, p) for p in pieces]),
            solution.brief,
            (space.id for space in rooms),
            catalog,
            solution.seed,
        ),
        patches=tuple(drawn),
        terms=tuple(values),
        left_out=tuple(dict.fromkeys(missing)),
        energies=energies,
        seconds=seconds,
        evaluations=sum(r.rest.answer.evaluations for r in found.values()),
    )
