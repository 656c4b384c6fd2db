"""What one person likes: a value learned from events, that says how much she would like a layout.

A :class:`PersonTaste` never changes; :func:`learn_taste` makes it from all events that count, so
taking one back is learning from the others. One taste a person: designers agree with each other
only little (α = .25), so others' tastes are at most where it starts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.choices import Choice, Rating
from scenewright.engine.preference.events import (
    Edit,
    Event,
    Pick,
    Prefer,
    Reason,
    Stars,
    Worst,
    counting,
)
from scenewright.engine.preference.kernel import Kernel
from scenewright.engine.preference.laplace import Posterior, Seen, predict, predict_each
from scenewright.engine.preference.relevance import fit_relevance

Floats = NDArray[np.float64]
Reasons = Mapping[str, Mapping[str, float]]
"""What each reason asks for: by its words, features and the sign in which they should change."""
FAR = 3.0
"""Standard deviations at which features are cut off: one odd layout must not rule the rest."""
STAR = 1.0
"""What a star more is worth, in the unit of a choice."""
STEP, SURE = 1.0, 2.0
"""A reason says that this layout moved by ``STEP`` standard deviations would be better than one
moved for any other reason; it is ``SURE`` times as certain as a choice among those shown."""


class TasteRule(NamedTuple):
    """How a taste is learned: the ``kernel`` one starts from, and in how many ``rounds`` it is
    found which features matter (0: all alike)."""

    kernel: Kernel = Kernel()
    rounds: int = 6


AS_USUAL = TasteRule()


class FeatureScale(NamedTuple):
    """Names of features and how they vary over sane layouts: mean (D,) and standard deviation."""

    names: tuple[str, ...]
    middle: Floats
    spread: Floats


class PersonTaste(NamedTuple):
    """What was learned: the scale of features, the posterior (none before anything was said),
    ``start`` (D,), the slopes it started from, and of how many choices and ratings."""

    scale: FeatureScale
    posterior: Posterior | None
    start: Floats
    statements: int = 0


class Liking(NamedTuple):
    """How much each of m layouts would be liked, *predicted*: mean (m,) and covariance (m, m); in
    the unit of a choice, where 1 more makes a layout e times as likely to be picked."""

    mean: Floats
    covariance: Floats


def measure_scale(names: Sequence[str], values: Floats) -> FeatureScale:
    """The scale of ``values`` (n, D) of sane layouts; features that do not vary have no say.

    >>> measure_scale(["sun"], np.array([[1.0], [3.0]])).spread.tolist()
    [1.0]
    """
    spread = values.std(0)
    still = spread < 1e-9 * np.maximum(1.0, np.abs(values).max(0))
    return FeatureScale(tuple(names), values.mean(0), np.where(still, np.inf, spread))


def standardise(scale: FeatureScale, values: Floats) -> Floats:
    """``values`` (..., D) in standard deviations from the mean, within :data:`FAR`."""
    return np.clip((values - scale.middle) / scale.spread, -FAR, FAR)


def learn_taste(
    scale: FeatureScale,
    events: Sequence[Event],
    values: Mapping[int, Floats],
    reasons: Reasons,
    start: Floats | None = None,
    rule: TasteRule = AS_USUAL,
) -> PersonTaste:
    """The taste that ``events`` tell of, with the features of each candidate by its number.

    ``reasons`` are those of the domain; ``start`` (D,) slopes of another taste, standardised.
    """
    origin = np.zeros(len(scale.names)) if start is None else start
    seen = _observe(scale, counting(events), values, reasons, origin)
    if not (seen.choices or seen.ratings):
        return PersonTaste(scale, None, origin)
    statements = len(seen.choices) + len(seen.ratings)
    return PersonTaste(scale, fit_relevance(seen, rule.kernel, rule.rounds), origin, statements)


def judge(taste: PersonTaste, values: Floats) -> Liking:
    """How much layouts of features ``values`` (m, D) would be liked."""
    points = standardise(taste.scale, values)
    given = points @ taste.start
    if taste.posterior is None:
        return Liking(given, points @ points.T / points.shape[1] + 1e-6 * np.eye(len(points)))
    mean, covariance = predict(taste.posterior, points)
    return Liking(mean + given, covariance)


def judge_each(taste: PersonTaste, values: Floats) -> tuple[Floats, Floats]:
    """Mean and standard deviation (m,) of how much each layout would be liked separately, quicker
    than :func:`judge`."""
    points = standardise(taste.scale, values)
    given = points @ taste.start
    if taste.posterior is None:
        return given, np.ones(len(points))
    mean, variance = predict_each(taste.posterior, points)
    return mean + given, np.sqrt(np.maximum(variance, 0.0))


def slopes_of(taste: PersonTaste) -> Floats:
    """How much each feature is liked (D,), near the mean layout, in a standard deviation."""
    if taste.posterior is None:
        return taste.start
    steps = 0.5 * np.eye(len(taste.scale.names))
    ahead, _ = predict(taste.posterior, steps)
    behind, _ = predict(taste.posterior, -steps)
    return taste.start + (ahead - behind)


def start_from(tastes: Sequence[PersonTaste], names: Sequence[str], share: float = 0.25) -> Floats:
    """Slopes (D,) to start from, of other people's tastes: their mean, by feature name, times
    ``share`` (α = .25: how much people agree)."""
    found = np.zeros(len(names))
    for taste in tastes:
        slopes = dict(zip(taste.scale.names, slopes_of(taste), strict=True))
        found += np.array([slopes.get(name, 0.0) for name in names]) / len(tastes)
    return share * found


def _observe(
    scale: FeatureScale,
    events: Sequence[Event],
    values: Mapping[int, Floats],
    reasons: Reasons,
    start: Floats,
) -> Seen:
    """What events say, as choices and ratings among standardised points."""
    rows: dict[int, int] = {}
    points: list[Floats] = []
    choices: list[Choice] = []
    ratings: list[Rating] = []

    def row_of(candidate: int) -> int:
        if candidate not in rows:
            rows[candidate] = len(points)
            points.append(standardise(scale, values[candidate]))
        return rows[candidate]

    for event in events:
        match event:
            case Pick(best, among):
                choices.append(Choice(row_of(best), tuple(map(row_of, among))))
            case Worst(worst, among):
                choices.append(Choice(row_of(worst), tuple(map(row_of, among)), -1.0))
            case Prefer(one, other) | Edit(other, one):
                pair = (row_of(one), row_of(other))
                choices.append(Choice(pair[0], pair))
            case Stars(candidate, stars, screen):
                ratings.append(Rating(row_of(candidate), (stars - 3.0) * STAR, screen))
            case Reason(candidate, reason):
                steps = _reason_steps(scale, reasons)
                if reason in steps:
                    here = row_of(candidate)
                    moved = range(len(points), len(points) + len(steps))
                    points += [np.clip(points[here] + step, -FAR, FAR) for step in steps.values()]
                    chosen = moved[list(steps).index(reason)]
                    choices.append(Choice(chosen, (here, *moved), 1.0, SURE))
    made = np.array(points).reshape(-1, len(scale.names))
    return Seen(made, made @ start, tuple(choices), tuple(ratings))


def _reason_steps(scale: FeatureScale, reasons: Reasons) -> dict[str, Floats]:
    """The steps (D,) of all reasons that speak of what varies, by their words."""
    steps = {words: reason_step(scale, wanted) for words, wanted in reasons.items()}
    return {words: step for words, step in steps.items() if step.any()}


def reason_step(scale: FeatureScale, wanted: Mapping[str, float]) -> Floats:
    """How a layout should change (D,), in standard deviations, of length :data:`STEP`.

    >>> scale = FeatureScale(("sun", "open"), np.zeros(2), np.ones(2))
    >>> reason_step(scale, {"open": 1.0}).tolist()
    [0.0, 1.0]
    """
    step = np.array([float(wanted.get(name, 0.0)) for name in scale.names])
    step[~np.isfinite(scale.spread)] = 0.0
    length = float(np.hypot.reduce(step, initial=0.0))
    return STEP * step / length if length else step
