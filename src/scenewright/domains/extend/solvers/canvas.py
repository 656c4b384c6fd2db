"""An area while it is filled: its buildings, which may be added, and adding them."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.extend.pattern import GapRules, SourcePattern, pair_kind
from scenewright.domains.extend.prepared import prepared_of
from scenewright.domains.extend.problem import (
    ExtendProblem,
    Floats,
    GrownLayout,
    Indices,
    boxes_at,
    shapes_at,
)
from scenewright.domains.extend.repeats import lattice_shifts
from scenewright.engine.growing import OnGrowth
from scenewright.ground.buildings.built import from_frames

Flags = NDArray[np.bool_]
EDGE = 1e-3
MIX = 1.2
"""How many times as often as in the sources' mix a size may be built."""
SHORT = 0.05
"""The share by which coverage may fall short before sizes and gaps give way."""
TOUCH = 0.005
"""Metres that buildings which touch in the sources may overlap by rounding."""
DEEP = 0.1
"""Metres by which circles within two footprints may overlap before these cannot both stand."""


class Canvas:
    """Buildings as they are added: those that stood first, then copies of buildings of the
    sources. ``boxes`` (n, 5), ``shapes`` (n,) and ``origin`` (n,) are views of what is there.
    ``on_growth`` is called for every building added; where it says so, the area counts as full."""

    def __init__(self, problem: ExtendProblem, on_growth: OnGrowth | None = None) -> None:
        self.problem, self._on_growth, self.stopped = problem, on_growth, False
        standing = problem.standing
        self.first = len(standing.boxes)
        self.count = self.first
        room = max(2 * self.first, 64)
        self._boxes = np.zeros((room, 5))
        self._shapes = np.empty(room, object)
        self._origin = np.zeros(room, np.int64)
        self._circles = np.zeros((room, 3))
        self._within = prepared_of(problem)
        self.how: list[str] = []
        self.alive = np.ones(room, np.bool_)
        self._boxes[: self.first] = standing.boxes
        self._shapes[: self.first] = standing.shapes
        self._origin[: self.first] = standing.origin
        self._circles[: self.first] = self._within.standing
        inside = standing.inside
        self.covered = float(np.asarray(shapely.area(standing.shapes[inside])).sum())
        self.held = int(inside.sum())
        self.reach = max(problem.pattern.gaps) + 1.0
        self.floor = problem.floor.buffer(EDGE, join_style="mitre")
        shapely.prepare(self.floor)
        self.wanted = problem.coverage * problem.outline.area
        self.sizes = size_classes(problem.pattern)
        self.most = _most_of_each(problem, self.sizes, self.wanted)
        self.made = np.zeros(len(self.most), np.int64)
        self.gaps = problem.pattern.gaps
        self._shifts: dict[int, Floats] | None = None

    @property
    def boxes(self) -> Floats:
        """Boxes (n, 5) of all that was ever there."""
        return self._boxes[: self.count]

    @property
    def shapes(self) -> NDArray[np.object_]:
        """Footprints (n,) of all that was ever there."""
        return self._shapes[: self.count]

    @property
    def origin(self) -> Indices:
        """The building of the sources that each is like (n,); -1: none."""
        return self._origin[: self.count]

    @property
    def there(self) -> Flags:
        """Which of them stand (n,)."""
        return self.alive[: self.count]

    def full(self) -> bool:
        """Whether as much is built as is wanted, or nobody waits for more."""
        if self.stopped:
            return True
        if self.problem.number is not None:
            return self.held >= self.problem.number
        return self.covered >= self.wanted * (1 - self.problem.settings.slack)

    def enough(self) -> bool:
        """Whether enough is built: what is missing is within :data:`SHORT`, and no fault."""
        if self.stopped:
            return True
        if self.problem.number is not None:
            return self.held >= self.problem.number
        return self.covered >= self.wanted * (1 - SHORT)

    def shifts(self) -> dict[int, Floats]:
        """The shifts (m, 2) by which each source that stands goes on with itself (once found)."""
        if self._shifts is None:
            pattern, standing = self.problem.pattern, self.problem.standing
            known = np.unique(pattern.source[standing.origin[~standing.inside]]).tolist()
            bounds = self.problem.floor.bounds
            self._shifts = {
                s: lattice_shifts(pattern.boxes[pattern.source == s], pattern.steps[s], bounds)
                for s in known
            }
        return self._shifts

    def loosen(self, share: float, least: int = 0) -> None:
        """Let any number stand of the classes of size from ``least`` on, and as near as a share of
        the sources' least gaps."""
        self.most[least:] = np.iinfo(np.int64).max
        self.gaps = GapRules(*(share * gap for gap in self.problem.pattern.gaps))

    def room_for(self, origin: int, replaced: float = 0.0) -> bool:
        """Whether a copy of a building of the sources is still wanted: the area is not full, and
        holds no more of its size than the sources' mix has. ``replaced`` are square metres that
        go in its place."""
        enough = self.problem.number is not None and self.held >= self.problem.number
        if self.stopped or enough:
            return False
        size = self.sizes[origin]
        if self.made[size] >= self.most[size]:
            return False
        area = float(self.problem.pattern.shapes[origin].area) - replaced
        free = self.wanted * (1 + 4 * self.problem.settings.slack)
        return self.problem.number is not None or self.covered + area <= free

    def legal(
        self, poses: Floats, origin: Indices, skip: int = -1, gaps: GapRules | None = None
    ) -> Flags:
        """Which copies (n,) at poses (n, 3) stand on the floor and as far from all others as in
        the sources, or as ``gaps`` say; ``skip`` is one that does not count."""
        good = self._maybe_legal(poses, origin, skip)
        rows = np.flatnonzero(good)
        if len(rows):
            shapes = shapes_at(self.problem.pattern, poses[rows], origin[rows])
            boxes = boxes_at(self.problem.pattern, poses[rows], origin[rows])
            good[rows] = self.legal_shapes(shapes, boxes, skip, gaps)
        return good

    def _maybe_legal(self, poses: Floats, origin: Indices, skip: int) -> Flags:
        """Which copies (n,) have a circle within their footprint that leaves neither the floor nor
        cuts the circle of another building deeply: of all others it is known at once."""
        local = self._within.circles[origin]
        circles = self._place_circles(local, poses)
        good = np.asarray(shapely.contains_xy(self.floor, circles[:, 0], circles[:, 1]))
        rows, there = np.flatnonzero(good), self.there.copy()
        if skip >= 0:
            there[skip] = False
        others = self._circles[: self.count][there]
        if len(rows) and len(others):
            mine = circles[rows]
            step = mine[:, None, :2] - others[None, :, :2]
            deep = mine[:, None, 2] + others[None, :, 2] - np.hypot(step[..., 0], step[..., 1])
            good[rows] = deep.max(1) <= DEEP
        return good

    @staticmethod
    def _place_circles(local: Floats, poses: Floats) -> Floats:
        """Circles (n, 3) of the frames of boxes at poses (n, 3), in the plan."""
        return np.column_stack([from_frames(local[:, :2], poses), local[:, 2]])

    def legal_shapes(
        self,
        shapes: NDArray[np.object_],
        boxes: Floats,
        skip: int = -1,
        gaps: GapRules | None = None,
    ) -> Flags:
        """The same of footprints (n,) with their boxes (n, 5)."""
        good = np.asarray(shapely.covers(self.floor, shapes))
        rows = np.flatnonzero(good)
        if not len(rows) or not self.count:
            return good
        there = self.there.copy()
        if skip >= 0:
            there[skip] = False
        half = np.hypot(boxes[:, 3], boxes[:, 4]) / 2
        theirs = np.hypot(self.boxes[:, 3], self.boxes[:, 4]) / 2
        step = boxes[rows, None, :2] - self.boxes[None, :, :2]
        away = np.hypot(step[..., 0], step[..., 1])
        close = (away < half[rows, None] + theirs[None] + self.reach) & there[None]
        i, j = np.nonzero(close)
        if not len(i):
            return good
        away = np.asarray(shapely.distance(shapes[rows[i]], self.shapes[j]))
        least = np.array(gaps or self.gaps)
        how = pair_kind(boxes[rows[i]], self.boxes[j])
        bad = away < least[how] - 1e-6
        touching = away <= 0
        touching &= ~bad
        if touching.any():
            t = np.flatnonzero(touching)
            shared = shapely.intersection(shapes[rows[i[t]]], self.shapes[j[t]])
            bad[t] |= np.asarray(shapely.area(shared)) > TOUCH * np.asarray(shapely.length(shared))
            bad[t] |= measure_thickness(shared) > 2.0 * TOUCH
        good[rows[np.unique(i[bad])]] = False
        return good

    def add(self, pose: Floats, origin: int, how: str) -> int:
        """Add a copy of a building of the sources; its number."""
        if self.count == len(self._boxes):
            more = self.count
            self._boxes = np.concatenate([self._boxes, np.zeros((more, 5))])
            self._shapes = np.concatenate([self._shapes, np.empty(more, object)])
            self._origin = np.concatenate([self._origin, np.zeros(more, np.int64)])
            self._circles = np.concatenate([self._circles, np.zeros((more, 3))])
            self.alive = np.concatenate([self.alive, np.ones(more, np.bool_)])
        number, self.count = self.count, self.count + 1
        self.how.append(how)
        self.alive[number] = True
        self.held += 1
        self.made[self.sizes[origin]] += 1
        self._put(number, pose, origin)
        self.covered += float(self._shapes[number].area)
        self.tell()
        return number

    def tell(self) -> None:
        """Tell who listens how far it is, and hear whether to go on."""
        if self._on_growth is not None:
            self.stopped = self._on_growth(self.share(), self.layout)

    def share(self) -> float:
        """The share of what is wanted that is built, 0 to 1."""
        number = self.problem.number
        there, wanted = (self.covered, self.wanted) if number is None else (self.held, number)
        return float(min(there / max(wanted, 1e-9), 1.0))

    def _put(self, number: int, pose: Floats, origin: int) -> None:
        pattern, many = self.problem.pattern, np.array([origin])
        self._boxes[number] = boxes_at(pattern, pose[None], many)[0]
        self._shapes[number] = shapes_at(pattern, pose[None], many)[0]
        self._origin[number] = origin
        self._circles[number] = self._place_circles(self._within.circles[many], pose[None])[0]

    def move(self, number: int, pose: Floats, origin: int) -> None:
        """Put an added building elsewhere, or another in its place."""
        self.covered -= float(self._shapes[number].area)
        self.made[self.sizes[self._origin[number]]] -= 1
        self.made[self.sizes[origin]] += 1
        self._put(number, pose, origin)
        self.covered += float(self._shapes[number].area)

    def remove(self, number: int) -> None:
        """Take an added building away."""
        self.alive[number] = False
        self.held -= 1
        self.made[self.sizes[self._origin[number]]] -= 1
        self.covered -= float(self._shapes[number].area)

    def restore(self, number: int) -> None:
        """Put back a building that was taken away."""
        self.alive[number] = True
        self.held += 1
        self.made[self.sizes[self._origin[number]]] += 1
        self.covered += float(self._shapes[number].area)

    def find_added(self) -> Indices:
        """The numbers of the added buildings that stand."""
        return self.first + np.flatnonzero(self.alive[self.first : self.count])

    def movable(self) -> Indices:
        """The numbers of the added buildings that no row of the brief put where they are."""
        rows = self.find_added()
        return rows[[self.how[k - self.first] != "row" for k in rows.tolist()]]

    def layout(self) -> GrownLayout:
        """The buildings added, as a layout without scores."""
        rows = self.find_added()
        asked = self.problem.number
        return GrownLayout(
            self.boxes[rows, :3].copy(),
            self.origin[rows].copy(),
            tuple(self.how[k - self.first] for k in rows.tolist()),
            0 if asked is None else max(asked - int(self.problem.standing.inside.sum()), 0),
            {},
        )


def measure_thickness(shapes: NDArray[np.object_]) -> Floats:
    """The short side (n,) of the least rectangle about each shape, however many pieces it is of; 0
    for those of less than 1 cm².

    >>> measure_thickness(np.array([shapely.box(0, 0, 3, 0.5), shapely.Point(0, 0)])).tolist()
    [0.5, 0.0]
    """
    found = np.zeros(len(shapes))
    wide = np.flatnonzero(shapely.area(shapes) > 1e-4)
    if len(wide):
        boxes = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapes[wide]))
        sides = np.diff(boxes.reshape(-1, 5, 2)[:, :3], axis=1)
        found[wide] = np.hypot(sides[..., 0], sides[..., 1]).min(1)
    return found


def size_classes(pattern: SourcePattern) -> Indices:
    """The class of size (n,) of each building of the sources: 0 small, 1 usual, 2 large, by the
    thirds of their areas."""
    area = np.asarray(shapely.area(pattern.shapes))
    return np.searchsorted(np.quantile(area, (1 / 3, 2 / 3)), area, side="left")


def _most_of_each(problem: ExtendProblem, sizes: Indices, wanted: float) -> Indices:
    """How many buildings (3,) of each class of size an area may get: the sources' mix, and a
    little more."""
    weight = problem.pattern.weight / problem.pattern.weight.sum()
    area = float(weight @ np.asarray(shapely.area(problem.pattern.shapes)))
    total = problem.number if problem.number is not None else wanted / max(area, 1.0)
    shares = np.bincount(sizes, weight, 3)
    return np.ceil(MIX * total * shares + 1.0).astype(np.int64)
