"""The referee of halls: what all rooms share, then zones, passages, tours and ways out."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from scenewright.building.plan import room_ids
from scenewright.check.owed import find_owed
from scenewright.check.plan_notes import note_cut_openings, note_reading, note_unknown_kinds
from scenewright.check.rooms import count_findings, judge_rooms, walk_rooms
from scenewright.check.spaces import find_doorless
from scenewright.core.brief import Room
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.solution import Solution
from scenewright.domains.hall.check.cross_aisles import find_unbroken_rows
from scenewright.domains.hall.check.demands import find_changed_zones, find_misplaced, list_owed
from scenewright.domains.hall.check.facing import note_seats_turned_away
from scenewright.domains.hall.check.figures import HallVerdict, judge_halls
from scenewright.domains.hall.check.halls import JudgedHall, halls_of
from scenewright.domains.hall.check.zones import note_zone_sizes


def check(solution: Solution, plan: Plan, kinds: Catalog, figures: bool = True) -> Report:
    """Judge a hall as laid out; see :func:`scenewright.domains.check`."""
    brief, detail = solution.brief, solution.detail
    walked = walk_rooms(brief, solution.pieces, plan.spaces, kinds)
    asked = dict(zip(room_ids(brief), brief.rooms, strict=True))
    halls: list[JudgedHall] = []
    faults: list[Finding] = []
    if detail is not None:
        halls, faults = halls_of(
            detail.layout, detail.tours, asked, brief.passage_width, walked.bodies, walked.rooms
        )
    shared = judge_rooms(walked, [group for hall in halls for group in hall.groups], figures)
    verdict = HallVerdict([], [], {})
    if halls:
        verdict = judge_halls(
            brief, asked, halls, walked.bodies, walked.grounds, walked.walks, walked.narrow
        )
    changed = find_changed_zones(halls, asked)
    known = [found for found in verdict.findings if found.kind == "outside_zone"]
    misplaced = [f for hall in halls for f in find_misplaced(hall, asked, walked.bodies, known)]
    owed = find_owed([*list_owed(asked, walked.bodies)], solution.left_out)
    unbroken = find_unbroken_rows(walked.bodies.pieces, plan.spaces, asked)
    rules = (*faults, *verdict.findings, *unbroken)
    findings = (*shared.findings, *rules, *changed, *misplaced, *owed)
    doorless = find_doorless(walked.bodies, walked.rooms, _find_visited(asked))
    turned = note_seats_turned_away(walked.bodies, plan.spaces, asked)
    read = (
        *note_reading(brief),
        *note_unknown_kinds(brief, kinds.kinds),
        *note_cut_openings(brief, plan.spaces),
    )
    sized = [note for hall in halls for note in note_zone_sizes(hall, asked)]
    notes = (*read, *doorless, *turned, *sized, *shared.notes, *verdict.notes)
    told = {**count_findings(solution.pieces, findings), **shared.figures}
    if halls:
        told["halls"] = _add_energies(solution, verdict.figures)
    return Report(findings, notes, told)


def check_rules(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """The same without the figures all rooms share."""
    return check(solution, plan, kinds, figures=False)


def _find_visited(asked: Mapping[str, Room]) -> list[str]:
    """The spaces that hold something for visitors."""
    return [space for space, room in asked.items() if room.demands]


def _add_energies(
    solution: Solution, figures: dict[str, dict[str, Any]]
) -> dict[str, dict[str, Any]]:
    """Figures with the energy of each hall that was solved and its excess over its floor."""
    for space, floor in solution.detail.floors:
        if space in figures and space in solution.energies:
            energy = solution.energies[space]
            above = {"energy": round(energy, 3), "excess": round(energy - floor, 3)}
            figures[space] = {**figures[space], **above}
    return figures
