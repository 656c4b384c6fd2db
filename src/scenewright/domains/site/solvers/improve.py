"""Buildings change places and turn where walkers see more of what is worth seeing, or sun gains.

Two buildings that fit into each other's places exchange them, front to front; or one turns by
quarters. Only rays that met them or meet them now, and buildings they may shade, are looked at
again. What breaks a rule, or gains nothing, is taken back.
"""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.domains.site.problem import Flags, Floats, Ints, SiteProblem, sides_of
from scenewright.domains.site.solvers.blocks.front import blind, on_square
from scenewright.domains.site.solvers.exchange import (
    ExchangeRule,
    Lists,
    Slots,
    exchange_all,
    fill_hours,
)
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.terms.measure import (
    SitePrepared,
    SiteState,
    lay,
    make_site_state,
    prepare_site,
)
from scenewright.domains.site.terms.table import MUCH, read_site_aims
from scenewright.engine.solve import BudgetWatch
from scenewright.geometry.box_grid import BoxGrid, box_grid
from scenewright.geometry.sun import sun_path
from scenewright.geometry.walker import REACH, look, sights

LOT = 64
"""Exchanges tried between two looks at the clock."""
LOOSE = 1e-3
"""Square metres that rounding may be off."""


def improve_layout(
    problem: SiteProblem,
    found: SiteLayout,
    seed: int,
    watch: BudgetWatch,
    begun: float = 0.0,
    joined: Flags | None = None,
) -> tuple[SiteLayout, int]:
    """A layout after exchanges and turns that gain in what is seen and in sun, by their weights,
    and how many were tried. ``begun`` is the share of the run done before, ``joined`` (n,) are
    buildings that stay.

    Time grows with the number of buildings and of eyes near each. All are taken for boxes: a
    building in the corner of another stays.
    """
    aims = read_site_aims(problem.weights)
    here = np.flatnonzero(found.present)
    if len(here) < 1 or not len(problem.ground.block_areas) or not aims[:2].any():
        return found, 0
    if watch.reached(begun, lambda: found):
        return found, 0
    problem = problem._replace(buildings=problem.buildings._replace(footprints=()))
    rng, made = np.random.default_rng(seed), make_slots(problem, found.boxes[here], here)
    p, s = prepare_site(problem), make_site_state(problem)
    _stand(s, p, problem, found.boxes[here])
    who, tally = here.astype(np.int64), np.zeros(2)
    rule = make_rule(problem, made, aims)
    moves = np.concatenate(
        [exchanges(problem, made, who, found.forms, rng), turns(problem, found.boxes[here])]
    )
    stays = on_square(problem, found.boxes[here])  # as does what closes a court
    if joined is not None:
        stays |= joined[here]
    if problem.court_gap > 0.0:
        stays |= np.array([found.forms[i] == "peripheral" for i in here])
    moves = np.ascontiguousarray(moves[~stays[moves[:, :2]].any(1)])

    def best() -> SiteLayout:
        return _read_slots(found, here, who, made)

    for first in range(0, len(moves), LOT):
        exchange_all(p, s, made, rule, moves[first : first + LOT], who, tally)
        if watch.reached(begun + (1.0 - begun) * (first + LOT) / (len(moves) + LOT), best):
            break
    return best(), int(tally[0])


def _read_slots(found: SiteLayout, here: Ints, who: Ints, made: Slots) -> SiteLayout:
    """The layout that slots hold: ``who`` (k,) stands now where ``here`` (k,) stood."""
    boxes, forms = found.boxes.copy(), list(found.forms)
    frames = made.grid.frames[: len(here)]
    boxes[who] = frames[:, [0, 1, 7, 4, 5]] * (1.0, 1.0, 1.0, 2.0, 2.0)
    for slot, i in enumerate(who.tolist()):
        forms[i] = found.forms[here[slot]]
    return found._replace(boxes=boxes, forms=tuple(forms))


def make_slots(problem: SiteProblem, boxes: Floats, here: Ints) -> Slots:
    """The buildings ``here`` (k,) at boxes (k, 5) as slots, and what is seen of them."""
    ground, made, count = problem.ground, problem.buildings, len(here)
    rule = problem.settings.exchange
    heights = np.concatenate([made.sizes[here, 2], ground.landmark_heights])
    every = np.concatenate([boxes, ground.landmarks])
    eyes = ground.eyes[:: rule.paces]
    grid = _roomy(every, heights, count, rule.give)
    seen = sights(eyes, rule.rays)
    quality = np.ascontiguousarray(
        np.concatenate(
            [
                sides_of(made.sides, made.quality)[here],
                sides_of(ground.landmark_sides, ground.landmark_quality),
            ]
        )
    )
    look(grid, quality, seen, REACH)
    middles = shapely.points(boxes[:, :2])
    slots = Slots(
        grid,
        quality,
        boxes[:, 3:] + rule.give,
        seen,
        sun_path(problem.latitude, problem.day, minutes=30.0),
        np.zeros(count),
        _near(middles, shapely.points(eyes), REACH + float(boxes[:, 3:].max())),
        _near(middles, middles, rule.shade),
        np.zeros((seen.values.size, 3), np.int64),
        np.zeros((seen.values.size, 2)),
        np.zeros(1, np.int64),
        np.zeros(count),
        np.full(len(eyes), -1, np.int64),
        np.full(count, -1, np.int64),
    )
    fill_hours(slots, float(heights.max()))
    return slots


def _roomy(boxes: Floats, heights: Floats, count: int, give: float) -> BoxGrid:
    """A grid over boxes, the first ``count`` of them exchangeable, for boxes of any later size."""
    large = boxes.copy()
    large[:count, 3:] = (boxes[:count, 3:].max(1) + 2.0 * give)[:, None]
    grid, true = box_grid(large, heights), box_grid(boxes, heights)
    grid.frames[:] = true.frames
    grid.tallest[grid.tallest > 0.0] = heights.max()
    return grid


def _near(places: Floats, others: Floats, far: float) -> Lists:
    """For each of ``places``, the ``others`` within ``far`` metres."""
    own, other = shapely.STRtree(others).query(places, predicate="dwithin", distance=far)
    order = np.lexsort((other, own))
    starts = np.searchsorted(own[order], np.arange(len(places) + 1))
    return Lists(starts.astype(np.int64), other[order].astype(np.int64))


def _stand(s: SiteState, p: SitePrepared, problem: SiteProblem, boxes: Floats) -> None:
    """Let the state hold the slots, in their order."""
    every = np.zeros((len(problem.buildings.sizes), 5))
    every[: len(boxes)] = boxes
    lay(p, s, every)


def make_rule(problem: SiteProblem, made: Slots, aims: Floats) -> ExchangeRule:
    """The weights of the aims brought to rays and hours."""
    toward = math.pi / 2 if problem.latitude < 0.0 else -math.pi / 2
    whole = max(float(made.path[:, 3].sum()), 1e-9) * max(len(made.hours), 1)
    return ExchangeRule(
        float(aims[0]) / (MUCH * max(made.made.values.size, 1)),
        float(aims[1]) / whole,
        (math.cos(toward), math.sin(toward)),
        problem.sun_spacing,
        LOOSE,
        float(made.grid.heights.max()),
    )


def exchanges(
    problem: SiteProblem, made: Slots, who: Ints, forms: tuple[str, ...], rng: np.random.Generator
) -> Ints:
    """Pairs of slots (m, 3) to be tried: of like size and other models, first those that promise
    most, by how much is seen of each place and how good the sides of each building are."""
    count, rule = len(who), problem.settings.exchange
    first = np.repeat(np.arange(count), rule.partners)
    second = rng.integers(count, size=len(first))
    quality = made.quality[:count, :4].mean(1)
    found = made.made.found
    shown = np.bincount(found[found >= 0], made.made.values[found >= 0], len(made.quality))[
        :count
    ] / np.maximum(quality, 1e-9)
    sizes, models = problem.buildings.sizes[who], problem.buildings.models[who]
    apart = np.abs(sizes[first, :2] - sizes[second, :2]).max(1)
    fit = (apart <= rule.give) & (models[first] != models[second])
    fit &= _find_allowed_pairs(problem, who, forms, first, second)
    first, second = first[fit], second[fit]
    promise = (quality[second] - quality[first]) * (shown[first] - shown[second])
    order = np.argsort(-promise, kind="stable")[: rule.tries * count]
    moves = np.column_stack([first, second, np.zeros(len(first), np.int64)])[order]
    return np.ascontiguousarray(moves, np.int64)


def _find_allowed_pairs(
    problem: SiteProblem, who: Ints, forms: tuple[str, ...], first: Ints, second: Ints
) -> Flags:
    """Which pairs may change places as far as their planar forms go."""
    given = problem.buildings.forms
    if not given or not forms or not any(given):
        return np.ones(len(first), bool)
    names = sorted(set(forms))
    may = np.array([[not given[i] or name in given[i] for name in names] for i in who.tolist()])
    now = np.array([names.index(forms[i]) for i in who.tolist()])
    allowed: Flags = may[first, now[second]] & may[second, now[first]]
    return allowed


def turns(problem: SiteProblem, boxes: Floats) -> Ints:
    """Turns (m, 3) by quarters to be tried: fronts stay about the preferred heading or as near to
    it as they were, do not turn away from the nearest way, nor to a border without a way."""
    slot = np.repeat(np.arange(len(boxes)), 3)
    quarters = np.tile([1, 2, 3], len(boxes))
    before, after = boxes[slot, 2], boxes[slot, 2] + quarters * math.pi / 2
    fit, leeway = np.ones(len(slot), bool), problem.settings.exchange.leeway
    for wanted in (np.full(len(slot), problem.facing), _to_way(problem, boxes)[slot]):
        near = np.maximum(_off(before, wanted), leeway) + 1e-6
        fit &= np.isnan(wanted) | (_off(after, wanted) <= near)
    places = boxes[slot]
    places[:, 2] = after
    fit &= ~blind(problem, places) | (_off(after, np.full(len(slot), problem.facing)) <= leeway)
    fit &= ~blind(problem, places, problem.door_distance)
    moves = np.column_stack([slot, slot, quarters])[fit]
    return np.ascontiguousarray(moves, np.int64)


def _to_way(problem: SiteProblem, boxes: Floats) -> Floats:
    """Headings (k,) from boxes to the nearest place where people walk; NaN where none is near."""
    eyes, middles = problem.ground.eyes, boxes[:, :2]
    found = np.full(len(boxes), np.nan)
    if len(eyes):
        own, eye = shapely.STRtree(shapely.points(eyes)).query_nearest(
            shapely.points(middles),
            max_distance=problem.settings.exchange.beside,
            all_matches=False,
        )
        way = eyes[eye] - middles[own]
        found[own] = np.arctan2(way[:, 1], way[:, 0])
    return found


def _off(headings: Floats, wanted: Floats) -> Floats:
    return np.abs((headings - wanted + math.pi) % (2.0 * math.pi) - math.pi)
