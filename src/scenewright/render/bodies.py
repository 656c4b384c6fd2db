"""What of a thing stands still, and what moves by which joint: for files that keep bodies apart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from scenewright.core.catalog import Part
from scenewright.geometry.joints import Joint


class Body(NamedTuple):
    """The parts of a thing that move by one joint, in the frame of the thing."""

    joint: Joint
    parts: tuple[Part, ...]


def split_bodies(parts: Sequence[Part]) -> tuple[tuple[Part, ...], tuple[Body, ...]]:
    """The parts that stand still, and the bodies that move against them, by name.

    >>> split_bodies(())
    ((), ())
    """
    found: dict[Joint, list[Part]] = {}
    for part in parts:
        if part.joint is not None:
            found.setdefault(part.joint, []).append(part)
    still = tuple(part for part in parts if part.joint is None)
    ordered = sorted(found, key=lambda joint: joint.body)
    return still, tuple(Body(joint, tuple(found[joint])) for joint in ordered)
