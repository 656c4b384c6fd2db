"""Where the metres of a brief lie on a map: the reference system of what it was read from."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.core.brief import Brief
from scenewright.core.reference_system import address_of


class Georeference(NamedTuple):
    """The coordinates of (0, 0) in a map and the name of its system, an address of the OGC; empty
    if it is not known."""

    origin: tuple[float, float]
    system: str


def georeference_of(brief: Brief) -> Georeference:
    """The one place of all sites of a brief; nothing is known of sites of several, nor of briefs
    that were not read from a map.

    >>> from scenewright.formats import read
    >>> georeference_of(read("sample:home-room"))
    Georeference(origin=(0.0, 0.0), system='')
    """
    sites = getattr(brief.part, "sites", ())
    frames = {Georeference(site.shift, address_of(site.system)) for site in sites}
    return frames.pop() if len(frames) == 1 else Georeference((0.0, 0.0), "")
