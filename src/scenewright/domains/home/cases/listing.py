"""The furniture groups as rows to list."""

from __future__ import annotations

from typing import Any

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
