"""Our default: the shipped samples with many seeds, and sites of 120 to 6000 buildings.

Every answer is judged by the referee: overlaps, what lies outside, blocked ways. Sites grow at one
density (:mod:`.site_scenes`), with a distance behind buildings for the sun. Seconds are of the
wall and of the processor, which a busy machine does not stretch.
"""

from __future__ import annotations

import resource
import statistics
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

from benchmarks.comparison import ratio
from benchmarks.hall_scale import growth
from benchmarks.site_scenes import scene_brief
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.site.solving import solve
from scenewright.formats import read, samples, write

Row = dict[str, Any]
SIZES = (120, 1000, 6000)
DENSITY, SUN = 0.5, 0.8
LIMIT = 1.0
"""Seconds 120 buildings may take."""
FILES = ("glb", "svg", "geojson", "json")
TIMES = ("seconds", "cpu", "judging", "dressing and writing")


def sites() -> list[str]:
    """Names of the shipped samples of sites."""
    return [name for name in samples() if name.startswith("sample:site-")]


def run(brief: Brief, seed: int) -> Row:
    """One site solved and judged: counts of what is wrong, and seconds."""
    begun, used = time.perf_counter(), time.process_time()
    solution = solve(brief, seed=seed)
    took, used = time.perf_counter() - begun, time.process_time() - used
    begun = time.process_time()
    report = check(solution)
    judging = time.process_time() - begun
    kinds = Counter(finding.kind for finding in report.findings)
    figures = next(iter(report.figures["sites"].values()))
    return {
        "overlaps": kinds["collision"],
        "outside": kinds["out_of_bounds"],
        "blocked": kinds["blocked_path"] + kinds["unreachable_building"],
        "near": kinds["setback"] + kinds["spacing"],
        "valid": float(report.valid),
        "left_out": len(solution.left_out),
        "sun": figures["sun_mean"],
        "buildings": figures["buildings"],
        "seconds": took,
        "cpu": used,
        "judging": judging,
        "solution": solution,
    }


def samples_records(seeds: int, names: list[str] | None = None) -> list[Row]:
    """Every sample with so many seeds: sums of what is wrong, medians of seconds."""
    found = []
    for name in names or sites():
        brief = read(name)
        run(brief, 0)
        rows = [run(brief, seed) for seed in range(seeds)]
        for key in ("overlaps", "outside", "blocked", "near", "left_out"):
            found.append(_record(name, key, "1", sum(row[key] for row in rows), 0, seeds))
        valid = statistics.fmean(row["valid"] for row in rows)
        found.append(_record(name, "valid", "share", valid, 1.0, seeds))
        for key in ("seconds", "cpu"):
            median = statistics.median(row[key] for row in rows)
            aim = LIMIT if name == "sample:site-120" else None
            found.append(_record(name, key, "s", median, aim, seeds))
    return found


def scale_records(sizes: tuple[int, ...] = SIZES, runs: int = 3) -> list[Row]:
    """Growing sites: seconds of solving, judging and writing, and how they grow, validity and the
    most memory this process has held."""
    run(scene_brief(sizes[0], DENSITY, SUN), 0)
    found, medians = [], {key: list[float]() for key in TIMES}
    for size in sizes:
        brief, case = scene_brief(size, DENSITY, SUN), f"{size} buildings"
        rows = [run(brief, seed) | {"size": size} for seed in range(runs if size < 6000 else 1)]
        for row in rows:
            row["dressing and writing"] = writing(row["solution"])
        for key in TIMES:
            medians[key].append(statistics.median(row[key] for row in rows))
            found.append(_record(case, key, "s", medians[key][-1], None, len(rows)))
        for key in ("overlaps", "outside", "blocked", "near", "left_out"):
            found.append(_record(case, key, "1", sum(row[key] for row in rows), 0, len(rows)))
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
        found.append(_record(case, "most memory", "MB", most, None, len(rows)))
    if len(sizes) > 1:
        scales = [float(size) for size in sizes]
        found += [
            _record(
                "all sizes",
                f"{key}, growth exponent",
                "1",
                growth(scales, medians[key]),
                1.0,
                len(sizes),
            )
            for key in TIMES
        ]
    return found


def writing(solution: Any) -> float:
    """Processor seconds of writing a solution as scene, plan, map and record."""
    begun = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        for suffix in FILES:
            write(solution, Path(folder) / f"site.{suffix}")
    return time.process_time() - begun


def _record(case: str, metric: str, unit: str, ours: float, aim: float | None, runs: int) -> Row:
    """A figure beside its aim, if there is one, and how many times better than the aim it is."""
    return {
        "case": case,
        "metric": metric.replace("_", " "),
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": aim,
        "baseline_name": "" if aim is None else "aim",
        "ratio": ratio(ours, aim, unit),
        "runs": runs,
    }
