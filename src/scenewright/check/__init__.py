"""The referee: is the answer right? Exact geometry on the final pieces.

It shares no code with what it judges: it sees the brief, the rooms made of it and the pieces,
never patches, costs or kernels. Definitions follow SceneEval (Tam, Pun, Wang, Chang, Savva 2025,
"SceneEval: Evaluating Semantic Coherence in Text-Conditioned 3D Indoor Scene Synthesis"); where
ours differ the module of the test says how.
"""

from __future__ import annotations

from scenewright.brief import Brief, Room
from scenewright.catalog import Catalog
from scenewright.check.accessible import Barriers, find_barriers
from scenewright.check.bodies import Bodies, Rooms, bodies_of, rooms_of
from scenewright.check.bounds import find_out_of_bounds, find_unsupported
from scenewright.check.ceilings import find_through_slopes
from scenewright.check.collisions import find_collisions
from scenewright.check.complete import (
    ESSENTIALS,
    USABLE,
    expected,
    find_doorless,
    find_incomplete,
    find_unknown,
    inscribed_width,
    room_figures,
)
from scenewright.check.hall_figures import Verdict, judge_halls
from scenewright.check.halls import Hall, halls_of
from scenewright.check.openings import find_blocked
from scenewright.check.outlets import connections_of, connections_told
from scenewright.check.radiators import find_shut_in
from scenewright.check.reach import find_unreachable
from scenewright.check.report import KINDS, Finding, Note, Report, count_by_kind
from scenewright.check.routes import (
    ROBOT_RADIUS,
    Ground,
    Walk,
    grounds_of,
    navigable_share,
    reachable_share,
    walk_in,
)
from scenewright.check.site_figures import judge_sites
from scenewright.check.site_notes import find_small
from scenewright.check.stairs import find_blocked_stairs, find_cut_off
from scenewright.check.wishes import wishes_told
from scenewright.solution import Solution
from scenewright.space import Space
from scenewright.stock import catalog_of

__all__ = [
    "ESSENTIALS", "KINDS", "USABLE", "Finding", "Note", "Report", "check", "expected",
    "inscribed_width",
]  # fmt: skip


def check(
    solution: Solution,
    *,
    spaces: tuple[Space, ...] | None = None,
    catalog: Catalog | None = None,
) -> Report:
    """Judge a solution: every violation, what is missing, and figures.

    ``spaces`` are the rooms, made of the solution's brief unless given; ``catalog`` tells how
    each category is used, the shipped one unless given. Nothing the pieces hold, however broken,
    raises an error: it becomes a finding.
    """
    if solution.brief.sites:
        return _of_sites(solution)
    rooms = rooms_of(_spaces(solution) if spaces is None else spaces)
    bodies, malformed = bodies_of(solution.pieces, rooms, catalog or _shipped())
    grounds = grounds_of(rooms, solution.brief.route_width)
    walks = [walk_in(bodies, ground, solution.brief.route_width / 2) for ground in grounds]
    narrow = [walk_in(bodies, ground, ROBOT_RADIUS) for ground in grounds]
    halls, told = _halls(solution, bodies, rooms)
    verdict = _judged(solution, halls, bodies, grounds, walks, narrow)
    groups = [group for hall in halls for group in hall.groups]
    barriers = Barriers([], [], {})
    if solution.brief.accessible and solution.brief.domain == "home":
        fixed = tuple(piece for piece in solution.pieces if piece.fixed)
        given, _ = bodies_of(fixed, rooms, catalog or _shipped())
        barriers = find_barriers(bodies, given, rooms, grounds, walks)
    unserved, unreached, connected = connections_told(connections_of(bodies, rooms), bodies, rooms)
    findings = (
        *malformed,
        *told,
        *find_collisions(bodies, rooms.levels),
        *find_out_of_bounds(bodies, rooms),
        *find_through_slopes(bodies, rooms),
        *find_blocked(bodies, rooms),
        *find_shut_in(bodies, rooms),
        *unserved,
        *find_blocked_stairs(bodies, rooms),
        *find_unreachable(bodies, rooms, grounds, walks, groups),
        *verdict.findings,
        *find_unsupported(bodies, rooms),
        *barriers.findings,
    )
    figures = {
        "pieces": len(solution.pieces),
        "counts": count_by_kind(findings),
        "navigable_share": navigable_share(bodies, rooms, grounds),
        "reachable_share": reachable_share(bodies, rooms, grounds, narrow),
        "rooms": room_figures(bodies, rooms),
        **barriers.figures,
    }
    if halls:
        figures["halls"] = verdict.figures
    if any(room.wishes for room in solution.brief.rooms):
        figures["wishes"] = wishes_told(bodies, rooms, solution.brief.rooms)
    if connected:
        figures["outlets"] = connected
    missing = _missing(solution.brief, bodies, rooms)
    notes = (*missing, *unreached, *verdict.notes, *barriers.notes)
    return Report(findings, notes, figures)


def _missing(brief: Brief, bodies: Bodies, rooms: Rooms) -> list[Note]:
    """Ways into rooms and to levels that are missing, and what rooms of homes lack."""
    found = [*find_doorless(bodies, rooms), *find_cut_off(brief, bodies, rooms)]
    if brief.domain != "home":
        return found
    from scenewright.plan import room_ids

    unknown = find_unknown(dict(zip(room_ids(brief), brief.rooms, strict=True)), bodies, rooms)
    return [*found, *find_incomplete(bodies, rooms), *unknown]


def _of_sites(solution: Solution) -> Report:
    """The report on an answer to a brief of sites."""
    models = catalog_of(solution.brief.catalogs)
    findings, by_site = judge_sites(solution.brief.sites, solution.pieces, models)
    counts = count_by_kind(tuple(findings))
    figures = {"pieces": len(solution.pieces), "counts": counts, "sites": by_site}
    return Report(tuple(findings), tuple(find_small(solution.brief.sites, models)), figures)


def _halls(solution: Solution, bodies: Bodies, rooms: Rooms) -> tuple[list[Hall], list[Finding]]:
    """The spaces of an answer with a scene graph as halls; none for a home."""
    if solution.graph is None:
        return [], []
    passage = solution.brief.passage_width
    wishes = _wishes(solution)
    return halls_of(solution.graph, solution.tours, wishes, passage, bodies, rooms)


def _judged(
    solution: Solution, halls: list[Hall], bodies: Bodies, grounds: list[Ground],
    walks: list[Walk], narrow: list[Walk],
) -> Verdict:  # fmt: skip
    if not halls:
        return Verdict([], [], {})
    wishes = _wishes(solution)
    return judge_halls(solution.brief, wishes, halls, bodies, grounds, walks, narrow)


def _wishes(solution: Solution) -> dict[str, Room]:
    """The rooms of the brief by the id of their space."""
    from scenewright.plan import room_ids

    return dict(zip(room_ids(solution.brief), solution.brief.rooms, strict=True))


def _spaces(solution: Solution) -> tuple[Space, ...]:
    from scenewright.plan import spaces

    return spaces(solution.brief)


def _shipped() -> Catalog:
    """Only the table of kinds: the referee never looks at models."""
    from scenewright.assets.kinds import KINDS

    return Catalog(KINDS)
