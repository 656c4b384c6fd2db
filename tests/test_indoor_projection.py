"""Indoor maps in degrees and in metres."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from indoor_maps import (
    BOOKS,
    LAT,
    LON,
    PER_DEGREE,
    SHOES,
    STREET,
    Json,
    crs,
    document,
    floor,
    read,
    room,
    tangent_plane,
)
from scenewright.building.plan import spaces
from scenewright.core.projection import metres, projection
from scenewright.domains.hall.indoor.geojson import report
from scenewright.ground.maps.features import collection


@given(st.floats(-179, 179), st.floats(-80, 80), st.floats(-300, 300), st.floats(-300, 300))
def test_lengths_agree_with_the_tangent_plane(lon: float, lat: float, x: float, y: float) -> None:
    """To a thousandth within 300 m, at every latitude up to 80 degrees."""
    about = np.array([lon, lat])
    there = about + np.array([x / (111_320 * math.cos(math.radians(lat))), y / 111_132])
    ours = metres(projection(about[None]), there[None])[0]
    exact = tangent_plane(there[None], about)[0]
    assert np.hypot(*(ours - exact)) <= 1e-3 * max(np.hypot(*exact), 1.0)


def test_nothing_is_torn_where_longitudes_begin_anew() -> None:
    corners = np.array([[179.9999, 0.0], [-179.9999, 0.0], [-179.9999, 0.0001]])
    flat = metres(projection(corners), corners)
    assert np.hypot(*(flat[1] - flat[0])) == pytest.approx(22.26, abs=0.01)


def plain_metres(*features: Json, at: tuple[float, float] = (0.0, 0.0)) -> Json:
    """The same features in metres."""

    def turned(value: Any) -> Any:
        if isinstance(value[0], list):
            return [turned(part) for part in value]
        return [(value[0] - LON) * PER_DEGREE[0] + at[0], (value[1] - LAT) * PER_DEGREE[1] + at[1]]

    found = json.loads(json.dumps(features))
    for feature in found:
        feature["geometry"]["coordinates"] = turned(feature["geometry"]["coordinates"])
    return document(*found)


@pytest.mark.parametrize("at", [(0.0, 0.0), (450_000.0, 5_400_000.0)])
def test_maps_in_metres_are_read_as_they_are(at: tuple[float, float]) -> None:
    utm = crs("urn:ogc:def:crs:EPSG::32631")
    brief = report(collection(plain_metres(SHOES, BOOKS, STREET, at=at) | utm), "m").brief
    assert floor(room(brief, "way-1")).area == pytest.approx(80, abs=0.02)
    assert len(spaces(brief)) == 3


def test_a_named_reference_system_counts() -> None:
    assert read(SHOES, **crs("urn:ogc:def:crs:OGC:1.3:CRS84")).units == 1
    assert read(SHOES, **crs("EPSG:4326")).units == 1
    utm = plain_metres(SHOES) | crs("urn:ogc:def:crs:EPSG::32631")
    assert floor(report(collection(utm), "m").brief.rooms[0]).area == pytest.approx(80, abs=0.02)
