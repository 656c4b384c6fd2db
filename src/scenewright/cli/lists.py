"""The verbs ``list`` and ``schema``: rows of the tables, for people and machines."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from scenewright.workflow.request import check_name

Row = dict[str, Any]


def rows(what: str) -> list[Row]:
    """Rows of one of :data:`LISTS`; the keys are the columns."""
    check_name("list", what, list(LISTS))
    return LISTS[what]()


def select_columns(what: str, rows: list[Row]) -> list[Row]:
    """The columns a person reads; machines get them all."""
    columns = SHOWN.get(what)
    return [{key: row[key] for key in columns} for row in rows] if columns else rows


def schema(what: str) -> dict[str, Any]:
    """The JSON Schema of a brief or a solution."""
    check_name("schema", what, ["brief", "solution"])
    if what == "brief":
        from scenewright.formats import brief_json

        return brief_json.schema()
    from scenewright.formats.solution_record import solution_schema

    return solution_schema()


def _solvers() -> list[Row]:
    from scenewright.domains import domain_names, solvers

    return [
        {"name": name, "domain": kind, "about": row.doc, "source": row.source}
        for kind in domain_names()
        for name, row in solvers(kind).items()
    ]


def _terms() -> list[Row]:
    from scenewright.domains import domains

    return [
        {"domain": kind.name} | row._asdict() for kind in domains() for row in kind.table("terms")
    ]


def _patterns() -> list[Row]:
    from scenewright.domains import domains

    rows = [row._asdict() for kind in domains() for row in kind.table("patterns").values()]
    return [{name: row[name] for name in (*SHOWN["patterns"], "source")} for row in rows]


def _presets() -> list[Row]:
    from scenewright.domains import domain_names, presets

    return [
        {
            "domain": kind,
            "name": name,
            "about": preset.doc,
            "solver": preset.solver,
            "steps": preset.steps,
            "weights": preset.weights,
            "settings": _settings(preset.settings),
        }
        for kind in domain_names()
        for name, preset in presets(kind).items()
    ]


def _settings(values: Any) -> Any:
    """Settings as plain values, group in group."""
    if not hasattr(values, "_asdict"):
        return values
    return {name: _settings(value) for name, value in values._asdict().items()}


def _formats() -> list[Row]:
    """A row a suffix, whichever modules read and write it."""
    from scenewright.formats import formats

    rows: dict[str, Row] = {}
    for row in formats():
        known = rows.setdefault(
            row.suffix, {"suffix": row.suffix, "reads": False, "writes": False, "about": ""}
        )
        known["reads"] |= bool(row.reader)
        known["writes"] |= bool(row.writer)
        known["about"] = "; ".join(filter(None, (known["about"], row.about)))
    return list(rows.values())


def _assets() -> list[Row]:
    """What there is to place; of what halls know, where it stands and its usual clearance."""
    from scenewright.catalog.assets import shipped

    catalog = shipped()
    halls = {name: kind.hall for name, kind in catalog.kinds.items() if kind.hall}
    return [
        {
            "id": asset.id,
            "category": asset.category,
            "name": asset.name,
            "smallest": list(asset.smallest),
            "usual": list(asset.usual),
            "largest": list(asset.largest),
            "licence": asset.licence,
            "in halls": " ".join(halls[asset.category].patterns) if asset.category in halls else "",
            "clearance": list(halls[asset.category].clearance) if asset.category in halls else [],
        }
        for asset in catalog.assets.values()
    ]


def _groups() -> list[Row]:
    """What ``ask`` may name, of every domain that has groups."""
    from scenewright.domains import domains

    return [row for kind in domains() if kind.has("groups") for row in kind.verb("groups")()]


def _styles() -> list[Row]:
    """What ``--style`` may name, of every domain that has styles."""
    from scenewright.domains import domains

    return [
        {"domain": kind.name} | row
        for kind in domains()
        if kind.has("styles")
        for row in kind.verb("styles")()
    ]


def _samples() -> list[Row]:
    from scenewright.formats import read, samples

    briefs = {name: read(name) for name in samples()}
    rows: list[Row] = []
    for name, brief in briefs.items():
        counts = {
            "rooms": len(brief.rooms),
            "levels": len(brief.levels) or 1,
            "zones": sum(len(room.zones) for room in brief.rooms),
            "demands": sum(len(room.demands) for room in brief.rooms),
        }
        lines = ("zones", "demands") if counts["demands"] else ("rooms", "levels")
        holds = ", ".join(f"{counts[key]} {key if counts[key] > 1 else key[:-1]}" for key in lines)
        row = {"domain": brief.domain, "name": name, "about": brief.name, "holds": holds}
        rows.append(row | counts)
    return rows


LISTS: dict[str, Callable[[], list[Row]]] = {
    "solvers": _solvers,
    "terms": _terms,
    "patterns": _patterns,
    "presets": _presets,
    "formats": _formats,
    "groups": _groups,
    "styles": _styles,
    "assets": _assets,
    "samples": _samples,
}
"""What can be listed."""

SHOWN: dict[str, tuple[str, ...]] = {
    "solvers": ("domain", "name", "about"),
    "terms": ("domain", "name", "form", "kind", "weight", "doc"),
    "patterns": ("name", "about", "used_for"),
    "presets": ("domain", "name", "solver", "steps", "about"),
    "assets": ("category", "usual", "in halls"),
    "samples": ("name", "about", "holds"),
}
"""Columns for people, where not all."""
