"""What is built somewhere, read from maps, city models and saved solutions."""

from __future__ import annotations

from pathlib import Path

from scenewright.catalog.models.city_documents import document_of
from scenewright.catalog.models.files import MEBIBYTE, json_of, whole
from scenewright.core.atomic_file import note_read
from scenewright.core.errors import InputError
from scenewright.core.workspace import check_inside
from scenewright.ground.buildings.built import BuiltScene
from scenewright.ground.geodata.kinds import is_map

MOST_BYTES = 128 * MEBIBYTE


def read_built(
    path: Path, origin: tuple[float, float] | None = None, scale: float = 1.0
) -> BuiltScene:
    """What is built in a file: a map (GeoJSON, GIS, OpenStreetMap), CityJSON, a glTF scene (or a
    folder of them; ``scale`` is metres a unit), a saved solution of buildings or a brief that
    draws some.

    Maps in degrees become metres about ``origin`` (longitude, latitude), else about their own
    middle. InputError, naming the file, for what holds no building.
    """
    try:
        return _read(path, origin, scale)
    except OSError as error:
        fault = f"cannot be read: {error.strerror or error}"
        raise InputError(fault, "check the path", file=str(path)) from None
    except InputError as error:
        raise error.located(file=str(path)) from None


def _read(path: Path, origin: tuple[float, float] | None, scale: float) -> BuiltScene:
    from scenewright.ground.reading.briefs import drawn_scene, draws_buildings
    from scenewright.ground.reading.city import city_scene
    from scenewright.ground.reading.maps import map_scene, scene_of_features
    from scenewright.ground.reading.models import SUFFIXES, model_scene
    from scenewright.ground.reading.saved import saved_scene

    check_inside(path)
    if path.is_dir() or (path.is_file() and path.suffix.lower() in SUFFIXES):
        return _with_buildings(model_scene(path, scale))
    if not path.is_file():
        raise InputError("there is no such file", "check the path")
    if is_map(path.name):
        from scenewright.ground.geodata.reading import load_map, name_of

        return _with_buildings(scene_of_features(load_map(path), name_of(path), origin))
    if path.suffix.lower() not in (".json", ".geojson", ".cityjson", ".jsonl"):
        raise InputError(
            f"'{path.suffix}' holds no buildings that can be read",
            "give a map (.geojson, .osm, .gpkg, .shp, .kml), .city.json, .glb or a saved solution",
        )
    note_read(path)
    document = document_of(whole(path, MOST_BYTES), "JSON")
    if document.get("type") == "CityJSON":
        found = city_scene(document, path)
    elif document.get("type") in ("FeatureCollection", "Feature"):
        found = map_scene(document, path.stem, origin)
    elif isinstance(document.get("pieces"), list):
        found = saved_scene(document)
    elif draws_buildings(document):
        found = drawn_scene(document)
    else:
        raise InputError(
            "is no map, city model or solution and draws no building",
            "give a map, .city.json, or what arrange wrote as .json",
        )
    return _with_buildings(found)


def _with_buildings(found: BuiltScene) -> BuiltScene:
    if not found.buildings:
        raise InputError("holds no building", "give a scene with buildings")
    return found


def read_grown(path: Path) -> tuple[BuiltScene, BuiltScene]:
    """What stood before and what was grown, of a saved extension. InputError for any other
    file."""
    from scenewright.ground.reading.saved import grown_scenes

    try:
        if not path.is_file():
            raise InputError("there is no such file", "check the path")
        if path.suffix.lower() != ".json":
            raise InputError("is no saved extension", "give two scenes to compare")
        document = json_of(whole(path, MOST_BYTES), "JSON")
        note_read(path)
        return grown_scenes(document)
    except InputError as error:
        raise error.located(file=str(path)) from None
