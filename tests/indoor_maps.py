"""Indoor maps drawn by hand: a small shopping street of our own."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import shapely

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief, Room
from scenewright.domains.hall.indoor.geojson import IndoorReport, report
from scenewright.ground.maps.features import collection

LON, LAT = 5.72, 45.18


Json = dict[str, Any]


PHI = math.radians(LAT)


PER_DEGREE = (
    111_412.84 * math.cos(PHI) - 93.5 * math.cos(3 * PHI) + 0.118 * math.cos(5 * PHI),
    111_132.92 - 559.82 * math.cos(2 * PHI) + 1.175 * math.cos(4 * PHI),
)
"""Metres of a degree of longitude and latitude in Grenoble, by the usual series."""


def degrees(x: float, y: float) -> list[float]:
    """Metres about a place in Grenoble as longitude and latitude."""
    return [LON + x / PER_DEGREE[0], LAT + y / PER_DEGREE[1]]


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [degrees(*p) for p in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))]


def area(name: str, ring: Any, /, **tags: str) -> Json:
    rings = ring if isinstance(ring[0][0], list) else [ring]
    geometry = {"type": "Polygon", "coordinates": rings}
    return {"type": "Feature", "id": name, "properties": tags, "geometry": geometry}


def node(name: str, x: float, y: float, /, **tags: str) -> Json:
    geometry = {"type": "Point", "coordinates": degrees(x, y)}
    return {"type": "Feature", "id": name, "properties": tags, "geometry": geometry}


def document(*features: Any, **more: Any) -> Json:
    return {"type": "FeatureCollection", "features": list(features), **more}


def read(*features: Any, **more: Any) -> IndoorReport:
    found = report(collection(document(*features, **more)), "mall")
    assert len(spaces(found.brief)) == len(found.brief.rooms)
    return found


def room(brief: Brief, name: str) -> Room:
    return next(r for r in brief.rooms if r.id == name)


def floor(r: Room) -> shapely.Polygon:
    return shapely.Polygon(r.outline, r.holes)


SHOES = area("way/1", box(0, 0, 10, 8), indoor="room", shop="shoes", name="Pied", level="0")


BOOKS = area("way/2", box(10, 0, 20, 8), indoor="room", shop="books", level="0")


STREET = area("way/4", box(0, 8, 24, 12), indoor="corridor", level="0")


DOOR = node("node/9", 4, 8.02, door="hinged", width="1.0", level="0")


# Projection


def tangent_plane(rings: np.ndarray[Any, Any], about: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """East and north on the plane that touches WGS 84 at ``about``, by way of space."""

    def in_space(lon_lat: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        lam, phi = np.deg2rad(lon_lat).T
        b_over_a = 6_356_752.314245 / 6_378_137.0
        n = 6_378_137.0**2 / np.hypot(6_378_137.0 * np.cos(phi), 6_356_752.314245 * np.sin(phi))
        return np.column_stack(
            [
                n * np.cos(phi) * np.cos(lam),
                n * np.cos(phi) * np.sin(lam),
                b_over_a**2 * n * np.sin(phi),
            ]
        )

    lam, phi = np.deg2rad(about)
    east = np.array([-np.sin(lam), np.cos(lam), 0.0])
    north = np.array([-np.sin(phi) * np.cos(lam), -np.sin(phi) * np.sin(lam), np.cos(phi)])
    away = in_space(np.atleast_2d(rings)) - in_space(about[None])
    return np.column_stack([away @ east, away @ north])


def crs(name: str) -> Json:
    return {"crs": {"type": "name", "properties": {"name": name}}}
