"""Where the sun stands and whom it reaches, against almanacs and polygons of shadow."""

from __future__ import annotations

import datetime

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from scenewright.geometry.box_grid import box_grid, cast
from scenewright.geometry.sun import (
    REFRACTED,
    declination,
    open_hours,
    sun_hours,
    sun_path,
    sun_position,
    sunrise,
)

Floats = NDArray[np.float64]
SOUTH = -np.pi / 2


def almanac(days: Floats) -> Floats:
    """Apparent declination in degrees, ``days`` after noon of 1 January 2000: the low-precision
    theory of J. Meeus, *Astronomical algorithms* (1991), chapter 25, good to 0.01 degrees."""
    t = days / 36525.0
    mean, anomaly = 280.46646 + 36000.76983 * t, np.deg2rad(357.52911 + 35999.05029 * t)
    centre = (
        1.914602 * np.sin(anomaly) + 0.019993 * np.sin(2 * anomaly) + 0.000289 * np.sin(3 * anomaly)
    )
    node = np.deg2rad(125.04 - 1934.136 * t)
    longitude = np.deg2rad(mean + centre - 0.00569 - 0.00478 * np.sin(node))
    tilt = np.deg2rad(23.439291 - 0.0130042 * t + 0.00256 * np.cos(node))
    return np.rad2deg(np.arcsin(np.sin(tilt) * np.sin(longitude)))


def test_the_almanac_is_right() -> None:
    """Meeus' own example, 13 October 1992 at 0 h: -7° 47' 06"; and 1 January 2001: -23.0126°."""
    found = almanac(np.array([2448908.5, 2451910.5]) - 2451545.0)
    assert found == pytest.approx([-(7 + 47 / 60 + 6 / 3600), -23.012593], abs=1e-3)


def test_the_declination_of_any_day_this_century() -> None:
    start = datetime.date(2000, 1, 1)
    dates = [start + datetime.timedelta(days=k) for k in range(366, 366 + 365 * 39)]
    days = np.array([(date - start).days for date in dates], float)
    numbers = np.array([date.timetuple().tm_yday for date in dates])
    apart = np.rad2deg(declination(numbers)) - almanac(days)
    assert np.abs(apart).max() < 0.25
    assert np.sqrt((apart**2).mean()) < 0.1


@pytest.mark.parametrize(
    ("day", "longitude"),
    [
        (5, 285),
        (20, 300),
        (35, 315),
        (50, 330),
        (79.5, 0),
        (110, 30),
        (125, 45),
        (172, 90),
        (204, 120),
        (219, 135),
        (266, 180),
        (281, 195),
        (296, 210),
        (326, 240),
        (355.5, 270),
    ],
)
def test_the_24_solar_terms(day: float, longitude: float) -> None:
    """Days of the Chinese calendar at which the sun has gone so far round the ecliptic."""
    known = np.arcsin(np.sin(np.deg2rad(23.437)) * np.sin(np.deg2rad(longitude)))
    assert np.rad2deg(declination(day) - known) == pytest.approx(0.0, abs=0.25)


@pytest.mark.parametrize(
    ("latitude", "day", "noon"),
    [
        (39.9, 355, 26.7),
        (39.9, 172, 73.5),
        (39.9, 79.5, 50.1),
        (31.2, 355, 35.4),
        (51.5, 355, 15.1),
        (23.44, 172, 90.0),
        (0.0, 266, 90.0),
        (-33.9, 172, 32.7),
        (-33.9, 355, 79.6),
        (69.6, 172, 43.8),
    ],
)
def test_the_height_of_the_sun_at_noon(latitude: float, day: float, noon: float) -> None:
    """90° less the distance of latitude and declination: Beijing, Shanghai, London, the tropic,
    the equator, Sydney, Tromsø."""
    azimuth, altitude = sun_position(latitude, day, 12.0)
    assert np.rad2deg(altitude) == pytest.approx(noon, abs=0.4)
    if noon < 89:
        wanted = 0.0 if latitude < 0 else np.pi
        assert np.cos(azimuth - wanted) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("latitude", "day", "length"),
    [
        (51.51, 355, 7 + 50 / 60),
        (51.51, 172, 16 + 38 / 60),
        (40.71, 355, 9 + 15 / 60),
        (40.71, 172, 15 + 6 / 60),
        (-33.87, 355, 14 + 25 / 60),
        (-33.87, 172, 9 + 54 / 60),
        (0.0, 100, 12 + 7 / 60),
        (64.15, 355, 4 + 8 / 60),
        (69.65, 355, 0.0),
        (69.65, 172, 24.0),
    ],
)
def test_published_lengths_of_the_day(latitude: float, day: float, length: float) -> None:
    """London, New York, Sydney, the equator, Reykjavik and Tromsø, to a few minutes."""
    found = 2 * (12.0 - sunrise(latitude, day, float(REFRACTED)))
    assert found == pytest.approx(length, abs=0.06 if latitude < 60 else 0.15)


def test_the_sun_rises_where_and_when_it_is_said_to() -> None:
    for latitude in (-60.0, -20.0, 0.0, 35.0, 60.0):
        for day in (20, 80, 172, 300):
            hour = sunrise(latitude, day)
            azimuth, altitude = sun_position(latitude, day, [hour, 24 - hour])
            assert altitude == pytest.approx([0.0, 0.0], abs=1e-9)
            rise = np.arccos(np.sin(declination(day)) / np.cos(np.deg2rad(latitude)))
            assert azimuth == pytest.approx([rise, 2 * np.pi - rise])


def test_the_path_is_where_the_sun_stands() -> None:
    path = sun_path(35.0, 20, (6.0, 18.0), 5.0, north=np.pi / 2 + 0.3)
    assert np.linalg.norm(path[:, :3], axis=1) == pytest.approx(1.0)
    hours = 6.0 + (np.arange(144) + 0.5) / 12
    azimuth, altitude = sun_position(35.0, 20, hours)
    kept = altitude > 0.0
    plan = np.pi / 2 + 0.3 - azimuth[kept]
    assert path[:, 2] == pytest.approx(np.sin(altitude[kept]))
    assert path[:, 0] == pytest.approx(np.cos(altitude[kept]) * np.cos(plan))
    assert path[:, 1] == pytest.approx(np.cos(altitude[kept]) * np.sin(plan))
    assert path[:, 3].sum() == pytest.approx(2 * (12 - sunrise(35.0, 20)), abs=0.2)
    assert len(sun_path(80.0, 355)) == 0


def town(rng: np.random.Generator, count: int = 40) -> tuple[Floats, Floats]:
    """Buildings of all kinds, some touching or overlapping."""
    boxes = np.column_stack(
        [
            rng.uniform(0, 150, (count, 2)),
            rng.uniform(-np.pi, np.pi, count),
            rng.uniform(8, 40, count),
            rng.uniform(8, 15, count),
        ]
    )
    boxes[::3, 2] = SOUTH
    return boxes, rng.choice([0.5, 4.0, 9.0, 18.0, 60.0], count)


def outline(box: Floats) -> shapely.Geometry:
    ring = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * box[[4, 3]] / 2
    c, s = np.cos(box[2]), np.sin(box[2])
    return shapely.Polygon(ring @ np.array([[c, s], [-s, c]]) + box[:2])


def swept(shape: shapely.Geometry, run: Floats) -> shapely.Geometry:
    return shapely.convex_hull(
        shapely.union_all([shape, shapely.transform(shape, lambda p: p + run)])
    )


def by_shadows(boxes: Floats, heights: Floats, path: Floats, places: int) -> Floats:
    """The same hours by polygons: the shadow of a prism at a height is swept by its outline."""
    shapes, hours = [outline(box) for box in boxes], np.zeros((len(boxes), 4))
    for ax, ay, az, held in path:
        for i, box in enumerate(boxes):
            z = min(0.9, heights[i])
            shade = shapely.union_all(
                [
                    swept(shape, (z - h) / az * np.array([ax, ay]))
                    for k, (shape, h) in enumerate(zip(shapes, heights, strict=True))
                    if h > z and k != i
                ]
            )
            for side in range(4):
                turn = box[2] + side * np.pi / 2
                out = np.array([np.cos(turn), np.sin(turn)])
                if out @ [ax, ay] <= 0:
                    continue
                deep, wide = (box[3], box[4]) if side % 2 else (box[4], box[3])
                for place in range(places):
                    shift = wide * ((place + 0.5) / places - 0.5)
                    spot = box[:2] + deep / 2 * out + shift * np.array([-out[1], out[0]])
                    hours[i, side] += 0.0 if shapely.intersects_xy(shade, *spot) else held / places
    return hours


@pytest.mark.parametrize(("seed", "places"), [(0, 1), (1, 3)])
def test_hours_are_those_of_shadow_polygons(seed: int, places: int) -> None:
    boxes, heights = town(np.random.default_rng(seed), 25)
    path = sun_path(40.0, 20, minutes=48.0)
    found = sun_hours(boxes, heights, path, places=places)
    wanted = by_shadows(boxes, heights, path, places)
    assert 0.2 < (wanted > 0).mean() < 0.8
    assert found == pytest.approx(wanted)


def test_hours_are_those_of_rays_without_a_grid() -> None:
    """One wide site with a few far towers and houses at its rim: the walk leaves none out."""
    rng = np.random.default_rng(5)
    boxes, heights = town(rng, 300)
    boxes[:, :2] *= [20, 3]
    grid = box_grid(boxes, heights)
    assert grid.columns * grid.rows > 100
    angles = rng.uniform(-np.pi, np.pi, 2000)
    rise = rng.uniform(-0.2, 0.3, 2000)
    ways = np.column_stack(
        [np.cos(angles) * np.cos(rise), np.sin(angles) * np.cos(rise), np.sin(rise)]
    )
    ways[:40] = np.repeat([[1.0, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], 10, 0)
    starts = np.column_stack(
        [rng.uniform(-500, 3500, 2000), rng.uniform(-200, 600, 2000), rng.uniform(0, 90, 2000)]
    )
    found, far = np.zeros(2000, np.int64), np.zeros(2000)
    cast(grid, starts, ways, 1e4, found, far, np.zeros(2000, np.int64), np.zeros(2000))
    least = np.full(2000, np.inf)
    one = (np.zeros(2000, np.int64), np.zeros(2000), np.zeros(2000, np.int64), np.zeros(2000))
    for box, height in zip(boxes, heights, strict=True):
        cast(box_grid([box], [height]), starts, ways, 1e4, *one)
        least = np.minimum(least, one[1])
    assert far == pytest.approx(least)
    assert 0.1 < np.isfinite(far).mean() < 0.9
    assert ((found >= 0) == np.isfinite(far)).all()


def test_nothing_in_front_gives_the_hours_of_the_sky() -> None:
    turns = np.linspace(-np.pi, np.pi, 17)
    boxes = np.column_stack([np.arange(17) * 5e3, np.zeros(17), turns, np.full((17, 2), 12.0)])
    path = sun_path(40.0, 20, minutes=1.0)
    hours = sun_hours(boxes, np.full(17, 20.0), path)
    assert hours == pytest.approx(open_hours(turns, path))
    for heading, row in zip(turns, hours, strict=True):
        azimuth = np.pi / 2 - heading
        times = np.linspace(8, 16, 48001)
        sun, _ = sun_position(40.0, 20, times)
        assert row[0] == pytest.approx(8 * (np.cos(sun - azimuth) > 0).mean(), abs=0.02)


def test_a_taller_neighbour_never_gives_more_sun() -> None:
    rng = np.random.default_rng(3)
    boxes, heights = town(rng)
    path = sun_path(35.0, 20)
    before = sun_hours(boxes, heights, path)
    total = 0.9 * before.sum()
    for raised in rng.permutation(len(boxes))[:12]:
        heights[raised] += 40.0
        hours = sun_hours(boxes, heights, path)
        others = np.arange(len(boxes)) != raised
        assert (hours[others] <= before[others] + 1e-12).all()
        before = hours
    assert before.sum() < total


def test_turning_site_and_north_together_changes_nothing() -> None:
    boxes, heights = town(np.random.default_rng(4))
    hours = sun_hours(boxes, heights, sun_path(35.0, 20))
    for angle in (0.4, 2.0, -1.1):
        c, s = np.cos(angle), np.sin(angle)
        turned = boxes.copy()
        turned[:, :2] = boxes[:, :2] @ np.array([[c, s], [-s, c]])
        turned[:, 2] += angle
        path = sun_path(35.0, 20, north=np.pi / 2 + angle)
        assert sun_hours(turned, heights, path) == pytest.approx(hours)


def test_the_south_of_the_south_is_the_north() -> None:
    """Mirrored at the equator half a year later, the site has the same hours."""
    boxes, heights = town(np.random.default_rng(6))
    path = sun_path(35.0, 20)
    mirrored = boxes * [1, -1, -1, 1, 1]
    hours = sun_hours(mirrored, heights, path * [1, -1, 1, 1])
    assert hours[:, [0, 3, 2, 1]] == pytest.approx(sun_hours(boxes, heights, path))
    assert (sun_path(-35.0, 172)[:, 1] > 0).all()


def test_landmarks_only_throw_shadows() -> None:
    boxes, heights = town(np.random.default_rng(7))
    path = sun_path(35.0, 20)
    alone = sun_hours(boxes[:30], heights[:30], path, (boxes[30:], heights[30:]))
    assert alone == pytest.approx(sun_hours(boxes, heights, path)[:30])


def test_the_spacing_of_the_rules_keeps_its_hours() -> None:
    """A long slab south of another: at noon of a sun 26.6° high its shadow ends at the sill when
    it is as far away as (18 - 0.9) / tan 26.6°."""
    path = sun_path(39.9, 355, (11.9, 12.1), 12.0)
    apart = (18.0 - 0.9) / np.tan(np.arcsin(path[0, 2]))
    for gap, lit in ((apart - 0.1, 0.0), (apart + 0.1, 0.2)):
        boxes = [[0, 0, SOUTH, 400, 12], [0, 12 + gap, SOUTH, 40, 12]]
        assert sun_hours(boxes, [18.0, 18.0], path)[1, 0] == pytest.approx(lit)


def test_no_buildings_and_no_sun() -> None:
    assert sun_hours(np.zeros((0, 5)), np.zeros(0), sun_path(40.0, 20)).shape == (0, 4)
    assert sun_hours([[0, 0, 0, 9, 9]], [9.0], sun_path(80.0, 355)).tolist() == [[0.0] * 4]
