"""Methods that say where the next house stands: on the same proposals the net, gradient boosting on
the same figures, nothing, and hugging the street; and the paper's *location* network."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from benchmarks.kept import KeptRuns
from benchmarks.village_location import (
    EVEN,
    Foretelling,
    Foretold,
    Scoring,
    best_places,
    foretell_house,
    missing_houses,
    nearest_of,
    turns_drawn,
)
from scenewright.domains.village.learned.fullness import odds_of_figures
from scenewright.domains.village.learned.pose_net import score_poses
from scenewright.domains.village.learned.style import VillageStyle
from scenewright.domains.village.learned.tokens import PoseTokens
from scenewright.domains.village.learning.examples import Turn, examples_of
from scenewright.domains.village.learning.more_training import states_of
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.filling import tell_standing
from scenewright.domains.village.paper.nets_file import PaperNets
from scenewright.domains.village.paper.passes import odds_of_places
from scenewright.domains.village.paper.views import base_and_door, class_planes, frame_of, paint
from scenewright.domains.village.standing import Floats

SETBACK, STEEP = 12, 3.0
"""Where in what is told of a house its distance to the street is, and how hard it is hugged."""
CHUNK = 256
"""Poses weighed at a time."""
FALSE = 12
"""Proposals beside each real pose that boosting learns from."""


def methods_of(style: VillageStyle, train: Sequence[RealBlock], seed: int) -> dict[str, Scoring]:
    """Methods by name; boosting only where scikit-learn is installed."""
    found: dict[str, Scoring] = {
        "net": partial(_by_net, style),
        "proposals": lambda _turn, tokens: np.zeros(len(tokens.own)),
        "hug the street": lambda _turn, tokens: -STEEP * tokens.own[:, SETBACK],
    }
    boosted = boost(style, train, seed)
    return found if boosted is None else {"boosting": boosted, **found}


def _by_net(style: VillageStyle, turn: Turn, tokens: PoseTokens) -> Floats:
    del turn
    parts = (
        PoseTokens(*(v[k : k + CHUNK] for v in tokens)) for k in range(0, len(tokens.own), CHUNK)
    )
    return np.concatenate([score_poses(style.poses, part) for part in parts])


def boost(style: VillageStyle, train: Sequence[RealBlock], seed: int) -> Scoring | None:
    """Gradient boosting (scikit-learn's by histograms, after Ke and others 2017) that tells real
    poses from proposals by the same figures; its log odds weigh poses."""
    try:
        from sklearn.ensemble import HistGradientBoostingClassifier
    except ImportError:
        return None
    rng = np.random.default_rng(seed)
    rows = [row.tokens for b in train for row in examples_of(b, style, rng, FALSE + 1)]
    label = np.concatenate([np.arange(len(row.own)) == 0 for row in rows])
    model = HistGradientBoostingClassifier(
        max_iter=150, learning_rate=0.1, max_leaf_nodes=31, l2_regularization=1.0, random_state=seed
    )
    model.fit(np.concatenate([flat(row) for row in rows]), label)
    return partial(_by_model, model)


def _by_model(model: Any, turn: Turn, tokens: PoseTokens) -> Floats:
    del turn
    return np.asarray(model.decision_function(flat(tokens)))


def flat(tokens: PoseTokens) -> Floats:
    """What is told of poses as rows (k, …): the house, the four nearest houses, all sides."""
    count = len(tokens.own)
    parts = [tokens.own, tokens.houses[:, :4].reshape(count, -1), tokens.sides.reshape(count, -1)]
    return np.concatenate(parts, 1).astype(np.float32)


def tell_locations(
    style: VillageStyle,
    train: Sequence[RealBlock],
    test: Sequence[RealBlock],
    houses: int,
    seed: int,
    nets: PaperNets | None,
    kept: KeptRuns,
) -> dict[str, list[Foretold]]:
    """What each method foretells of so many held-out houses; ``nets`` are the paper's."""
    ready: dict[str, Scoring | Foretelling] = {}

    def tell(number: int, block: RealBlock, turn: Turn) -> dict[str, Foretold]:
        if not ready:
            ready.update(methods_of(style, train, seed))
            if nets is not None:
                ready["paper's CNN"] = Foretelling(partial(tell_by_paper, nets))
        return foretell_house(block, turn, style, ready, np.random.default_rng([seed, number]))

    found: dict[str, list[Foretold]] = {}
    for number, (block, turn) in enumerate(turns_drawn(test, houses, seed)):
        told = kept.have(f"house {number}", partial(tell, number, block, turn))
        for name, row in told.items():
            found.setdefault(name, []).append(Foretold(*row))
    return found


def tell_by_paper(nets: PaperNets, block: RealBlock, turn: Turn, free: Floats) -> Foretold:
    """What the paper's *location* network, told the real classes, says of the base point."""
    frame = frame_of(block.floor, nets.sizes.pixels)
    view = paint(frame, block.floor, tell_standing(turn.seen.standing, block.streets))
    classes = (0, turn.house.shape, turn.house.size)
    planes = np.concatenate([view, class_planes(classes, frame.size)])
    odds = odds_of_places(nets, planes).astype(float)
    odds = np.where(view[0] < 0.5, 0.0, np.exp(odds - odds[view[0] >= 0.5].max()))
    odds /= odds.sum()
    rings = [block.houses[k] for k in missing_houses(block, turn)]
    bases = np.array([base_and_door(ring, ring[0])[0] for ring in rings])
    base = bases[0]
    column, row = np.clip(frame.pixels(base[None])[0].astype(int), 0, frame.size - 1)
    there = odds[row, column] / frame.pixel**2
    rows, columns = np.nonzero(odds > 0)
    places = best_places(
        frame.metres(np.column_stack([columns, rows]).astype(float) + 0.5), odds[rows, columns]
    )
    nats = float(np.log((1 - EVEN) * there * len(free) + EVEN))
    return Foretold(nats, *nearest_of(places, bases))


def tell_more(style: VillageStyle, test: Sequence[RealBlock], seed: int) -> tuple[float, float]:
    """How well full held-out blocks are told from those that lack half their houses (area under
    the curve): by the law, and by the number of houses alone."""
    rows, label = states_of(test, style, seed, 2)
    by = odds_of_figures(style.more, rows), rows[:, 1]
    one, two = (float((v[label > 0][:, None] > v[label == 0][None]).mean()) for v in by)
    return one, two


def location_figures(found: dict[str, list[Foretold]]) -> Iterator[tuple[str, str, float]]:
    """Method, figure and value: mean nats over even ground and its standard error, medians of the
    distances."""
    for name, rows in found.items():
        values = np.array(rows)
        yield name, "location: nats over even ground", float(values[:, 0].mean())
        yield name, "location: standard error of nats", float(values[:, 0].std() / len(rows) ** 0.5)
        for column, what in ((1, "the house"), (2, "any missing house")):
            metric = f"location: metres from the nearest of 5 places to {what}, median"
            yield name, metric, float(np.median(values[:, column]))
