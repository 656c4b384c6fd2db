"""The loop of Zhu, Jiang and Li (2022): another? which? where? which way? fetch it, repeat."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.domains.village.learning.paper.nets import CLASSES
from scenewright.domains.village.learning.paper.retrieval import RetrievedHouse, retrieve
from scenewright.domains.village.learning.paper.samples import class_planes, count_vector
from scenewright.domains.village.learning.paper.views import (
    SHAPES,
    PaperHouses,
    ViewFrame,
    base_and_door,
    centre_view,
    door_points,
    frame_of,
    paint,
)
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.standing import Floats

MOST, TRIES, SEEN = 150, 12, 160
"""Houses of a block at most, places tried for one, candidates looked at."""


def candidates_of(blocks: Sequence[RealBlock], told: Sequence[PaperHouses]) -> list[RetrievedHouse]:
    """Every house of some blocks as a candidate."""
    found = []
    for block, houses in zip(blocks, told, strict=True):
        doors = door_points(list(block.houses), block.streets)
        for k, ring in enumerate(block.houses):
            material, shape, area = (int(v[k]) for v in houses[3:])
            found.append(RetrievedHouse(ring, doors[k], (material, shape, area)))
    return found


def fill_block(
    nets: dict[str, Any],
    block: RealBlock,
    candidates: Sequence[RetrievedHouse],
    pixels: int,
    hidden: int,
    rng: np.random.Generator,
) -> list[Floats]:
    """The rings of the houses put on the ground of a block until *continue* says stop."""
    import torch

    frame, floor = frame_of(block.floor, pixels), block.floor
    rings: list[Floats] = []
    houses = _none()
    while len(rings) < MOST:
        view = paint(frame, floor, houses)
        with torch.no_grad():
            odds = torch.sigmoid(nets["continue"](torch.from_numpy(view[None])))[0, 0].item()
            if odds < 0.5:
                break
            placed = _place(torch, nets, frame, block, houses, view, candidates, hidden, rng)
        if placed is None:
            break
        rings.append(placed[0])
        houses = _with(houses, *placed)
    return rings


def _place(
    torch: Any,
    nets: dict[str, Any],
    frame: ViewFrame,
    block: RealBlock,
    houses: PaperHouses,
    view: np.ndarray,
    candidates: Sequence[RetrievedHouse],
    hidden: int,
    rng: np.random.Generator,
) -> tuple[Floats, Floats, tuple[int, int, int]] | None:
    """Ring, door and classes of the next house; None if no place is found."""
    seen = torch.from_numpy(view[None])
    counts = torch.from_numpy(count_vector(houses)[None].astype(np.float32))
    drawn = [_draw(torch, nets[name](seen, counts)[0], rng) for name in CLASSES]
    classes = (drawn[0], drawn[1], drawn[2])
    planes = np.concatenate([view, class_planes(classes, frame.size)])[None]
    where = nets["location"](torch.from_numpy(planes))[0].flatten()
    where = where.masked_fill(seen[0, 0].flatten() < 0.5, -1e9)
    shape = torch.eye(SHAPES)[classes[1]][None]
    progress = min(len(houses.footprints) / 20.0, 1.0)
    for _ in range(TRIES):
        pixel = _draw(torch, where, rng)
        at = np.array([[pixel % frame.size, pixel // frame.size]]) + rng.random((1, 2))
        base = frame.metres(at)[0]
        near = torch.from_numpy(paint(centre_view(frame, base), block.floor, houses)[None])
        inner = torch.from_numpy(rng.normal(size=(1, hidden)).astype(np.float32))
        cosine = nets["orientation"].draw(near, shape, inner)[0].item()
        some = rng.choice(len(candidates), min(SEEN, len(candidates)), replace=False)
        angle = float(np.arccos(np.clip(cosine, -1, 1)))
        chosen = [candidates[k] for k in some.tolist()]
        standing = houses.footprints
        found = retrieve(chosen, classes, base, angle, block.floor, standing, progress)
        if found is not None:
            return found.ring, found.door, chosen[found.number].classes
    return None


def _draw(torch: Any, odds: Any, rng: np.random.Generator) -> int:
    shares = torch.softmax(odds.double(), 0).numpy()
    return int(rng.choice(len(shares), p=shares / shares.sum()))


def _none() -> PaperHouses:
    none = np.zeros(0, np.int64)
    return PaperHouses(np.zeros(0, object), np.zeros((0, 2)), np.zeros(0), none, none, none)


def _with(
    houses: PaperHouses, ring: Floats, door: Floats, classes: tuple[int, int, int]
) -> PaperHouses:
    base, angle = base_and_door(ring, door)
    shapes = np.empty(len(houses.footprints) + 1, object)
    shapes[:-1], shapes[-1] = houses.footprints, shapely.Polygon(ring)
    material, shape, area = (
        np.append(old, new) for old, new in zip(houses[3:], classes, strict=True)
    )
    bases = np.concatenate([houses.bases, base[None]])
    return PaperHouses(shapes, bases, np.append(houses.doors, angle), material, shape, area)
