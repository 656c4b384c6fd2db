"""Findings that a user has looked at and accepts, each with a reason that is kept in the brief."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from scenewright.core.brief.accepted import AcceptedFinding
from scenewright.core.report import Finding, Note, Report


def accept_findings(report: Report, accepted: Sequence[AcceptedFinding]) -> Report:
    """The report with the reasons for which findings were accepted; what was accepted but is not
    found any more is noted.

    >>> found = Finding("blocked_window", "0", "a", "a/bed_1", "w1", "a bed stands before it")
    >>> like = AcceptedFinding(kind="blocked_window", piece="a/bed_1", reason="she likes it so")
    >>> str(accept_findings(Report((found,)), [like]))
    'valid (1 accepted)'
    """
    if not accepted:
        return report
    reasons = [next((a.reason for a in accepted if covers(a, f)), "") for f in report.findings]
    findings = tuple(
        replace(found, accepted=reason) if reason and not found.given else found
        for found, reason in zip(report.findings, reasons, strict=True)
    )
    idle = [a for a in accepted if not any(covers(a, found) for found in report.findings)]
    notes = tuple(Note(a.space, "", "accepted", _tell_idle(a)) for a in idle)
    return replace(report, findings=findings, notes=(*report.notes, *notes))


def covers(accepted: AcceptedFinding, found: Finding) -> bool:
    """Whether a finding is of the kind, piece and space that were accepted.

    >>> found = Finding("collision", "0", "a", "a/sofa_1", "a/tv_1", "they overlap")
    >>> covers(AcceptedFinding(kind="collision", piece="a/tv_1", reason="built in"), found)
    True
    """
    pieces = {found.piece, *found.other.split(",")}
    return (
        accepted.kind == found.kind
        and accepted.space in ("", found.space)
        and (not accepted.piece or accepted.piece in pieces)
    )


def _tell_idle(accepted: AcceptedFinding) -> str:
    where = " of ".join(filter(None, [accepted.piece, accepted.space]))
    what = accepted.kind.replace("_", " ")
    return f"accepted, but not found any more: {what}{': ' if where else ''}{where}"
