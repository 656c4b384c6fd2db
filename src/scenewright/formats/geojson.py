"""GeoJSON: a map is read by the domain that recognises its features."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from types import ModuleType

from scenewright.core.brief import Brief
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.core.registry import domain_names, domain_of
from scenewright.ground.maps.features import Collection, load
from scenewright.ground.maps.place import place_map


def read(path: Path, keep: bool = False, map_options: MapOptions = AS_IT_IS) -> Brief:
    """The brief of a map, placed as the ``map_options`` say. There is no furniture to ``keep``."""
    del keep
    return brief_of_map(place_map(load(path), map_options), Path(path).stem)


def brief_of_map(found: Collection, name: str) -> Brief:
    """The brief of the features of a map.

    The domain that the features name reads them, else the first that recognises them; if none
    does, the first that reads maps says what is missing.
    """
    reader = find_reader(found) or _readers()[0]
    brief: Brief = reader.brief_of(found, name)
    return brief


def find_reader(found: Collection) -> ModuleType | None:
    """The module of the domain that reads a map; ``None`` where none recognises it."""
    readers = _readers()
    named = [one for one in readers if getattr(one, "names_itself", lambda _found: False)(found)]
    return next((one for one in (*named, *readers) if one.recognises(found)), None)


def _readers() -> list[ModuleType]:
    rows = [kind for kind in map(domain_of, domain_names()) if kind.maps]
    return [import_module(row.maps, row.package) for row in rows]
