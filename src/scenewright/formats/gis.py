"""Maps of GIS programs (GeoPackage, shapefile, KML) and of OpenStreetMap (XML, PBF), with the extra
``gis``: the domain that recognises their features reads them, as it does those of GeoJSON."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.formats.geojson import brief_of_map, find_reader
from scenewright.ground.geodata.reading import load_map, name_of
from scenewright.ground.maps.place import place_map

NEEDED = (
    "name its layers after what they hold (buildings, roads, site), or give the id of an area with "
    "--site"
)


def read(path: Path, keep: bool = False, map_options: MapOptions = AS_IT_IS) -> Brief:
    """The brief of a map, of the layers and placed as the ``map_options`` say. There is no
    furniture to ``keep``."""
    del keep
    found = place_map(load_map(path, map_options), map_options)
    if find_reader(found) is None:
        kinds = Counter(feature.kind for feature in found.features).most_common(3)
        counted = ", ".join(f"{count:,} × {kind}" for kind, count in kinds) or "nothing drawn"
        raise InputError(f"holds no building, street or room, but {counted}", NEEDED)
    return brief_of_map(found, name_of(path))
