"""Zones cut into rectangular blocks, one for each group: the coarse level of Wu et al. 2018.

Everything is measured along the main direction of the zone, in whole units of 0.1 m; what of the
zone's bounds is not free floor is covered by rectangles, so that slanted and curved sides become
stairs on the safe side. Wu et al. state a mixed integer quadratic programme; the same model (areas
are products of widths and heights) goes to the constraint solver CP-SAT here.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Event, Thread
from typing import Any, NamedTuple

import numpy as np
import shapely
import shapely.affinity
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.engine.solve import Cancel

Floats = NDArray[np.float64]
UNIT = 0.1
STAIR = 3
"""Height of the stairs that stand for slanted sides, in units."""
POLL = 0.02
"""Seconds between looks at whether a search is still waited for."""


class ZoneFrame(NamedTuple):
    """A zone along its main direction ``angle``: origin ``x``, ``y`` in turned axes, width and
    height in units, and the rectangles x0, y0, x1, y1 that are not free."""

    angle: float
    x: float
    y: float
    width: int
    height: int
    taken: tuple[tuple[int, int, int, int], ...]


class Option(NamedTuple):
    """One way to subdivide a block: columns, rows, turned by a quarter or not, and the least
    width and height in units."""

    columns: int
    rows: int
    turned: bool
    width: int
    height: int


class GroupBlock(NamedTuple):
    """A block as cut: lower left corner, width, height in units, and the option taken."""

    x: int
    y: int
    width: int
    height: int
    option: Option


def main_direction(edges: Floats) -> float:
    """The direction, modulo a quarter turn, most of the length of some edges (e, 4) follows.

    >>> round(main_direction(np.array([[0, 0, 4, 4], [4, 4, 2, 6]], float)), 6)
    0.785398
    """
    step = edges[:, 2:] - edges[:, :2]
    way = step[:, 0] + 1j * step[:, 1]
    folded = (way**4 / np.maximum(np.abs(way), 1e-9) ** 3).sum()
    return float(np.angle(folded)) / 4.0 % (math.pi / 2)


def sheet_of(free: Any, angle: float) -> ZoneFrame:
    """The sheet of a free floor (a polygon or several)."""
    turned = shapely.affinity.rotate(free, -angle, (0.0, 0.0), use_radians=True)
    x0, y0, x1, y1 = turned.bounds
    width, height = int((x1 - x0) / UNIT + 1e-6), int((y1 - y0) / UNIT + 1e-6)
    local = shapely.affinity.scale(
        shapely.affinity.translate(turned, -x0, -y0), 1 / UNIT, 1 / UNIT, origin=(0.0, 0.0)
    )
    steps = sorted(_steps(local, height))
    floor = local.buffer(1e-6, join_style="mitre")
    found: list[list[int]] = []
    for low, high in itertools.pairwise(steps):
        missing = shapely.box(0, low, width, high).difference(floor)
        for part in (part for part in shapely.get_parts(missing) if part.area > 1e-6):
            a, _, b, _ = part.bounds
            span = [max(math.floor(a + 1e-6), 0), min(math.ceil(b - 1e-6), width)]
            above = [row for row in found if row[3] == low and [row[0], row[2]] == span]
            if above:
                above[0][3] = high
            elif span[1] > span[0]:
                found.append([span[0], low, span[1], high])
    taken = tuple((a, b, c, d) for a, b, c, d in found)
    return ZoneFrame(angle, x0, y0, width, height, taken)


def _steps(local: Any, height: int) -> set[int]:
    """Where strips begin and end: at level sides, and in stairs along slanted ones."""
    steps, stair = {0, height}, max(STAIR, height // 60)
    for ring in (
        ring for part in shapely.get_parts(local) for ring in (part.exterior, *part.interiors)
    ):
        points = shapely.get_coordinates(ring)
        for (xa, ya), (xb, yb) in itertools.pairwise(points):
            low, high = min(ya, yb), max(ya, yb)
            steps |= {math.floor(low + 1e-6), math.ceil(low - 1e-6)}
            steps |= {math.floor(high + 1e-6), math.ceil(high - 1e-6)}
            if high - low > 1e-6 and abs(xa - xb) > 1e-6:
                steps |= set(range(math.ceil(low), math.floor(high) + 1, stair))
    return {step for step in steps if 0 <= step <= height}


def to_hall(sheet: ZoneFrame, boxes: Floats) -> Floats:
    """Boxes (n, 5) in metres along the sheet, turned and moved into the hall."""
    cos, sin = math.cos(sheet.angle), math.sin(sheet.angle)
    x, y = boxes[:, 0] + sheet.x, boxes[:, 1] + sheet.y
    return np.column_stack(
        [cos * x - sin * y, sin * x + cos * y, boxes[:, 2] + sheet.angle, boxes[:, 3:]]
    )


def solver_module() -> Any:
    """CP-SAT of OR-tools, which the extra ``solve`` installs."""
    try:
        from ortools.sat.python import cp_model
    except ImportError:
        raise InputError(
            "the solver miqp needs the package ortools, which is not installed",
            "install the extra: pip install 'scenewright[solve]'",
        ) from None
    return cp_model


def cut_blocks(
    sheet: ZoneFrame,
    options: list[list[Option]],
    targets: list[float],
    seed: int,
    seconds: float | None,
    cancelled: Cancel,
) -> list[GroupBlock] | None:
    """Blocks of a zone, no two of them overlapping; None if none were found.

    Each takes one of its options and at least its size, and comes as near to its target area
    (square metres) as it can: the sum of what they miss is least. Without ``seconds`` the effort
    is bounded by counted work, so the result depends on the seed alone. When ``cancelled`` answers
    true, what was found so far is the answer.
    """
    cp = solver_module()
    model = cp.CpModel()
    rows = [
        _block_variables(model, sheet, one, target)
        for one, target in zip(options, targets, strict=True)
    ]
    across = [row["along_x"] for row in rows]
    up = [row["along_y"] for row in rows]
    for a, b, c, d in sheet.taken:
        across.append(model.new_fixed_size_interval_var(a, c - a, ""))
        up.append(model.new_fixed_size_interval_var(b, d - b, ""))
    model.add_no_overlap_2d(across, up)
    model.minimize(sum(row["miss"] for row in rows))
    solver = cp.CpSolver()
    solver.parameters.num_workers, solver.parameters.random_seed = 1, seed % 2**31
    solver.parameters.max_deterministic_time = 4.0
    if seconds is not None:
        solver.parameters.max_time_in_seconds = max(seconds, 0.05)
    with stop_when(cancelled, solver.stop_search):
        status = solver.solve(model)
    if status not in (cp.OPTIMAL, cp.FEASIBLE):
        return None
    cut = [[solver.value(row[name]) for name in ("x", "y", "w", "h", "k")] for row in rows]
    return [
        GroupBlock(x, y, w, h, one[k]) for (x, y, w, h, k), one in zip(cut, options, strict=True)
    ]


@contextmanager
def stop_when(cancelled: Cancel, stop: Callable[[], None], every: float = POLL) -> Iterator[None]:
    """Call ``stop`` as soon as ``cancelled`` answers true while the block runs, and again until it
    has ended: a search that has not begun yet does not hear the first call."""
    ended = Event()

    def watch() -> None:
        while not ended.wait(every):
            if cancelled():
                stop()

    thread = Thread(target=watch, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()


def _block_variables(
    model: Any, sheet: ZoneFrame, options: list[Option], target: float
) -> dict[str, Any]:
    """The variables of one block, with what binds them to one of its options."""
    width, height = sheet.width, sheet.height
    x, y = model.new_int_var(0, width, ""), model.new_int_var(0, height, "")
    w, h = model.new_int_var(1, width, ""), model.new_int_var(1, height, "")
    k = model.new_int_var(0, len(options) - 1, "")
    least_w = model.new_int_var(1, width, "")
    least_h = model.new_int_var(1, height, "")
    fitting = [
        (i, o.width, o.height)
        for i, o in enumerate(options)
        if o.width <= width and o.height <= height
    ]
    model.add_allowed_assignments([k, least_w, least_h], fitting or [(-1, 1, 1)])
    model.add(w >= least_w)
    model.add(h >= least_h)
    area = model.new_int_var(1, width * height, "")
    model.add_multiplication_equality(area, [w, h])
    goal = round(target / UNIT**2)
    miss = model.new_int_var(0, width * height + goal, "")
    model.add(miss >= area - goal)
    model.add(miss >= goal - area)
    end_x, end_y = model.new_int_var(0, width, ""), model.new_int_var(0, height, "")
    return {
        "x": x,
        "y": y,
        "w": w,
        "h": h,
        "k": k,
        "miss": miss,
        "along_x": model.new_interval_var(x, w, end_x, ""),
        "along_y": model.new_interval_var(y, h, end_y, ""),
    }
