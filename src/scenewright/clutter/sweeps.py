"""The room that doors, drawers and flaps of a model take while they open."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part
from scenewright.core.scene import Piece
from scenewright.geometry.joints import Joint
from scenewright.render.bodies import split_bodies

Floats = NDArray[np.float64]
Box = tuple[Floats, Floats]
"""The least and the greatest corner."""

POSITIONS = 8
"""Positions of a body at which its box is taken."""
TURNING = "seat"
"""How bodies are called that turn in their own room."""


def sweeps_of(piece: Piece, parts: Sequence[Part]) -> tuple[Box, ...]:
    """Boxes about the bodies of a placed model at their positions from closed to open, in the
    frame of its level."""
    _, bodies = split_bodies(parts)
    c, s = cos(piece.pose.heading), sin(piece.pose.heading)
    turn, shift = np.array([[s, c, 0.0], [-c, s, 0.0], [0.0, 0.0, 1.0]]), np.array(piece.pose[:3])
    moving = (body for body in bodies if not body.joint.body.startswith(TURNING))
    return tuple(
        (points.min(0), points.max(0))
        for body in moving
        for moved in _moved(body.joint, np.concatenate([part.vertices for part in body.parts]))
        for points in [moved @ turn.T + shift]
    )


def _moved(joint: Joint, points: Floats) -> Iterator[Floats]:
    pivot, axis = np.array(joint.pivot), np.array(joint.axis)
    for amount in np.linspace(0, joint.upper - joint.at, POSITIONS + 1)[1:]:
        if joint.kind == "slide":
            yield points + amount * axis
        else:
            x, y, z = axis
            across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
            turn = np.eye(3) + sin(amount) * across + (1 - cos(amount)) * across @ across
            yield (points - pivot) @ turn.T + pivot
