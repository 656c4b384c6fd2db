"""Borders of zones that move: the floor stays whole, drawn zones stay as drawn, energies fall."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.domains.hall.hall_layout import Zone
from scenewright.domains.hall.zoning.borders import shared_borders
from scenewright.domains.hall.zoning.shifted_zones import BorderLine, border_lines, shift_zones
from scenewright.domains.hall.zoning.zones import zones_of
from scenewright.formats import read


def zones_and_lines(name: str) -> tuple[Brief, tuple[Zone, ...], tuple[BorderLine, ...]]:
    brief = read(name)
    zones = zones_of(brief, 0, spaces(brief)[0]).zones
    return brief, zones, border_lines(shared_borders(zones))


@pytest.mark.parametrize("name", ["exhibition", "shop", "irregular", "reading-room"])
@pytest.mark.parametrize("metres", [-0.7, 0.4])
def test_moved_zones_fill_the_same_floor_without_overlap(name: str, metres: float) -> None:
    brief, zones, lines = zones_and_lines(f"sample:hall-{name}")
    before = shapely.union_all([_shape(zone) for zone in zones])
    moves = [shift_zones(zones, line, metres, spaces(brief)[0]) for line in lines]
    assert any(moved is not None for moved in moves)
    for line, moved in zip(lines, moves, strict=True):
        if moved is None:
            continue
        shapes = [_shape(zone) for zone in moved]
        after = shapely.union_all(shapes)
        assert after.symmetric_difference(before).area < 0.01
        assert sum(shape.area for shape in shapes) == pytest.approx(after.area, abs=0.01)
        swept = np.array([_shape(zone).area for zone in moved])
        swept -= [_shape(zone).area for zone in zones]
        assert {k for k in range(len(zones)) if abs(swept[k]) > 1e-6} <= set(line.zones)
        grown = sum(swept[list(line.right)]) - sum(swept[list(line.left)])
        assert np.sign(grown) == np.sign(metres)


def test_a_line_too_far_away_from_itself_does_not_move() -> None:
    brief, zones, lines = zones_and_lines("sample:hall-shop")
    assert all(shift_zones(zones, line, 30.0, spaces(brief)[0]) is None for line in lines)


def crowded(slack: float) -> Brief:
    """A crowded zone beside an empty one."""
    zones = [
        {"id": "west", "outline": [[0, 0], [5, 0], [5, 8], [0, 8]], "slack": slack},
        {"id": "east", "outline": [[5, 0], [16, 0], [16, 8], [5, 8]], "slack": slack},
    ]
    room = {
        "id": "hall",
        "outline": [[0, 0], [16, 0], [16, 8], [0, 8]],
        "doors": [{"id": "in", "at": [12, 0], "width": 1.8, "swing": "out"}],
        "zones": zones,
        "demands": [
            {"category": "showcase", "count": 9, "zone": "west", "patterns": ["grid", "chain"]},
            {"category": "plinth", "count": 3, "zone": "east"},
        ],
    }
    told = {"format": "scenewright/brief", "version": 1, "domain": "hall", "rooms": [room]}
    return Brief.model_validate(told)


def test_a_crowded_zone_expands_where_borders_have_slack() -> None:
    for seed in range(3):
        fixed = scenewright.solve(crowded(0.0), steps=3000, seed=seed)
        loose = scenewright.solve(crowded(2.0), steps=3000, seed=seed)
        assert fixed.detail.shifts == ()
        ((_, _, metres),) = loose.detail.shifts
        assert -2.0 <= metres < 0.0  # to the right of the line, which leads north
        west = _shape(loose.detail.layout.zones[0])
        assert west.area == pytest.approx(40.0 - 8.0 * metres, abs=0.01)
        assert sum(loose.energies.values()) < sum(fixed.energies.values())
        assert scenewright.check(loose).valid


def test_moved_borders_are_written_and_read_again(tmp_path: Path) -> None:
    found = scenewright.solve(crowded(2.0), steps=3000)
    scenewright.write(found, tmp_path / "hall.json")
    again = scenewright.read_solution(tmp_path / "hall.json")
    assert again.detail.shifts == found.detail.shifts
    assert [zone.outline.tolist() for zone in again.detail.layout.zones] == [
        zone.outline.tolist() for zone in found.detail.layout.zones
    ]


@pytest.mark.parametrize("seed", [11, 16])
def test_walls_on_moved_borders_end_within_the_hall(seed: int) -> None:
    found = scenewright.solve(read("sample:hall-irregular"), seed=seed)
    assert scenewright.check(found).valid


def _shape(zone: Zone) -> shapely.Polygon:
    return shapely.Polygon(zone.outline, zone.holes)
