"""The verbs ``list`` and ``schema``: rows of the tables, for people and machines."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from scenewright.cli_arrange import named

Row = dict[str, Any]


def rows(what: str) -> list[Row]:
    """Rows of one of :data:`LISTS`; the keys are the columns."""
    named("list", what, list(LISTS))
    return LISTS[what]()


def schema(what: str) -> dict[str, Any]:
    """The JSON Schema of a brief or a solution."""
    named("schema", what, ["brief", "solution"])
    if what == "brief":
        from scenewright.formats import brief_json

        return brief_json.schema()
    from scenewright.formats.solution_record import SolutionRecord

    return SolutionRecord.model_json_schema()


def _solvers() -> list[Row]:
    from scenewright.solvers import SOLVERS

    return [{"name": name, "about": row.doc} for name, row in SOLVERS.items()]


def _terms() -> list[Row]:
    from scenewright.terms.table import TERMS

    return [row._asdict() for row in TERMS]


def _presets() -> list[Row]:
    from scenewright.domains.home.presets import PRESETS

    return [
        {"name": name, "about": preset.doc, "solver": preset.solver, "weights": preset.weights}
        for name, preset in PRESETS.items()
    ]


def _formats() -> list[Row]:
    from scenewright.formats import formats

    return [
        {"suffix": row.suffix, "reads": bool(row.reader), "writes": bool(row.writer),
         "about": row.about}
        for row in formats()
    ]  # fmt: skip


def _assets() -> list[Row]:
    from scenewright.assets import shipped

    return [
        {"id": asset.id, "category": asset.category, "name": asset.name,
         "smallest": list(asset.smallest), "usual": list(asset.usual),
         "largest": list(asset.largest), "licence": asset.licence}
        for asset in shipped().assets.values()
    ]  # fmt: skip


def _samples() -> list[Row]:
    from scenewright.formats import read, samples

    briefs = {name: read(name) for name in samples()}
    return [
        {"name": name, "about": brief.name, "rooms": len(brief.rooms), "levels": len(brief.levels)}
        for name, brief in briefs.items()
    ]


LISTS: dict[str, Callable[[], list[Row]]] = {
    "solvers": _solvers,
    "terms": _terms,
    "presets": _presets,
    "formats": _formats,
    "assets": _assets,
    "samples": _samples,
}
"""What can be listed."""
