"""``arrange --alternatives N``: several plans that differ, ranked, each with numbers and files."""

from __future__ import annotations

from typing import Any

from rich.console import Console

from scenewright.cli.arrange import follow
from scenewright.core.registry import domain_of
from scenewright.workflow import documents
from scenewright.workflow.alternatives import RankedSolution, arrange_alternatives
from scenewright.workflow.request import ArrangeRequest
from scenewright.workflow.schemes import add_schemes, find_schemes, scheme_row


def arrange_all(request: ArrangeRequest, console: Console) -> tuple[list[RankedSolution], bool]:
    """Solve, judge and write every plan; whether the search was interrupted."""
    return follow(lambda cancel: arrange_alternatives(request, cancel=cancel), console)


def row(plan: RankedSolution) -> dict[str, Any]:
    """One line of the table of plans."""
    halls = list(plan.report.figures.get("halls", {}).values())
    solution = plan.solution
    values: dict[str, Any] = {
        "plan": plan.rank,
        "energy": float(sum(solution.energies.values())),
        "verdict": str(plan.report),
        "not placed": len(solution.left_out),
    }
    if len(halls) == 1 and solution.detail is not None:
        values |= {key: halls[0][key] for key in ("aesthetic", "uniformity", "circulation")}
    grounds = list(find_schemes(solution, plan.plan, plan.report).values())
    return values | scheme_row(add_schemes(grounds))


def differences(plans: list[RankedSolution]) -> list[float]:
    """How much each plan differs from the most like of the others, 0 to 1; none where the domain
    has no measure of it."""
    domain = domain_of(plans[0].solution.brief.domain)
    if not domain.has("compare"):
        return []
    compare = domain.verb("compare")
    return [
        min((compare(p.solution, q.solution, p.plan) for q in plans if q is not p), default=0.0)
        for p in plans
    ]


def rows(plans: list[RankedSolution]) -> list[dict[str, Any]]:
    """The table of plans."""
    found = [row(plan) for plan in plans]
    for shown, apart in zip(found, differences(plans), strict=False):
        shown["differs"] = f"{apart:.0%}"
    return found


def patterns(plan: RankedSolution) -> str:
    """What distinguishes a plan, in one line."""
    domain = domain_of(plan.solution.brief.domain)
    words = domain.verb("describe")(plan.solution, plan.plan) if domain.has("describe") else ""
    return f"plan {plan.rank}: {words}" if words else ""


def document(source: str, plan: RankedSolution) -> dict[str, Any]:
    """One plan as plain values."""
    code = 0 if plan.complete else 1
    grounds = find_schemes(plan.solution, plan.plan, plan.report)
    noun = domain_of(plan.solution.brief.domain).noun
    told = {"plan": plan.rank} | ({f"{noun}s": grounds} if grounds else {})
    return told | documents.arranged_document(
        source, plan.outputs, plan.solution, plan.plan, plan.report, code
    )
