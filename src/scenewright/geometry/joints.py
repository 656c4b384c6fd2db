"""How the bodies of a model move: a door about its hinges, a drawer along its runners."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

Vector = tuple[float, float, float]
JointKind = Literal["hinge", "slide"]


class Joint(NamedTuple):
    """How one body moves against the rest of its model, in the frame of that model, in metres.

    ``body`` is its name, unique in the model. A hinge turns it about the line through ``pivot``
    along the unit vector ``axis``, counter-clockwise seen against the axis, in radians; a slide
    moves it along the axis, in metres. It moves from ``lower`` to ``upper``, 0 is closed, and it is
    drawn where it stands ``at``.
    """

    body: str
    kind: JointKind
    pivot: Vector
    axis: Vector
    lower: float
    upper: float
    at: float = 0.0


def transform_joint(joint: Joint, matrix: ArrayLike, shift: ArrayLike = 0.0) -> Joint:
    """The joint of a model whose points p become ``matrix`` (3, 3) p + ``shift`` (3,).

    A reflection turns the sense of a hinge round; a slide is as much longer as its axis is.

    >>> door = Joint("door", "hinge", (-0.3, 0.2, 0.4), (0.0, 0.0, 1.0), 0.0, 1.5)
    >>> transform_joint(door, np.diag([-1.0, 1.0, 1.0])).axis
    (0.0, 0.0, -1.0)
    """
    turn = np.asarray(matrix, np.float64)
    pivot = turn @ np.array(joint.pivot) + np.asarray(shift, np.float64)
    along = turn @ np.array(joint.axis)
    length = float(np.linalg.norm(along))
    hinge = joint.kind == "hinge"
    along *= (np.sign(np.linalg.det(turn)) if hinge else 1.0) / length
    scale = 1.0 if hinge else length
    limits = (value * scale for value in joint[4:])
    return Joint(joint.body, joint.kind, _vector(pivot), _vector(along), *limits)


def _vector(values: np.typing.NDArray[np.float64]) -> Vector:
    x, y, z = (np.round(values, 12) + 0.0).tolist()  # no -0.0
    return x, y, z
