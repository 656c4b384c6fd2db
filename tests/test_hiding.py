"""Tall pieces that hide others, drawn as if of glass, against the plain loop."""

import numpy as np
import pytest
import shapely

from deadline import HANGS, within
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.render.hiding import FLOOR, SHARE, TALL, WALL, WIDE, find_hiding


def _hides(high: Piece, low: Piece, lean: np.ndarray) -> bool:
    rise = high.pose.z + high.size.height - low.pose.z - low.size.height / 2
    one, two = polygons_of((high, low))
    if rise <= 0 or low.category in (WALL, high.category) or two.area < FLOOR:
        return False
    points = shapely.get_coordinates(one)
    shadow = shapely.MultiPoint(np.vstack([points, points + rise * lean])).convex_hull
    return bool(shadow.intersection(two).area >= SHARE * two.area)


def _find_slowly(pieces: list[Piece], towards: tuple[float, float, float]) -> frozenset[str]:
    lean = np.array(towards[:2]) / -towards[2]
    tall = [p for p in pieces if p.pose.z + p.size.height >= TALL and p.size.width >= WIDE]
    return frozenset(p.id for p in tall if any(_hides(p, q, lean) for q in pieces if q is not p))


def _scatter(count: int, seed: int) -> list[Piece]:
    rng = np.random.default_rng(seed)
    pieces = []
    for k in range(count):
        w, d, h = rng.uniform(0.15, 2.2, 3)
        corner = (
            (-w / 2, -d / 2),
            (w / 2, -d / 2),
            (w / 2, 0),
            (0, 0),
            (0, d / 2),
            (-w / 2, d / 2),
        )
        pose = Pose(*rng.uniform(0, 2 * count**0.5 + 1, 2), 0.0, rng.uniform(0, 6))
        category = ("partition", "wardrobe", "bed")[k % 3]
        footprint = corner if k % 5 == 0 else ()
        pieces.append(Piece(f"p{k}", category, "", "r", pose, Size(w, d, h), footprint=footprint))
    return pieces


@pytest.mark.parametrize("count", [0, 1, 2, 12, 60])
@pytest.mark.parametrize("seed", range(4))
def test_what_hides_others_is_what_the_plain_loop_finds(count: int, seed: int) -> None:
    pieces = _scatter(count, seed)
    x, y = np.random.default_rng(seed + 100).uniform(-1, 1, 2)
    assert find_hiding(pieces, (x, y, -0.6)) == _find_slowly(pieces, (x, y, -0.6))


def test_what_thousands_of_pieces_hide_is_found_in_bounded_time() -> None:
    with within(HANGS):
        assert find_hiding(_scatter(3000, 1), (0.5, 0.5, -0.7))


def test_a_partition_with_pictures_towards_the_eye_is_solid() -> None:
    def make(name: str, kind: str, y: float, size: Size, heading: float = 0.0) -> Piece:
        return Piece(name, kind, "", "a", Pose(0.0, y, 0.0, heading), size)

    wall = make("wall", WALL, 0.0, Size(4.0, 0.1, 2.4), np.pi / 2)
    stand = make("stand", "showcase", 0.7, Size(1.2, 1.0, 1.0))
    towards = (0.0, 0.7, -0.7)
    assert find_hiding([wall, stand], towards) == {"wall"}
    front, back = (
        make("art", "wall_exhibit", side * 0.25, Size(1.2, 0.4, 2.2), side * np.pi / 2)
        for side in (-1.0, 1.0)
    )
    assert "wall" not in find_hiding([wall, stand, front], towards)
    assert "wall" in find_hiding([wall, stand, back], towards)
