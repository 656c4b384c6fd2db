"""Rows for rooms one sleeps in."""

from __future__ import annotations

from scenewright.arranging.rows import BACK, FRONT, LEFT, Class, Row, against, clear
from scenewright.catalog.classes import BEDS, SOFAS
from scenewright.domains.home.measures import AT_WALL
from scenewright.domains.home.rules.classes import stand
from scenewright.domains.home.rules.sources import FLATS

DEAD = 0.6  # gap behind a head that counts in full, metres

_NEAR = "{of} is within {metres} m of {to}"

BEDROOM = (
    Row(
        "adrift", stand("a single bed", "single_bed"), against(LEFT), Class("a wall"), AT_WALL,
        "adrift", "{of} has no long side at {to}", FLATS,
    ),
    Row(
        "head_off", stand("a single bed", "single_bed"), against(BACK, DEAD), Class("the wall"),
        AT_WALL, "head_off", "the head of {of} is off {to}", FLATS,
    ),
    Row(
        "sofa_at_foot", stand("a bed", *BEDS), clear(FRONT, each=True), stand("a sofa", *SOFAS),
        0.4, 4.0, _NEAR, FLATS, late=True,
    ),
)  # fmt: skip
"""The rows."""
