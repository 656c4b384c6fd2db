"""Kitchens round corners: lines that meet where two walls do (an L), round two corners a U."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from scenewright.domains.home.composing.kitchens.free_walls import (
    AT_CORNER,
    KitchenStretch,
    end_of,
    floor_length,
)
from scenewright.domains.home.groups.fitted_kitchen import (
    CORNER,
    FittedKitchen,
    UnitLine,
    wash,
    width_of,
)
from scenewright.domains.home.groups.kitchen import (
    AMPLY_BEYOND,
    BETWEEN,
    BEYOND,
    FRIDGE,
    HOBS,
    Unit,
    fill,
    widest_hob,
)
from scenewright.domains.home.least_sizes import CABINET, HOB, SINK
from scenewright.domains.home.measures import HAIR

LEAST_OF_ARM = {"hs": 1.1, "h": 0.6, "s": SINK.width}
"""Metres that sink and hob take at least beside a corner cabinet without a fault beside them."""
LONG, UNIT = 1.2, 0.6
"""Metres by which an arm is longer than the least that is tried in a length between as well, from
twice as many on also by one unit longer than the least."""
WIDE_SINK = 0.9
"""Width in metres below which a sink has a drainer."""
WORKED = 0.9
"""Metres of worktop between hob and sink (NKBA, Planning Guidelines, 2012, 12): what more there is,
if it is a unit, lies beyond the sink."""
DISHWASHER, LEAST_RINSED = 0.6, 0.6  # width of one, and of a sink beside it, metres
Units = tuple[Unit, ...]


def _corners(low: list[KitchenStretch]) -> Iterator[tuple[KitchenStretch, KitchenStretch]]:
    """The stretches that meet in a corner of the room: the one that ends there, the one that
    begins."""
    for one, other in product(low, low):
        meets = abs(end_of(one)[0] - other.wall.x) + abs(end_of(one)[1] - other.wall.y) < AT_CORNER
        turns = one.wall.ux * other.wall.uy - one.wall.uy * other.wall.ux > 0.99
        if meets and turns and one.end > one.length - AT_CORNER and other.start < AT_CORNER:
            yield one, other


ROUND = ("h/s", "s/h", "hs/", "/hs")
"""The units on either side of a corner."""


def list_round_corners(
    low: list[KitchenStretch], most: float, whole: bool, left: float = 0.0
) -> Iterator[FittedKitchen]:
    """Two lines of at most ``most`` metres that meet in a corner, with a fridge at either end if
    ``whole``; arms without it also with ``left`` metres of their wall unused."""
    for one, other in _corners(low):
        for holds, cold in product(ROUND, (0, 1) if whole else (-1,)):
            arms = holds.split("/")
            sides = [
                list(_arms(stretch.end - stretch.start - CORNER, arm, k == cold, most, left))
                for k, (stretch, arm) in enumerate(zip((one, other), arms, strict=True))
            ]
            for before, after in product(*sides):
                yield _join(one, other, before, after)


def _arms(spare: float, holds: str, cold: bool, most: float, left: float = 0.0) -> Iterator[Units]:
    """What stands along a wall from its corner cabinet on."""
    fridge: Units = (("fridge", FRIDGE.width),) if cold else ()
    spare -= width_of(fridge)
    if not holds and spare > -HAIR:
        side = floor_length(min(spare, most))
        yield (*(fill(side) if side >= BEYOND else ()), *fridge)
    elif holds:
        least = LEAST_OF_ARM[holds]
        full = floor_length(min(spare, max(most, least)))
        wider = least + (0.3 if full >= least + 0.6 else 0.0)
        lengths = [full] * (full >= least) + [wider] * (full >= least + 0.3)
        if full >= wider + LONG:
            lengths.append(floor_length((wider + full) / 2))
            lengths += [wider + UNIT] * (full >= wider + 2 * LONG)
        if left and not cold and full >= least + left:
            lengths.append(floor_length(min(spare - left, full)))
        for length in dict.fromkeys(lengths):
            yield (*_units_of_arm(holds, length), *fridge)


def _units_of_arm(holds: str, length: float) -> Units:
    """Units from a corner cabinet on, whose worktop is one side of a hob next to it."""
    if holds == "s":
        return _wash_in_corner(length)
    wide = widest_hob(length - LEAST_OF_ARM[holds] + HOB.width)
    beside = length - wide
    rest: list[Unit] = fill(AMPLY_BEYOND if beside >= AMPLY_BEYOND + CABINET.width else beside)
    if holds == "hs":
        sink = next((w for w in (0.8, 0.6) if length - wide >= w + BETWEEN), SINK.width)
        top = length - wide - sink
        between = WORKED if top >= WORKED + BETWEEN else top
        beyond = top - between
        before, after = fill(between), _rinse(beyond)
        if between >= DISHWASHER + CABINET.width:
            before, after = [*_rinse(between)[::-1]], tuple(fill(beyond))
        rest = [*before, ("sink_cabinet", sink), *after]
    return (*fill(length - wide - width_of(rest)), ("hob_cabinet", wide), *rest)


def _wash_in_corner(length: float) -> Units:
    """A sink beside a corner cabinet, which is worktop: as wide as ``length`` metres hold."""
    if length < WIDE_SINK:
        return (("sink_cabinet", length),)
    return tuple(wash(length)) if length >= 0.6 + WIDE_SINK else _sink_and_rest(length)


def _sink_and_rest(length: float) -> Units:
    if length < DISHWASHER + LEAST_RINSED - HAIR:
        sink = 0.8 if length >= 0.8 + BEYOND - HAIR else 0.6
        return (("sink_cabinet", sink), *fill(length - sink))
    sink = length - DISHWASHER if length < 0.8 + DISHWASHER + CABINET.width else 0.8
    return (("sink_cabinet", sink), *_rinse(length - sink))


def _rinse(length: float) -> Units:
    """Worktop beside a sink, over a dishwasher first where it holds one."""
    if length < DISHWASHER - HAIR:
        return tuple(fill(length))
    return (("dishwasher", DISHWASHER), *fill(length - DISHWASHER))


def _join(one: KitchenStretch, other: KitchenStretch, left: Units, right: Units) -> FittedKitchen:
    """The units outwards from the corner along the wall that ends there and the one that begins."""
    lines = []
    if left:
        lines.append(UnitLine(one.wall, one.length - CORNER - width_of(left), left[::-1]))
    if right:
        lines.append(UnitLine(other.wall, CORNER, right))
    return FittedKitchen(_hob_first(lines), (other.wall,))


def _hob_first(lines: list[UnitLine]) -> tuple[UnitLine, ...]:
    return tuple(sorted(lines, key=lambda line: "hob_cabinet" not in dict(line.units)))


AROUND = ("h/s/f", "f/s/h", "hf/s/", "/s/hf", "sf/h/", "/h/sf", "s/h/f", "f/h/s")
"""What stands in a U along its three walls."""


def list_us(low: list[KitchenStretch], most: float) -> Iterator[FittedKitchen]:
    """Three lines round two corners, the outer ones of at most ``most`` metres."""
    meetings = list(_corners(low))
    for (one, middle), (again, other) in product(meetings, meetings):
        if middle is not again:
            continue
        between = floor_length(middle.length - 2 * CORNER)
        for form in AROUND:
            yield from _u(most, (one, middle, other), form.split("/"), between)


def _u(
    most: float,
    walls: tuple[KitchenStretch, KitchenStretch, KitchenStretch],
    holds: list[str],
    between: float,
) -> Iterator[FittedKitchen]:
    one, middle, other = walls
    least = HOB.width if holds[1] == "h" else SINK.width
    if not least <= between <= 1.8:
        return
    inner = tuple(_between(holds[1], between))
    sides = []
    for stretch, arm in ((one, holds[0]), (other, holds[2])):
        spare, bare = stretch.end - stretch.start - CORNER, arm.replace("f", "")
        sides.append(list(_arms(spare, bare, "f" in arm, most)))
    for left, right in product(*sides):
        joined = _join(one, middle, left, inner)
        far = [UnitLine(other.wall, CORNER, right)] if right else []
        yield FittedKitchen(_hob_first([*joined.lines, *far]), (middle.wall, other.wall))


def _between(holds: str, length: float) -> list[Unit]:
    """A sink or hob in the middle of the base of a U."""
    widths = (0.8, 0.6, SINK.width) if holds == "s" else HOBS
    wide = next((w for w in widths if length >= w - 1e-9), length)
    side = fill((length - wide) / 2)
    return [*side, ("sink_cabinet" if holds == "s" else "hob_cabinet", wide), *side]
