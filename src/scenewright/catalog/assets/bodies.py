"""What of a model moves: how fronts open, and what is mounted on them.

A helper that draws a front (:mod:`scenewright.catalog.assets.joinery`) says once how it opens;
whatever a model draws on that front - a handle, a window, slats - goes with it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from math import pi
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from scenewright.geometry.joints import Joint
from scenewright.geometry.mesh import Floats, Mesh
from scenewright.geometry.solids import Interval

Opens = Literal["door", "drawer", "flap"]
"""A door turns about an upright edge, a flap about its lower one, a drawer slides out."""

LONGEST = 0.45
"""How far a drawer comes out at most, metres."""
DRAWN_OUT = 0.75
"""That of the depth of its case."""
LIFTED = 0.4
"""How far the lever of a tap is lifted, radians."""
SLACK = 0.01
"""How far what is mounted on a front may stand out beside it, metres."""
BEHIND = 0.004
"""How far it may begin behind its inner face."""
REACH = 0.12
"""How far it may stand out before it."""


def front_joint(opens: Opens, x: Interval, z: Interval, y: Interval, right: bool = False) -> Joint:
    """How a front opens that lies between two depths ``y`` and looks to +y; ``right``: a door
    whose hinges are at the end of its ``x``.

    The line of the hinges is an outer edge of the front: so it turns clear of its neighbours, and
    nothing of it gets behind it. A drawer comes out by three quarters of the depth of its case,
    which is drawn round the origin.

    >>> joint = front_joint("door", (0.0, 0.5), (0.0, 0.7), (0.2, 0.22))
    >>> joint.pivot, joint.axis
    ((0.0, 0.22, 0.35), (0.0, 0.0, 1.0))
    """
    middle, level = sum(x) / 2, sum(z) / 2
    if opens == "door":
        pivot = (x[1] if right else x[0], y[1], level)
        return Joint(opens, "hinge", pivot, (0.0, 0.0, -1.0 if right else 1.0), 0.0, pi / 2)
    if opens == "flap":
        return Joint(opens, "hinge", (middle, y[1], z[0]), (-1.0, 0.0, 0.0), 0.0, pi / 2)
    travel = min(LONGEST, DRAWN_OUT * 2 * abs(y[1]))
    return Joint(opens, "slide", (middle, y[1], level), (0.0, 1.0, 0.0), 0.0, travel)


def slide_joint(body: str, x: Interval, z: Interval, y: float, by: float) -> Joint:
    """How a panel runs along x by a distance, to -x where that is negative."""
    axis = (1.0 if by > 0 else -1.0, 0.0, 0.0)
    return Joint(body, "slide", (sum(x) / 2, y, sum(z) / 2), axis, 0.0, abs(by))


def lever_joint(pivot: ArrayLike, tip: ArrayLike) -> Joint:
    """How the lever of a tap is lifted about its foot, across the way it points."""
    x, y, z = (float(value) for value in np.asarray(pivot))
    along = np.asarray(tip, np.float64) - np.asarray(pivot)
    axis = (float(np.sign(along[1])), float(-np.sign(along[0])), 0.0)
    return Joint("lever", "hinge", (x, y, z), axis, 0.0, LIFTED)


def attach_joint(joint: Joint | None, meshes: Sequence[Mesh]) -> list[Mesh]:
    """The meshes as those of one body."""
    return [mesh._replace(joint=joint) for mesh in meshes]


def assign_bodies(meshes: Sequence[Mesh]) -> list[Joint | None]:
    """The joint each mesh of a model moves by, its body named by what it is and numbered; none for
    the rest, which does not move.

    >>> from scenewright.geometry.solids import block
    >>> x, y, z = (0.0, 0.5), (0.2, 0.22), (0.0, 0.7)
    >>> front = block(x, y, z)._replace(joint=front_joint("door", x, z, y))
    >>> case, knob = block(x, (-0.2, 0.2), z), block((0.4, 0.41), (0.22, 0.24), (0.3, 0.31))
    >>> [joint and joint.body for joint in assign_bodies([case, knob, front])]
    [None, 'door 1', 'door 1']
    """
    spaces: dict[Joint, list[Floats]] = {}
    for mesh in meshes:
        if mesh.joint is not None:
            spaces.setdefault(mesh.joint, []).append(_space_of(mesh.joint, mesh))
    names = _number_bodies([*spaces])
    found: list[Joint | None] = []
    for mesh in meshes:
        own = mesh.joint or _mounted_on(mesh, spaces)
        found.append(names[own] if own is not None else None)
    return found


def _number_bodies(joints: Sequence[Joint]) -> dict[Joint, Joint]:
    counts: Counter[str] = Counter()
    names: dict[Joint, Joint] = {}
    for joint in joints:
        word = joint.body.rstrip(" 0123456789")
        counts[word] += 1
        names[joint] = joint._replace(body=f"{word} {counts[word]}")
    return names


def _space_of(joint: Joint, mesh: Mesh) -> Floats:
    """The box (2, 3) before a front, in the direction it opens to, where what is mounted on it
    lies."""
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    opens = np.array(joint.axis)
    if joint.kind == "hinge":
        opens = np.cross(opens, (low + high) / 2 - joint.pivot)
    along = int(np.abs(opens).argmax())
    space = np.array([low - SLACK, high + SLACK])
    ahead = 1 if opens[along] > 0 else 0
    sign = 2 * ahead - 1
    space[ahead, along] += sign * REACH
    space[1 - ahead, along] += sign * (SLACK - BEHIND)
    return space


def _mounted_on(mesh: Mesh, spaces: dict[Joint, list[Floats]]) -> Joint | None:
    if not spaces:
        return None
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    for joint, own in spaces.items():
        if any(bool((low >= space[0]).all() and (high <= space[1]).all()) for space in own):
            return joint
    return None
