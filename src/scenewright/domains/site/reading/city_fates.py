"""The fate of every object of a city model that was read as a site."""

from __future__ import annotations

from scenewright.catalog.models.cityjson import City, parts_within, roots_of
from scenewright.core.brief.input_report import InputReport, report_input
from scenewright.core.errors import InputError
from scenewright.ground.maps.fates import Note, settle

UNREAD = {
    "TINRelief": "all ground is level",
    "PlantCover": "plants are planted anew",
    "SolitaryVegetationObject": "trees are planted anew",
    "LandUse": "is no ground drawn as a site (class 'site')",
    "BuildingInstallation": "a building is drawn by itself and its parts",
    "Tunnel": "lies below the ground",
}
"""Why objects of a type are left out."""
OTHERS = "objects of its type are not read"


def report_objects(city: City, notes: list[Note]) -> InputReport:
    """The report of a city model: parts of a building share its fate."""
    kinds = {key: str(one.get("type"))[:80] for key, one in city.objects.items()}
    by_key: dict[str, list[Note]] = {}
    for note in notes:
        by_key.setdefault(note.name, []).append(note)
    shared = [
        note._replace(name=part)
        for root in roots_of(city)
        for part in _parts(city, root)
        for note in by_key.get(root, ())
    ]
    fates = settle(kinds, [*notes, *shared], lambda key: UNREAD.get(kinds[key].lstrip("+"), OTHERS))
    map_ = city.map_
    named = map_.system_in_words
    return report_input(fates, format="CityJSON", system=named, unit=map_.unit_in_words)


def _parts(city: City, root: str) -> list[str]:
    """The parts of a building, without itself; none where they are too deep."""
    try:
        return [key for key in parts_within(city, root) if key != root]
    except InputError:
        return []
