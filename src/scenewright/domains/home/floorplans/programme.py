"""Which rooms a home of a size has: a table of what each is for, and the list for a storey."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class RoomRow(NamedTuple):
    """What a kind of room asks for: ``functions`` of the brief; ``share`` of a home's floor that it
    usually takes and ``most`` square metres; ``least`` clear width in metres and ``slender``, the
    most its length is to its width; ``light``, metres of outer wall it needs for a window (0:
    none); ``door`` its width in metres; ``joins`` the kinds of rooms its door may lead to, the
    first choice first.

    Shares are medians of the flats of Raster-to-Vector (Liu, Wu, Kohli, Furukawa 2017); widths are
    those the furniture of the room and the way along it need."""

    name: str
    functions: tuple[str, ...]
    share: float
    most: float
    least: float
    slender: float
    light: float
    door: float
    joins: tuple[str, ...] = ("hall", "living")


ROWS = {
    "living": RoomRow("Living and dining", ("living", "dining"), 0.27, 45.0, 3.2, 2.0, 2.2, 0.9),
    "studio": RoomRow(
        "Studio", ("living", "kitchen", "dining", "double_bedroom"), 0.75, 60.0, 3.4, 2.2, 2.2, 0.9
    ),
    "open": RoomRow(
        "Living, dining, kitchen", ("living", "dining", "kitchen"), 0.37, 60.0, 3.6, 2.2, 2.2, 0.9
    ),
    "kitchen": RoomRow(
        "Kitchen", ("kitchen",), 0.10, 14.0, 1.9, 2.2, 1.0, 0.85, ("living", "hall")
    ),
    "double": RoomRow("Bedroom", ("double_bedroom",), 0.15, 20.0, 2.8, 1.8, 1.6, 0.85),
    "child": RoomRow("Child's room", ("child_bedroom",), 0.12, 18.0, 2.4, 1.9, 1.6, 0.85),
    "single": RoomRow("Small bedroom", ("single_bedroom",), 0.10, 16.0, 2.3, 1.9, 1.5, 0.85),
    "study": RoomRow("Study", ("study",), 0.09, 14.0, 2.2, 1.9, 1.4, 0.85),
    "bath": RoomRow("Bathroom", ("bathroom",), 0.07, 9.0, 1.75, 2.0, 0.0, 0.75),
    "toilet": RoomRow("Toilet", ("toilet",), 0.022, 2.4, 1.0, 2.2, 0.0, 0.7),
    "storage": RoomRow("Storage", ("storage",), 0.03, 5.0, 1.0, 2.6, 0.0, 0.75),
    "hall": RoomRow("Hall", ("hall",), 0.09, 14.0, 1.25, 6.0, 0.0, 0.95, ()),
}
"""Kinds of rooms by id; all but the hall are entered from one of those they join."""
BEDROOMS = ("double", "child", "single")


def list_rooms(rooms: int, area: float, rng: np.random.Generator) -> list[str]:
    """The kinds of rooms of a home of ``rooms`` habitable ones (living room, bedrooms, study) on
    ``area`` square metres: a kitchen of its own or open to the living room, one bathroom to three
    bedrooms and two above, a toilet and a store where there is floor for them.

    >>> list_rooms(1, 30.0, np.random.default_rng(0))
    ['studio', 'bath', 'hall']
    """
    if rooms == 1:
        return ["studio", "bath", "hall"]
    is_open = rng.random() < (0.5 if area / rooms < 20 else 0.3)
    bedrooms = rooms - 1
    study = bedrooms >= 3 and rng.random() < 0.5
    sleeping = ["double", *rng.choice(["child", "single"], bedrooms - 1 - study, p=[0.7, 0.3])]
    wet = ["bath"] * (1 + (bedrooms > 3 and area > 120))
    wet += ["toilet"] * bool(rooms >= 3 and area > 65 and rng.random() < 0.7)
    stores = ["storage"] * bool(area > 55 and rng.random() < 0.6)
    common = ["open"] if is_open else ["living", "kitchen"]
    return [*common, *map(str, sleeping), *["study"] * study, *wet, *stores, "hall"]


def wanted_areas(kinds: list[str], area: float) -> NDArray[np.float64]:
    """Square metres (n,) that rooms of these kinds take of ``area``: by their shares, none below
    a quarter above the square of its least width or above its most, as far as ``area`` allows.

    >>> wanted_areas(["studio", "bath", "hall"], 40.0).round(1)
    array([31.8,  4.4,  3.8])
    """
    rows = [ROWS[kind] for kind in kinds]
    least = np.array([1.25 * (row.least + 0.12) ** 2 for row in rows])
    most = np.array([row.most for row in rows])
    wanted = np.array([row.share for row in rows])
    wanted *= area / wanted.sum()
    for _ in kinds:
        wanted = np.clip(wanted, least, most)
        wanted *= area / wanted.sum()
    return wanted
