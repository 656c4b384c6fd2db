"""Names of coordinate reference systems, which every format writes in its own way."""

from __future__ import annotations

import re

EPSG = re.compile(r"\bEPSG[:/]+(?:[\d.]*[:/])?(\d{4,6})$", re.IGNORECASE)
ADDRESS = re.compile(r"https?://www\.opengis\.net/def/crs/\S+")


def address_of(system: str) -> str:
    """The name as CityJSON wants it, an address of the OGC; empty if it is not known.

    >>> address_of("urn:ogc:def:crs:EPSG::25832"), address_of("local")
    ('https://www.opengis.net/def/crs/EPSG/0/25832', '')
    """
    if ADDRESS.fullmatch(system):
        return system
    found = EPSG.search(system)
    return f"https://www.opengis.net/def/crs/EPSG/0/{found[1]}" if found else ""


def urn_of(system: str) -> str:
    """The name as GeoJSON before RFC 7946 wants it; empty if it is not known.

    >>> urn_of("https://www.opengis.net/def/crs/EPSG/0/7415"), urn_of("EPSG:25832"), urn_of("")
    ('urn:ogc:def:crs:EPSG::7415', 'urn:ogc:def:crs:EPSG::25832', '')
    """
    found = EPSG.search(system)
    return f"urn:ogc:def:crs:EPSG::{found[1]}" if found else ""
