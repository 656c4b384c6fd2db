"""Blocks in the manner of Hui villages, made by rules of our own and a seed, surveyed nowhere.

Rows of houses stand wall to wall or with lanes of 1.5 to 3 m between them and between the rows:
court houses (closed, or open to the lane as a U), halls, halls with a wing, annexes. Doors look to
the edge of the block from the outer rows and to the lane from the inner ones; materials follow the
kind. So doors and all three materials are known, which no map tells. Rows are those that
``scenewright learn village`` reads:

    python -m benchmarks.hui_blocks 40 hui/

writes ``hui/blocks.json``, and beside it ``hui.json``, a brief of the first block in which its
houses stand drawn in the Hui style, with stepped gables and courts.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.domains.village.house import rectangle_about
from scenewright.domains.village.learning.real_blocks import MATERIALS

Row = dict[str, Any]
LANES = (1.5, 3.0)
"""Least and greatest width of a lane in metres."""
PLACES = 10
WALL, YARD, GABLE = 0.35, 0.1, 0.4
"""Shares of neighbours with a common wall, of yards left free, of ends of rows whose door is in
the gable wall."""


class HuiKind(NamedTuple):
    """A kind of house: its share, least and greatest width, share of the depth of its row, the
    form of its footprint, and shares of the three materials."""

    share: float
    width: tuple[float, float]
    depth: tuple[float, float]
    form: str
    materials: tuple[float, float, float]


KINDS = (
    HuiKind(0.16, (10, 14), (0.95, 1.0), "box", (0.8, 0.05, 0.15)),
    HuiKind(0.14, (10, 14), (0.95, 1.0), "court", (0.8, 0.05, 0.15)),
    HuiKind(0.34, (6.5, 9), (0.75, 1.0), "box", (0.55, 0.2, 0.25)),
    HuiKind(0.14, (8, 11), (0.8, 1.0), "wing", (0.4, 0.2, 0.4)),
    HuiKind(0.22, (3.5, 6), (0.45, 0.7), "box", (0.25, 0.6, 0.15)),
)


def make_hui_blocks(count: int, seed: int) -> list[Row]:
    """So many blocks of :data:`PLACES` villages; the same seed gives the same.

    >>> rows = make_hui_blocks(2, 0)
    >>> rows == make_hui_blocks(2, 0), rows[0]["houses"][0]["material"] in MATERIALS
    (True, True)
    """
    turns = np.random.default_rng([seed, 0]).uniform(0, np.pi, PLACES)
    return [
        make_hui_block(np.random.default_rng([seed, 1, k]), f"hui-{k}", k % PLACES, turns)
        for k in range(count)
    ]


def make_hui_block(rng: np.random.Generator, name: str, place: int, turns: np.ndarray) -> Row:
    """One block: two to four rows of houses, turned as its village is."""
    wide, rows = rng.uniform(38, 75), int(rng.integers(2, 5))
    turn = turns[place] + rng.normal(0, 0.05)
    spin = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    at, houses = rng.uniform(0.8, 2.0), list[Row]()
    for number in range(rows):
        deep = rng.uniform(8.5, 13)
        outward = -1 if number == 0 else 1 if number == rows - 1 else 0
        houses += _row(rng, at, deep, wide, outward, spin)
        at += deep + rng.uniform(*LANES)
    corners = np.array([(0, 0), (wide, 0), (wide, at), (0, at)], float)
    away = np.sign(corners - corners.mean(0)) * rng.uniform(0, 1.5, (4, 2))
    return {
        "id": name,
        "place": f"village {place}",
        "place_kind": "village",
        "outline": ((corners + away) @ spin).round(3).tolist(),
        "outline_on_street": [True] * 4,
        "houses": houses,
    }


def _row(
    rng: np.random.Generator, low: float, deep: float, wide: float, outward: int, spin: np.ndarray
) -> list[Row]:
    """The houses of a row between y = ``low`` and ``low + deep``; ``outward``: 1 where its fronts
    look up to the edge of the block, -1 down to it, 0 to the lane below."""
    found, west = list[Row](), rng.uniform(0.8, 2.0)
    while True:
        west += rng.uniform(5, 9) * (rng.random() < YARD)
        kind = KINDS[int(rng.choice(len(KINDS), p=[one.share for one in KINDS]))]
        size = rng.uniform(*kind.width), deep * rng.uniform(*kind.depth)
        if west + size[0] > wide - 0.8:
            return found
        ring = _footprint(kind.form, size, rng.uniform(0.3, 0.4))
        front = rng.uniform(0.3, 0.7) * size[0]
        door = np.array([front, size[1] * 0.36 if kind.form == "court" else 0.0])
        if kind.form == "court":
            door[0] = size[0] / 2
        ends = not found or west + size[0] > wide - 12
        if ends and rng.random() < GABLE:
            door = np.array([0.0 if not found else size[0], size[1] * rng.uniform(0.6, 0.8)])
        ring, door = (_settle(part, size, low, deep, west, outward) for part in (ring, door))
        material = MATERIALS[int(rng.choice(3, p=kind.materials))]
        told = {"polygon": (ring @ spin).round(3).tolist(), "material": material}
        found.append({**told, "door": (door @ spin).round(3).tolist()})
        west += size[0] + (0 if rng.random() < WALL else rng.uniform(*LANES))


def _footprint(form: str, size: tuple[float, float], share: float) -> np.ndarray:
    """A footprint with its front on y = 0: a box, a U with its court there, an L."""
    x, y = size
    if form == "court":
        a, b = share * x, 0.36 * y
        ring = [(0, 0), (a, 0), (a, b), (x - a, b), (x - a, 0), (x, 0), (x, y), (0, y)]
    elif form == "wing":
        ring = [(0, 0), (x, 0), (x, y), (x - share * x, y), (x - share * x, 0.6 * y), (0, 0.6 * y)]
    else:
        ring = [(0, 0), (x, 0), (x, y), (0, y)]
    return np.array(ring, float)


def _settle(
    points: np.ndarray,
    size: tuple[float, float],
    low: float,
    deep: float,
    west: float,
    outward: int,
) -> np.ndarray:
    """Points (…, 2) of a footprint where it stands in its row, its front to the right side."""
    up = outward > 0
    y = low + deep - points[..., 1] if up else low + points[..., 1]
    x = west + (size[0] - points[..., 0] if up else points[..., 0])
    return np.stack([x, y], -1)


def brief_of_block(row: Row) -> Row:
    """A brief in which the houses of a block stand, each drawn in the Hui style."""
    fixed = []
    for number, told in enumerate(row["houses"]):
        ring = np.array(told["polygon"])
        angle, middle, (longer, shorter) = rectangle_about(ring)
        cos, sin = np.cos(angle), np.sin(angle)
        local = (ring - middle) @ np.array([[cos, -sin], [sin, cos]])
        tall = 7.5 if shapely.Polygon(ring).area > 50 else 4.0
        fixed.append(
            {
                "id": f"house-{number}",
                "at": middle.tolist(),
                "heading": float(angle + np.pi / 2),
                "size": [longer, shorter, tall],
                "footprint": local.round(4).tolist(),
            }
        )
    block = {"id": row["id"], "outline": row["outline"], "streets": [0, 1, 2, 3], "count": 0}
    return {"domain": "village", "style": "hui", "blocks": [{**block, "fixed": fixed}]}


def main(count: int, folder: Path) -> None:
    """Write so many blocks of seed 0, and the brief of the first."""
    rows = make_hui_blocks(count, 0)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "blocks.json").write_text(json.dumps(rows), encoding="utf-8")
    brief = json.dumps(brief_of_block(rows[0]))
    folder.with_suffix(".json").write_text(brief, encoding="utf-8")


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]))
