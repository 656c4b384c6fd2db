"""The records of :mod:`.papers_halls_equal` as tables."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

Row = dict[str, Any]
OURS = "default"
HEADS = {
    "valid": ("valid", ".0%"),
    "aesthetic": ("aesthetic", ".4f"),
    "uniformity": ("uniformity", ".3f"),
    "circulation": ("circulation, m", ".1f"),
    "excess": ("above floor", ".1f"),
    "seconds": ("s", ".2f"),
    "runs": ("of", ".1f"),
}
MEASURES = {"aesthetic": 1.0, "uniformity": -1.0, "circulation": -1.0}
"""The measures, and whether more or less is better."""
PAPER = ("paper", "paper-repaired", "paper-strict")


def markdown_lines(told: Sequence[Row]) -> Iterator[str]:
    """Every method, equality and pick, then the verdict."""
    yield from _lines(told, lambda _key: True)


def page_lines(told: Sequence[Row]) -> Iterator[str]:
    """The same for a page: what the referee takes at equal time, and of the paper's presets what
    their own energy takes, the best, and what is taken at equal layouts."""
    more = {f"{name}, equal seconds, best" for name in PAPER[:2]}
    more |= {OURS, "paper, equal seconds, own", "paper, equal layouts, referee"}
    yield from _lines(told, lambda key: key in more or key.endswith(", equal seconds, referee"))


def _lines(told: Sequence[Row], wanted: Any) -> Iterator[str]:
    yield "| method, equal to ours, taken by | " + " | ".join(h for h, _ in HEADS.values()) + " |"
    yield "|---" * (len(HEADS) + 1) + "|"
    for case in dict.fromkeys(row["case"] for row in told):
        mine = [row for row in told if row["case"] == case]
        hall = case.removeprefix("sample:hall-")
        for key in filter(wanted, dict.fromkeys(row["baseline_name"] for row in mine)):
            rows = {row["metric"]: row for row in mine if row["baseline_name"] == key}
            cells = [f"{rows[name]['baseline']:{form}}" for name, (_, form) in HEADS.items()]
            name = "**ours**" if key == OURS else key.replace(", equal", " ·").replace(",", " ·")
            yield f"| {hall}: {name} | {' | '.join(cells)} |"
    yield ""
    yield "| verdict on ours | | |"
    yield "|---|---|---|"
    yield f"| all runs valid and complete | {count_valid(told)} | |"
    yield f"| energy no higher than the best of the paper's at equal time | {count_lower(told)} | |"
    told_worse = "a measure worse than that of the paper's, by the referee at equal time"
    yield f"| {told_worse} | {list_worse(told)} |"


def count_valid(told: Sequence[Row]) -> str:
    """In how many halls all runs of ours are valid and complete."""
    rows = [row for row in told if row["baseline_name"] == OURS and row["metric"] == "valid"]
    return f"{sum(r['ours'] == 1.0 for r in rows)} of {len(rows)} halls"


def count_lower(told: Sequence[Row]) -> str:
    """In how many halls the mean energy of ours is no higher than the least of the paper's presets
    at equal time, each seed by the best of its valid runs."""
    names = [f"{name}, equal seconds, best" for name in PAPER]
    rows = [row for row in told if row["metric"] == "excess" and row["baseline_name"] in names]
    least: dict[str, float] = {}
    for row in rows:
        least[row["case"]] = min(row["baseline"], least.get(row["case"], row["baseline"]))
    ours = {row["case"]: row["ours"] for row in rows}
    return f"{sum(ours[case] <= least[case] + 1e-9 for case in ours)} of {len(ours)} halls"


def list_worse(told: Sequence[Row]) -> str:
    """In how many cells a measure of ours is worse, by more than a standard error of the
    difference, than that of a paper's preset; and in which."""
    keys = {f"{name}, equal seconds, referee": name for name in PAPER}
    rows = [row for row in told if row["baseline_name"] in keys and row["metric"] in MEASURES]
    worse = [
        f"{row['case'].removeprefix('sample:hall-')} {row['metric']} ({keys[row['baseline_name']]})"
        for row in rows
        if MEASURES[row["metric"]] * (row["ours"] - row["baseline"]) < -row["error"] - 1e-9
    ]
    return f"{len(worse)} of {len(rows)} cells | {', '.join(worse)}"
