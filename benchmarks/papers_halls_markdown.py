"""The records of :mod:`.papers_halls` as tables of Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

Row = dict[str, Any]
COLUMNS = (
    ("aesthetic", "aesthetic", ".4f"),
    ("uniformity", "uniformity", ".3f"),
    ("circulation", "circulation, m", ".1f"),
    ("excess", "above floor", ".1f"),
    ("seconds", "s", ".2f"),
)
"""Figure, heading, how it is written."""
VALID = "valid and complete"


def markdown_lines(told: list[Row]) -> Iterator[str]:
    """One table a hall, then what else the records say."""
    for case in dict.fromkeys(row["case"] for row in told if row["metric"] == VALID):
        yield from measures_table(case, [row for row in told if row["case"] == case])
        yield ""
    yield from forms_tables(row for row in told if row["metric"].startswith("E_"))


def measures_table(case: str, told: list[Row]) -> Iterator[str]:
    """The three measures of one hall; figures of methods without a valid run in italics."""
    valid = {row["baseline_name"]: row for row in told if row["metric"] == VALID}
    heads = ["valid", *(head for _, head, _ in COLUMNS), "layouts"]
    yield f"| {case.removeprefix('sample:hall-')} | {' | '.join(heads)} |"
    yield "|---" * (len(heads) + 1) + "|"
    for method, share in valid.items():
        names = (method, f"{method}, no valid run")
        mine = {row["metric"]: row for row in told if row["baseline_name"] in names}
        slant = "*" if any(row["baseline_name"] == names[1] for row in mine.values()) else ""
        cells = [_cell(mine.get(name), form, slant) for name, _, form in COLUMNS]
        name = "**ours**" if method == "default" else method
        yield (
            f"| {name} | {share['baseline']:.0%} | {' | '.join(cells)} | {share['layouts']:,d} |"
        )
    verdicts = [row for row in told if row["metric"].endswith("no worse than")]
    yield ""
    yield "No worse than: " + "; ".join(map(_verdict, verdicts)) + "."


def _verdict(row: Row) -> str:
    """What a measure says of ours against all others together."""
    measure = row["metric"].partition(":")[0]
    return f"{measure}, {row['ours']:.0f} of {row['baseline']} {row['baseline_name']}"


def _cell(row: Row | None, form: str, slant: str) -> str:
    return "" if row is None else f"{slant}{row['baseline']:{form}}{slant}"


def forms_tables(told: Iterable[Row]) -> Iterator[str]:
    """Eqs. 1 and 3 repaired and as printed, a line for each widening of the gaps."""
    found: dict[tuple[str, str], dict[str, Row]] = {}
    for row in told:
        name, gaps = row["metric"].split(", ")
        found.setdefault((row["case"], gaps), {})[name] = row
    if found:
        yield "| hall | gaps | E_s repaired | E_s printed | E_u repaired | E_u printed |"
        yield "|---|---|---|---|---|---|"
    for (case, gaps), pair in found.items():
        cells = [
            f"{pair[name][side]:.4g}" for name in ("E_s", "E_u") for side in ("ours", "baseline")
        ]
        yield f"| {case.removeprefix('sample:hall-')} | {gaps} | {' | '.join(cells)} |"
