"""The records of :mod:`.papers_site` as tables beside the paper's figures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

Record = dict[str, Any]
NOTE = "All raters are simulated: a hidden taste, noise that grows as they tire, drift, anchoring."


def markdown_lines(records: Sequence[Record]) -> list[str]:
    """One table a part: liked by scene, and by leading aim."""
    liked = [row for row in records if row["metric"].startswith("liked, ")]
    aims = [row for row in records if "leads" in row["case"]]
    return [NOTE, "", *_liked(liked), "", *_aims(aims)]


def _liked(rows: Sequence[Record]) -> Iterator[str]:
    cases = list(dict.fromkeys(row["case"] for row in rows))
    names = list(dict.fromkeys(row["metric"] for row in rows))
    known = {(row["case"], row["metric"]): row["ours"] for row in rows}
    yield f"| liked, by simulated raters | {' | '.join(cases)} |"
    yield f"|{'---|' * (len(cases) + 1)}"
    for name in names:
        cells = [f"{known[case, name]:.2f}" for case in cases if (case, name) in known]
        yield f"| {name.removeprefix('liked, ')} | {' | '.join(cells)} |"


def _aims(rows: Sequence[Record]) -> Iterator[str]:
    metrics = list(dict.fromkeys(row["metric"] for row in rows))
    known = {(row["case"], row["metric"]): row["ours"] for row in rows}
    yield f"| leading aim | {' | '.join(metrics)} |"
    yield f"|{'---|' * (len(metrics) + 1)}"
    for case in dict.fromkeys(row["case"] for row in rows):
        cells = [f"{known[case, name]:.3f}" for name in metrics if (case, name) in known]
        yield f"| {case.partition(' leads')[0]} | {' | '.join(cells)} |"
