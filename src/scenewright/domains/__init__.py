"""Domains: what kinds of scenes can be laid out. One package each, found by the brief's name.

A domain's package has ``solve(brief, *, preset, solver, seconds, steps, seed, threads, progress,
cancel)``, which returns a solution, and ``PRESETS``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from scenewright.brief import Brief
from scenewright.errors import InputError
from scenewright.solution import Solution


class DomainRow(NamedTuple):
    """One domain: its name, what it is, and where its table of solvers is."""

    name: str
    about: str
    solvers: str


_ROWS = (
    DomainRow("home", "dwellings: rooms furnished by what they are for", "solvers:SOLVERS"),
    DomainRow("hall", "exhibitions, shops, reading rooms, auditoria: groups in zones",
              "solvers.halls:HALL_SOLVERS"),
    DomainRow("site", "groups of buildings on a site, around landmarks",
              "solvers.sites:SITE_SOLVERS"),
)  # fmt: skip
DOMAINS: dict[str, DomainRow] = {row.name: row for row in _ROWS}


def solve(
    brief: Brief,
    *,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[float, str], None] | None = None,
    cancel: Callable[[], bool] | None = None,
) -> Solution:
    """Solve a brief by its domain: a home is furnished, a hall laid out.

    ``preset`` and ``solver`` are names (``scenewright list presets``). The work is ``steps`` or
    ``seconds``, else what the preset says; the same seed and steps give the same answer.
    ``progress`` hears the share done and what is being done; when ``cancel`` answers true, what
    was found so far is returned.
    """
    found: Solution = _module(brief.domain).solve(
        brief, preset=preset, solver=solver, seconds=seconds, steps=steps, seed=seed,
        threads=threads, progress=progress, cancel=cancel,
    )  # fmt: skip
    return found


def alternatives(
    brief: Brief,
    count: int,
    *,
    seed: int = 0,
    progress: Callable[[float, str], None] | None = None,
    cancel: Callable[[], bool] | None = None,
    **options: Any,
) -> tuple[Solution, ...]:
    """``count`` solutions that differ, best first. Halls differ by pattern, zoning and place, homes
    room by room in walls and groups (fewer, where no more differ); sites by the seed. ``options``
    are those of :func:`solve`."""
    if brief.domain in ("hall", "home"):
        module = import_module(f"scenewright.domains.{brief.domain}.alternatives")
        plans: tuple[Solution, ...] = module.alternatives(
            brief, count, seed=seed, progress=progress, cancel=cancel, **options
        )
        return plans
    found = []
    for k in range(count):
        found.append(solve(brief, seed=seed + k, cancel=cancel, **options))
        if progress:
            progress((k + 1) / count, f"plan {k + 1} of {count}")
        if cancel is not None and cancel():
            break
    return tuple(sorted(found, key=lambda s: (len(s.left_out), sum(s.energies.values()))))


def resolve(
    solution: Solution,
    *,
    move: Mapping[str, tuple[float, ...]] | None = None,
    swap: Sequence[tuple[str, str]] = (),
    lock: Sequence[str] = (),
    unlock: Sequence[str] = (),
    again: Sequence[str] = (),
    steps: int | None = None,
    seed: int | None = None,
) -> Solution:
    """Change a furnished home by hand and solve again only what that touches.

    Pieces and groups are named by id, or by what is enough of it: ``"sofa"``, ``"bedroom/bed"``.
    ``move`` puts them at (x, y) or (x, y, heading) in metres and radians, ``swap`` exchanges two;
    both are locked there. ``lock`` keeps groups where they are whatever is solved, ``unlock`` lets
    them go. In rooms where something was moved as little as possible changes; rooms named in
    ``again`` are laid out anew around what is locked (give another ``seed`` for another answer).
    """
    if solution.brief.domain != "home":
        raise InputError(
            f"a {solution.brief.domain} cannot be solved again in part",
            'set "fixed": true on what is to stay and arrange the file again',
        )
    from scenewright.domains.home.changes.edits import Edits
    from scenewright.domains.home.changes.resolve import resolve as of_home

    edits = Edits(move or {}, tuple(swap), tuple(lock), tuple(unlock), tuple(again))
    return of_home(solution, edits, steps=steps, seed=seed)


def presets(domain: str) -> Mapping[str, Any]:
    """The presets of a domain, by name."""
    found: Mapping[str, Any] = import_module(f"scenewright.domains.{domain}.presets").PRESETS
    return found


def solvers(domain: str) -> Mapping[str, Any]:
    """The solvers of a domain, by name."""
    module, _, name = DOMAINS[domain].solvers.partition(":")
    found: Mapping[str, Any] = getattr(import_module(f"scenewright.{module}"), name)
    return found


def _module(domain: str) -> Any:
    return import_module(f"scenewright.domains.{domain}")
