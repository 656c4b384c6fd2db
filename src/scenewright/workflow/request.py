"""What is asked of a run, and whether it can be done: files, names and formats."""

from __future__ import annotations

from collections.abc import Collection, Generator, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.clutter.rows import AMOUNTS
from scenewright.core.atomic_file import check_targets
from scenewright.core.brief import Brief
from scenewright.core.catalog import OWN
from scenewright.core.errors import InputError
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains import domain_of
from scenewright.domains.contract import Domain
from scenewright.formats import (
    SWEET_HOME,
    check_outputs,
    extends,
    losses,
    read_planned,
    suffix_of,
    writer,
)
from scenewright.workflow.events import Event, Notice, Planned
from scenewright.workflow.looks import Look, vary_brief

HEAVY = 50_000
"""Faces of a model above which it is reported."""


class ArrangeRequest(NamedTuple):
    """A scene to arrange: where its brief is, the files to write, and the options."""

    source: str
    outputs: tuple[Path, ...]
    preset: str = "default"
    solver: str | None = None
    seconds: float | None = None
    steps: int | None = None
    seed: int = 0
    keep: bool = False
    alternatives: int = 1
    catalogs: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()
    accessible: bool = False
    scale: float = 1.0
    hidden_levels: bool = False
    style: str = ""
    layouts: int | None = None
    map_options: MapOptions = AS_IT_IS
    trace: Path | None = None
    nets: str = ""
    look: Look | None = None
    clutter: str = "none"

    @property
    def work(self) -> int | None:
        """Steps of the search or whole layouts, whichever the scene is made by."""
        return self.steps if self.layouts is None else self.layouts

    @property
    def extending(self) -> bool:
        """Whether a file is written as a copy of the source with more, whose furniture stays."""
        return any(extends(self.source, path) for path in self.outputs)


def plan_request(request: ArrangeRequest) -> Planned:
    """The brief of a request whose outputs and names can be used, its plan and its domain."""
    for path in request.outputs:
        writer(path)
    brief, plan = read_planned(
        request.source,
        keep=request.keep or request.extending,
        catalogs=request.catalogs,
        groups=request.groups,
        scale=request.scale,
        hidden_levels=request.hidden_levels,
        style=request.style,
        map_options=request.map_options,
    )
    check_outputs(request.outputs, brief)
    domain: Domain = domain_of(brief.domain)
    if request.accessible:
        brief = make_accessible(brief, domain, request.source)
    if request.look is not None:
        brief = vary_brief(brief, request.look)
        plan = domains.plan_valid(brief)
    presets, solvers = domain.table("presets"), domain.table("solvers")
    check_name("preset", request.preset, presets)
    check_name("solver", request.solver, (*solvers, None))
    check_name("clutter", request.clutter, AMOUNTS)
    check_work(request, brief, plan, domain)
    if request.nets:
        brief, plan = use_nets(request, brief, plan, domain)
    if request.trace is not None:
        check_targets([*request.outputs, request.trace])
        check_traced(request, domain)
    return Planned(brief, plan, domain)


def open_request(request: ArrangeRequest) -> Generator[Event, None, Planned]:
    """The brief and plan of a request, told, and what the user should know of them."""
    planned = plan_request(request)
    yield planned
    if request.extending and planned.brief.source_file:
        yield Notice(f"furniture is added to a copy of {Path(request.source).name}, all else stays")
    yield from note_ineffective(request, planned.brief)
    yield from note_scale(request.source, *planned, request.scale)
    return planned


def check_work(request: ArrangeRequest, brief: Brief, plan: Plan, domain: Domain) -> None:
    """Raise :class:`InputError` for ``--steps`` where whole layouts are made, ``--layouts`` where
    steps are, and for more of them than a day allows."""
    given = {"steps": request.steps, "layouts": request.layouts}
    other = "layouts" if domain.budget == "steps" else "steps"
    if given[other] is not None:
        made = {"steps": "searched step by step", "layouts": "made as whole layouts"}
        fault = f"--{other} is not for scenes of the domain '{brief.domain}'"
        raise InputError(f"{fault}, which are {made[domain.budget]}", f"give --{domain.budget}")
    most = max(domain.a_day // max(len(plan.spaces), 1), 1)
    if (request.work or 0) > most:
        fault = f"--{domain.budget} {request.work} takes more than a day here"
        raise InputError(fault, f"give at most {most}")


def check_traced(request: ArrangeRequest, domain: Domain) -> None:
    """Raise :class:`InputError` where a trace is asked of a solver that tells nothing."""
    solvers = domain.table("solvers")
    named = request.solver or domain.table("presets")[request.preset].solver
    if not solvers[named].traced:
        traced = ", ".join(name for name, row in solvers.items() if row.traced)
        fault = f"the solver '{named}' tells no steps: --trace has nothing to write"
        raise InputError(fault, f"give --preset paper, or a --solver of: {traced}")


def make_accessible(brief: Brief, domain: Domain, source: str) -> Brief:
    """The brief with room for wheelchairs, as its domain makes it; the plan stays the same. Raises
    :class:`InputError` for what is no home."""
    if not domain.has("accessible"):
        fault = f"--accessible is for homes, but the brief is of a {domain.name}"
        raise InputError(fault, "leave it out", file=source)
    changed: Brief = domain.verb("accessible")(brief)
    return changed


def use_nets(
    request: ArrangeRequest, brief: Brief, plan: Plan, domain: Domain
) -> tuple[Brief, Plan]:
    """The brief and plan with the networks of a file; InputError for what is no village."""
    if not domain.has("nets"):
        fault = f"--nets is for villages, but the brief is of a {domain.name}"
        raise InputError(fault, "leave it out", file=request.source)
    solver = request.solver or domain.table("presets")[request.preset].solver
    changed: tuple[Brief, Plan] = domain.verb("nets")(brief, plan, request.nets, solver)
    return changed


def note_ineffective(request: ArrangeRequest, brief: Brief) -> Iterator[Notice]:
    """Options of a request that change nothing for this file."""
    home = request.source.lower().endswith(SWEET_HOME)
    drawn = home or request.source.lower().endswith((".ifc", ".ifczip"))
    if request.keep and not (drawn and any(room.fixed for room in brief.rooms)):
        yield Notice("--keep has no effect: the file holds no furniture to keep")
    if request.hidden_levels and not home:
        yield Notice("--hidden-levels has no effect: only Sweet Home 3D homes have hidden levels")
    if request.seconds is not None and request.seed:
        yield Notice(
            "--seconds ends by the clock: only with --steps is a seed the same layout again"
        )


def note_scale(
    source: str, brief: Brief, plan: Plan, domain: Domain, given: float = 1.0
) -> Iterator[Notice]:
    """That the plan of a file, read with a scale ``given``, seems drawn too small or too large."""
    found = domain.verb("drawn_scale")(brief, plan.spaces) if domain.has("drawn_scale") else None
    if found is not None and found.is_doubtful:
        yield Notice(f"{source}: {found.describe(given)}")


def note_losses(solution: Solution, outputs: Sequence[Path]) -> Iterator[Notice]:
    """What the formats of the outputs do not hold of a solution, once for each format."""
    for path in {suffix_of(path): path for path in outputs}.values():
        if lost := losses(solution, path):
            yield Notice(f"{path.name}: left out: {', '.join(loss.describe() for loss in lost)}")


def note_heavy(solution: Solution) -> Iterator[Notice]:
    """The user's models in use that have more than :data:`HEAVY` faces."""
    catalog = catalog_of(solution.brief.catalogs)
    for name in sorted({piece.asset for piece in solution.pieces if piece.asset.startswith(OWN)}):
        asset = catalog.assets.get(name)
        faces = sum(len(part.faces) for part in asset.mesh(asset.usual)) if asset else 0
        if faces > HEAVY:
            yield Notice(f"{name} has {faces:,} faces: files with it are large")


def check_name(what: str, name: str | None, known: Collection[str | None]) -> None:
    """Raise :class:`InputError` naming the choices unless ``name`` is one of them.

    >>> check_name("preset", "papper", ["default", "paper"])
    Traceback (most recent call last):
    scenewright.core.errors.InputError: unknown preset 'papper'; use one of: default, paper
    """
    if name not in known:
        choices = ", ".join(filter(None, known))
        raise InputError(f"unknown {what} '{name}'", f"use one of: {choices}")
