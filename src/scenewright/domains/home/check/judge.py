"""The referee of homes: what all rooms share, what a home is to hold, wishes and wheelchairs."""

from __future__ import annotations

from scenewright.building.plan import room_ids
from scenewright.check.bodies import bodies_of
from scenewright.check.plan_notes import (
    note_cut_openings,
    note_labels,
    note_reading,
    note_scale,
    note_unknown_kinds,
    note_vast_rooms,
)
from scenewright.check.rooms import Walked, count_findings, judge_rooms, walk_rooms
from scenewright.check.spaces import find_doorless
from scenewright.check.stairs import find_cut_off
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains.home.check.accessible import Barriers, find_barriers
from scenewright.domains.home.check.complete import (
    find_idle_hoods,
    find_incomplete,
    find_missing,
    find_short_beds,
    find_unknown,
    find_unmet_asks,
)
from scenewright.domains.home.check.wishes import wishes_told
from scenewright.domains.home.furnishing.style_words import note_colours, note_styles


def check(solution: Solution, plan: Plan, kinds: Catalog, figures: bool = True) -> Report:
    """Judge a furnished home; see :func:`scenewright.domains.check`."""
    brief = solution.brief
    walked = walk_rooms(brief, solution.pieces, plan.spaces, kinds, narrow=figures)
    rooms, bodies = walked.rooms, walked.bodies
    shared = judge_rooms(walked, figures=figures)
    barriers = _barriers(solution, walked, kinds) if brief.accessible else Barriers([], [], {})
    asked = dict(zip(room_ids(brief), brief.rooms, strict=True))
    lacking = [
        *find_incomplete(bodies, rooms),
        *find_unmet_asks(asked, bodies, rooms),
        *find_short_beds(brief.residents, bodies),
    ]
    missing = find_missing(lacking, asked, rooms, solution.left_out)
    findings = (*shared.findings, *barriers.findings, *missing)
    notes = (
        *note_reading(brief),
        *note_unknown_kinds(brief, kinds.kinds),
        *note_scale(brief, plan.spaces),
        *note_cut_openings(brief, plan.spaces),
        *note_vast_rooms(rooms.spaces),
        *note_labels(brief, plan.spaces),
        *note_styles(brief, kinds),
        *note_colours(brief, kinds),
        *find_doorless(bodies, rooms),
        *find_cut_off(brief, bodies, rooms),
        *lacking,
        *find_idle_hoods(bodies, rooms),
        *find_unknown(asked, bodies, rooms),
        *shared.notes,
        *barriers.notes,
    )
    told = {**count_findings(solution.pieces, findings), **shared.figures, **barriers.figures}
    if any(room.wishes for room in brief.rooms):
        told["wishes"] = wishes_told(bodies, rooms, brief.rooms)
    return Report(findings, notes, told)


def check_rules(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """The same without the figures all rooms share."""
    return check(solution, plan, kinds, figures=False)


def _barriers(solution: Solution, walked: Walked, kinds: Catalog) -> Barriers:
    """What keeps a wheelchair out, beside what the brief itself put in the way."""
    fixed = tuple(piece for piece in solution.pieces if piece.fixed)
    given, _ = bodies_of(fixed, walked.rooms, kinds)
    return find_barriers(walked.bodies, given, walked.rooms, walked.grounds, walked.walks)
