"""Six-fold: each furnished home by what the other five tell, nothing asked for.

A home is left out, groups and habits are learned from the other five, and it is furnished as by
default with these. Counted are the guidelines of its rooms that ours keeps at least as well as its
designer, and the designer at least as well as ours. The rules that are written by hand were written
for all six homes and cannot be unlearned: this measures what is learned, and what happens where
nothing is asked for, no more. ``scenewright bench designer_folds``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.designer import Progress, count_kept
from benchmarks.designer_guidelines import GUIDELINES
from benchmarks.designer_rooms import Home, files, furnish
from benchmarks.home_learned import list_furnished
from benchmarks.stages import tally
from scenewright.catalog.assets import shipped
from scenewright.domains.home.learned.groups import learn, write

Record = dict[str, Any]


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """A record a home left out, and one of all; ``quick`` leaves out two homes."""
    return tally(furnish_folds(files()[: 2 if quick else 6], progress), tally_folds)


def furnish_folds(chosen: list[Path], progress: Progress | None = None) -> Iterator[Home]:
    """Each home furnished by what all others tell."""
    for number, path in enumerate(chosen):
        if progress:
            progress(number / len(chosen), path.stem)
        others = [room for other in files() if other != path for room in list_furnished(other)]
        with tempfile.TemporaryDirectory() as folder:
            learned = Path(folder) / "learned.json"
            write(learn(others, shipped()), learned)
            yield furnish(path, 0, asked=False, groups=[str(learned)])


def tally_folds(homes: list[Home]) -> list[Record]:
    """The guidelines kept at least as well, of all rooms of a home, then of all homes."""
    rows = [(f"left out: {home.name}", [home]) for home in homes] + [("all", homes)]
    return [_record(name, held) for name, held in rows]


def _record(name: str, homes: list[Home]) -> Record:
    pairs = [pair for home in homes for pair in home.rooms]
    counts = [count_kept(row, pairs) for row in GUIDELINES]
    ours, theirs, runs = (sum(each) for each in zip(*counts, strict=True))
    return {
        "case": name,
        "metric": "guidelines at least as good",
        "unit": "share",
        "ours": round(ours / max(runs, 1), 4),
        "baseline": round(theirs / max(runs, 1), 4),
        "baseline_name": "designer",
        "ratio": round(ours / max(theirs, 1), 2),
        "runs": runs,
    }
