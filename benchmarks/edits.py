"""Changes by hand in all kinds of scenes: ``scenewright bench edits``.

Pieces drawn by a seed are nudged by 0.1 m, put on others, taken away, doubled and given another
size; moves are judged as they are while dragging. Times are processor time; a change is of pieces
of other groups than that which was moved; bytes are those of the JSON that the page of the studio
gets of a nudge.
"""

from __future__ import annotations

import gzip
import json
import random
import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains import adjust, check, plan_of, solve
from scenewright.formats import read
from scenewright.studio.delta import tell_change
from scenewright.studio.drawable import draw, tell_by_key
from scenewright.studio.replies import LEVEL
from scenewright.studio.shapes import Shapes
from scenewright.workflow.editing import edit_pieces
from scenewright.workflow.judging import MoveJudge

Record = dict[str, Any]
Progress = Callable[[float, str], None]
SCENES = ("home-flat", "hall-shop", "site-square", "village-street", "extend-village")
TIMES, QUICK = 10, 2
LIMITS = {
    "edit, p95": 250.0,
    "judged while dragging, p95": 100.0,
    "judged while dragging, median": 20.0,
}
"""Milliseconds that are asked for at most."""
FEW, BYTES, LAYOUT = 5.0, 3000.0, 5000.0
CLOSE: Record = {"separators": (",", ":")}
"""JSON as it is sent, before it is packed."""


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """How long changes take, what else they change, and how much of it is told."""
    for number, name in enumerate(SCENES):
        if progress is not None:
            progress(number / len(SCENES), name)
        yield from measure(name, QUICK if quick else TIMES)


def measure(name: str, times: int) -> Iterator[Record]:
    """One scene; the first of each kind of change is not counted: it compiles."""
    scene, rng = solve(read(f"sample:{name}")), random.Random(name)
    plan, judge, spent = plan_of(scene.brief), MoveJudge(scene), list[float]()
    movable, dragged, nudged, told = list_movable(scene), list[float](), list[int](), list[int]()
    shapes = Shapes()

    def tell(shown: Solution) -> Record:
        return tell_by_key(draw(shown, plan, check(shown, plan=plan, figures=False)), shapes)

    state = tell(scene)
    for _ in range(times + 1):
        one, other = rng.sample(movable, 2)
        near = (one.pose.x + 0.1, one.pose.y)
        started = time.process_time()
        judge.find_new({one.id: (*near, one.pose.heading)})
        dragged.append(time.process_time() - started)
        for edits in (
            {"move": {one.id: near}},
            {"move": {one.id: other.pose[:2]}},
            {"remove": [one.id]},
            {"duplicate": [one.id]},
            {"resize": {one.id: one.size._replace(width=one.size.width * 0.98)}},
        ):
            change = adjust if "move" in edits else edit_pieces
            started = time.process_time()
            try:
                done = change(scene, plan=plan, **edits)
            except InputError:
                continue
            finally:
                spent.append(time.process_time() - started)
            if edits == {"move": {one.id: near}}:
                groups = {p.id: p.group for p in scene.pieces}
                others = [c for c in done.changes if groups.get(c.piece) != one.group]
                nudged.append(len(others))
                told.append(len(json.dumps(tell_change(state, tell(done.solution)), **CLOSE)))
    yield _row(name, "edit, p95", 1000 * float(np.quantile(spent[5:], 0.95)), "ms")
    slow = 1000 * float(np.quantile(dragged[1:], 0.95))
    yield _row(name, "judged while dragging, p95", slow, "ms")
    usual = 1000 * float(np.median(dragged[1:]))
    yield _row(name, "judged while dragging, median", usual, "ms")
    yield _row(name, "changed by a nudge beside its group, most", float(max(nudged)), "pieces")
    yield _row(name, "told of a nudge, median", float(np.median(told)), "bytes")
    text = json.dumps(state["pieces"], **CLOSE).encode()
    yield _row(name, "poses of the layout", float(len(text)), "bytes")
    yield _row(name, "poses of the layout, packed", float(len(gzip.compress(text, LEVEL))), "bytes")


def list_movable(scene: Solution) -> list[Piece]:
    """Furniture, objects of halls, buildings: what is not carried by others."""
    built = [p for p in scene.pieces if p.category == "building"]
    pieces = built or [p for p in scene.pieces if p.on is None]
    unmoved = ("landmark", "partition", "light", "fixed", "stairs")
    return [
        p
        for p in pieces
        if not p.fixed and p.function not in unmoved and not p.function.endswith("/chairs")
    ]


def _row(case: str, metric: str, value: float, unit: str) -> Record:
    size = LAYOUT if "layout" in metric else BYTES
    aim = LIMITS.get(metric) or (FEW if unit == "pieces" else size)
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(value, 1),
        "baseline": aim,
        "baseline_name": "aim",
        "ratio": round(value / aim, 3),
        "runs": 1,
    }
