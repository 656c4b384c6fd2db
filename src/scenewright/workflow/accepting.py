"""Findings of the referee accepted by hand, each with a reason that the brief keeps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from pydantic import ValidationError

from scenewright.core.acceptance import covers, resolve_names
from scenewright.core.brief.accepted import AcceptedFinding
from scenewright.core.edits import Adjusted
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.report import KINDS
from scenewright.core.solution import Solution
from scenewright.domains import check, plan_of


def accept_findings_by_hand(
    solution: Solution, *, plan: Plan | None = None, accept: Mapping[str, str]
) -> Adjusted:
    """A scene whose brief accepts findings, with the reason for each: a kind of findings
    (``surplus``), or that of one piece or space (``surplus:shop``, ``blocked_window:a/bed``).
    InputError where there is no such finding.

    >>> import scenewright as sw
    >>> room = sw.solve(sw.read("sample:home-room"), steps=200)
    >>> bare = sw.edit_pieces(room, add=[sw.Addition("wardrobe", 2.0, 1.0)]).solution
    >>> found = [one.kind for one in sw.check(bare).findings if one.is_blamed]
    >>> done = accept_findings_by_hand(bare, accept=dict.fromkeys(found, "while we move in"))
    >>> sw.check(done.solution).valid
    True
    """
    made = plan or plan_of(solution.brief)
    rows = [_read_accepted(what, reason, made) for what, reason in accept.items()]
    report = check(solution, plan=made, figures=False)
    meant = resolve_names((row.piece for row in rows), solution.pieces)
    for row in rows:
        if not any(covers(row, found, meant) for found in report.findings):
            kinds = sorted({found.kind for found in report.findings if found.is_blamed})
            there = f"there are: {', '.join(kinds)}" if kinds else "there is none to accept"
            raise InputError(f"no {row.kind.replace('_', ' ')} of that kind is found", there)
    brief = solution.brief.model_copy(update={"accepted": [*solution.brief.accepted, *rows]})
    return Adjusted(replace(solution, brief=brief), ())


def _read_accepted(what: str, reason: str, plan: Plan) -> AcceptedFinding:
    """``KIND`` or ``KIND:THING``, a space or a piece, as the brief states it."""
    kind, _, thing = what.partition(":")
    where = "space" if thing in {space.id for space in plan.spaces} else "piece"
    try:
        return AcceptedFinding(kind=kind.replace(" ", "_"), reason=reason, **{where: thing})
    except ValidationError:
        fault = f"'{what}' with the reason '{reason[:40]}' cannot be accepted"
        raise InputError(fault, f"use KIND or KIND:PIECE, of {', '.join(KINDS)}") from None
