"""The storeys of a set of pages: which pages are plans, in which order they lie above each other,
and what the others are."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.drawn.paper import Paper
from scenewright.building.drawn.paper_plan import plan_page, written_scales
from scenewright.building.drawn.plan import STOREY
from scenewright.core.errors import InputError
from scenewright.ground.maps.levels import ATTIC, level_number
from scenewright.text import fold_letters

SHARE, ALIKE = 0.3, 0.005
"""The floor of a storey as a share of that of the largest, at least; how far the floors of two
pages of the same storey differ at most, as a share."""
TITLE = 0.5
"""Words of a title are as large as this share of the largest on the page."""
NO_PLAN = re.compile(
    r"\b(elevations?|sections?|details?|schedule|site plan|roof plan|facades?|"
    r"ansicht(?:en)?|schnitte?|lageplan|dachaufsicht|coupes?|alzados?|secciones|seccion|prospett[io]|"
    r"sezion[ei]|gevels?|doorsnede|fachadas?|cortes?)\b"
)
"""Words in titles of drawings that are no plans of storeys."""
HEIGHT = re.compile(r"^([+±-])\s?(\d{1,3}[.,]\d{2})(?:\s?m)?$")
"""The height of a storey's floor, such as +2.90."""
PLAN_WORDS = re.compile(r"\b(?:plan|grundri(?:ss|ß)|plattegrond)\b", re.IGNORECASE)
"""Words in titles of plans, besides the name of a level."""


class Storey(NamedTuple):
    """The plan of a page: its number, what :func:`plan_page` found, the name of its level, the
    level's number and the height of its floor as written (``None``: not)."""

    page: int
    found: dict[str, Any]
    name: str
    number: float | None
    height: float | None


def read_pages(count: int, read: Callable[[int], Paper], scale: float) -> dict[str, Any]:
    """The plan of a set as :func:`plan_page` gives it, each page that holds one a storey.

    Raises :class:`InputError` where no page does, as the first page is refused.
    """
    storeys: list[Storey] = []
    left: dict[int, str] = {}
    refusal: InputError | None = None
    for number in range(count):
        try:
            storey = _storey(number, read(number), scale, storeys)
        except InputError as error:
            refusal = refusal or error.located(place=f"page {number + 1}")
            left[number] = error.fault
            continue
        same = next((one.page for one in storeys if _are_same(one, storey)), None)
        if same is None:
            storeys.append(storey)
        else:
            left[number] = f"shows the storey of page {same + 1}"
    if not storeys:
        raise refusal or InputError("has no page", "give the plan of a storey")
    largest = max(one.found["read_floor"] for one in storeys)
    small = [one for one in storeys if one.found["read_floor"] < SHARE * largest]
    left |= {one.page: "its rooms are too few for a storey: another drawing" for one in small}
    return _join([one for one in storeys if one.page not in left], left)


def _storey(number: int, paper: Paper, scale: float, before: Sequence[Storey]) -> Storey:
    """The storey that a page shows, drawn to the scale of those before it.

    Raises :class:`InputError` where it shows none.
    """
    largest = max((word.size for word in paper.words), default=0.0)
    titles = [word.words for word in paper.words if word.size >= TITLE * largest]
    titles = [fold_letters(words) for words in titles]
    called = next((m for words in titles if (m := NO_PLAN.search(words))), None)
    if called is not None and not any(PLAN_WORDS.search(NO_PLAN.sub("", t)) for t in titles):
        raise InputError(f"is called {called[0]}: no plan of a storey", "give the plan of a storey")
    written = written_scales(paper)
    first = next((one.found["scale"] for one in before), None)
    if scale == 1.0 and first and written and first not in written:
        fault = f"is drawn at 1:{written[0]}, the plan before it at 1:{first}"
        raise InputError(fault, "give pages of one scale")
    found = plan_page(paper, scale)
    names = {room["name"] for room in found["rooms"]}
    name, level, height = _level_words([w.words for w in paper.words if w.words not in names])
    return Storey(
        number, found | {"scale": first or next(iter(written), None)}, name, level, height
    )


def _level_words(words: Sequence[str]) -> tuple[str, float | None, float | None]:
    """The name of a level, its number, and the height of its floor, as words of a page say.

    >>> _level_words(["Villa · Upper floor", "Upper floor · +2.90 · 70 m²"])
    ('Upper floor', 1.0, 2.9)
    >>> _level_words(["GRUNDRISS EG", "1:50"]), _level_words(["FIRST FLOOR PLAN"])
    (('EG', 0.0, None), ('FIRST FLOOR', 1.0, None))
    """
    parts = [part.strip() for text in words for part in re.split(r"[·|–,;:]| - ", text)]
    heights = [match for part in parts if (match := HEIGHT.match(part))]
    height = None
    if heights:
        sign, digits = heights[0].groups()
        height = float(digits.replace(",", ".")) * (-1.0 if sign == "-" else 1.0)
    for part in parts:
        name = " ".join(PLAN_WORDS.sub(" ", part).split())
        number = level_number(name) if sum(map(str.isalpha, name)) >= 2 else None
        if number is not None:
            return name[:40], number, height
    return "", None, height


def _are_same(one: Storey, other: Storey) -> bool:
    """Whether two pages show the same storey: levels of one name, or equal rooms without names."""
    if one.name or other.name:
        return one.name.casefold() == other.name.casefold()
    floors = [storey.found["read_floor"] for storey in (one, other)]
    as_many = len(one.found["rooms"]) == len(other.found["rooms"])
    return as_many and abs(floors[0] - floors[1]) <= ALIKE * max(floors)


def _join(storeys: list[Storey], left: dict[int, str]) -> dict[str, Any]:
    """One document of all storeys, from below upwards, and a row a page."""
    first = storeys[0].found
    fates = [list(row) for one in storeys for row in one.found["fates"]]
    fates += [[f"page {one.page + 1}", "page", "used", "", 1] for one in storeys]
    fates += [[f"page {k + 1}", "page", "left out", why[:200], 1] for k, why in left.items()]
    if len(storeys) == 1:
        return first | {"fates": fates}
    rooms: list[dict[str, Any]] = []
    levels: list[dict[str, Any]] = []
    for one, elevation in _stack(storeys):
        shift = _shift(first, one.found)
        own = one.found["levels"] or [{"id": "0", "elevation": 0.0}]
        ids = {row["id"]: str(len(levels) + k) for k, row in enumerate(own)}
        for row in own:
            name = {"name": one.name} if one.name and len(own) == 1 else {}
            levels.append({"id": ids[row["id"]], "elevation": elevation + row["elevation"]} | name)
        for room in one.found["rooms"]:
            level = {"level": ids[room.get("level", own[0]["id"])]}
            rooms.append(_moved(room, shift) | level | {"id": f"room-{len(rooms) + 1}"})
    floors = {k: sum(s.found[k] for s in storeys) for k in ("drawn_floor", "read_floor")}
    return first | {"rooms": rooms, "levels": levels, "fates": fates} | floors


def _stack(storeys: list[Storey]) -> Iterator[tuple[Storey, float]]:
    """Storeys from below upwards with the height of their floors: as written, else by the numbers
    of their levels, else in the order of the pages."""
    heights = [one.height for one in storeys]
    if None not in heights and len(set(heights)) == len(heights):
        yield from sorted(((one, float(one.height or 0.0)) for one in storeys), key=lambda r: r[1])
        return
    numbers = [one.number for one in storeys]
    named = None not in numbers and len(set(numbers)) == len(numbers)
    ranked = sorted(storeys, key=lambda one: one.number or 0.0) if named else storeys
    place = -1.0
    for one in ranked:
        listed = named and one.number is not None and one.number != ATTIC
        place = one.number or 0.0 if listed else place + 1.0
        yield one, round(STOREY * place, 3)


def _shift(first: dict[str, Any], found: dict[str, Any]) -> NDArray[np.float64]:
    """From the origin of a page's plan to that of the first: none where both are as large, else as
    the pages lie on each other, if the plans then do."""
    away = np.subtract(found["place"], first["place"])
    own, other = (
        np.ptp(np.vstack([room["outline"] for room in one["rooms"]]), axis=0)
        for one in (first, found)
    )
    alike = bool((np.abs(own - other) <= 0.02 * own).all())
    near = bool((np.abs(away) <= 0.5 * own).all())
    return away if near and not alike else np.zeros(2)


def _moved(room: dict[str, Any], shift: NDArray[np.float64]) -> dict[str, Any]:
    def move(points: Any) -> Any:
        return np.round(np.asarray(points) + shift, 4).tolist()

    openings = {
        kind: [one | {"at": move(one["at"])} for one in room[kind]] for kind in ("doors", "windows")
    }
    rings = {"outline": move(room["outline"]), "holes": [move(ring) for ring in room["holes"]]}
    return room | rings | openings
