"""What piece of furniture a model is: its kind, its front and its scale, and how sure that is.

The name says most (:mod:`.words`), in the room its catalogue lists it under; the size tells
kinds of one name apart (a *sofa* is a loveseat below 1.75 m) and takes back what cannot be: a
*chair* 4 cm high is no chair. What is not understood is ``other`` and used only where named.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import inf
from pathlib import PurePath
from typing import NamedTuple

from scenewright.catalog.kinds import KINDS, SIZES
from scenewright.catalog.kinds.other_words import GENERIC
from scenewright.catalog.models.front import Front, front
from scenewright.catalog.models.model import Model
from scenewright.catalog.models.words import match, tokens_of
from scenewright.core.scene import Size

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
    words, the quarter turns counter-clockwise that bring its front to +y, and the factor that
    brings it to metres."""

    category: str
    sure: float
    why: str
    turn: int = 0
    scale: float = 1.0


def understood(model: Model, unit: float = 1.0) -> Understood:
    """What a model is, with lengths of ``unit`` metres.

    >>> chair = Model("chair", "Chair", (), Size(45, 50, 90), "", "", "chair.obj")
    >>> found = understood(chair)
    >>> found.category, found.scale
    ('dining_chair', 0.01)
    """
    kinds, why, sure = said(model)
    if not kinds:
        return Understood(OTHER, sure, why, scale=unit)
    hung = tuple(kind for kind in kinds if _hangs_right(kind, model))
    if not hung:
        return Understood(OTHER, 0.3, f"{why}, but {model.elevation:.1f} m above the floor")
    scale = _scale(model.size, hung, unit)
    size = Size(*(side * scale for side in model.size))
    kind, misfit = nearest(hung, size)
    if misfit > LIKELY or (kind in TABLES and misfits(kind, size)[2] > UPRIGHT):
        shown = " x ".join(f"{side:.2f}" for side in size)
        return Understood(OTHER, 0.3, f"{why}, but of {shown} m", scale=unit)
    way = _front(model, kind)
    if scale != unit:
        why += f", taken {scale / unit:g} times as large"
    if way.turn:
        why += ", turned by its shape"
    sure = round(sure * (1.0 if misfit <= 1.0 else 0.85), 2)
    return Understood(kind, sure, why, way.turn, scale)


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
    ratios = sorted(a / b for a, b in zip(SIZES[kind][1], model.size, strict=True))
    return ratios[1]


def nearest_shape(kinds: tuple[str, ...], size: Size) -> tuple[str, float]:
    """As :func:`nearest`, whatever the unit."""

    def off(kind: str) -> float:
        ratios = [a / b for a, b in zip(SIZES[kind][1], size, strict=True)]
        return max(ratios) / min(ratios)

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


def _scale(size: Size, kinds: tuple[str, ...], unit: float) -> float:
    """The unit in which a size suits one of the kinds; as it is if that is not far off."""

    def off(scale: float) -> float:
        return nearest(kinds, Size(*(side * scale for side in size)))[1]

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
