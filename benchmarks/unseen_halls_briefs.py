"""Briefs of halls nobody has looked at: themes by dice, outlines generated and of malls.

A theme is one row: the floor it usually has and what those who write briefs ask of it, numbers for
each 100 m². By the dice a number is stated, from sparse to plenty, or left open. The rows are the
judge's own; no table of the halls is asked.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from benchmarks.real_data import data_files
from scenewright.building import plan
from scenewright.core.brief import Brief
from scenewright.core.space import Opening, Space
from scenewright.domains.hall.generating import generate_hall

OPEN, REAL = 0.4, 0.5
"""Shares of the numbers that are left open, and of the shops that are those of a mall."""
MALL_SHOPS = (30.0, 1200.0)
"""Square metres of the shops of malls that are drawn."""


class ThemeRow(NamedTuple):
    """Square metres of floor, least and most; demands as ``"1-2 checkout; 4-9% gondola*"``: pieces
    for the hall, or (%) for each 100 m² of it; starred numbers may be left open."""

    floor: tuple[float, float]
    demands: str


THEMES: dict[str, ThemeRow] = {
    "clothes shop": ThemeRow(
        (70, 420),
        "1-2 checkout; 2-6% clothes_rail*; 1-3% round_rack*; 1-3% mannequin; 2-4 fitting_room;"
        " 2-6% wall_shelving*; 1-2% display_table",
    ),
    "bookshop": ThemeRow(
        (70, 400),
        "1-1 checkout; 4-9% bookcase*; 2-6% book_stack*; 1-2% display_table; 2-4 lounge_seat",
    ),
    "household shop": ThemeRow(
        (80, 600), "1-2 checkout; 3-8% gondola*; 3-7% wall_shelving*; 1-2% display_table"
    ),
    "jeweller": ThemeRow(
        (50, 160), "1-2 counter; 4-9% showcase*; 3-6% display_cabinet*; 2-3 lounge_seat"
    ),
    "supermarket": ThemeRow(
        (250, 950),
        "2-4 checkout; 4-9% gondola*; 1-3% fridge_shelf; 2-4% wall_shelving*; 1-2 basket_stack;"
        " 1-1 ticket_gate",
    ),
    "museum": ThemeRow(
        (120, 700),
        "1-1 info_desk; 2-5% showcase*; 2-5% wall_exhibit*; 1-1 exhibit_island; 1-2% plinth;"
        " 2-4 bench",
    ),
    "bank": ThemeRow(
        (90, 350),
        "2-4 counter; 2-3 cash_machine; 2-4 desk; 4-8 lounge_seat*; 1-1 info_desk;"
        " 2-4 rope_barrier",
    ),
    "library": ThemeRow(
        (150, 700),
        "1-1 info_desk; 3-8% book_stack*; 1-3% reading_table*; 2-5% bookcase*; 3-6 lounge_seat;"
        " 1-2 catalogue_terminal",
    ),
    "fair": ThemeRow(
        (250, 950), "1-1 info_desk; stands: 1-2% exhibit_island*; 1-2% round_table; 2-4 litter_bin"
    ),
    "boarding gate": ThemeRow(
        (150, 500),
        "1-2 counter; 2-3 ticket_gate; 10-25% auditorium_seat*; 1-2 vending_machine;"
        " 2-2 litter_bin",
    ),
    "restaurant": ThemeRow(
        (70, 350), "1-1 counter; 3-6% round_table*; 1-4% dining_table*; 1-2 coat_rack"
    ),
    "canteen": ThemeRow((150, 700), "2-3 counter; 5-9% dining_table*; 1-2 vending_machine"),
    "showroom": ThemeRow(
        (200, 800),
        "cars: 1-2% exhibit_island* sized 4.4x1.8x1.5; 2-3 desk; 1-1 info_desk; 1-2 sofa;"
        " 1-1 coffee_table",
    ),
    "church": ThemeRow((150, 600), "altar: 1-1 stage sized 4x2.5x0.4; 1-1 lectern; 5-9% pew*"),
    "office": ThemeRow(
        (100, 500), "6-12% desk*; 2-5% storage_shelf*; 1-2 copier; 1-2 sofa; 1-3 potted_tree"
    ),
}
"""By name."""
SHOPS = ("clothes shop", "bookshop", "household shop", "jeweller", "supermarket")
"""Those that have a gate, a till and goods at walls."""


class Drawn(NamedTuple):
    """A hall: what it is called, its theme, and its brief of one room."""

    name: str
    theme: str
    brief: Brief


def draw_halls(seed: int, count: int) -> list[Drawn]:
    """Halls drawn by a seed, every theme as often as chance has it.

    >>> [hall.name for hall in draw_halls(3, 2)] == [hall.name for hall in draw_halls(3, 2)]
    True
    """
    rng, shops = np.random.default_rng(seed), list_mall_shops()
    return [_draw(k, rng, shops) for k in range(count)]


def _draw(number: int, rng: np.random.Generator, shops: tuple[Drawn, ...]) -> Drawn:
    theme = str(rng.choice(list(THEMES)))
    if theme in SHOPS and shops and rng.random() < REAL:
        return shops[int(rng.integers(len(shops)))]
    low, high = THEMES[theme].floor
    area = float(rng.uniform(low, high))
    room = (
        generate_hall({"use": "generic", "area": area}, int(rng.integers(2**31)))
        .rooms[0]
        .model_dump(mode="json")
    )
    room |= {"name": theme, "demands": list(_write_demands(theme, area, rng))}
    room["doors"] = _use_doors(theme, room["doors"])
    brief = Brief.model_validate({"domain": "hall", "name": theme.capitalize(), "rooms": [room]})
    return Drawn(f"{number} {theme}, {area:.0f} m2", theme, brief)


def _use_doors(theme: str, doors: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """One boards by the door at the back of a gate, as wide as the entrance."""
    if theme != "boarding gate":
        return doors
    return [d | {"use": "exit" if k else "entrance", "width": 2.0} for k, d in enumerate(doors)]


def _write_demands(theme: str, area: float, rng: np.random.Generator) -> Iterator[dict[str, Any]]:
    for text in THEMES[theme].demands.split(";"):
        title, _, rest = text.strip().rpartition(":")
        found = re.fullmatch(r" ?(\d+)-(\d+)(%?) (\w+)(\*?)(?: sized (\S+))?", rest)
        assert found is not None, text
        low, high, each, category, starred, size = found.groups()
        number = rng.uniform(float(low), float(high)) * (area / 100.0 if each else 1.0)
        demand: dict[str, Any] = {"category": category}
        if title:
            demand["name"] = title
        if size:
            demand["size"] = [float(side) for side in size.split("x")]
        if not (starred and rng.random() < OPEN):
            demand["count"] = max(round(number), 1)
        yield demand


@cache
def list_mall_shops() -> tuple[Drawn, ...]:
    """The shops of the maps of malls that get demands, each as a hall of its own."""
    from scenewright.domains.hall.indoor.geojson import read_report

    found = []
    for path in data_files("indoor_osm", "*.geojson"):
        brief = read_report(path).brief
        for room, space in zip(brief.rooms, plan.spaces(brief), strict=True):
            area = plan_area(space)
            if room.demands and MALL_SHOPS[0] <= area <= MALL_SHOPS[1]:
                name = f"{path.stem} {space.id}, {area:.0f} m2"
                found.append(Drawn(name, "mall shop", _part(room.model_dump(mode="json"), space)))
    return tuple(found)


def plan_area(space: Space) -> float:
    """Square metres of a space (Gauss), less its holes."""
    rings = (space.outline, *space.holes)
    return float(sum(_area(ring) for ring in rings))


def _area(ring: Any) -> float:
    x, y = np.asarray(ring, float).T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def _part(room: dict[str, Any], space: Space) -> Brief:
    """A single room of a map, with its doors where they meet its inner walls."""
    low = space.outline.min(0)
    room |= {
        "outline": (space.outline - low).round(3).tolist(),
        "holes": [(hole - low).round(3).tolist() for hole in space.holes],
        "level": None,
        "function": "other",
        "doors": [_door(o, low, space) for o in space.openings if o.kind != "window"],
        "windows": [],
    }
    room = {key: value for key, value in room.items() if value is not None}
    return Brief.model_validate({"domain": "hall", "name": str(room["name"]), "rooms": [room]})


def _door(opening: Opening, low: Any, space: Space) -> dict[str, Any]:
    import shapely

    ring = shapely.LinearRing(space.outline - low)
    at = ring.interpolate(ring.project(shapely.Point(opening.x - low[0], opening.y - low[1])))
    return {
        "id": opening.id,
        "at": [round(at.x, 3), round(at.y, 3)],
        "width": round(opening.width - 0.01, 3),
        "use": opening.use,
        "swing": "slide",
    }
