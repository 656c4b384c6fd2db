"""The best so far: drawn anew while the person looks at a sheet, as candidates are bred for the
next one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scenewright.workflow.evolution.candidate import ShownCandidate
    from scenewright.workflow.evolve import Evolution

BEST = "-best.png"
"""What the picture is called after the first output."""


def name_picture(sheet: Path) -> Path:
    """The picture of the best so far, beside a sheet.

    >>> name_picture(Path("flat-sheet.png")).name
    'flat-best.png'
    """
    return sheet.with_name(sheet.stem.removesuffix("-sheet") + BEST)


def tell_best(evolution: Evolution) -> str:
    """One line: the predicted best bred so far for the next sheet, beside the champion."""
    best = evolution.best_so_far()
    return "nothing bred for the next sheet yet" if best is None else _compare(evolution, best)


def _compare(evolution: Evolution, best: ShownCandidate) -> str:
    import numpy as np

    from scenewright.workflow.evolution.candidate import predicted_shares

    screen, mean, deviation = evolution.screen, best.predicted or 0.0, best.deviation or 0.0
    shown = screen.candidates if screen else ()
    for one in shown:
        if screen and one.number == screen.champion and one.predicted is not None:
            means, spread = np.array([mean, one.predicted]), np.array([deviation, one.deviation])
            share = 100 * float(predicted_shares(means, spread)[0])
            return (
                f"bred for the next sheet; predicted: preferred to the champion with {share:.0f} %"
            )
    return f"bred for the next sheet; predicted: {mean:+.1f}"


def draw_best(evolution: Evolution, picture: Path, views: bool) -> int | None:
    """Draw the best so far; its number, none while there is nothing to draw."""
    from scenewright.render.contact_sheet import SheetEntry, draw_sheet, write_sheet

    best = evolution.best_so_far()
    if best is None:
        return None
    entry = SheetEntry(
        best.view(480) if views else best.picture(480), "", _compare(evolution, best)
    )
    write_sheet(draw_sheet([entry], f"{evolution.brief.name}: best so far", ""), picture)
    return best.number


def watch_best(evolution: Evolution, picture: Path, views: bool) -> Callable[[], None]:
    """A look at what is bred so far, to be taken now and then: draws the best whenever another
    one is."""
    drawn: list[int | None] = [None]

    def look() -> None:
        best = evolution.best_so_far()
        if best is not None and best.number != drawn[0]:
            drawn[0] = draw_best(evolution, picture, views)

    return look
