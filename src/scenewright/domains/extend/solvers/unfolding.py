"""Growth by the grammar: arrays unfold sideways, and the buildings between them are repeated.

Zhang and Fei (2017, section 1.2): LayoutConstruction → (Front)(Border){Group …}(Back), groups of
features, features of arrays, arrays of elements. How a scene grows by it is not printed. Ours: each
feature that runs along the scene's longer rows is folded, its string stretched to the length of the
ground before it and laid out with its own gaps and setbacks, along streets that bend; a lone
building belongs to the group of the nearest element of such a feature and follows it, or is
repeated as it stands; and the whole layout is repeated across, one scene and one gap between its
features farther each time, the nearest first.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import chain, cycle

import numpy as np
import shapely

from scenewright.domains.extend.problem import ExtendFound, ExtendProblem, Floats, GrownLayout
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.continued_rows import face_street, union_streets
from scenewright.domains.extend.solvers.repair import repair_coverage, take_away
from scenewright.domains.extend.solvers.scene_grammar import SceneGrammar, UnfoldedRow, read_grammar
from scenewright.domains.extend.solvers.single_layout import grow_once
from scenewright.engine.growing import OnGrowth
from scenewright.engine.solve import Budget, Cancel, Progress
from scenewright.geometry.folding import stretch, unfold
from scenewright.ground.buildings.built import from_frames, to_frames
from scenewright.ground.buildings.rows import PASSAGE

BESIDE, STEP = 30.0, 1.0
"""Metres between a row and the ground on which it goes on from its own end; metres an element moves
on where it cannot stand."""


def unfold_area(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """The sources' grammars unfolded into an area; where settings are ``relaxed`` coverage is then
    repaired. One layout."""
    make = partial(_unfold, problem, np.random.default_rng(seed))
    return grow_once(problem, make, budget, progress, cancel)


def _unfold(problem: ExtendProblem, rng: np.random.Generator, on_growth: OnGrowth) -> GrownLayout:
    canvas, pattern = Canvas(problem, on_growth), problem.pattern
    streets = union_streets(problem.roads)
    sources = np.unique(pattern.source).tolist()
    grammars = [read_grammar(problem, source) for source in sources]
    shares = np.array([pattern.weight[pattern.source == source].sum() for source in sources])
    there = np.unique(pattern.source[problem.standing.origin[~problem.standing.inside]]).tolist()
    for shift in _shifts_across(problem, grammars):
        for grammar, source in zip(grammars, sources, strict=True):
            stands = source in there
            if not stands and there:
                continue
            if (
                not there
                and source != sources[int(rng.choice(len(sources), p=shares / shares.sum()))]
            ):
                continue
            _lay_scene(canvas, streets, grammar, shift, stands and shift == 0)
    if problem.settings.relaxed:
        repair_coverage(canvas, rng)
    take_away(canvas)
    return canvas.layout()


def _shifts_across(problem: ExtendProblem, grammars: list[SceneGrammar]) -> list[int]:
    """How many times each layout is moved across, to either side, the nearest first."""
    long = float(np.hypot(*np.subtract(problem.outline.bounds[2:], problem.outline.bounds[:2])))
    away = max(
        float(problem.outline.distance(shapely.Point(grammar.frame[:2]))) for grammar in grammars
    )
    many = int((long + away) / min(g.frame[4] + g.between for g in grammars)) + 1
    return sorted(range(-many, many + 1), key=lambda k: (abs(k), k))


def _lay_scene(
    canvas: Canvas, streets: shapely.Geometry, grammar: SceneGrammar, times: int, stands: bool
) -> None:
    """One layout, moved across ``times`` times: its rows to the ends of the ground, then what else
    is of it, as often as there is room along the rows."""
    frame = grammar.frame
    step = np.array([np.cos(frame[2]), np.sin(frame[2])]) * times * (frame[4] + grammar.between)
    for row in grammar.rows:
        moved = row._replace(frame=row.frame + np.array([*step, 0, 0, 0]))
        for start, length, side in _stretches(canvas, moved, stands):
            _lay_row(canvas, streets, grammar.grouped, moved, (start, length, side))
    if not grammar.others:
        return
    others = np.array(grammar.others)
    boxes = canvas.problem.pattern.boxes[others]
    along = np.array([np.sin(frame[2]), -np.cos(frame[2])]) * (frame[3] + grammar.between)
    bounds = np.array(canvas.problem.outline.bounds)
    many = int(np.hypot(*(bounds[2:] - bounds[:2])) / np.hypot(*along)) + 2
    for j in sorted(range(-many, many + 1), key=abs):
        poses = boxes[:, :3] + np.array([*(step + j * along), 0.0])
        for k in np.flatnonzero(canvas.legal(poses, others)).tolist():
            if canvas.full():
                return
            _add(canvas, poses[k], int(others[k]))


def _stretches(
    canvas: Canvas, row: UnfoldedRow, stands: bool
) -> Iterator[tuple[float, float, int]]:
    """Where a row may be laid: the start along its line, the length of the ground from there, and
    whether it runs to the right (1) or to the left (-1). A row that stands goes on from its own
    end; what is taken up beyond a break in the ground begins at its left."""
    far = 1e4
    deep = row.frame[4]
    strip = from_frames(
        np.array([[-far, -deep], [far, -deep], [far, -0.01], [-far, -0.01]]), row.frame
    )
    ground = shapely.intersection(canvas.problem.outline, shapely.Polygon(strip))
    for part in shapely.get_parts(ground):
        if part.geom_type != "Polygon" or part.area < deep:
            continue
        along = to_frames(shapely.get_coordinates(part), row.frame[None])[:, 0]
        low, high = float(along.min()), float(along.max())
        end, begin = row.frame[3] + row.usual, -row.usual
        if stands and -row.usual <= low - row.frame[3] <= BESIDE:
            yield end, high - end, 1
        elif stands and -row.usual <= -high <= BESIDE:
            yield begin, begin - low, -1
        else:
            yield low, high - low, 1


def _lay_row(
    canvas: Canvas,
    streets: shapely.Geometry,
    grouped: dict[int, tuple[tuple[int, Floats], ...]],
    row: UnfoldedRow,
    stretch_of: tuple[float, float, int],
) -> None:
    """Unfold a row to a length and lay it; where it ends early it begins anew."""
    start, length, side = stretch_of
    symbols = unfold(row.elements)
    pitch = row.frame[3] / max(len(symbols), 1)
    longer = unfold(stretch(row.elements, max(round(length / max(pitch, 1.0)), 1)))
    origins = {symbol: cycle(numbers) for symbol, numbers in row.origins.items()}
    at, last = 0.0, ""
    for symbol in chain(longer[::side], cycle(symbols[::side])):
        if at >= length or canvas.full():
            return
        if symbol == PASSAGE:
            continue
        origin = next(origins[symbol])
        wide = float(canvas.problem.pattern.boxes[origin, 3])
        if last:
            pair = (last, symbol) if side > 0 else (symbol, last)
            at += row.gaps.get(pair, row.usual)
        for more in np.arange(0.0, max(pitch, STEP), STEP).tolist():
            pose = _pose(canvas, streets, row, origin, start + side * (at + more + wide / 2))
            if canvas.legal(pose[None], np.array([origin]))[0]:
                _add_group(canvas, pose, origin, grouped)
                at += more
                break
        at, last = at + wide, symbol


def _pose(
    canvas: Canvas, streets: shapely.Geometry, row: UnfoldedRow, origin: int, along: float
) -> Floats:
    """The pose (3,) of an element with its middle ``along`` metres down the row's line."""
    deep = float(canvas.problem.pattern.boxes[origin, 4])
    spot = from_frames(np.array([along, row.before[origin] - deep / 2]), row.frame)
    return face_street(np.array([*spot, row.frame[2]]), deep, row.setbacks[origin], streets)


def _add_group(
    canvas: Canvas, pose: Floats, origin: int, grouped: dict[int, tuple[tuple[int, Floats], ...]]
) -> None:
    """Build an element, and what is of its group where that can stand."""
    _add(canvas, pose, origin)
    box = np.array([*pose, 1.0, 1.0])
    for number, local in grouped.get(origin, ()):
        _add(canvas, np.array([*from_frames(local[:2], box), pose[2] + local[2]]), number)


def _add(canvas: Canvas, pose: Floats, origin: int) -> None:
    """Build it if it still stands clear of what was built since, and is still wanted."""
    if canvas.room_for(origin) and canvas.legal(pose[None], np.array([origin]))[0]:
        canvas.add(pose, origin, "unfolded")
