"""Findings that a user has looked at and accepts, each with a reason that is kept in the brief."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from scenewright.core.brief.accepted import AcceptedFinding
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import find_piece
from scenewright.core.report import Finding, Note, Report
from scenewright.core.scene import Piece

MOST_NAMED = 4
"""Pieces that the note of what was accepted in vain names."""


def accept_findings(
    report: Report, accepted: Sequence[AcceptedFinding], pieces: Sequence[Piece] = ()
) -> Report:
    """The report with the reasons for which findings were accepted; what was accepted but is not
    found is noted. Names may be any by which ``adjust`` finds one of the ``pieces``.

    >>> found = Finding("blocked_window", "0", "a", "a/bed_1", "w1", "a bed stands before it")
    >>> like = AcceptedFinding(kind="blocked_window", piece="a/bed_1", reason="she likes it so")
    >>> str(accept_findings(Report((found,)), [like]))
    'valid (1 accepted)'
    """
    if not accepted:
        return report
    meant = resolve_names((a.piece for a in accepted), pieces)
    reasons = [
        next((a.reason for a in accepted if covers(a, f, meant)), "") for f in report.findings
    ]
    findings = tuple(
        replace(found, accepted=reason) if reason else found
        for found, reason in zip(report.findings, reasons, strict=True)
    )
    idle = [a for a in accepted if not any(covers(a, found, meant) for found in report.findings)]
    notes = tuple(Note(a.space, "", "accepted", _tell_idle(a, report)) for a in idle)
    return replace(report, findings=findings, notes=(*report.notes, *notes))


def resolve_names(names: Iterable[str], pieces: Sequence[Piece]) -> Mapping[str, str]:
    """The id of the piece that each name means to ``adjust``, of those that mean one.

    >>> from scenewright.core.scene import Pose, Size
    >>> box = Piece("oma", "chest", "", "parents", Pose(0, 0, 0, 0), Size(1, 1, 1), "", "")
    >>> resolve_names(["parents/oma", "parents/opa"], [box])
    {'parents/oma': 'oma'}
    """
    meant = {}
    for name in filter(None, names):
        try:
            meant[name] = find_piece(pieces, name, lambda _piece: False).id
        except InputError:
            continue
    return meant


def covers(
    accepted: AcceptedFinding, found: Finding, meant: Mapping[str, str] = MappingProxyType({})
) -> bool:
    """Whether a finding is of the kind, piece and space that were accepted; ``a/sofa`` names what
    is ``a/sofa/sofa``, too, and whatever id it is ``meant`` for.

    >>> found = Finding("collision", "0", "a", "a/sofa_1", "a/tv_1", "they overlap")
    >>> covers(AcceptedFinding(kind="collision", piece="a/tv_1", reason="built in"), found)
    True
    """
    name = accepted.piece
    return (
        accepted.kind == found.kind
        and accepted.space in ("", found.space)
        and (not name or any(_is_named(p, name) or p == meant.get(name) for p in _named_in(found)))
    )


def _named_in(found: Finding) -> list[str]:
    return [name for name in (found.piece, *found.other.split(",")) if name]


def _is_named(piece: str, name: str) -> bool:
    return piece == name or piece.startswith(f"{name}/")


def _tell_idle(accepted: AcceptedFinding, report: Report) -> str:
    where = " of ".join(filter(None, [accepted.piece, accepted.space]))
    what = accepted.kind.replace("_", " ")
    same = [found for found in report.findings if found.kind == accepted.kind]
    there = dict.fromkeys(name for found in same for name in _named_in(found))
    tail = f"; there is one of {', '.join([*there][:MOST_NAMED])}" if there else ""
    return f"accepted, but not found: {what}{': ' if where else ''}{where}{tail}"
