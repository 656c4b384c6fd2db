"""The designer as judge: six furnished homes, room by room, against ours with the same groups.

``scenewright bench designer`` counts, for the energy and for each guideline, in how many rooms ours
is at least as good. ``python -m benchmarks.designer OUT`` prints where it is not, term by term, and
writes both plans of each home side by side to the folder OUT.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.designer_guidelines import GUIDELINES, Guideline
from benchmarks.designer_rooms import Home, Pair, files, furnish
from benchmarks.designer_sheet import sheet
from benchmarks.stages import tally
from scenewright.core.atomic_file import write_atomically

Record = dict[str, Any]
Progress = Callable[[float, str], None]
NEAR = 0.5
"""Energies that differ by less are equal."""


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Rooms where ours is at least as good beside those where the designer's is; ``quick`` takes
    two homes."""
    return tally(homes(2 if quick else 6, progress), _tally)


def _tally(furnished: list[Home]) -> list[Record]:
    pairs = [pair for home in furnished for pair in home.rooms]
    return [
        _record("energy", *_energy(pairs)),
        *(_record(row.name, *count_kept(row, pairs)) for row in GUIDELINES),
    ]


def homes(
    count: int, progress: Progress | None = None, seed: int = 0, asked: bool = True
) -> Iterator[Home]:
    """The homes, each furnished again; as by default where not ``asked`` for the same groups."""
    chosen = files()[:count]
    for number, path in enumerate(chosen):
        if progress:
            progress(number / len(chosen), path.stem)
        yield furnish(path, seed, asked)


def _record(name: str, ours: int, theirs: int, count: int) -> Record:
    """How often each is at least as good as the other."""
    return Record(
        case="at least as good",
        metric=name,
        unit="rooms",
        ours=ours,
        baseline=theirs,
        baseline_name="designer",
        ratio=round(ours / max(theirs, 1), 2),
        runs=count,
    )


def _energy(pairs: list[Pair]) -> tuple[int, int, int]:
    both = [
        (sum(p.our_terms.values()), sum(p.designer_terms.values()))
        for p in pairs
        if p.our_terms and p.designer_terms
    ]
    return (sum(a <= b + NEAR for a, b in both), sum(b <= a + NEAR for a, b in both), len(both))


def values(row: Guideline, pairs: list[Pair]) -> list[tuple[Pair, float, float]]:
    """The rooms in which both layouts have the number, with ours and the designer's."""
    found = [(pair, row.measure(pair.ours), row.measure(pair.designer)) for pair in pairs]
    return [(pair, a, b) for pair, a, b in found if a is not None and b is not None]


def count_kept(row: Guideline, pairs: list[Pair]) -> tuple[int, int, int]:
    """In how many rooms each, ours first, is at least as good by a guideline, and of how many."""
    missed = [(row.missed(a), row.missed(b)) for _, a, b in values(row, pairs)]
    ours = sum(a <= b + row.slack for a, b in missed)
    theirs = sum(b <= a + row.slack for a, b in missed)
    return ours, theirs, len(missed)


def lines(pairs: list[Pair]) -> Iterator[str]:
    """The tables as lines of Markdown: each guideline, where ours is worse, energy by term."""
    out = [p for p in pairs if p.left_out]
    yield f"{len(pairs)} rooms; of {len(out)} something is left out: " + "; ".join(
        f"{_name(p)}: {', '.join(p.left_out)}" for p in out
    )
    yield (
        "\n| guideline | limits | source | rooms | ours at least as good | designer's "
        "| median ours | median designer's |"
    )
    yield "|---|---|---|---|---|---|---|---|"
    for row in GUIDELINES:
        found = values(row, pairs)
        ours, theirs, count = count_kept(row, pairs)
        middle = [float(np.median([v[k] for v in found])) if found else 0.0 for k in (1, 2)]
        yield (
            f"| {row.name}: {row.doc} | {row.low:g} – {row.high:g} {row.unit} | {row.source} "
            f"| {count} | {ours} | {theirs} | {middle[0]:.2f} | {middle[1]:.2f} |"
        )
    ours, theirs, count = _energy(pairs)
    yield f"| energy of the groups both hold | | | {count} | {ours} | {theirs} | | |"
    yield "\nWhere the designer's is better, ours against theirs:\n"
    for row in GUIDELINES:
        worse = [
            f"{_name(pair)} {a:.2f} / {b:.2f}"
            for pair, a, b in values(row, pairs)
            if row.missed(a) > row.missed(b) + row.slack
        ]
        if worse:
            yield f"* {row.name}: {'; '.join(worse)}"
    yield "\n| term | rooms where the designer's costs less | mean cost ours | mean designer's |"
    yield "|---|---|---|---|"
    for term in sorted({name for p in pairs for name in (*p.our_terms, *p.designer_terms)}):
        costs = np.array(
            [[t.get(term, 0.0) for t in (p.our_terms, p.designer_terms)] for p in pairs]
        )
        less = int((costs[:, 1] < costs[:, 0] - NEAR).sum())
        yield f"| {term} | {less} | {costs[:, 0].mean():.1f} | {costs[:, 1].mean():.1f} |"


def _name(pair: Pair) -> str:
    return f"{pair.home}/{pair.ours.space.id}"


def main(folder: Path | None) -> None:
    """Print the tables; write the sheets, if a folder is given."""
    pairs: list[Pair] = []
    for home in homes(6):
        pairs += home.rooms
        if folder:
            folder.mkdir(parents=True, exist_ok=True)
            write_atomically(folder / f"{home.name}.svg", sheet(home))
    print("\n".join(lines(pairs)))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else None)
