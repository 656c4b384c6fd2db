"""Plans that are not what they seem: what reading left out, and a scale that is hardly right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import shapely

from scenewright.building.labels import tell_labels
from scenewright.catalog.suggestions import offer_kinds, suggest_kinds
from scenewright.check.drawn_scale import estimate_scale
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.units import suggest_scale
from scenewright.core.kind import Kind
from scenewright.core.report import Note
from scenewright.core.space import Space

CUT = 0.1
"""Metres an opening may reach above the ceiling without a note: a usual height in a low room."""
VAST = 1000.0
"""Square metres that a room of a home hardly has."""


def note_reading(brief: Brief) -> list[Note]:
    """Features left out or assumed on reading."""
    return [Note("", "plan", "", text) for text in brief.notes]


def note_unknown_kinds(brief: Brief, kinds: Mapping[str, Kind]) -> list[Note]:
    """A note for each word for fixed items that is not a kind but like one: they stand as boxes.

    >>> from scenewright.catalog.kinds import KINDS
    >>> items = [{"category": word, "at": [1, 1], "size": [1, 1, 1]} for word in ("couch", "well")]
    >>> room = {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "fixed": items}
    >>> [note.message[:56] for note in note_unknown_kinds(Brief(rooms=[room]), KINDS)]
    ["a fixed 'couch' is no kind of the catalog and drawn as a"]
    """
    items = Counter(item.category for room in brief.rooms for item in room.fixed)
    notes = []
    for word, count in items.items():
        if word not in kinds and suggest_kinds(word, kinds):
            some = f"a fixed '{word}' is" if count == 1 else f"{count} fixed '{word}' are"
            text = f"{some} no kind of the catalog and drawn as a box; {offer_kinds(word, kinds)}"
            notes.append(Note("", "plan", "kind", text))
    return notes


def note_scale(brief: Brief, spaces: Sequence[Space]) -> list[Note]:
    """A note if the plan seems drawn too small or too large, with the factor that helps.

    >>> from scenewright.building.plan import spaces
    >>> doors = [{"at": [1, 0], "width": 0.55}, {"at": [3, 0], "width": 0.6}]
    >>> room = {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "doors": doors}
    >>> brief = Brief.model_validate({"rooms": [room]})
    >>> note_scale(brief, spaces(brief))[0].message[:41]
    'hinged doors measure 0.57 m (median of 2)'
    """
    found = estimate_scale(brief, spaces)
    if found is None or not found.is_doubtful:
        return []
    return [Note("", "plan", "scale", found.describe())]


def note_cut_openings(brief: Brief, spaces: Sequence[Space]) -> list[Note]:
    """A note if doors or windows reach above a flat ceiling, where they are cut off: the first of
    them. Under a slope most of a window must remain, else it is refused.

    >>> from scenewright.building.plan import spaces
    >>> room = {"id": "hut", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    >>> high = [{"at": [1, 0], "height": 3.0}, {"at": [1, 3], "sill": 1.6}]
    >>> brief = Brief.model_validate({"rooms": [room | {"windows": high}]})
    >>> note_cut_openings(brief, spaces(brief))[0].message[:61]
    'windows[0] of hut reaches 3.9 m, above the ceiling at 2.6 m, '
    """
    cut = [
        (f"{which} of {space.name or space.id}", head, space.height)
        for room, space in zip(brief.rooms, spaces, strict=False)  # further spaces have no room
        for which, head in _heads(room)
        if head > space.height + CUT and not space.slopes
    ]
    if not cut:
        return []
    which, reach, ceiling = cut[0]
    others = f" (as {'does' if len(cut) == 2 else 'do'} {len(cut) - 1} more)" if cut[1:] else ""
    text = (
        f"{which} reaches {reach:g} m, above the ceiling at {ceiling:g} m, and ends there{others}; "
        "lower its sill or height"
    )
    return [Note("", "plan", "height", text)]


def _heads(room: Room) -> list[tuple[str, float]]:
    """The heights asked for the heads of a room's doors and windows."""
    return [
        *((f"doors[{k}]", door.height) for k, door in enumerate(room.doors)),
        *((f"windows[{k}]", light.sill + light.height) for k, light in enumerate(room.windows)),
    ]


def note_labels(brief: Brief, spaces: Sequence[Space]) -> list[Note]:
    """A note for each room that is not for what its label says."""
    told = tell_labels(brief, spaces)
    return [Note(space.id, space.functions[0], "label", text) for space, text in told]


def note_vast_rooms(spaces: Sequence[Space]) -> list[Note]:
    """A note if a room is larger than :data:`VAST`: its lengths are hardly metres.

    >>> from scenewright.building.plan import spaces
    >>> room = {"id": "bath", "outline": [[0, 0], [250, 0], [250, 180], [0, 180]]}
    >>> note_vast_rooms(spaces(Brief.model_validate({"rooms": [room]})))[0].message
    'bath has 45000 m²: lengths are metres; add --scale 0.0254 if they are inches'
    """
    areas = {space.id: shapely.Polygon(space.outline).area for space in spaces}
    vast = [(area, name) for name, area in areas.items() if area > VAST]
    if not vast:
        return []
    area, name = max(vast)
    text = f"{name} has {area:.0f} m²: lengths are metres; {suggest_scale(area**0.5)}"
    return [Note("", "plan", "unit", text)]
