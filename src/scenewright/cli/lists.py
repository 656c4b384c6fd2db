"""The verbs ``list`` and ``schema``: rows of the tables, for people and machines."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from scenewright.cli.arrange import named

Row = dict[str, Any]


def rows(what: str) -> list[Row]:
    """Rows of one of :data:`LISTS`; the keys are the columns."""
    named("list", what, list(LISTS))
    return LISTS[what]()


def shown(what: str, rows: list[Row]) -> list[Row]:
    """The columns a person reads; machines get them all."""
    columns = SHOWN.get(what)
    return [{key: row[key] for key in columns} for row in rows] if columns else rows


def schema(what: str) -> dict[str, Any]:
    """The JSON Schema of a brief or a solution."""
    named("schema", what, ["brief", "solution"])
    if what == "brief":
        from scenewright.formats import brief_json

        return brief_json.schema()
    from scenewright.formats.solution_record import SolutionRecord

    return SolutionRecord.model_json_schema()


def _solvers() -> list[Row]:
    from scenewright.domains import DOMAINS, solvers

    return [
        {"name": name, "domain": domain, "about": row.doc, "source": row.source}
        for domain in DOMAINS
        for name, row in solvers(domain).items()
    ]


def _terms() -> list[Row]:
    from scenewright.terms.hall_terms import HALL_TERMS
    from scenewright.terms.site_terms import SITE_AIMS, SITE_TERMS
    from scenewright.terms.table import TERMS

    home = [{"domain": "home"} | row._asdict() for row in TERMS]
    hall = [{"domain": "hall"} | row._asdict() for row in HALL_TERMS]
    site = [{"domain": "site"} | row._asdict() for row in (*SITE_TERMS, *SITE_AIMS)]
    return [*home, *({"form": "repaired", "kind": row["of"]} | row for row in (*hall, *site))]


def _patterns() -> list[Row]:
    from scenewright.encodings.patterns import PATTERNS

    return [row._asdict() for row in PATTERNS.values()]


def _presets() -> list[Row]:
    from scenewright.domains import DOMAINS, presets

    return [
        {"domain": domain, "name": name, "about": preset.doc, "solver": preset.solver,
         "weights": preset.weights}
        for domain in DOMAINS
        for name, preset in presets(domain).items()
    ]  # fmt: skip


def _formats() -> list[Row]:
    from scenewright.formats import formats

    return [
        {"suffix": row.suffix, "reads": bool(row.reader), "writes": bool(row.writer),
         "about": row.about}
        for row in formats()
    ]  # fmt: skip


def _assets() -> list[Row]:
    """What there is to place; of what halls know, where it stands and its usual clearance."""
    from scenewright.assets import shipped
    from scenewright.assets.hall_use import USE

    return [
        {"id": asset.id, "category": asset.category, "name": asset.name,
         "smallest": list(asset.smallest), "usual": list(asset.usual),
         "largest": list(asset.largest), "licence": asset.licence,
         "in halls": " ".join(USE[asset.category].patterns) if asset.category in USE else "",
         "clearance": list(USE[asset.category].clearance) if asset.category in USE else []}
        for asset in shipped().assets.values()
    ]  # fmt: skip


def _groups() -> list[Row]:
    """What ``ask`` may name; sizes are width and depth of the cases of least and most floor."""
    from scenewright.domains.home.cases.library import cases
    from scenewright.domains.home.groups import GROUPS

    rows = []
    for name, kind in GROUPS.items():
        order = sorted(cases(name).groups, key=lambda case: case.width * case.depth)
        small, large = order[0], order[-1]
        rows.append({
            "name": name, "holds": " or ".join(part.replace("_", " ") for part in kind.essential),
            "smallest": [round(small.width, 2), round(small.depth, 2)],
            "largest": [round(large.width, 2), round(large.depth, 2)],
        })  # fmt: skip
    return rows


def _samples() -> list[Row]:
    from scenewright.formats import read, samples

    briefs = {name: read(name) for name in samples()}
    rows: list[Row] = []
    for name, brief in briefs.items():
        counts = {
            "rooms": len(brief.rooms), "levels": len(brief.levels) or 1,
            "zones": sum(len(room.zones) for room in brief.rooms),
            "demands": sum(len(room.demands) for room in brief.rooms),
        }  # fmt: skip
        told = ("zones", "demands") if brief.domain == "hall" else ("rooms", "levels")
        holds = ", ".join(f"{counts[key]} {key if counts[key] > 1 else key[:-1]}" for key in told)
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
    "assets": _assets,
    "samples": _samples,
}
"""What can be listed."""

SHOWN: dict[str, tuple[str, ...]] = {
    "solvers": ("domain", "name", "about"),
    "terms": ("domain", "name", "form", "kind", "weight", "doc"),
    "patterns": ("name", "about", "used_for"),
    "presets": ("domain", "name", "solver", "about"),
    "assets": ("category", "usual", "in halls"),
    "samples": ("name", "about", "holds"),
}
"""Columns for people, where not all."""
