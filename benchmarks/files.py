"""Scene files: ``scenewright bench files``.

Of every sample, arranged with few steps, the GLB file: kilobytes, draw calls (primitives by the
nodes that draw them), those of bodies that move, triangles drawn, and seconds of the processor to
write it, beside those of version 857482f2, which had plain materials, no ceilings and no parts that
move.
"""

from __future__ import annotations

import json
import struct
import time
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

Record = dict[str, Any]
Progress = Callable[[float, str], None]
STEPS = 300
BEFORE = """
extend-court 583 319 24184
extend-terrace 740 1064 127132
extend-village 747 238 21448
hall-auditorium 151 474 25854
hall-exhibition 259 599 30340
hall-irregular 310 402 23994
hall-reading-room 370 774 56428
hall-shop 245 793 34220
home-acute 1149 299 38876
home-attic 1122 351 38316
home-child 327 74 7332
home-curved 842 229 23878
home-flat 1601 502 49614
home-house 1942 667 64554
home-l-shape 1041 303 29910
home-loft 1082 291 33538
home-room 347 87 7718
home-services 1199 305 33484
home-studio 663 166 17256
site-120 1938 2656 360738
site-30 941 596 79310
site-courtyards 499 675 91118
site-landmarks 1105 1008 143304
site-square 971 628 92302
village-dense 1835 286 44460
village-hamlet 944 283 43646
village-street 1490 476 64388
"""
"""Sample, kilobytes, draw calls and triangles of the version before."""
QUICK = ("home-room", "hall-shop", "site-courtyards")
INSTANCING = "EXT_mesh_gpu_instancing"
COLUMNS = (
    "sample", "KB before", "KB", "draws before", "draws", "of them moving",
    "triangles before", "triangles", "s",
)  # fmt: skip


class FileFigures(NamedTuple):
    """Kilobytes, draw calls, those of bodies that move, and triangles of a file."""

    kilobytes: int
    draws: int
    moving: int
    triangles: int


def figures_of(content: bytes) -> FileFigures:
    """The figures of a GLB file."""
    (size,) = struct.unpack_from("<I", content, 12)
    document = json.loads(content[20 : 20 + size])
    meshes, accessors = document["meshes"], document["accessors"]
    draws = moving = triangles = 0
    for node in (node for node in document["nodes"] if "mesh" in node):
        rows = meshes[node["mesh"]]["primitives"]
        draws += len(rows)
        moving += len(rows) * (node.get("extras", {}).get("category") == "body")
        many = node.get("extensions", {}).get(INSTANCING)
        times = accessors[many["attributes"]["TRANSLATION"]]["count"] if many else 1
        triangles += times * sum(accessors[row["indices"]]["count"] // 3 for row in rows)
    return FileFigures(round(len(content) / 1024), draws, moving, triangles)


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Four records a sample; with ``quick`` of three samples."""
    rows = [line.split() for line in BEFORE.strip().splitlines()]
    rows = [row for row in rows if not quick or row[0] in QUICK]
    for number, (name, *before) in enumerate(rows):
        if progress is not None:
            progress(number / len(rows), name)
        content, seconds = _write(name)
        found = figures_of(content)
        old = (int(before[0]), int(before[1]), 0, int(before[2]))
        for metric, value, was in zip(FileFigures._fields, found, old, strict=True):
            yield _record(name, metric, value, was)
        yield _record(name, "seconds", round(seconds, 2), None)


def _write(name: str) -> tuple[bytes, float]:
    """The second file of a sample, and the seconds of the processor it takes."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of
    from scenewright.formats.glb import encode_scene
    from scenewright.workflow.arrange import arrange

    few = name.startswith(("village", "extend"))
    made = arrange(f"sample:{name}", layouts=1) if few else arrange(f"sample:{name}", steps=STEPS)
    solution = made.solution
    scene, catalog = scene_of(solution), catalog_of(solution.brief.catalogs)
    content, start = b"", 0.0
    for _ in range(2):
        start = time.process_time()
        content = encode_scene(scene, catalog, solution.brief.domain)
    return content, time.process_time() - start


def _record(name: str, metric: str, ours: float, before: float | None) -> Record:
    return {
        "case": name,
        "metric": metric,
        "unit": "s" if metric == "seconds" else "",
        "ours": ours,
        "baseline": before,
        "baseline_name": "" if before is None else "857482f2",
        "ratio": round(ours / before, 2) if before else None,
        "runs": 1,
    }


def markdown_lines(found: Iterable[Record]) -> list[str]:
    """The table, a row a sample."""
    rows: dict[str, dict[str, Record]] = {}
    for record in found:
        rows.setdefault(record["case"], {})[record["metric"]] = record
    lines = [f"| {' | '.join(COLUMNS)} |", "|---|" + "---:|" * (len(COLUMNS) - 1)]
    for name, row in rows.items():
        cells: list[Any] = [f"`{name}`"]
        for metric in ("kilobytes", "draws", "moving", "triangles", "seconds"):
            if metric in row:
                was = [] if metric in ("moving", "seconds") else [row[metric]["baseline"]]
                cells += [*was, row[metric]["ours"]]
        lines.append(f"| {' | '.join(map(str, cells))} |")
    return lines
