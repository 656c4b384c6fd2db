"""What became of every feature of a Sweet Home 3D home.

Features are the elements a user has drawn or placed, and all else that lies in the home itself:
each level, wall, room, door, window, piece and group with its members, dimension line, label,
camera and setting. Corners, colours and textures belong to a feature and are not counted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import repeat

from scenewright.core.brief.input_report import Fate, Outcome
from scenewright.formats.sh3d.openings import is_door
from scenewright.formats.sh3d.xml import Home, HomeLevel, HomePiece, HomeRoom, HomeWall, place_of

Feature = HomeWall | HomeRoom | HomePiece
Fates = dict[int, Fate]
"""Fates by the number of the feature's element."""

OTHERS = {
    "dimensionLine": ("dimension line", "measures are drawn anew"),
    "label": ("label", "words on the plan are set anew"),
    "polyline": ("polyline", "lines on the plan are no walls"),
    "camera": ("camera", "views are chosen anew"),
    "observerCamera": ("camera", "views are chosen anew"),
    "environment": ("environment", "ground, sky and light are of our own"),
    "compass": ("compass", "north is taken to be at the top"),
    "print": ("print settings", "plans are printed by our own sheet"),
    "backgroundImage": ("background image", "pictures are not read"),
    "property": ("setting", "a setting of Sweet Home 3D"),
    "furnitureVisibleProperty": ("setting", "a setting of Sweet Home 3D"),
}
"""Features that are not read: kind and reason."""
PIECE_KINDS = {"light": "lamp", "shelfUnit": "shelf unit", "furnitureGroup": "group of furniture"}
HIDDEN = "hidden in Sweet Home 3D"
HIDDEN_LEVEL = "its level is hidden in Sweet Home 3D; add --hidden-levels to include it"
EMPTY_LEVEL = "no room is on its level"


def list_fates(home: Home, hidden: Iterable[HomeLevel], used: set[str], found: Fates) -> list[Fate]:
    """A fate for every feature: as ``found`` while its level was read, else by its level, which is
    ``hidden``, ``used`` (its id) or without a room."""
    lost = {level.id for level in hidden}
    fates = [_of_level(level, lost, used) for level in home.levels if level.number >= 0]
    features: list[Feature] = [*home.walls, *home.rooms, *every_piece(home.pieces)]
    for feature in features:
        fates.append(found.get(feature.number) or _by_level(feature, lost, used))
    for tag, count in sorted(home.others.items()):
        kind, reason = OTHERS.get(tag, (tag, "it is not known what it means"))
        fates += repeat(Fate("", kind, "left out", reason), count)
    return fates


def every_piece(pieces: Iterable[HomePiece], level: str = "") -> Iterator[HomePiece]:
    """Pieces and groups with all their members, which stand on the level of their group."""
    for piece in pieces:
        here = piece._replace(level=piece.level or level)
        yield here
        yield from every_piece(here.members, here.level)


def kind_in_words(feature: HomeLevel | Feature) -> str:
    """The name a user knows a feature by."""
    if isinstance(feature, HomePiece):
        if feature.kind == "doorOrWindow":
            return "door" if is_door(feature) else "window"
        return PIECE_KINDS.get(feature.kind, "piece of furniture")
    return {HomeLevel: "level", HomeWall: "wall", HomeRoom: "room"}[type(feature)]


def fate_of(
    feature: HomeLevel | Feature, why: str = "", *, kept: bool = False, stands: bool = False
) -> Fate:
    """The fate of a feature: used, or for a reason ``why`` left out, or with it ``kept``."""
    outcome: Outcome = ("changed" if kept else "left out") if why else "used"
    return Fate(place_of(feature), kind_in_words(feature), outcome, why, stands and not kept)


def _of_level(level: HomeLevel, lost: set[str], used: set[str]) -> Fate:
    if level.id in lost:
        return fate_of(level, "hidden in Sweet Home 3D; add --hidden-levels to include it")
    return fate_of(level, "" if level.id in used else "no room is on it")


def _by_level(feature: Feature, lost: set[str], used: set[str]) -> Fate:
    """The fate of what no level that is read holds."""
    if feature.level in lost:
        return fate_of(feature, HIDDEN_LEVEL)
    if feature.level not in used:
        return fate_of(feature, EMPTY_LEVEL)
    return fate_of(feature)
