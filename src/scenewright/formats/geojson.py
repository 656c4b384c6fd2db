"""GeoJSON: a map is read by the domain that recognises its features."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from scenewright.core.brief import Brief
from scenewright.core.registry import domain_names, domain_of
from scenewright.ground.map_features import load


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a map. There is no furniture to ``keep``.

    The domain that the features name reads them, else the first that recognises them; if none
    does, the first that reads maps says what is missing.
    """
    del keep
    found, name = load(path), Path(path).stem
    rows = [kind for kind in map(domain_of, domain_names()) if kind.maps]
    readers = [import_module(row.maps, row.package) for row in rows]
    named = [one for one in readers if getattr(one, "names_itself", lambda _found: False)(found)]
    reader = next((one for one in (*named, *readers) if one.recognises(found)), readers[0])
    brief: Brief = reader.brief_of(found, name)
    return brief
