"""Domains: what kinds of scenes can be laid out. Each is one package behind one contract.

The functions here hand a brief or a solution to its domain (:mod:`scenewright.domains.contract`);
what a domain does not support is refused by name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from scenewright.catalog.loading import catalog_of
from scenewright.check.given import locked_ids, mark_locked, restore_footprints, restore_given
from scenewright.check.locating import locate_findings
from scenewright.core.acceptance import accept_findings
from scenewright.core.breeding import Breeder, Gene, MatrixBreeder
from scenewright.core.brief import Brief
from scenewright.core.brief.domain_keys import check_domain
from scenewright.core.catalog import Catalog
from scenewright.core.edits import Adjusted, Edits, check_moves
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.explanation import Explanation
from scenewright.core.layout import Layouts, Watch
from scenewright.core.learned import LearnedGroups
from scenewright.core.passes import PassTrace
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_names, domain_of
from scenewright.core.report import Report
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.contract import Domain
from scenewright.domains.explaining import advise, explain_solution
from scenewright.domains.terrain import check_terrain, draw_ground, judge_ground, lay_on_terrain
from scenewright.engine.preference.features import composition_features

if TYPE_CHECKING:
    from scenewright.drawing.layers import PlanDrawing

__all__ = [
    "adjust",
    "advise",
    "alternatives",
    "breeder_of",
    "check",
    "domain_names",
    "domain_of",
    "domains",
    "draw_levels",
    "draw_plan",
    "explain",
    "features_of",
    "learn_from",
    "learn_groups",
    "matrix_breeder_of",
    "plan_of",
    "plan_valid",
    "presets",
    "problems",
    "reasons_of",
    "resolve",
    "scene_of",
    "solution_of",
    "solve",
    "solvers",
    "trace_passes",
]

CHANCES = 64
"""Seeds that layouts of a domain without genes are made of."""


def domains() -> tuple[Domain, ...]:
    """All domains, those shipped first.

    >>> [domain.name for domain in domains()][:3]
    ['home', 'hall', 'site']
    """
    return tuple(domain_of(name) for name in domain_names())


def plan_of(brief: Brief) -> Plan:
    """The plan of a brief: valid spaces on levels. Raises :class:`InputError`, with the place in
    the brief, for anything that cannot be built."""
    check_domain(brief)
    plan: Plan = domain_of(brief.domain).verb("plan")(brief)
    check_terrain(brief, plan)
    return plan


def plan_valid(brief: Brief, style: str = "") -> Plan:
    """The plan of a brief that its domain can lay out, down to its geometry; a ``style`` named
    beside the brief must be known. Raises :class:`InputError`."""
    plan, domain = plan_of(brief), domain_of(brief.domain)
    if style and domain.has("refuse_style"):
        domain.verb("refuse_style")(brief)
    if domain.has("validate"):
        domain.verb("validate")(brief, plan)
    return plan


def problems(brief: Brief, preset: str = "default", *, plan: Plan | None = None) -> tuple[Any, ...]:
    """A brief as its solvers see it: the problem of each space that is to hold something.

    ``plan`` is that of the brief (made unless given). A domain that does not tell is refused."""
    domain: Domain = domain_of(brief.domain)
    found: tuple[Any, ...] = domain.verb("problems")(brief, preset, plan=plan or plan_of(brief))
    return found


def solve(
    brief: Brief,
    *,
    plan: Plan | None = None,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[float, str], None] | None = None,
    cancel: Callable[[], bool] | None = None,
    watch: Watch | None = None,
) -> Solution:
    """Solve a brief by its domain: a home is furnished, a hall laid out, a site built on.

    ``plan`` is that of the brief (made unless given).
    ``preset`` and ``solver`` are names (``scenewright list presets``). The work is ``steps`` or
    ``seconds``, else what the preset says; the same seed and steps give the same answer.
    ``progress`` is called with the share done and what is being done; when ``cancel`` answers true,
    the best so far is returned. ``watch`` is called with the best layout of a space, from the
    thread that searches; :func:`solution_of` makes a solution of such layouts.

    >>> from scenewright.formats import read
    >>> best = {}
    >>> def watch(layout): best[layout.space] = layout.rows()
    >>> _ = solve(read("sample:home-room"), steps=200, watch=watch)
    >>> sorted(row.name for row in best["room"])[:2]
    ['desk', 'dining_wall']
    """
    domain = domain_of(brief.domain)
    watched = {"watch": watch} if watch and domain.takes("solve", "watch") else {}
    solution: Solution = domain.verb("solve")(
        brief,
        plan=plan or plan_valid(brief),
        preset=preset,
        solver=solver,
        seconds=seconds,
        steps=steps,
        seed=seed,
        threads=threads,
        progress=progress,
        cancel=cancel,
        **watched,
    )
    return solution


def solution_of(
    brief: Brief, layouts: Layouts, *, plan: Plan | None = None, seed: int = 0
) -> Solution:
    """The solution of a layout made by hand or by another program.

    ``layouts`` holds, by the id of each room, hall or site, rows of a name and a box (x, y,
    heading, width, depth) in metres and radians: patches of furniture groups in homes, objects by
    the id of their demand in halls, buildings by name or model on sites. The solution is furnished
    and explained like one of :func:`solve`; ``check`` judges it. Raises :class:`InputError` for a
    space, name or size there is not.
    """
    verb = domain_of(brief.domain).verb("solution")
    solution: Solution = verb(brief, layouts, plan=plan, seed=seed)
    return solution


def check(
    solution: Solution,
    *,
    plan: Plan | None = None,
    spaces: tuple[Space, ...] | None = None,
    catalog: Catalog | None = None,
    figures: bool = True,
) -> Report:
    """Judge a solution: every violation and where it lies, what is missing, and figures.

    ``plan`` is that of the solution's brief (made unless given), ``spaces`` take the place of its
    spaces; ``catalog`` tells how each category is used (that of the brief unless given). Nothing
    the pieces hold, however broken, raises an error: it becomes a finding. What is given, and what
    is asked for, follows from the brief alone. Findings that the brief has ``accepted`` say why.
    Without ``figures`` those of rooms, most of the work, are left out.
    """
    brief, made = solution.brief, plan or plan_of(solution.brief)
    kinds, domain = catalog or catalog_of(brief.catalogs), domain_of(brief.domain)
    given = domain.verb("given")(brief, made, kinds) if domain.has("given") else ()
    pieces = restore_footprints(solution.pieces, kinds) if domain.rooms else solution.pieces
    restored = restore_given(pieces, given, locked_ids(brief))
    judged = replace(solution, pieces=restored.pieces)
    made = made if spaces is None else made._replace(spaces=spaces)
    quick = not figures and domain.has("findings")
    judge = domain.verb("findings") if quick else domain.verb("check")
    report: Report = judge_ground(judged, made, judge(judged, made, kinds))
    told = (*restored.findings, *report.findings)
    found = mark_locked(told, restored.locked)
    placed = locate_findings(found, judged.pieces, made.spaces)
    report = replace(report, findings=placed, unplaced=sum(o.required for o in solution.left_out))
    return accept_findings(report, brief.accepted, solution.pieces)


def explain(solution: Solution, *, plan: Plan | None = None) -> Explanation:
    """Why a solution is as it is, in words: what was decided, what was not placed and why, what
    the layout gives up, and what helps. ``print`` shows it as ``scenewright explain`` does.

    >>> from scenewright.formats import read
    >>> told = explain(solve(read("sample:home-room"), steps=200))
    >>> told.decided.startswith("1 person")
    True
    """
    return explain_solution(solution, plan or plan_of(solution.brief))


def scene_of(solution: Solution, plan: Plan | None = None) -> Scene:
    """The scene of a solution: its surroundings, its pieces, and the small objects on them."""
    made = plan or plan_of(solution.brief)
    flat = domain_of(solution.brief.domain).verb("scene")(solution, made)
    scene: Scene = lay_on_terrain(flat, solution, made)
    if solution.clutter == "none":
        return scene
    from scenewright.clutter import with_clutter

    return with_clutter(scene, catalog_of(solution.brief.catalogs), solution.clutter, solution.seed)


def draw_plan(solution: Solution, plan: Plan | None = None) -> PlanDrawing:
    """The plan of a solution to print."""
    made, draw = plan or plan_of(solution.brief), domain_of(solution.brief.domain).verb("draw")
    drawing: PlanDrawing = draw(solution, made, partial(check, solution, plan=made))
    return draw_ground(drawing, solution, made)


def draw_levels(solution: Solution, plan: Plan | None = None) -> tuple[PlanDrawing, ...]:
    """The plan of a solution as sheets of one level each; one sheet for all where its domain
    does not part them."""
    domain: Domain = domain_of(solution.brief.domain)
    if not domain.has("draw_levels"):
        return (draw_plan(solution, plan),)
    made = plan or plan_of(solution.brief)
    judge = partial(check, solution, plan=made)
    sheets: tuple[PlanDrawing, ...] = domain.verb("draw_levels")(solution, made, judge)
    return sheets or (draw_plan(solution, made),)


def alternatives(
    brief: Brief,
    count: int,
    *,
    plan: Plan | None = None,
    seed: int = 0,
    progress: Callable[[float, str], None] | None = None,
    cancel: Callable[[], bool] | None = None,
    **options: Any,
) -> tuple[Solution, ...]:
    """``count`` solutions that differ, best first, as the domain makes them (fewer, where no more
    differ); a domain without a way of its own answers by other seeds. ``options`` are those of
    :func:`solve`."""
    domain: Domain = domain_of(brief.domain)
    made = plan or plan_of(brief)
    if domain.has("alternatives"):
        told = {"plan": made, "seed": seed, "progress": progress, "cancel": cancel}
        plans: tuple[Solution, ...] = domain.verb("alternatives")(brief, count, **told, **options)
        return plans
    found = []
    for k in range(count):
        found.append(solve(brief, plan=made, seed=seed + k, cancel=cancel, **options))
        if progress:
            progress((k + 1) / count, f"plan {k + 1} of {count}")
        if cancel is not None and cancel():
            break
    return tuple(sorted(found, key=lambda s: (len(s.left_out), sum(s.energies.values()))))


def resolve(solution: Solution, **edits: Any) -> Solution:
    """Change a furnished home by hand and solve again only what that touches; the arguments are
    those of :func:`adjust`."""
    return adjust(solution, **edits).solution


def adjust(
    solution: Solution,
    *,
    plan: Plan | None = None,
    move: Mapping[str, tuple[float, ...]] | None = None,
    swap: Sequence[tuple[str, str]] = (),
    lock: Sequence[str] = (),
    unlock: Sequence[str] = (),
    again: Sequence[str] = (),
    steps: int | None = None,
    seed: int | None = None,
    cancel: Callable[[], bool] | None = None,
) -> Adjusted:
    """Change a solved scene by hand and solve again only what that touches.

    Pieces and groups are named by id, or by what is enough of it: ``"sofa"``, ``"bedroom/bed"``.
    ``move`` puts them at (x, y) or (x, y, heading) in metres and radians, ``swap`` exchanges two;
    both are locked there, and belong to the room they stand in then. ``lock`` keeps groups where
    they are whatever is solved, ``unlock`` lets them go. In spaces where something was moved as
    little as possible changes: nothing that could stay at no greater cost. Spaces named in
    ``again`` are laid out anew around what is locked (give another ``seed`` for another answer).
    The answer is the ``solution`` and every one of its ``changes`` with the reason; once ``cancel``
    says so there is none (:class:`CancelledError`).
    """
    check_moves(move or {})
    edits = Edits(move or {}, tuple(swap), tuple(lock), tuple(unlock), tuple(again), cancel)
    verb, made = domain_of(solution.brief.domain).verb("adjust"), plan or plan_of(solution.brief)
    adjusted: Adjusted = verb(solution, edits, plan=made, steps=steps, seed=seed)
    if cancel is not None and cancel():
        raise CancelledError("cancelled: nothing was changed")
    return adjusted._replace(solution=replace(adjusted.solution, clutter=solution.clutter))


def learn_groups(homes: Mapping[str, Brief], output: Path) -> LearnedGroups:
    """Learn how people group furniture from furnished scenes of one domain, read with all that
    stands in them as fixed (by file), and write the file of groups that briefs name. A domain
    that cannot learn is refused."""
    learn = domain_of(next(iter(homes.values())).domain).verb("learn")
    found: LearnedGroups = learn(homes, output)
    return found


def learn_from(
    what: str,
    domain: str,
    sources: Sequence[Path],
    output: Path,
    options: Mapping[str, Any],
    read_plan: Callable[[Path], Plan],
    tell: Callable[[float, str], None],
    cancel: Callable[[], bool],
) -> Any:
    """Learn ``what`` ("style" or "nets") from real scenes of a domain and write it as a file that
    briefs name. ``options`` are the domain's; a domain that cannot learn is refused."""
    kind: Domain = domain_of(domain)
    verb = kind.verb("learn_nets") if what == "nets" else kind.verb("learn_style")
    return verb(sources, output, options, read_plan, tell, cancel)


def features_of(solution: Solution, plan: Plan) -> dict[str, float]:
    """What can be liked about a solution, by name, as its domain measures it; for a domain that
    does not, the composition of its pieces."""
    domain: Domain = domain_of(solution.brief.domain)
    has = domain.has("features")
    return dict((domain.verb("features") if has else composition_features)(solution, plan))


def breeder_of(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """How layouts of a brief are bred, as its domain does it; else by seed alone."""
    domain: Domain = domain_of(brief.domain)
    if domain.has("breeder"):
        made: Breeder = domain.verb("breeder")(brief, plan, seed)
        return made
    again = partial(solve, brief, plan=plan, threads=1)
    return Breeder((Gene("chance", CHANCES),), lambda genome: again(seed=seed + genome[0]))


def matrix_breeder_of(brief: Brief, plan: Plan, seed: int = 0) -> MatrixBreeder:
    """The matrix code of a brief's layouts, for the genetic algorithms that a person rates; raises
    :class:`InputError` where its domain has none."""
    domain: Domain = domain_of(brief.domain)
    if not domain.has("matrix_breeder"):
        fault = f"--method is for sites and extensions, but the brief is of a {domain.name}"
        raise InputError(fault, "leave it out")
    made: MatrixBreeder = domain.verb("matrix_breeder")(brief, plan, seed)
    return made


def trace_passes(solution: Solution, plan: Plan) -> PassTrace:
    """What each pass of its domain changes when the brief of a solution is solved again with its
    preset, solver and seed; a domain without passes is refused."""
    trace: PassTrace = domain_of(solution.brief.domain).verb("passes")(solution, plan)
    return trace


def reasons_of(domain: str) -> Mapping[str, Mapping[str, float]]:
    """Reasons a person may give for a domain's scenes, by their words: features and the sign in
    which they should change."""
    table: Mapping[str, Mapping[str, float]] = domain_of(domain).table("reasons")
    return table


def presets(domain: str) -> Mapping[str, Any]:
    """The presets of a domain, by name."""
    table: Mapping[str, Any] = domain_of(domain).table("presets")
    return table


def solvers(domain: str) -> Mapping[str, Any]:
    """The solvers of a domain, by name."""
    table: Mapping[str, Any] = domain_of(domain).table("solvers")
    return table
