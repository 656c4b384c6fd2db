"""``arrange --alternatives N``: several plans that differ, ranked, each with numbers and files."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from rich.console import Console

from scenewright.check import Report, check
from scenewright.cli import show
from scenewright.cli.arrange import Request, prepared, write_together
from scenewright.cli.progress import watching
from scenewright.errors import InputError
from scenewright.solution import Solution


class Plan(NamedTuple):
    """One plan: its rank from 1, the files it was written to, and the referee's report."""

    rank: int
    outputs: tuple[Path, ...]
    solution: Solution
    report: Report

    @property
    def complete(self) -> bool:
        """Whether all that was asked for stands and no rule is broken."""
        return self.report.valid and not any(out.required for out in self.solution.left_out)


def arrange_all(request: Request, console: Console) -> tuple[list[Plan], bool]:
    """Solve, judge and write every plan; whether the search was interrupted.

    ``plan.svg`` becomes ``plan-1.svg``, ``plan-2.svg`` …; all files appear together.
    """
    from scenewright import domains, formats

    brief = prepared(request, console)
    every = [numbered(path, k + 1) for path in request.outputs for k in range(request.alternatives)]
    formats.check_kept(request.source, every)
    with watching(console, console.quiet) as watch:
        try:
            found = domains.alternatives(
                brief, request.alternatives, preset=request.preset, solver=request.solver,
                seconds=request.seconds, steps=request.steps, seed=request.seed,
                progress=watch.progress, cancel=watch.cancelled,
            )  # fmt: skip
        except InputError as error:
            raise error.located(file=str(request.source)) from None
        interrupted = watch.cancelled()
        if interrupted and not any(solution.evaluations for solution in found):
            raise KeyboardInterrupt
        plans = ranked(found, request.outputs)
        for plan in plans:
            write_together(plan.solution, plan.outputs, watch)
    return plans, interrupted


def ranked(found: tuple[Solution, ...], outputs: tuple[Path, ...]) -> list[Plan]:
    """Plans judged and numbered: those that break no rule and leave nothing out come first."""
    judged = [(solution, check(solution)) for solution in found]
    order = sorted(judged, key=lambda pair: (not pair[1].valid, len(pair[0].left_out)))
    return [
        Plan(rank, tuple(numbered(path, rank) for path in outputs), solution, report)
        for rank, (solution, report) in enumerate(order, 1)
    ]


def numbered(path: Path, rank: int) -> Path:
    """The name of one plan's file.

    >>> numbered(Path("out/plan.svg"), 2).as_posix()
    'out/plan-2.svg'
    >>> numbered(Path("plan.street.png"), 2).as_posix()
    'plan-2.street.png'
    """
    from scenewright.formats import suffix_of

    suffix = suffix_of(path)
    return path.with_name(f"{path.name.removesuffix(suffix)}-{rank}{suffix}")


def row(plan: Plan) -> dict[str, Any]:
    """One line of the table of plans."""
    halls = list(plan.report.figures.get("halls", {}).values())
    solution = plan.solution
    told: dict[str, Any] = {
        "plan": plan.rank,
        "energy": float(sum(solution.energies.values())),
        "verdict": str(plan.report),
        "left out": len(solution.left_out),
    }
    if len(halls) == 1 and solution.graph is not None:
        told |= {key: halls[0][key] for key in ("aesthetic", "uniformity", "circulation")}
    return told


def differences(plans: list[Plan]) -> list[float]:
    """How much each plan of a home differs from the most like of the others, 0 to 1."""
    from scenewright.domains.home.alternatives import difference

    return [
        min((difference(p.solution, q.solution) for q in plans if q is not p), default=0.0)
        for p in plans
    ]


def rows(plans: list[Plan]) -> list[dict[str, Any]]:
    """The table of plans."""
    found = [row(plan) for plan in plans]
    if plans[0].solution.brief.domain == "home":
        for told, apart in zip(found, differences(plans), strict=True):
            told["differs"] = f"{apart:.0%}"
    return found


def patterns(plan: Plan) -> str:
    """How the groups of a hall are laid out, or where those of a home stand, in one line."""
    if plan.solution.brief.domain == "home":
        from scenewright.domains.home.alternatives import sides

        stand = sides(plan.solution)
        return f"plan {plan.rank}: {stand}" if stand else ""
    groups = () if plan.solution.graph is None else plan.solution.graph.groups
    told = [f"{group.demand} {group.pattern}" for group in groups if len(group.objects) > 1]
    return f"plan {plan.rank}: {', '.join(told)}" if told else ""


def document(source: str, plan: Plan) -> dict[str, Any]:
    """One plan as plain values."""
    code = 0 if plan.complete else 1
    return {"plan": plan.rank} | show.arranged_document(
        source, plan.outputs, plan.solution, plan.report, code
    )
