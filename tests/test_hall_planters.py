"""Where planters stand in a zone that has no wall of its own free."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.accessories.planters import find_planter_spots
from scenewright.domains.hall.accessories.setting import Setting

PLANTER = Size(0.8, 0.3, 0.6)


def spots(pieces: tuple[Piece, ...], others: np.ndarray | None = None) -> np.ndarray:
    """Boxes of the spots for a planter among some pieces in a hall without walls."""
    others = np.zeros((0, 5)) if others is None else others
    return find_planter_spots(Setting((), np.zeros((0, 4)), pieces, others), PLANTER).boxes


def piece(category: str, width: float, depth: float) -> Piece:
    """A piece about (3, 2) that looks east."""
    pose, size = Pose(3.0, 2.0, 0.0, 0.0), Size(width, depth, 1.0)
    return Piece("one", category, "", "hall", pose, size)


def test_planters_stand_at_both_faces_of_a_partition_their_backs_at_it() -> None:
    found = spots((piece("partition", 4.0, 0.2),))
    ahead = found[:, 0] - 3.0
    assert set(np.sign(ahead)) == {1.0, -1.0}
    assert (np.abs(ahead) - 0.5 * (0.2 + PLANTER.depth) < 0.05).all()
    assert np.cos(found[:, 2]) == pytest.approx(np.sign(ahead))
    assert (np.abs(found[:, 1] - 2.0) < 2.0).all()


def test_planters_end_a_desk_and_a_row_of_gates() -> None:
    for category in ("info_desk", "ticket_gate"):
        shapes = corners(spots((piece(category, 2.0, 0.8),)))
        beside = np.abs(shapes[..., 1] - 2.0).min(1) - 1.0
        assert len(shapes) == 2
        assert ((beside > 0.0) & (beside < 0.3)).all()


def test_planters_go_on_in_a_row() -> None:
    found = spots((), np.array([[3.0, 2.0, 0.5 * np.pi, 0.8, 0.3]]))
    assert sorted(found[:, 0].round(2)) == [2.18, 3.82]
    assert found[:, 1] == pytest.approx([2.0, 2.0])
