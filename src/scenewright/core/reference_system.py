"""Coordinate reference systems, however a file names them: what a unit of theirs measures.

One rule for every reader, by PROJ: codes (``EPSG:25832``), names of the OGC (``urn:ogc:def:crs:…``
and addresses), compounds of a plane and a height, WKT and PROJJSON. A system says whether its
coordinates are degrees, how long a unit is, and how much its plane stretches the ground at a place
(half as long again in web Mercator at 48 degrees).
"""

from __future__ import annotations

import json
import math
import re
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.space import Points

LEAST_STRETCH = 0.005
"""A plane that stretches the ground by less is taken as it is: UTM, national grids."""
LONGEST, LONGEST_NAME = 20_000, 200
"""Letters of a system's definition that are read, and of its name."""
REMEDY = (
    'name one that is, such as "EPSG:25832", or export it as longitude and latitude (EPSG:4326)'
)
_HEIGHT = "Vertical CRS"
_CODE = re.compile(
    r"\b(EPSG|ESRI|OGC|IGNF|IAU_?\d*)(?:\.xml#|[:/]+(?:[\d.]*[:/]+)?)((?:CRS)?\w+)", re.IGNORECASE
)
_ADDRESS = re.compile(r"https?://www\.opengis\.net/def/crs\S+")
_DEFINITION = re.compile(r"\s*(?:\{|\+|[A-Za-z]\w*\s*\[)")
_PLAIN = re.compile(
    r"(?:https?://(?:www\.)?(?:epsg\.io|spatialreference\.org/ref/epsg)/)?(\d{4,6})/?"
)


class ReferenceSystem(NamedTuple):
    """A system as its file ``named`` it: the ``code`` of its plane (``EPSG:25832``; empty if it has
    none), its ``title``, whether x and y are longitude and latitude, the ``unit`` of both in words
    and in metres (in degrees of angle where they are degrees), and metres in a unit of height."""

    named: str
    code: str
    title: str
    degrees: bool
    unit: str
    length: float
    height: float

    @property
    def label(self) -> str:
        """The system in words, for a report."""
        return f"{self.code} ({self.title})" if self.code else self.title

    @property
    def name(self) -> str:
        """A name of at most 200 letters under which it is found again; empty if it has none."""
        short = len(self.named) <= LONGEST_NAME and self.named.isprintable()
        return self.named if short else self.code


def system_of(named: object) -> ReferenceSystem | None:
    """The reference system that a file names, by text, by number or as PROJJSON; ``None`` where it
    names none. InputError for one that is not known.

    >>> found = system_of("http://www.opengis.net/def/crs/EPSG/0/2263")
    >>> found.code, found.degrees, found.unit, round(found.length, 4)
    ('EPSG:2263', False, 'US survey foot', 0.3048)
    >>> system_of("urn:ogc:def:crs:OGC:1.3:CRS84").degrees, system_of("")
    (True, None)
    """
    text = json.dumps(named) if isinstance(named, dict) else str(named or "").strip()
    return _known(text) if text else None


@lru_cache(maxsize=32)
def _known(text: str) -> ReferenceSystem:
    crs = _parse(text)
    plane = _plane(crs)
    axes = list(plane.axis_info)[:2]
    if len(axes) < 2 or crs.is_geocentric:
        raise InputError(f"its reference system '{crs.name[:60]}' is not of a plane map", REMEDY)
    degrees = bool(plane.is_geographic)
    factor = float(axes[0].unit_conversion_factor)
    length = math.degrees(factor) if degrees else factor
    ups = [axis for axis in crs.axis_info if axis.direction == "up"]
    height = float(ups[0].unit_conversion_factor) if ups else 1.0 if degrees else length
    authority = plane.to_authority(min_confidence=70)
    return ReferenceSystem(
        text[:LONGEST],
        ":".join(authority) if authority else "",
        " ".join(str(plane.name).split())[:80],
        degrees,
        str(axes[0].unit_name),
        length,
        height,
    )


def place_of(system: ReferenceSystem, x: float, y: float) -> tuple[float, float] | None:
    """Longitude and latitude in degrees of a place in a system; ``None`` if it is not on earth.

    >>> [round(v, 2) for v in place_of(system_of("EPSG:25832"), 650_000.0, 5_480_000.0)]
    [11.07, 49.45]
    """
    lon, lat = to_degrees(system, np.array([[x, y]], float))[0].tolist()
    right = math.isfinite(lon) and math.isfinite(lat) and abs(lat) <= 90
    return (lon, lat) if right else None


def to_degrees(system: ReferenceSystem, points: Points) -> Points:
    """Longitudes and latitudes (n, 2) of points (n, 2) of a system, x first; not finite where they
    are not on earth."""
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    try:
        turning = Transformer.from_crs(_plane(_parse(system.named)), "OGC:CRS84", always_xy=True)
        found = turning.transform(points[:, 0], points[:, 1], errcheck=False)
    except ProjError:
        return np.full((len(points), 2), np.inf)
    return np.column_stack(found)


def from_degrees(system: ReferenceSystem, lon: float, lat: float) -> tuple[float, float]:
    """The place of a longitude and latitude in a system, x first; not finite where it has none.

    >>> [round(v) for v in from_degrees(system_of("EPSG:25832"), 11.07, 49.45)]
    [650031, 5479542]
    """
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    try:
        turning = Transformer.from_crs("OGC:CRS84", _plane(_parse(system.named)), always_xy=True)
        x, y = turning.transform(lon, lat, errcheck=False)
    except ProjError:
        return math.inf, math.inf
    return float(x), float(y)


def stretch_at(system: ReferenceSystem, x: float, y: float) -> float:
    """Metres that the plane of a system shows for a metre of ground at a place; 1 within half a
    per cent of that.

    >>> round(stretch_at(system_of("EPSG:3857"), 1.2e6, 6.1e6), 2)
    1.49
    >>> stretch_at(system_of("EPSG:25832"), 650_000.0, 5_480_000.0)
    1.0
    """
    from pyproj import Proj
    from pyproj.exceptions import ProjError

    where = None if system.degrees else place_of(system, x, y)
    if where is None:
        return 1.0
    try:
        factors = Proj(_plane(_parse(system.named))).get_factors(*where)
    except ProjError:
        return 1.0
    found = math.sqrt(abs(factors.areal_scale)) if math.isfinite(factors.areal_scale) else 1.0
    return found if found > LEAST_STRETCH and abs(found - 1) > LEAST_STRETCH else 1.0


def covers(system: ReferenceSystem, x: float, y: float) -> bool:
    """Whether a place lies where a system is used."""
    area, where = _plane(_parse(system.named)).area_of_use, place_of(system, x, y)
    if area is None or where is None:
        return False
    west, south, east, north = area.bounds
    return bool(west <= where[0] <= east and south <= where[1] <= north)


def address_of(system: str) -> str:
    """The name as CityJSON wants it, an address of the OGC; empty if it is not known.

    >>> address_of("urn:ogc:def:crs:EPSG::25832"), address_of("local")
    ('https://www.opengis.net/def/crs/EPSG/0/25832', '')
    """
    if _ADDRESS.fullmatch(system):
        return system
    authority, _, code = _code_of(system).partition(":")
    version = "1.3" if authority == "OGC" else "0"
    return f"https://www.opengis.net/def/crs/{authority}/{version}/{code}" if code else ""


def urn_of(system: str) -> str:
    """The name as GeoJSON before RFC 7946 wants it; empty if it is not known.

    >>> urn_of("https://www.opengis.net/def/crs/EPSG/0/7415"), urn_of("EPSG:25832"), urn_of("")
    ('urn:ogc:def:crs:EPSG::28992', 'urn:ogc:def:crs:EPSG::25832', '')
    """
    authority, _, code = _code_of(system).partition(":")
    version = "1.3" if authority == "OGC" else ""
    return f"urn:ogc:def:crs:{authority}:{version}:{code}" if code else ""


def _code_of(system: str) -> str:
    """The code of a system by any of its names; empty if it is not known or has none."""
    try:
        found = system_of(system)
    except InputError:
        return ""
    return found.code if found else ""


@lru_cache(maxsize=32)
def _parse(text: str) -> Any:
    """The system of PROJ that a text names; InputError if there is none."""
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    for name in _spellings(text[:LONGEST]):
        try:
            found = CRS.from_user_input(name)
        except CRSError:
            continue
        if _is_stated(name) or _letters(found.name) == _letters(name):
            return found
    shown = "".join(sign if sign.isprintable() else " " for sign in text[:60])
    raise InputError(f"its reference system '{shown}' is not known", REMEDY)


def _spellings(text: str) -> list[str]:
    """The names by which PROJ may know a system: what is written, then the codes in it."""
    codes = [f"{found[1].upper()}:{found[2].upper()}" for found in _CODE.finditer(text)]
    plain = _PLAIN.fullmatch(text)
    bare = [f"EPSG:{plain[1]}"] if plain else []
    if re.fullmatch(r"(?:urn:)?CRS:?84h?", text, re.IGNORECASE):
        bare = ["OGC:CRS84"]
    joined = [f"{codes[0]}+{codes[1].partition(':')[2]}"] if len(codes) == 2 else []
    return [text] if _DEFINITION.match(text) else [*joined, *codes[:1], *bare, text]


def _is_stated(name: str) -> bool:
    """Whether a name is a code or a definition, which PROJ takes exactly or not at all; of words
    it takes the most alike."""
    return bool(_DEFINITION.match(name) or _CODE.search(name))


def _letters(name: str) -> str:
    return re.sub(r"\W|_", "", name).casefold()


def _plane(crs: Any) -> Any:
    """The part of a system that x and y are of."""
    while crs.is_bound:
        crs = crs.source_crs
    parts = [part for part in crs.sub_crs_list if part.type_name != _HEIGHT]
    return _plane(parts[0]) if parts else crs
