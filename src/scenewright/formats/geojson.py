"""GeoJSON: an indoor map if an area in it has the tag ``indoor``, else a site."""

from __future__ import annotations

from pathlib import Path

from scenewright.brief import Brief
from scenewright.formats import indoor_geojson, site_geojson
from scenewright.formats.indoor_features import load
from scenewright.formats.indoor_floors import role


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a map. There is no furniture to ``keep``."""
    del keep
    found, name = load(path), Path(path).stem
    indoor = any(feature.polygons and role(feature.tags) for feature in found.features)
    if indoor or not site_geojson.is_site(found):
        return indoor_geojson.report(found, name).brief
    return site_geojson.report(found, name).brief
