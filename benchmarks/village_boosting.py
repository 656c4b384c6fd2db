"""Whether the net foretells better than gradient boosting where the next house stands: ``bench
village_boosting``.

Both weigh the same legal proposals by the same figures (:mod:`.village_foretelling`), on blocks of
places held out: three splits, three seeds (of houses, proposals and boosting), twenty houses each.
Told is the mean over houses of the net less boosting, with a 95 % interval of a bootstrap over
houses; where it holds 0 they are *not told apart*. Of nats more is
better, of metres from the nearest of five places less (at most 30 count).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.kept import open_runs
from benchmarks.spread import Progress
from benchmarks.village import CODE, _files, style_of_split
from benchmarks.village_data import SPLITS, split
from benchmarks.village_foretelling import methods_of
from benchmarks.village_location import Foretold, foretell_house, turns_drawn
from scenewright.core.errors import InputError
from scenewright.domains.village.standing import Floats

Record = dict[str, Any]
SEEDS, HOUSES, FULL_HOUSES = (3, 4, 5), 20, 70
QUICK_HOUSES, QUICK_BLOCKS = 8, 40
FAR, DRAWS = 30.0, 2000
"""Metres that count at most, and draws of the bootstrap."""
NET, BOOSTING, NOTHING = "net", "boosting", "proposals"


class Interval(NamedTuple):
    """A mean and the ends of its interval."""

    mean: float
    low: float
    high: float

    @property
    def apart(self) -> bool:
        """Whether it does not hold 0."""
        return self.low > 0.0 or self.high < 0.0


def interval_of(values: Sequence[float], seed: int = 0) -> Interval:
    """The 95 % interval of a mean by a bootstrap of the values.

    >>> interval_of([1.0, 1.0, 1.0]).apart, interval_of([-1.0, 1.0, 0.0]).apart
    (True, False)
    """
    rows, rng = np.array(values, float), np.random.default_rng(seed)
    drawn = rows[rng.integers(0, len(rows), (DRAWS, len(rows)))].mean(1)
    low, high = np.quantile(drawn, (0.025, 0.975)).tolist()
    return Interval(float(rows.mean()), low, high)


def measure_split(name: str, seed: int, houses: int, quick: bool) -> dict[str, NDArray[Any]]:
    """What the net, boosting and nothing foretell of some houses of a split (houses, 3)."""
    train, test = split(name)
    style, kept = (
        style_of_split(name),
        open_runs("village_boosting", (*CODE, *_files(name, "grow"))),
    )
    ready: dict[str, Any] = {}

    def tell(number: int, block: Any, turn: Any) -> dict[str, Foretold]:
        if not ready:
            ready.update(methods_of(style, train[:QUICK_BLOCKS] if quick else train, seed))
        return foretell_house(block, turn, style, ready, np.random.default_rng([seed, number]))

    found: dict[str, list[Any]] = {}
    for number, (block, turn) in enumerate(turns_drawn(test, houses, seed)):
        told = f"{name}, {seed}, {number}{', quick' * quick}"
        for method, row in kept.have(told, partial(tell, number, block, turn)).items():
            found.setdefault(method, []).append(row)
    return {method: np.array(rows, float) for method, rows in found.items()}


def records(
    quick: bool = False, progress: Progress | None = None, full: bool = False
) -> Iterator[Record]:
    """Records of each seed over the splits, then of all; houses once done are kept."""
    houses = QUICK_HOUSES if quick else FULL_HOUSES if full else HOUSES
    names = list(SPLITS)[:1] if quick else list(SPLITS)
    every: list[dict[str, Floats]] = []
    for number, seed in enumerate(SEEDS):
        rows = []
        for k, name in enumerate(names):
            if progress:
                progress((number + k / len(names)) / len(SEEDS), f"split {name}, seed {seed}")
            rows.append(measure_split(name, seed, houses, quick))
        every += rows
        yield from compare_methods(f"seed {seed}", rows)
    yield from compare_methods("all seeds", every)


def compare_methods(case: str, rows: Sequence[dict[str, Floats]]) -> Iterator[Record]:
    """The net beside boosting, and both beside the proposals alone."""
    if BOOSTING not in rows[0]:
        raise InputError("boosting needs scikit-learn", "pip install scikit-learn")
    for ours, theirs in ((NET, BOOSTING), (NET, NOTHING), (BOOSTING, NOTHING)):
        for column, metric in enumerate(("nats", "metres to the house", "metres to any missing")):
            pair = [_joined(rows, name, column) for name in (ours, theirs)]
            gap = interval_of((pair[0] - pair[1]).tolist())
            yield Record(
                case=f"{case}: {ours} less {theirs}",
                metric=metric,
                unit="nats" if column == 0 else "m",
                ours=round(float(pair[0].mean()), 3),
                baseline=round(float(pair[1].mean()), 3),
                baseline_name=theirs,
                ratio=None,
                runs=len(pair[0]),
                low=round(gap.low, 3),
                high=round(gap.high, 3),
                gap=round(gap.mean, 3),
                told_apart=gap.apart,
                seeds="3 to 5",
            )


def _joined(rows: Sequence[dict[str, Floats]], name: str, column: int) -> Floats:
    values = np.concatenate([row[name][:, column] for row in rows])
    return values if column == 0 else np.minimum(values, FAR)


def markdown_lines(told: Sequence[Record]) -> Iterator[str]:
    """A line a seed and pair of methods: the difference of each measure with its interval."""
    metrics = list(dict.fromkeys(row["metric"] for row in told))
    yield f"| difference (95 % interval) | houses | {' | '.join(metrics)} |"
    yield "|---" * (len(metrics) + 2) + "|"
    for case in dict.fromkeys(row["case"] for row in told):
        rows = [row for row in told if row["case"] == case]
        cells = [show_gap(row) for row in rows]
        yield f"| {case} | {rows[0]['runs']} | {' | '.join(cells)} |"


def show_gap(row: Record) -> str:
    """A difference with its interval; ≈ before what is not told apart from none.

    >>> show_gap({"gap": 0.12, "low": -0.1, "high": 0.3, "told_apart": False})
    '≈ +0.12 (−0.10 to +0.30)'
    """
    told = f"{row['gap']:+.2f} ({row['low']:+.2f} to {row['high']:+.2f})".replace("-", "−")
    return told if row["told_apart"] else f"≈ {told}"
