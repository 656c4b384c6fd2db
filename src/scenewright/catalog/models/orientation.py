"""Which side of a model is its top: of a whole library, and of one model.

Files come with z or y up, and single pieces lie on their backs. How a model is set down is told by
its likeness to our own drawings of what its name says it is (:mod:`.likeness`): models of one
library mostly share their axes, so their energies are summed; one model is turned only where that
makes it clearly more like its kind, and by less where the kinds of fault are usual ones (up and
depth exchanged).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds import KINDS
from scenewright.catalog.models.likeness import TURNS, UPS, describe_shape, turn_energies
from scenewright.catalog.models.model import Model
from scenewright.core.catalog import Part
from scenewright.core.scene import Size

Floats = NDArray[np.float64]

MARGINS = {"top": 0.0, "front": 0.08, "back": 0.08, "right": 0.12, "left": 0.12, "bottom": 0.2}
"""By how much lower an energy must be for a side other than the top to be up."""
MISFIT = 0.3
"""What share of a margin is needed where the model as read does not suit its kind."""
LIKE = 0.65
"""Energy up to which a model is like its kind at all."""
VOTERS, SHARED = 5, 0.04
"""Models a library must hold to have axes of its own, and the mean margin for these."""


def stands(kind: str) -> bool:
    """Whether things of a kind stand on a floor, so that their shape tells their top."""
    return kind in KINDS and KINDS[kind].support == "floor" and not KINDS[kind].flat


def energies_of(model: Model, kinds: Sequence[str], unit: float) -> Floats:
    """The energy (24,) of each turn of a model under kinds that stand; infinite where it has no
    parts or the file tells its size (which then is that of the model as read)."""
    own = [kind for kind in kinds if stands(kind)]
    if model.sized or not model.parts or not own:
        return np.full(len(TURNS), np.inf)
    size = Size(*(side * unit for side in model.size))
    return turn_energies(describe_shape(model.parts), size, own)


def shared_turn(energies: Sequence[Floats]) -> int:
    """Which of the 24 turns suits the models of a library best together; 0 (as they are) unless
    another's mean energy is lower by :data:`SHARED`.

    >>> lying = np.where(np.arange(24) == 8, 0.3, 0.6)
    >>> shared_turn([lying] * 5), shared_turn([lying] * 4)
    (8, 0)
    """
    voters = [own for own in energies if np.isfinite(own).all() and own.min() < LIKE]
    if len(voters) < VOTERS:
        return 0
    means = np.mean(voters, axis=0)
    best = int(means.argmin())
    return best if means[0] - means[best] > SHARED else 0


def own_up(energies: Floats, fits: Sequence[bool]) -> int:
    """The number of the side in :data:`UPS` that is up; ``fits`` tells of each whether the model's
    size then suits its kind."""
    lowest = energies.reshape(len(UPS), 4).min(1)
    if not np.isfinite(lowest).all():
        return 0
    share = 1.0 if fits[0] else MISFIT
    worth = [lowest[k] + share * MARGINS[side] for k, side in enumerate(UPS)]
    usable = [k for k in range(1, len(UPS)) if fits[k] and lowest[k] < LIKE]
    return min((0, *usable), key=lambda k: worth[k])


def turn_number(matrix: Floats) -> int:
    """Which of :data:`.likeness.TURNS` a matrix is."""
    return int(np.abs(TURNS - matrix).sum((1, 2)).argmin())


def turn_model(model: Model, matrix: Floats) -> Model:
    """The model turned by a rotation of quarter turns; its underside is its lowest side again."""
    size = np.abs(matrix) @ np.array(model.size)
    shift = np.array([0.0, 0.0, size[2] / 2]) - matrix @ [0.0, 0.0, model.size.height / 2]
    parts = tuple(
        Part(part.material, part.vertices @ matrix.T + shift, part.faces) for part in model.parts
    )
    return model._replace(parts=parts, size=Size(*size.tolist()))
