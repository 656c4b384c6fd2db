"""Groups learned from the briefs of furnished homes, as the command line asks for them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.learned import LearnedGroups
from scenewright.domains.home.learned.cases import LearnedCase
from scenewright.domains.home.learned.groups import Learned, document, learn, write
from scenewright.domains.home.learned.learning import FurnishedSpace


def learn_from_homes(homes: Mapping[str, Brief], output: Path) -> LearnedGroups:
    """Learn from homes read with all that stands in them as fixed, by file, and write the file
    that briefs name in ``groups``; InputError if no group is found."""
    rooms = [
        FurnishedSpace(Path(home).stem, space, tuple(fixed_pieces(room, space, shipped())))
        for home, brief in homes.items()
        for space, room in zip(spaces(brief), brief.rooms, strict=True)
    ]
    found = learn(rooms, shipped())
    if not found.cases:
        first = next(iter(homes))
        raise InputError(
            "no furniture groups are found", "give homes with furniture in them", file=first
        )
    write(found, output)
    return LearnedGroups(found.rooms, tuple(_rows(found)), document(found))


def _rows(found: Learned) -> list[dict[str, Any]]:
    """One row a function: its cases, how often and in how many homes they were seen."""
    table: dict[str, list[LearnedCase]] = {}
    for case in found.cases:
        table.setdefault(case.case.function, []).append(case)
    return [
        {
            "function": name,
            "cases": len(own),
            "seen": sum(c.seen for c in own),
            "homes": len({home for c in own for home in c.homes}),
            "holds": "; ".join(dict.fromkeys(c.case.name for c in own)),
        }
        for name, own in table.items()
    ]
