"""The fate of every feature of an indoor map."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from scenewright.core.brief.input_report import InputReport, report_input
from scenewright.core.projection import Projection
from scenewright.domains.hall.demands.programme import shop_kind
from scenewright.domains.hall.indoor.floors import IndoorFloor, role
from scenewright.ground.maps.fates import Note, settle
from scenewright.ground.maps.features import Collection, Feature, SkippedFeature
from scenewright.ground.maps.kinds import kind_of

COVERED = "others cover all of it"
UNREAD = "is no room, corridor, open area, door or shop of a level"
LINE = "is drawn as a line: walls and columns are read where they are areas"
NO_ROOM = "marks a shop, and lies in no room without a use"


def report_indoor(
    found: Collection,
    map_: Projection,
    floors: Sequence[IndoorFloor],
    doors: Iterable[str],
    lost: Iterable[SkippedFeature],
    changed: Iterable[SkippedFeature],
) -> InputReport:
    """The report of a map from its ``floors`` as read, the ids of its ``doors`` that were placed,
    and what was ``lost`` or ``changed`` and why. A room that cannot be read was drawn as built."""
    kinds = {feature.id: feature.kind for feature in found.features}
    kinds |= {name: kind_of(tags, "feature") for name, tags in found.broken.items()}
    rooms = {f.id for f in found.features if role(f.tags) and role(f.tags) != "solid"}
    rooms |= {name for name, tags in found.broken.items() if role(tags)}
    notes = [
        *(Note(name, "used") for name in _used(found.features, floors, set(doors))),
        *(Note(row.feature, "changed", _in_general(row.reason)) for row in changed),
        *(Note(f.id, "changed", f.lost) for f in found.features if f.lost),
        *(
            Note(_feature_of(row.feature, kinds), "left out", row.reason, _stands(row, rooms))
            for row in (*found.skipped, *lost)
        ),
    ]
    lines = {f.id for f in found.features if f.lines and role(f.tags) == "solid"}
    about = {f.id: NO_ROOM for f in found.features if f.point is not None and shop_kind(f.tags)}
    return report_input(
        settle(kinds, notes, lambda name: LINE if name in lines else about.get(name, UNREAD)),
        format=found.format,
        system=map_.system_in_words,
        unit=map_.unit_in_words,
    )


def _in_general(reason: str) -> str:
    """A reason without the names in it, so that it is counted with others like it."""
    head = "was cut where it overlaps"
    return f"{head} others" if reason.startswith(head) else reason


def _stands(row: SkippedFeature, rooms: set[str]) -> bool:
    return row.feature in rooms and row.reason != COVERED


def _used(
    features: Sequence[Feature], floors: Sequence[IndoorFloor], doors: set[str]
) -> Iterator[str]:
    """Features that make up a floor, columns and walls that cut them, shops marked in them,
    and doors."""
    drawn = {floor.feature for floor in floors}
    drawn |= {f.id for f in features if f.polygons and role(f.tags) == "solid"}
    tagged = [floor.tags for floor in floors if floor.role == "unit"]
    drawn |= {name.partition("-level-")[0] for name in doors} | doors
    for feature in features:
        marks = feature.point is not None and bool(shop_kind(feature.tags))
        shown = marks and any(feature.tags.items() <= tags.items() for tags in tagged)
        if feature.id in drawn or shown:
            yield feature.id


def _feature_of(name: str, kinds: dict[str, str]) -> str:
    """The feature that a door of one of its levels is named after."""
    return name if name in kinds else name.partition("-level-")[0]
