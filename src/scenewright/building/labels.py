"""What rooms are for where their labels cannot be meant as they are.

A label is the name of a room for which the brief states no function. It is a word on a plan: it may
stand in a room too small for it, or twice over what is one kitchen. A stated function is kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import shapely

from scenewright.building.room_names import functions_from_name, says_nothing
from scenewright.building.room_needs import USABLE
from scenewright.core.brief import Brief, Room
from scenewright.core.space import Space

SLEEPING = ("bedroom", "double_bedroom", "single_bedroom", "child_bedroom")
LIVED = (*SLEEPING, "living")
LEAST_BEDROOM = 3.0
"""Floor of the smallest room with a bed and the way to it, m²."""
BEDROOM = 7.0
"""Floor from which on a room that nothing is known of may be the bedroom, m²."""
REASONS = {
    "other": "what is labelled as a bedroom is too small for a bed",
    "kitchen": "another room labelled as a kitchen is back to back with it",
    "bedroom": "it is too small for a bed",
}
"""Why a label is not followed, by what it says."""
WALL = 0.4
"""Thickest wall between two rooms back to back, metres."""


def correct_labels(brief: Brief, spaces: Sequence[Space]) -> list[Space]:
    """The spaces of a brief with functions that make sense where only a label says them.

    A bedroom of less than 3 m² is a store; where no other is left, the largest unknown room of at
    least 7 m² is the bedroom. Of kitchens back to back one is: the one with kitchen pieces
    in it, then with a door, then most floor; the others are a dining room, where there is none and
    they are large enough, or a pantry.
    """
    labelled = [_is_labelled(room) for room in brief.rooms]
    if not any(labelled):
        return list(spaces)
    floors = [shapely.Polygon(space.outline, space.holes) for space in spaces]
    found = _move_bed(list(spaces), labelled, floors)
    return _keep_one_kitchen(brief, found, labelled, floors)


def tell_labels(brief: Brief, spaces: Sequence[Space]) -> list[tuple[Space, str]]:
    """The spaces that are not for what their labels say, each with a line that tells so."""
    found = []
    for room, space in zip(brief.rooms, spaces, strict=False):  # further spaces have no room
        says = functions_from_name(room.name)[0]
        why = REASONS.get("bedroom" if says in SLEEPING else says, "")
        if _is_labelled(room) and why and says not in space.functions:
            area = shapely.Polygon(space.outline, space.holes).area
            use = space.functions[0].replace("_", " ")
            text = f"'{space.name[:80]}' ({area:.1f} m²) is furnished as {use}: {why}"
            found.append((space, text))
    return found if any(functions_from_name(s.name)[0] != "other" for s, _ in found) else []


def _is_labelled(room: Room) -> bool:
    return not room.function and not room.zones and room.ask is None


def _move_bed(
    spaces: list[Space], labelled: Sequence[bool], floors: Sequence[shapely.Polygon]
) -> list[Space]:
    """Bedrooms too small for a bed as stores, and the bed in a room that nothing is known of."""
    small = [
        i
        for i, space in enumerate(spaces)
        if labelled[i] and space.functions[0] in SLEEPING and floors[i].area < LEAST_BEDROOM
    ]
    for i in small:
        spaces[i] = replace(spaces[i], functions=("storage",))
    others = [
        i
        for i, space in enumerate(spaces)
        if labelled[i] and says_nothing(space.name) and floors[i].area >= BEDROOM
    ]
    if small and others and not any({*SLEEPING} & {*space.functions} for space in spaces):
        best = max(others, key=lambda i: floors[i].area)
        spaces[best] = replace(spaces[best], functions=("bedroom",))
    return spaces


def _keep_one_kitchen(
    brief: Brief, spaces: list[Space], labelled: Sequence[bool], floors: Sequence[shapely.Polygon]
) -> list[Space]:
    """Of labelled kitchens back to back all but the best as dining room or pantry; two dwellings
    back to back, each with rooms to live in, keep theirs."""
    kitchens = [i for i, s in enumerate(spaces) if s.functions == ("kitchen",)]
    fixed = [bool(room.fixed) for room in brief.rooms]
    order = sorted(
        kitchens,
        key=lambda i: (
            labelled[i],
            not fixed[i],
            not is_entered(spaces[i]),
            -round(floors[i].area, 2),
        ),
    )
    homes = _find_dwellings(spaces)
    lived = {homes[i] for i, s in enumerate(spaces) if {*LIVED} & {*s.functions}}
    kept: list[int] = []
    for i in order:
        beside = any(
            spaces[k].level == spaces[i].level
            and floors[k].distance(floors[i]) <= WALL
            and not (homes[k] != homes[i] and {homes[k], homes[i]} <= lived)
            for k in kept
        )
        if not (beside and labelled[i]):
            kept.append(i)
            continue
        eaten = any("dining" in space.functions for space in spaces)
        dining = not eaten and floors[i].area >= USABLE["dining"].area and is_entered(spaces[i])
        spaces[i] = replace(spaces[i], functions=("dining",) if dining else ("storage",))
    return spaces


def is_entered(space: Space) -> bool:
    """Whether a door, a passage or stairs lead into a space."""
    return bool(space.stairs) or any(opening.kind != "window" for opening in space.openings)


def _find_dwellings(spaces: Sequence[Space]) -> list[int]:
    """For each space the number of the first one that doors and stairs lead to from it."""
    first = list(range(len(spaces)))
    known: dict[str, int] = {}
    for i, space in enumerate(spaces):
        ways = [o.id for o in space.openings if o.kind != "window"] + [
            e.stairs for e in space.stairs
        ]
        for other in sorted({first[known[way]] for way in ways if way in known}):
            least, most = sorted((first[i], other))
            first = [least if k == most else k for k in first]
        known |= dict.fromkeys(ways, i)
    return first
