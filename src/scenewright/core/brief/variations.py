"""A brief as it was read, changed by what the user says beside it: its scale, more catalogues and
learned groups, another style."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import LONGEST
from scenewright.core.document_faults import check_text


def scale_brief(brief: Brief, scale: float) -> Brief:
    """A brief with its lengths in plan times ``scale``; what is reported of its file says so.

    >>> room = {"outline": [[0, 0], [4, 0], [4, 3]]}
    >>> scale_brief(Brief.model_validate({"rooms": [room]}), 2.0).rooms[0].outline[2]
    (8.0, 6.0)
    """
    if scale == 1.0:
        return brief
    return report_scale(Brief.model_validate(brief.model_dump() | {"scale": scale}), scale)


def report_scale(brief: Brief, scale: float) -> Brief:
    """A brief whose lengths in plan were multiplied by ``scale``, with its report saying so once;
    as it is where nothing is reported."""
    report, said = brief.input_report, f"lengths in plan times {scale:g}"
    if (
        scale == 1.0
        or report is None
        or said in {report.unit, *(row.reason for row in report.rows)}
    ):
        return brief
    unit = f"{report.unit.removesuffix(said).rstrip(', ') or 'metres'}, {said}"[:LONGEST]
    return brief.model_copy(update={"input_report": report.model_copy(update={"unit": unit})})


def add_named_files(
    brief: Brief, catalogs: Sequence[str], groups: Sequence[str], style: str
) -> Brief:
    """A brief with further catalogues and learned groups, and in another style (empty: its own).

    Raises :class:`InputError` for names that are no whole text."""
    for name in (*catalogs, *groups):
        check_text(name, "the name of a file")
    changed = {
        "catalogs": [*brief.catalogs, *catalogs] if catalogs else brief.catalogs,
        "groups": [*brief.groups, *groups] if groups else brief.groups,
        "style": style or brief.style,
    }
    return brief.model_copy(update=changed)
