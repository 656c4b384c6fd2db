"""Maps of GIS programs (GeoPackage, shapefile, KML) and of OpenStreetMap (XML, PBF), with the extra
``gis``: the domain that recognises their features reads them, as it does those of GeoJSON."""

from __future__ import annotations

from pathlib import Path

from scenewright.core.brief import Brief
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.formats.geojson import brief_of_map
from scenewright.ground.geodata.reading import load_map, name_of
from scenewright.ground.map_place import place_map


def read(path: Path, keep: bool = False, map_options: MapOptions = AS_IT_IS) -> Brief:
    """The brief of a map, of the layers and placed as the ``map_options`` say. There is no
    furniture to ``keep``."""
    del keep
    return brief_of_map(place_map(load_map(path, map_options), map_options), name_of(path))
