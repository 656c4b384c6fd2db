"""The records of :mod:`.papers_raters` as tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

Record = dict[str, Any]
NOTE = (
    "Mean and half of the 95 % interval over raters, **all simulated**; ≈: not told apart from the "
    "first method of the table. Of those who never reach a level all ratings count. The network of "
    "`vp` rates at most 3 generations, later 10, before the rater is asked again."
)


SHORT = {
    "ratings to the common level": "ratings, common level",
    "generations to the common level": "generations",
    "ratings to the usual method's end": "ratings, its end",
    "reached the usual method's end": "reached",
    "liked in the end": "liked",
    "generations rated by the network": "by the network",
}
"""Columns of a table in a page."""


def page_lines(records: Sequence[Record]) -> Iterator[str]:
    """The same for a page, with fewer columns."""
    kept = [row for row in records if row["metric"].split(", ", 1)[0] in SHORT]
    yield from markdown_lines(kept, SHORT)


def markdown_lines(
    records: Sequence[Record], heads: Mapping[str, str] | None = None
) -> Iterator[str]:
    """A table a case: a row a method, a column a figure."""
    yield NOTE
    for case in dict.fromkeys(row["case"] for row in records):
        rows = [row for row in records if row["case"] == case]
        pairs = [(*row["metric"].split(", ", 1), row) for row in rows]
        metrics = list(dict.fromkeys(metric for metric, _, _ in pairs))
        yield ""
        told = [(heads or {}).get(metric, metric) for metric in metrics]
        yield f"| {case}, {rows[0]['runs']} | {' | '.join(told)} |"
        yield "|---" * (len(metrics) + 1) + "|"
        for name in dict.fromkeys(name for _, name, _ in pairs):
            cells = [show_cell(row) for _, other, row in pairs if other == name]
            yield f"| `{name}` | {' | '.join(cells)} |"


def show_cell(row: Record) -> str:
    """A mean with half its interval; ≈ before what is not told apart.

    >>> row = {"ours": 12.34, "half": 3.0, "told_apart": False, "metric": "ratings, vp"}
    >>> show_cell(row | {"baseline_name": "tiga", "runs": 10})
    '≈ 12.3 ± 3.0'
    """
    if row["metric"].startswith("reached"):
        return f"{round(row['ours'] * row['runs'])} of {row['runs']}"
    same = row["metric"].endswith(f", {row['baseline_name']}") or row["told_apart"]
    digits = 2 if row["metric"].startswith("liked") else 1
    return f"{'' if same else '≈ '}{row['ours']:.{digits}f} ± {row['half']:.{digits}f}"
