"""What piece of furniture a model is: its kind, its front and its scale, and how sure that is.

The name says most (:mod:`.words`), in the room its catalogue lists it under; the size tells
kinds of one name apart (a *sofa* is a loveseat below 1.75 m) and takes back what cannot be: a
*chair* 4 cm high is no chair. What is not understood is ``other`` and used only where named.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations
from math import inf
from pathlib import PurePath
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds import KINDS, SIZES
from scenewright.catalog.kinds.other_words import GENERIC
from scenewright.catalog.models.front import Front, front
from scenewright.catalog.models.likeness import TURNS, UPS, turn_matrix
from scenewright.catalog.models.model import Model
from scenewright.catalog.models.orientation import (
    VOTERS,
    energies_of,
    own_up,
    shared_turn,
    turn_model,
    turn_number,
)
from scenewright.catalog.models.words import match, tokens_of
from scenewright.core.scene import Size

Floats = NDArray[np.float64]

OTHER = "other"
LIKELY = 1.45
"""How many times longer or shorter than the table of sizes a side may be."""
TABLES, UPRIGHT = ("dining_table", "round_table"), 1.15
"""What one sits at, and the same for its height."""
UNITS = (1.0, 0.001, 0.01, 0.1, 0.0254, 0.3048, 10.0, 100.0, 1000.0)
"""Metres a unit: as it is, powers of ten, inch, foot."""
OFF = 2.5
"""By what factor a size must be off before another unit is tried."""
RAISED = 0.3
"""Above this elevation, in metres, a thing hangs."""
OVERHEAD = 1.2
"""Above this a lamp hangs from the ceiling."""

OUTDOORS = frozenset(("exterior", "outdoor", "garden", "outside", "nature"))
ROOMS = {
    "kitchen": "kitchen",
    "bathroom": "bathroom",
    "bath": "bathroom",
    "office": "office",
    **dict.fromkeys(OUTDOORS, "exterior"),
}
NOT_FURNITURE = frozenset(("vehicles", "characters", "people", "animals", "doors", "weapons"))

REFINED: dict[tuple[str, str], tuple[str, ...]] = {
    (room, name): meant
    for name, rows in (
        *((name, kind.in_rooms) for name, kind in KINDS.items()),
        *((name, generic.in_rooms) for name, generic in GENERIC.items()),
    )
    for room, meant in rows
}
"""What a word means in a room."""


class Understood(NamedTuple):
    """What a model is: its category (a kind, or ``other``), how sure from 0 to 1, why in a few
    words, the quarter turns counter-clockwise that bring its front to +y, the factor that
    brings it to metres, and which of its sides as read is ``up`` (turned before its front is)."""

    category: str
    sure: float
    why: str
    turn: int = 0
    scale: float = 1.0
    up: str = UPS[0]


class _Standing(NamedTuple):
    """A model set upright by ``matrix``, as it suits one of its kinds: which, by what factor its
    worst side is off, and metres a unit."""

    model: Model
    matrix: Floats
    kind: str
    misfit: float
    scale: float

    @property
    def size(self) -> Size:
        return _scaled(self.model.size, self.scale)


def understood(model: Model, unit: float = 1.0, shared: int = 0) -> Understood:
    """What a model is, with lengths of ``unit`` metres, of a library whose models all need the
    ``shared`` turn (:func:`.upright.shared_turn`).

    >>> chair = Model("chair", "Chair", (), Size(45, 50, 90), "", "", "chair.obj")
    >>> found = understood(chair)
    >>> found.category, found.scale
    ('dining_chair', 0.01)
    """
    up, turn = divmod(shared, 4)
    kinds, why, sure = said(model)
    if not kinds:
        return Understood(OTHER, sure, why, turn, unit, UPS[up])
    hung = tuple(kind for kind in kinds if _hangs_right(kind, model))
    if not hung:
        why = f"{why}, but {model.elevation:.1f} m above the floor"
        return Understood(OTHER, 0.3, why, turn, 1.0, UPS[up])
    stood = _stand(model, hung, unit, shared)
    tall = misfits(stood.kind, stood.size)[2]
    if stood.misfit > LIKELY or (stood.kind in TABLES and tall > UPRIGHT):
        shown = " x ".join(f"{side:.2f}" for side in _scaled(model.size, stood.scale))
        return Understood(OTHER, 0.3, f"{why}, but of {shown} m", turn, unit, UPS[up])
    quarters = _face(stood)
    up, turn = divmod(turn_number(turn_matrix(0, quarters) @ stood.matrix), 4)
    if stood.scale != unit:
        why += f", taken {stood.scale / unit:g} times as large"
    if up:
        why += f", lay with its {UPS[up]} up"
    elif turn:
        why += ", turned by its shape"
    sure = round(sure * (1.0 if stood.misfit <= 1.0 else 0.85), 2)
    return Understood(stood.kind, sure, why, turn, stood.scale, UPS[up])


def library_turn(models: Sequence[Model], unit: float) -> int:
    """The turn that the models of a library need together, by what their names say they are."""
    if len(models) < VOTERS:
        return 0
    return shared_turn([energies_of(model, said(model)[0], unit) for model in models])


def _stand(model: Model, kinds: tuple[str, ...], unit: float, shared: int) -> _Standing:
    """The model with the side up that makes it most like its kinds."""
    read = turn_model(model, TURNS[shared]) if shared else model
    scale = _scale(read.size, kinds, unit)
    ups = [turn_matrix(up, 0) for up in range(len(UPS))]
    sides = np.array(_scaled(read.size, scale))
    suited = [_nearest_turned(kinds, Size(*(np.abs(own) @ sides)), model.sized) for own in ups]
    up = own_up(energies_of(read, kinds, scale), [misfit <= LIKELY for _, misfit in suited])
    stood = turn_model(read, ups[up]) if up else read
    return _Standing(stood, ups[up] @ TURNS[shared], *suited[up], scale)


def _nearest_turned(kinds: tuple[str, ...], size: Size, sized: bool) -> tuple[str, float]:
    """As :func:`nearest`; where a size suits none, and the file does not tell it, of the model
    turned by a quarter."""
    found = nearest(kinds, size)
    return (
        found
        if found[1] <= LIKELY or sized
        else min(found, nearest(kinds, _across(size)), key=lambda one: one[1])
    )


def _face(stood: _Standing) -> int:
    """The quarter turns that bring the front to +y: by the shape, else by the size where only
    across it suits its kind."""
    facing = _front(stood.model, stood.kind).turn
    size = _across(stood.size) if facing % 2 else stood.size
    if stood.model.sized or max(misfits(stood.kind, size)) <= stood.misfit:
        return facing
    energies = energies_of(stood.model, (stood.kind,), stood.scale)
    return 1 if energies[1] <= energies[3] else 3


def said(model: Model) -> tuple[tuple[str, ...], str, float]:
    """The kinds a model's name, file or tags say it may be, by which words, and how surely."""
    room = _room(model)
    if model.opening or NOT_FURNITURE & set(tokens_of(model.category)):
        return (), f"listed under {model.category.lower()}", 1.0
    for name, sure in _names(model):
        found = match(name)
        if found is not None:
            text = f"'{' '.join(found.words)}'" + f" in the {room}" * bool(room)
            if not found.kinds:
                return (), text, sure
            sure = min(1.0, sure + 0.1 * (len(found.words) > 1) + 0.1 * found.whole)
            return _refine_kinds(found.kinds, room), text, round(sure, 2)
    return (), "its name says nothing", 0.0


def nearest(kinds: tuple[str, ...], size: Size) -> tuple[str, float]:
    """Of some kinds the one a size suits best, the footprint before the height, and by what
    factor its worst side is off."""
    off = {kind: misfits(kind, size) for kind in kinds}
    best = min(
        kinds, key=lambda kind: (max(*off[kind][:2], off[kind][2] ** (1 / 3)), max(off[kind]))
    )
    return best, max(off[best])


def misfits(kind: str, size: Size) -> tuple[float, ...]:
    """How many times too short or too long each side of a thing is for its kind.

    >>> misfits("sofa", Size(5.6, 0.9, 0.8))
    (2.0, 1.0, 1.0)
    """
    if kind not in SIZES:
        return (inf,) * 3
    low, _, high = SIZES[kind]
    return tuple(
        max(least / side, side / most, 1.0)
        for least, side, most in zip(low, size, high, strict=True)
    )


def unit_of(models: tuple[Model, ...]) -> float:
    """Metres a unit in a catalogue that tells no sizes: what most of its models agree on.

    1 unless the middle model is off by more than a quarter; then the nearest usual unit, or, if
    the models agree among themselves, just the factor they need (rounded to half a unit).
    """
    ratios = sorted(_ratio(model) for model in models if not model.sized and said(model)[0])
    if len(ratios) < 5:
        return 1.0
    middle = ratios[len(ratios) // 2]
    if 0.75 < middle < 1.34:
        return 1.0
    near = min(UNITS, key=lambda unit: abs(middle / unit - 1))
    if abs(middle / near - 1) < 0.3:
        return near
    agree = ratios[-len(ratios) // 5] / ratios[len(ratios) // 5] < 3
    return max(round(2 * middle) / 2, 0.5) if agree and middle < 20 else 1.0


def _ratio(model: Model) -> float:
    """How many times larger the usual thing of this kind is, by the middle one of its sides."""
    kind, _ = nearest_shape(said(model)[0], model.size)
    return float(np.median(np.sort(SIZES[kind][1]) / np.sort(model.size)))


def nearest_shape(kinds: tuple[str, ...], size: Size) -> tuple[str, float]:
    """As :func:`nearest`, whatever the unit and whichever side is up."""

    def off(kind: str) -> float:
        ratios = np.sort(SIZES[kind][1]) / np.sort(size)
        return float(ratios.max() / ratios.min())

    return min(((kind, off(kind)) for kind in kinds if kind in SIZES), key=lambda one: one[1])


def _names(model: Model) -> Iterator[tuple[str, float]]:
    """What may name a model, and how surely."""
    yield model.name, 0.8
    yield PurePath(model.id).name, 0.7
    yield from ((tag, 0.5) for tag in model.tags)


def _room(model: Model) -> str:
    """The room a catalogue lists a model under, or that its name begins with."""
    words = (*tokens_of(model.category), *tokens_of(PurePath(model.id).name)[:1])
    return next((ROOMS[word] for word in words if word in ROOMS), "")


def meanings(word: str) -> tuple[str, ...]:
    """The kinds a word of the table may mean: those of a generic one, else itself.

    >>> meanings("lamp")[:2], meanings("sofa")
    (('table_lamp', 'floor_lamp'), ('sofa',))
    """
    return GENERIC[word].kinds if word in GENERIC else (word,)


def _refine_kinds(kinds: tuple[str, ...], room: str) -> tuple[str, ...]:
    """The kinds a word may mean in a room."""
    found = [REFINED.get((room, kind)) or meanings(kind) for kind in kinds]
    return tuple(dict.fromkeys(kind for own in found for kind in own))


def _hangs_right(kind: str, model: Model) -> bool:
    """Whether a kind may be as high above the floor as the catalogue says."""
    support = KINDS[kind].support if kind in KINDS else "floor"
    if support in ("floor", "top"):
        return model.elevation <= RAISED
    return support == "wall" or not model.sized or model.elevation > OVERHEAD


def _scaled(size: Size, scale: float) -> Size:
    return Size(*(side * scale for side in size))


def _across(size: Size) -> Size:
    return Size(size.depth, size.width, size.height)


def _scale(size: Size, kinds: tuple[str, ...], unit: float) -> float:
    """The unit in which a size suits one of the kinds, whichever side is up; as it is if that is
    not far off."""
    sides = [Size(*own) for own in permutations(size)]

    def off(scale: float) -> float:
        return min(nearest(kinds, _scaled(own, scale))[1] for own in sides)

    if off(unit) <= OFF:
        return unit
    best = min((unit * other for other in UNITS), key=off)
    return best if off(best) <= LIKELY else unit


def _front(model: Model, kind: str) -> Front:
    """The front by shape, where the catalogue does not tell it."""
    if model.sized or not model.parts:
        return Front(0, 0.0)
    found = front(model.parts, model.size, kind)
    return found if KINDS[kind].back == "flat" or found.sure > 0.6 else Front(0, 0.0)
