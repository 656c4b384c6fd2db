"""The records of :mod:`.papers_halls` as tables of Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from benchmarks.papers_halls_measures import BEST, BETTER, UNHUNG
from benchmarks.papers_halls_scenes import SCENES

Row = dict[str, Any]
COMPARED = ("by hand", "merrell", "miqp", "paper", "paper-repaired", "default")
"""The methods of table 2, and ours."""
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
    """Tables 1 and 2 of the paper, one table a hall, then what else the records say."""
    yield from scale_table(told)
    yield ""
    yield from scenes_table(told)
    yield ""
    for case in dict.fromkeys(row["case"] for row in told if row["metric"] == VALID):
        yield from measures_table(case, [row for row in told if row["case"] == case])
        yield ""
    yield from ablation_table(row for row in told if " by " in row["case"])
    yield ""
    yield from lists_table(row for row in told if row["case"].startswith("requirement list"))
    yield ""
    yield from forms_tables(row for row in told if row["metric"].startswith("E_"))


def scale_table(told: list[Row]) -> Iterator[str]:
    """Table 1: how much each scene holds, and the seconds that the paper's preset and ours take."""
    yield "| scene | objects | walls built | s, paper | s, ours |"
    yield "|---|---|---|---|---|"
    for share in (row for row in told if row["metric"] == VALID and _is(row, "default")):
        mine = [r for r in told if r["case"] == share["case"] and r["metric"] == "seconds"]
        paper, ours = (
            next((f"{r['baseline']:.2f}" for r in mine if _is(r, name)), "")
            for name in ("paper", "default")
        )
        size = f"{share['objects']:.0f} | {share['walls']:g}"
        yield f"| {_case(share)} | {size} | {paper} | {ours} |"


def scenes_table(told: list[Row]) -> Iterator[str]:
    """Table 2: the three measures and the seconds of the three kinds of scene by the methods that
    the paper compares, and drawn by hand."""
    yield "| scene | method | valid | aesthetic | uniformity | circulation, m | s |"
    yield "|---|---|---|---|---|---|---|"
    for case, method in ((case, method) for case in SCENES for method in COMPARED):
        mine = {r["metric"]: r for r in told if r["case"] == case and _is(r, method)}
        if VALID in mine:
            slant = "*" if any("no valid run" in r["baseline_name"] for r in mine.values()) else ""
            cells = [_cell(mine.get(n), form, slant) for n, _, form in COLUMNS if n != "excess"]
            share = f"{mine[VALID]['baseline']:.0%}"
            yield f"| {SCENES[case]} | {_method(method)} | {share} | {' | '.join(cells)} |"


def _is(row: Row, method: str) -> bool:
    return bool(row["baseline_name"].removesuffix(", no valid run") == method)


def _method(name: str) -> str:
    return "**ours**" if name == "default" else name


def _case(row: Row) -> str:
    return str(row["case"]).removeprefix("sample:hall-")


def measures_table(case: str, told: list[Row]) -> Iterator[str]:
    """The three measures of one hall; figures of methods without a valid run in italics."""
    valid = {row["baseline_name"]: row for row in told if row["metric"] == VALID}
    heads = ["valid", *(head for _, head, _ in COLUMNS), "layouts"]
    yield f"| {case.removeprefix('sample:hall-')} | {' | '.join(heads)} |"
    yield "|---" * (len(heads) + 1) + "|"
    for method, share in valid.items():
        mine = {row["metric"]: row for row in told if _is(row, method)}
        slant = "*" if any("no valid run" in row["baseline_name"] for row in mine.values()) else ""
        cells = [_cell(mine.get(name), form, slant) for name, _, form in COLUMNS]
        yield (
            f"| {_method(method)} | {share['baseline']:.0%} | {' | '.join(cells)} "
            f"| {share['layouts']:,.0f} |"
        )
    verdicts = [row for row in told if row["metric"].endswith("no worse than")]
    yield ""
    yield "No worse than: " + "; ".join(map(_verdict, verdicts)) + "."
    for row in (row for row in told if row["metric"] == BEST):
        least = f"{row['baseline']:.1f} of {row['baseline_name']}"
        yield f"Above floor: {row['ours']:.1f}, and {least}."
    yield from _unhung(told)


def _unhung(told: list[Row]) -> Iterator[str]:
    """What the table would say if what hangs needed no wall, where that changes who is valid."""
    rows = [row for row in told if row["metric"].endswith(f", {UNHUNG}")]
    there = [row for row in rows if "no worse than" not in row["metric"]]
    for method in dict.fromkeys(row["baseline_name"] for row in there):
        mine = {r["metric"].partition(",")[0]: r for r in there if r["baseline_name"] == method}
        figures = [f"{n} {mine[n]['baseline']:{form}}" for n, _, form in COLUMNS if n in BETTER]
        runs = f"{next(iter(mine.values()))['runs']} valid runs"
        yield f"If what hangs needed no wall, {method} would have {runs}: {', '.join(figures)}."
    verdicts = [row for row in rows if "no worse than" in row["metric"]]
    if verdicts:
        yield "No worse then: " + "; ".join(map(_verdict, verdicts)) + "."


def _verdict(row: Row) -> str:
    """What a measure says of ours against all others together."""
    measure = row["metric"].partition(":")[0]
    return f"{measure}, {row['ours']:.0f} of {row['baseline']} {row['baseline_name']}"


def _cell(row: Row | None, form: str, slant: str) -> str:
    return "" if row is None else f"{slant}{row['baseline']:{form}}{slant}"


def ablation_table(told: Iterable[Row]) -> Iterator[str]:
    """Each hall and solver: the figure of every energy, with all weights and without its own."""
    found: dict[str, list[Row]] = {}
    for row in told:
        found.setdefault(row["case"], []).append(row)
    if found:
        yield "| hall | by | walls | covered | in use | passage | gap |"
        yield "|---|---|---|---|---|---|---|"
    for case, rows in found.items():
        hall, _, solver = case.removeprefix("sample:hall-").rpartition(" by ")
        *four, walls = rows
        shares = [f"{row['ours']:.0%} → {row['baseline']:.0%}" for row in four[:2]]
        ratios = [f"{row['ours']:.2f} → {row['baseline']:.2f}" for row in four[2:]]
        yield f"| {hall} | {solver} | {walls['ours']:g} | {' | '.join(shares + ratios)} |"


def lists_table(told: Iterable[Row]) -> Iterator[str]:
    """One outline with several requirement lists."""
    found: dict[str, dict[str, Row]] = {}
    for row in told:
        found.setdefault(row["case"].partition(", ")[2], {})[row["metric"]] = row
    if found:
        yield "| requirement list | objects | valid | walls | s |"
        yield "|---|---|---|---|---|"
    for name, row in found.items():
        held, valid, walls, seconds = (
            row[key]["ours"] for key in ("objects", "valid", "walls", "seconds")
        )
        yield f"| {name} | {held:g} | {valid:.0%} | {walls:.2g} | {seconds:.2f} |"


def forms_tables(told: Iterable[Row]) -> Iterator[str]:
    """Eqs. 1 and 3 repaired and as printed, a line for each widening of the gaps."""
    found: dict[tuple[str, str], dict[str, Row]] = {}
    for row in told:
        name, gaps = row["metric"].split(", ")
        found.setdefault((row["case"], gaps), {})[name] = row
    if found:
        yield "| hall | gaps | E_s repaired | E_s printed | E_u repaired | E_u printed |"
        yield "|---|---|---|---|---|---|"
    for (_, gaps), pair in found.items():
        cells = [
            f"{pair[name][side]:.4g}" for name in ("E_s", "E_u") for side in ("ours", "baseline")
        ]
        yield f"| {_case(pair['E_s'])} | {gaps.removeprefix('gaps ')} | {' | '.join(cells)} |"
