"""Ten briefs of sites that no part of the solver was made for: grounds, streets, squares, parts.

Numbers are drawn once by a seed, so that nobody chose them: a ground of three to six corners, one
to three streets through or beside it, a mix of shipped dwellings and public buildings, and by turns
a square, a landmark, parking, a court that closes.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from scenewright.core.brief import Brief

COUNT, SEED = 10, 4711
DWELLINGS = (
    ("row_houses", None),
    ("villa", None),
    ("classical_residence", (24, 12, 13)),
    ("modern_residential", (36, 14, 24)),
    ("point_tower", (20, 20, 40)),
)
DENSITY = 0.2
"""Share of the ground that is asked to be built on."""
SIZES = {"row_houses": 36 * 10, "villa": 14 * 12}


def new_briefs() -> list[tuple[str, Brief]]:
    """The briefs with what each is called."""
    rng = np.random.default_rng(SEED)
    return [(f"new site {k + 1}", _brief(k, rng)) for k in range(COUNT)]


def _brief(k: int, rng: np.random.Generator) -> Brief:
    half = rng.uniform(70.0, 150.0, 2)
    outline = _outline(rng, half)
    site: dict[str, Any] = {
        "id": "site",
        "outline": outline,
        "roads": _roads(rng, half, 1 + k % 3),
        "buildings": _buildings(rng, 4.0 * float(half.prod()) * 0.8),
    }
    if k % 2 == 0:
        at = _on_street(site["roads"][0])
        site["squares"] = [{"name": "Square", "area": int(rng.integers(500, 1200)), "at": at}]
    if k % 3 == 0:
        x, y = (0.4 * half).round(1).tolist()
        site["landmarks"] = [{"id": "church", "model": "pavilion", "at": [-x, y]}]
    if k % 4 == 1:
        site["parking"] = {"per_building": 1.0}
    if k % 5 == 4:
        site |= {"form": "peripheral", "court_gap": 14}
    return Brief.model_validate({"domain": "site", "name": f"New site {k + 1}", "sites": [site]})


def _outline(rng: np.random.Generator, half: np.ndarray) -> list[list[float]]:
    corners = half * [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    corners = corners + rng.uniform(-0.15, 0.15, (4, 2)) * half
    return corners.round(1).tolist()


def _roads(rng: np.random.Generator, half: np.ndarray, count: int) -> list[dict[str, Any]]:
    rows = []
    for number in range(count):
        turn = math.pi / 2 * number + rng.uniform(-0.25, 0.25)
        along = np.array([math.cos(turn), math.sin(turn)])
        off = rng.uniform(-0.3, 0.3) * half * [along[1], -along[0]]
        ends = np.stack([off - 2.5 * half.max() * along, off + 2.5 * half.max() * along])
        rows.append({"line": ends.round(1).tolist(), "width": int(rng.integers(6, 12))})
    return rows


def _on_street(road: dict[str, Any]) -> list[float]:
    middle: list[float] = np.mean(road["line"], axis=0).round(1).tolist()
    return middle


def _buildings(rng: np.random.Generator, ground: float) -> list[dict[str, Any]]:
    chosen = rng.permutation(len(DWELLINGS))[:3].tolist()
    rows: list[dict[str, Any]] = [{"model": "gallery", "size": [30, 18, 12]}]
    for number in chosen:
        model, size = DWELLINGS[number]
        area = size[0] * size[1] if size else SIZES[model]
        count = max(round(DENSITY * ground / len(chosen) / area), 2)
        rows.append({"model": model, "count": count} | ({"size": size} if size else {}))
    return rows
