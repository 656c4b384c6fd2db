"""The manifest of a set of scenes: a JSON line a scene, and the same as Parquet.

A line names plan (by its hash) and split, seed and look, version, what the referee found, on what
terms the models may be used, and every file with its size and digest. Splits are by plan: all homes
and looks of one plan are in the same.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any

from scenewright.batch.jobs import MANIFEST, Job
from scenewright.batch.table import FAILED, ResultRow
from scenewright.core.atomic_file import atomic_write
from scenewright.core.errors import InputError
from scenewright.core.extras import install_line, is_installed
from scenewright.formats import suffix_of
from scenewright.workflow.looks import describe_look
from scenewright.workflow.manifest import plan_hash, split_of

if TYPE_CHECKING:
    from scenewright.core.report import Report
    from scenewright.core.solution import Solution
    from scenewright.workflow.looks import Look

PARQUET = "manifest.parquet"


def describe_scene(solution: Solution, report: Report, look: Look) -> dict[str, Any]:
    """What is known of a scene once it is arranged: plan, split, seed, look, score sheet, terms."""
    from scenewright.catalog.credits import credits_of_solution
    from scenewright.catalog.loading import catalog_of

    digest = plan_hash(solution.brief)
    used = credits_of_solution(solution, catalog_of(solution.brief.catalogs))
    return {
        "plan": digest,
        "split": split_of(digest),
        "domain": solution.brief.domain,
        "seed": solution.seed,
        "look": {"number": look.number, **describe_look(solution)},
        "version": solution.version,
        "score": _score(solution, report),
        "licences": sorted({row.licence for row in used}),
    }


def _score(solution: Solution, report: Report) -> dict[str, Any]:
    """The referee's verdict, what it found by kind, its figures that are one number each, and how
    much stands."""
    found = Counter(finding.kind for finding in report.findings if finding.is_blamed)
    spaces = report.figures.get("rooms", {})
    area = sum(room.get("area", 0.0) for room in spaces.values())
    return {
        "valid": report.valid,
        "complete": report.complete,
        "violations": dict(found),
        "notes": len(report.notes),
        "pieces": len(solution.pieces),
        "left_out": sum(out.required for out in solution.left_out),
        "optional_left_out": sum(not out.required for out in solution.left_out),
        "spaces": len(spaces),
        "area": round(float(area), 2),
        "evaluations": solution.evaluations,
    }


def list_files(name: str, paths: Sequence[Path]) -> list[dict[str, Any]]:
    """The results of a scene, by their names below the folder of the set, with size and BLAKE2b
    digest of 16 bytes (``b2sum -l 128``)."""
    from scenewright.batch.ledger import measure_file

    listed = []
    for path in paths:
        size, digest = measure_file(path)
        place = {"file": place_of(name, path), "format": suffix_of(path)}
        listed.append({**place, "bytes": size, "blake2b": digest})
    return listed


def place_of(name: str, path: Path) -> str:
    """The name of a result below the folder of its set, of a scene of some name.

    >>> place_of("old/flat-1", Path("/tmp/set/old/flat-1.glb"))
    'old/flat-1.glb'
    """
    return str(PurePosixPath(name).parent / path.name)


def manifest_line(job: Job, row: ResultRow) -> dict[str, Any]:
    """A scene's line: its name, the file it is made of, and what is known of it."""
    return {"scene": job.name, "brief": row.file, "status": row.status, **row.facts}


def write_manifest(folder: Path, lines: Iterable[Mapping[str, Any]], parquet: bool) -> None:
    """Write the manifest of a folder of results, and with ``parquet`` the same as a table."""
    rows = [*lines]
    text = "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows)
    try:
        with atomic_write(folder / MANIFEST, own=True) as partial:
            partial.write_text(text, encoding="utf-8", errors="backslashreplace")
        if parquet and rows:
            with atomic_write(folder / PARQUET, own=True) as partial:
                _write_parquet(partial, rows)
    except OSError as error:
        fault = f"cannot be written into: {error.strerror or error}"
        raise InputError(fault, "choose another folder", file=str(folder)) from None


def check_parquet() -> None:
    """Raise :class:`InputError` where tables cannot be written as Parquet."""
    if not is_installed("pyarrow"):
        raise InputError("--parquet needs pyarrow", f"{install_line('pyarrow')}, or leave it out")


def _write_parquet(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Rows as a table; what differs in keys from row to row (a look, violations) is JSON in it."""
    from pyarrow import Table, parquet

    flat = [
        {
            **row,
            **{
                key: json.dumps(row[key], ensure_ascii=False)
                for key in ("look", "score")
                if key in row
            },
            **{name: row["score"][name] for name in ("valid", "complete", "pieces", "area")},
        }
        for row in rows
    ]
    parquet.write_table(Table.from_pylist(flat), path)


def is_listed(row: ResultRow) -> bool:
    """Whether a row is a scene: what failed has no line."""
    return row.status != FAILED
