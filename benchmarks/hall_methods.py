"""Halls by every method on the same briefs: judged, measured, timed; and our time to quality.

Each run is one row of plain values; :func:`summary` takes medians. Timings are of warm kernels.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import Any

from benchmarks.comparison import figure, record
from benchmarks.hall_measure import energies_of, own_energy
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.hall.desks.chairs import DESK_CHAIRS
from scenewright.domains.hall.seats.chairs import CHAIRS
from scenewright.domains.hall.solving import solve
from scenewright.formats import read, samples

Row = dict[str, Any]
Progress = Callable[[float, str], None]
METHODS: dict[str, dict[str, Any]] = {
    "default": {},
    "paper": {"preset": "paper"},
    "gd-mh with our weights": {"solver": "gd-mh"},
    "miqp": {"solver": "miqp"},
    "merrell": {"solver": "merrell"},
    "random": {"solver": "random"},
    "ga": {"solver": "ga"},
}
LIMIT = 0.5
"""Seconds our default gets against the paper's 1000 iterations."""
FIGURES = (
    ("valid", "share"),
    ("overlaps", "1"),
    ("outside", "1"),
    ("narrow", "1"),
    ("other", "1"),
    ("left_out", "1"),
    ("aesthetic", "1"),
    ("uniformity", "1"),
    ("circulation", "m"),
    ("energy", "1"),
    ("own_energy", "1"),
    ("seconds", "s"),
)
SHARES = ("valid", "overlaps", "outside", "narrow", "other", "left_out")
"""Figures that are means over the runs; all others are medians."""
PRINTED = "paper, 1000 iterations"


def halls() -> list[str]:
    """Names of the shipped samples of halls."""
    return [name for name in samples() if name.startswith("sample:hall-")]


def judged(solution: Solution) -> Row:
    """What the referee and the common measure say of a solution with one hall."""
    report = check(solution)
    found = [finding for finding in report.findings if not finding.given]
    kinds = [finding.kind for finding in found]
    outside = kinds.count("out_of_bounds") + kinds.count("outside_zone")
    narrow, overlaps = kinds.count("narrow_passage"), kinds.count("collision")
    figures = next(iter(report.figures["halls"].values()))
    energies = energies_of(solution)
    return {
        "valid": float(report.valid),
        "overlaps": overlaps,
        "outside": outside,
        "narrow": narrow,
        "no_wall": kinds.count("no_wall"),
        "other": len(kinds) - outside - narrow - overlaps,
        "faults": len(kinds),
        "left_out": len(solution.left_out),
        "aesthetic": figures["aesthetic"],
        "uniformity": figures["uniformity"],
        "circulation": figures["circulation"],
        "energy": energies.total,
        "least": energies.least,
        "space": energies.space,
        "fill": energies.fill,
        "access": energies.access,
        "proportion": energies.proportion,
        "own_energy": own_energy(solution),
        "pieces": count_pieces(solution),
        "seconds": solution.seconds,
        "told": [finding.message for finding in found][:6],
    }


def count_pieces(solution: Solution) -> int:
    """The pieces of a hall without the chairs that come with desks, which no method places."""
    desks, kinds = (
        {row.category for row in DESK_CHAIRS},
        {p.id: p.category for p in solution.pieces},
    )
    return sum(
        not piece.function.endswith(CHAIRS) or kinds.get(piece.id.rpartition("/")[0]) not in desks
        for piece in solution.pieces
    )


def run(name: str, method: str, seed: int, brief: Brief | None = None, **more: Any) -> Row:
    """One hall by one method: a row."""
    solution = solve(brief or read(name), seed=seed, **METHODS[method], **more)
    return {"case": name, "method": method, "seed": seed} | judged(solution)


def methods() -> list[str]:
    """The methods that can run here: MIQP needs the extra ``solve``."""
    found = importlib.util.find_spec("ortools") is not None
    return [name for name in METHODS if found or name != "miqp"]


def rows(seeds: int, cases: list[str] | None = None, progress: Progress | None = None) -> list[Row]:
    """Every sample by every method with so many seeds."""
    chosen, found = cases or halls(), []
    for k, case in enumerate(chosen):
        for j, method in enumerate(methods()):
            run(case, method, 0)
            found += [run(case, method, seed) for seed in range(seeds)]
            if progress:
                progress((k + (j + 1) / len(methods())) / len(chosen), f"{case}: {method}")
    return found


def summary(found: list[Row]) -> list[Row]:
    """Records: our default against each other method, by sample and figure."""
    records: list[Row] = []
    for case in dict.fromkeys(row["case"] for row in found):
        mine = [row for row in found if row["case"] == case]
        ours = [row for row in mine if row["method"] == "default"]
        for method in dict.fromkeys(row["method"] for row in mine):
            theirs = [row for row in mine if row["method"] == method]
            if method != "default":
                records += [
                    record(case, name, unit, ours, theirs, method, SHARES) for name, unit in FIGURES
                ]
    return records


def quality(seeds: int, cases: list[str] | None = None) -> list[Row]:
    """The paper's four energies: median after its 1000 iterations against ours after half a
    second of work, and how many of the seeds are at least as good.

    Three comparisons: our default by the common measure, our default as both solvers count their
    own groups, and our solver on the very problems of the paper's preset.
    """
    return [record for case in cases or halls() for record in _quality(case, seeds)]


def _quality(case: str, seeds: int) -> list[Row]:
    brief = read(case)
    ways: dict[str, Row] = {
        "paper": {"preset": "paper"},
        "default": {"seconds": LIMIT},
        "same": {"preset": "paper", "solver": "anneal", "seconds": LIMIT},
    }
    runs: dict[str, list[Row]] = {}
    for name, options in ways.items():
        solve(brief, seed=0, **options)
        runs[name] = [judged(solve(brief, seed=seed, **options)) for seed in range(seeds)]
    return [
        *_against_paper(case, "default, common measure", "energy", runs["default"], runs["paper"]),
        *_against_paper(case, "default, own groups", "own_energy", runs["default"], runs["paper"]),
        *_against_paper(
            case, "our solver, the paper's problem", "own_energy", runs["same"], runs["paper"]
        ),
        _count(case, f"valid in {LIMIT} s", sum(r["valid"] for r in runs["default"]), seeds),
        record(case, "seconds", "s", runs["default"], runs["paper"], PRINTED, SHARES),
    ]


def _against_paper(
    case: str, what: str, name: str, ours: list[Row], theirs: list[Row]
) -> list[Row]:
    """Energies of runs against the paper's, their medians and seed by seed."""
    bar = figure(theirs, name, SHARES) * (1.0 + 1e-9)
    better = sum(row[name] <= bar for row in ours)
    paired = sum(a[name] <= b[name] * (1.0 + 1e-9) for a, b in zip(ours, theirs, strict=True))
    return [
        record(case, name, "1", ours, theirs, PRINTED, SHARES)
        | {"metric": f"energy in {LIMIT} s: {what}"},
        _count(case, f"no worse than the paper's median: {what}", better, len(ours)),
        _count(case, f"no worse than the paper seed by seed: {what}", paired, len(ours)),
    ]


def _count(case: str, metric: str, number: float, of: int) -> Row:
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": float(number),
        "baseline": of,
        "baseline_name": "all",
        "ratio": number / of,
        "runs": of,
    }
