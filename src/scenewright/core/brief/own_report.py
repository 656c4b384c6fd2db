"""The input report of files of our own: briefs and saved scenes.

A brief has no key that is passed over: what is not known is refused. So of most nothing is changed,
and their report, a count of what they hold, is made when asked for and not stored. Stored is what
differs from the file: a scale, empty keys of another kind of scene, pieces that are laid out anew.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from pydantic import BaseModel

from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import InputReport, InputRow
from scenewright.core.registry import DEFAULT, domain_names, part_keys

FORMAT = "brief"
SAVED = "saved scene"
NOUNS = {
    "ask": "furniture asked for",
    "fixed": "fixed item",
    "wishes": "wish",
    "stairs": "stairs",
    "accepted": "accepted finding",
}
"""The name of one entry of a list; of other keys their singular."""
DRAWN = {
    *("room", "door", "window", "wall", "stairs", "fixed item"),
    *("zone", "slope", "outlet", "radiator"),
}
"""Kinds of things that have a place in the plan."""
ANEW = "not locked, laid out anew"
STAYS = "locked, stays where it is"


def input_report_of(brief: Brief) -> InputReport:
    """What was read of the file of a brief: as stored in it, else all it holds, used.

    >>> room = {"outline": [[0, 0], [4, 0], [4, 3]], "doors": [{"at": [2, 0]}]}
    >>> found = input_report_of(Brief.model_validate({"rooms": [room]}))
    >>> found.format, [(row.kind, row.outcome, row.count) for row in found.rows]
    ('brief', [('room', 'used', 1), ('door', 'used', 1)])
    """
    return brief.input_report or InputReport(format=FORMAT, unit="metres", rows=_used_rows(brief))


def report_changes(brief: Brief, document: Mapping[str, Any], scale: float) -> Brief:
    """The brief read from a document, with the report of what was changed; as it is where nothing
    was, or where it tells already of another file. ``scale`` is what plans were multiplied by."""
    dropped = [
        key
        for name in domain_names()
        for key in part_keys(name)
        if key in document and not document[key] and key not in part_keys(brief.domain)
    ]
    if brief.input_report is not None or not (dropped or scale != 1.0):
        return brief
    rows = _used_rows(brief) if scale == 1.0 else [_scaled(r, scale) for r in _used_rows(brief)]
    reason = f"empty, and not of a {document.get('domain', DEFAULT)}"
    rows += [InputRow(kind=key, outcome="left out", count=1, reason=reason) for key in dropped]
    report = InputReport(format=FORMAT, unit="metres", rows=rows)
    return brief.model_copy(update={"input_report": report})


def report_pieces(brief: Brief, fixed: Sequence[bool]) -> Brief:
    """The brief to solve a saved scene again: its report tells which of the scene's pieces stay,
    ``fixed`` one a piece, beside what it tells of the file that was arranged first."""
    before = brief.input_report or InputReport(format=SAVED, unit="metres")
    rows = [row for row in before.rows if row.reason not in (ANEW, STAYS)]
    locked = sum(fixed)
    if locked:
        rows.append(InputRow(kind="piece", outcome="used", count=locked, reason=STAYS))
    if free := len(fixed) - locked:
        rows.append(InputRow(kind="piece", outcome="changed", count=free, reason=ANEW))
    return brief.model_copy(update={"input_report": before.model_copy(update={"rows": rows})})


def _scaled(row: InputRow, scale: float) -> InputRow:
    if row.kind not in DRAWN:
        return row
    changed = {"outcome": "changed", "reason": f"lengths in plan times {scale:g}"}
    return row.model_copy(update=changed)


def _used_rows(brief: Brief) -> list[InputRow]:
    counts = Counter(_list_things(brief))
    return [InputRow(kind=kind, outcome="used", count=n) for kind, n in counts.items()]


def _list_things(model: BaseModel) -> Iterator[str]:
    """What every object that is listed in a brief is, at any depth."""
    for key, value in model.__dict__.items():
        if key in ("input_report", "source_file"):
            continue
        if isinstance(value, BaseModel):
            yield from _list_things(value)
        for one in value if isinstance(value, list) else ():
            if isinstance(one, BaseModel):
                yield NOUNS.get(key, key.removesuffix("s").replace("_", " "))
                yield from _list_things(one)
