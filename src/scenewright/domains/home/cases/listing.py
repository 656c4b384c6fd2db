"""Furniture groups and styles as rows to list."""

from __future__ import annotations

from typing import Any

from scenewright.building.palettes import PALETTES, STYLES
from scenewright.catalog.kinds import name_of
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.groups import GROUPS


def list_groups() -> list[dict[str, Any]]:
    """What ``ask`` may name; sizes are width and depth in metres of the cases of least and most
    floor.

    >>> list_groups()[0]["name"] in GROUPS
    True
    """
    rows = []
    for name, kind in GROUPS.items():
        order = sorted(cases(name).groups, key=lambda case: case.width * case.depth)
        small, large = order[0], order[-1]
        rows.append(
            {
                "name": name,
                "label": kind.label or name.replace("_", " "),
                "holds": " or ".join(name_of(part) for part in kind.essential),
                "smallest": [round(small.width, 2), round(small.depth, 2)],
                "largest": [round(large.width, 2), round(large.depth, 2)],
            }
        )
    return rows


def list_styles() -> list[dict[str, Any]]:
    """The styles a home may have, other words for each, and the names of its palettes.

    >>> row = list_styles()[1]
    >>> row["name"], row["palettes"].split()[:2]
    ('nordic', ['fjord', 'birch'])
    """
    return [
        {
            "name": name,
            "also": words,
            "palettes": " ".join(row.name for row in PALETTES.values() if row.style == name),
        }
        for name, words in STYLES.items()
    ]
