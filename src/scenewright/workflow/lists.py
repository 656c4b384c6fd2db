"""Lists of what can be named: rows of the tables, for people and machines."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from scenewright.workflow.request import check_name

if TYPE_CHECKING:
    from scenewright.core.brief import Brief

Row = dict[str, Any]


def rows(what: str) -> list[Row]:
    """Rows of one of :data:`LISTS`; the keys are the columns."""
    check_name("list", what, list(LISTS))
    return LISTS[what]()


def select_columns(what: str, rows: list[Row]) -> list[Row]:
    """The columns a person reads; machines get them all."""
    columns = SHOWN.get(what)
    rows = _join_models(rows) if what == "assets" else rows
    return [{key: row[key] for key in columns} for row in rows] if columns else rows


def _join_models(assets: list[Row]) -> list[Row]:
    """One row a category: how many models draw it, and from which size to which they are made."""
    kinds: dict[str, list[Row]] = {}
    for asset in assets:
        kinds.setdefault(asset["category"], []).append(asset)
    return [
        alike[0] | {"models": len(alike), "usual": _span([row["usual"] for row in alike])}
        for alike in kinds.values()
    ]


def _span(sizes: list[list[float]]) -> list[str]:
    """Each side of several sizes, from the least to the greatest.

    >>> _span([[2.1, 0.9], [2.4, 0.9]])
    ['2.1–2.4', '0.9']
    """
    sides = [(min(side), max(side)) for side in zip(*sizes, strict=True)]
    return [f"{low:g}" if low == high else f"{low:g}–{high:g}" for low, high in sides]


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
            row.suffix,
            {"suffix": row.suffix, "reads": False, "writes": False, "about": "", "lacks": []},
        )
        known["reads"] |= bool(row.reader)
        known["writes"] |= bool(row.writer)
        known["lacks"] += [word for word in row.lacks if word not in known["lacks"]]
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
        holds = _count_parts({key: counts[key] for key in lines} if brief.rooms else _parts(brief))
        row = {"domain": brief.domain, "name": name, "about": brief.name, "holds": holds}
        rows.append(row | counts)
    return rows


def _parts(brief: Brief) -> dict[str, int]:
    """How many of each there are in what only the brief's domain knows."""
    lists = {key: value for key, value in brief.part if isinstance(value, list)}
    return {key: len(value) for key, value in lists.items() if value}


def _count_parts(counts: Mapping[str, int]) -> str:
    """What there is of each, in words.

    >>> _count_parts({"rooms": 3, "levels": 1})
    '3 rooms, 1 level'
    """
    return ", ".join(f"{count} {key if count > 1 else key[:-1]}" for key, count in counts.items())


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
    "formats": ("suffix", "reads", "writes", "about"),
    "presets": ("domain", "name", "solver", "steps", "about"),
    "assets": ("category", "models", "usual", "in halls"),
    "samples": ("name", "about", "holds"),
}
"""Columns for people, where not all."""
