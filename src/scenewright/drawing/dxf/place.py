"""Where marks on paper go in DXF: turned, scaled, y upwards."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.drawing.marks import PaperView


class Placing(NamedTuple):
    """``matrix`` (2, 2) and ``shift`` (2,) take paper points to units of the file; ``size`` is
    how many of these a millimetre of paper is, ``turn`` what is turned, degrees counter-clockwise.
    """

    matrix: NDArray[np.float64]
    shift: NDArray[np.float64]
    size: float
    turn: float = 0.0

    def points(self, points: ArrayLike) -> NDArray[np.float64]:
        """Paper points ``(..., 2)`` in the file.

        >>> true_size(PaperView(20.0, 10.0, 100.0), 1.0).points([30.0, 60.0]).tolist()
        [1.0, 2.0]
        """
        found: NDArray[np.float64] = np.asarray(points, dtype=float) @ self.matrix.T + self.shift
        return found


UPRIGHT = np.array([[1.0, 0.0], [0.0, -1.0]])


def true_size(view: PaperView, unit: float, east: float = 0.0) -> Placing:
    """The placing of a drawing in its plan's own coordinates, ``unit`` units a metre, moved
    ``east`` units."""
    size = unit / view.scale
    return Placing(size * UPRIGHT, np.array([east - view.x * size, view.y * size]), size)


def on_paper(height: float) -> Placing:
    """The placing of a sheet ``height`` millimetres high in its layout."""
    return Placing(UPRIGHT, np.array([0.0, height]), 1.0)


def local(size: float) -> Placing:
    """The placing of a symbol around its origin."""
    return Placing(size * UPRIGHT, np.zeros(2), size)


def local_of(at: tuple[float, float], turn: float, size: float) -> Placing:
    """The placing that takes marks drawn at a paper point, turned by degrees clockwise, back to
    the symbol around the origin that looks to the top."""
    angle = np.radians(turn)
    back = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    matrix = size * UPRIGHT @ back
    return Placing(matrix, -matrix @ np.array(at), size, turn)
