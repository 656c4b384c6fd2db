"""Treads have dark edges: seen from above, treads of one wood would be a ramp."""

from __future__ import annotations

from math import inf

import pytest

from scenewright.building.stair_parts import HAIR, RAIL, flight_parts
from scenewright.catalog.assets.materials import OAK, WALNUT
from scenewright.core.brief.stairs import StairsBrief
from scenewright.core.stairs import build_stairs


@pytest.mark.parametrize("shape", ["straight", "quarter", "half", "spiral"])
def test_every_tread_has_a_dark_edge(shape: str) -> None:
    asked = StairsBrief.model_validate({"at": (3.0, 3.0), "heading": 1.0, "shape": shape})
    stairs = build_stairs(asked, "s", "0", "1", 2.9)
    parts = {part.material: part for part in flight_parts(stairs)}
    tops = {round(float(z), 3) for z in parts[WALNUT].vertices[:, 2]}
    assert {round(t.height + HAIR, 3) for t in stairs.treads} <= tops
    assert max(WALNUT.color) < 0.8 * max(OAK.color)


@pytest.mark.parametrize("shape", ["straight", "quarter", "half", "spiral"])
def test_a_flight_is_cut_at_a_height_with_its_rails(shape: str) -> None:
    asked = StairsBrief.model_validate({"at": (3.0, 3.0), "heading": 1.0, "shape": shape})
    stairs = build_stairs(asked, "s", "0", "1", 2.9)
    whole, cut = (
        max(float(part.vertices[:, 2].max()) for part in flight_parts(stairs, upto=upto))
        for upto in (inf, 1.3)
    )
    assert whole > 2.9
    assert 1.3 < cut < 1.3 + RAIL + 0.1
