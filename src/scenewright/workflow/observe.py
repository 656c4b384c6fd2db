"""Cameras in an arranged scene: set, seeded or on a way through its rooms, and what they see."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from math import isfinite
from pathlib import Path
from typing import NamedTuple

import numpy as np
import shapely

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import recorded_run
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.plan import Plan
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.formats import read_planned, solution_json
from scenewright.formats.png import OPEN
from scenewright.formats.solution_record import FORMAT
from scenewright.render.observations.floor import walkable_floor
from scenewright.render.observations.trajectory import walk_through
from scenewright.render.observations.viewpoints import choose_viewpoints, inside_of
from scenewright.render.observations.views import KINDS, Lens, Observation, Viewpoint, observe_view
from scenewright.render.observations.world import VisibleWorld, build_world
from scenewright.workflow.observation_files import Taken, check_folder, write_observations
from scenewright.workflow.request import check_name

USUAL, MOST_CAMERAS = 4, 10_000
SIDES, MOST_PIXELS = (8, 4096), 4096 * 2160
FARTHEST = 1e5
SOLVING = 0.3
"""The share of the work that arranging a brief is told to be."""

Tell = Callable[[float, str], None]
Pose = tuple[float, float, float, float, float]


class ObservationRequest(NamedTuple):
    """What is asked for: the number of seeded ``cameras`` (None: 4 where nothing else is asked
    for), their height ``eye`` above the floor and ``clearance`` to walls and pieces in metres; the
    ``size`` of pictures in pixels and the width of the view ``fov`` in radians; the
    ``kinds`` observed; ``rooms`` by name or id (empty: all); ``poses`` set by hand, x, y, z in the
    world in metres, yaw and pitch in radians; poses of a ``trajectory``, a number."""

    cameras: int | None = None
    size: tuple[int, int] = (640, 480)
    fov: float = float(np.deg2rad(75.0))
    eye: float = 1.5
    clearance: float = 0.2
    seed: int = 0
    kinds: tuple[str, ...] = KINDS
    rooms: tuple[str, ...] = ()
    poses: tuple[Pose, ...] = ()
    trajectory: int = 0


@dataclass(frozen=True, slots=True)
class Observations:
    """Cameras in a scene; what they see is made when it is asked for."""

    world: VisibleWorld
    viewpoints: tuple[Viewpoint, ...]
    request: ObservationRequest
    solution: Solution

    @property
    def taken(self) -> Taken:
        """All but the pictures: what is written as JSON."""
        request, lens = self.request, lens_of(self.request)
        return Taken(self.world, self.viewpoints, lens, request.kinds, request.seed, self.solution)

    def views(self) -> Iterator[Observation]:
        """What each camera sees, one after the other."""
        lens, kinds = lens_of(self.request), frozenset(self.request.kinds)
        return (observe_view(self.world, each, lens, kinds) for each in self.viewpoints)


def observe(
    source: Solution | str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    cameras: int | None = None,
    size: tuple[int, int] = (640, 480),
    fov: float = float(np.deg2rad(75.0)),
    eye: float = 1.5,
    clearance: float = 0.2,
    seed: int = 0,
    kinds: Sequence[str] = KINDS,
    rooms: Sequence[str] = (),
    poses: Iterable[Pose] = (),
    trajectory: int = 0,
    steps: int | None = None,
    progress: Tell | None = None,
    cancel: Callable[[], bool] | None = None,
) -> Observations:
    """Cameras in a solution, a saved one, or a brief that is arranged first (with ``seed`` and
    ``steps``); what they see is written to the folder ``output`` if one is given.

    The options are those of :class:`ObservationRequest`. Raises :class:`InputError` for what cannot
    be observed.

    >>> seen = observe("sample:home-room", cameras=2, size=(32, 24), kinds=["depth"], steps=200)
    >>> [view.depth.shape for view in seen.views()]
    [(24, 32), (24, 32)]
    """
    request = ObservationRequest(
        cameras,
        size,
        fov,
        eye,
        clearance,
        seed,
        tuple(k for k in KINDS if k in kinds),
        tuple(rooms),
        tuple(poses),
        trajectory,
    )
    for kind in kinds:
        check_name("kind of observation", kind, KINDS)
    check_request(request)
    tell = progress or (lambda _share, _words: None)
    with recorded_run():
        count = sum(camera_counts(request))
        if output is not None:
            check_folder(Path(output), request.kinds, count)
        tell(0.0, "reading")
        solution, plan = solve_source(source, seed, steps, tell, cancel)
        made = open_observations(solution, plan, request)
        if output is not None:
            views = _told(made, tell, cancel)
            write_observations(Path(output), made.taken, views)
    return made


def _told(
    made: Observations, tell: Tell, cancel: Callable[[], bool] | None
) -> Iterator[Observation]:
    for number, view in enumerate(made.views(), 1):
        if cancel is not None and cancel():
            raise CancelledError
        yield view
        done = number / len(made.viewpoints)
        tell(SOLVING + (1 - SOLVING) * done, f"camera {number} of {len(made.viewpoints)}")


def solve_source(
    source: Solution | str | os.PathLike[str],
    seed: int,
    steps: int | None,
    tell: Tell,
    cancel: Callable[[], bool] | None,
) -> tuple[Solution, Plan | None]:
    """A solution as it is, from its file, or of a brief that is solved."""
    if isinstance(source, Solution):
        return source, None
    path = Path(source)
    if path.suffix.lower() == ".json" and path.is_file() and _holds_solution(path):
        return solution_json.read_planned(path)
    if path.is_dir():
        raise InputError("is a folder", "give a saved solution or a plan", file=str(source))
    brief, plan = read_planned(source)
    check_rooms(brief.domain, plan.spaces)
    solve = domains.solve
    told = partial(_tell_share, tell)
    return solve(brief, plan=plan, seed=seed, steps=steps, progress=told, cancel=cancel), plan


def _tell_share(tell: Tell, share: float, words: str) -> None:
    tell(SOLVING * share, words)


def _holds_solution(path: Path) -> bool:
    try:
        return FORMAT.encode() in path.read_bytes()
    except OSError:
        return False


def lens_of(request: ObservationRequest) -> Lens:
    """The lens of all cameras of a request."""
    return Lens(*request.size, request.fov)


def camera_counts(request: ObservationRequest) -> tuple[int, int, int]:
    """How many cameras are set by hand, drawn, and on a trajectory."""
    usual = 0 if request.poses or request.trajectory else USUAL
    drawn = usual if request.cameras is None else request.cameras
    return len(request.poses), drawn, request.trajectory


def check_request(request: ObservationRequest) -> None:
    """Raise :class:`InputError` for numbers that no camera can have."""
    least, most = SIDES
    checks = (
        (
            request.cameras is None or request.cameras >= 1,
            "--cameras",
            request.cameras,
            "1 or more",
        ),
        (request.trajectory >= 0, "--trajectory", request.trajectory, "the number of poses"),
        (sum(camera_counts(request)) <= MOST_CAMERAS, "so many cameras", "", f"{MOST_CAMERAS:,}"),
        (
            all(least <= side <= most for side in request.size)
            and request.size[0] * request.size[1] <= MOST_PIXELS,
            "--size",
            "x".join(map(str, request.size)),
            f"sides of {least} to {most} pixels, 4096x2160 at most",
        ),
        (
            0.17 <= request.fov <= 2.8,
            "--fov",
            round(float(np.rad2deg(request.fov)), 1),
            "10 to 160",
        ),
        (0.05 <= request.eye <= 10, "--eye", request.eye, "metres above the floor, 0.05 to 10"),
        (0.05 <= request.clearance <= 1.4, "--clearance", request.clearance, "0.05 to 1.4 metres"),
        (request.seed >= 0, "--seed", request.seed, "0 or more"),
        (
            all(isfinite(v) and abs(v) <= FARTHEST for p in request.poses for v in p),
            "--camera",
            "",
            f"plain numbers up to {FARTHEST:,.0f}",
        ),
        (
            all(abs(pose[4]) <= np.pi / 2 + 1e-9 for pose in request.poses),
            "--camera",
            "",
            "a pitch of -90 to 90 degrees",
        ),
        (bool(request.kinds), "what to observe", "", ", ".join(KINDS)),
    )
    for right, name, value, wanted in checks:
        if not right:
            raise InputError(f"{name} {value}".strip() + " cannot be used", f"give {wanted}")


def open_observations(
    solution: Solution, plan: Plan | None, request: ObservationRequest
) -> Observations:
    """The world of a solution with the cameras of a request in it."""
    scene = domains.scene_of(solution, plan)
    check_rooms(solution.brief.domain, scene.spaces)
    rooms = named_rooms(scene, request.rooms)
    world = build_world(scene, catalog_of(solution.brief.catalogs))
    given = [_by_hand(world, pose) for pose in request.poses]
    _, drawn, along = camera_counts(request)
    rng = np.random.default_rng(request.seed)
    if drawn or along:
        levels = {space.level for space in scene.spaces if not rooms or space.id in rooms}
        floors = [
            walkable_floor(scene, one.id, request.eye) for one in scene.levels if one.id in levels
        ]
        given += choose_viewpoints(
            world, floors, rooms, drawn, request.eye, request.clearance, lens_of(request), rng
        )
        if along:
            given += walk_through(floors, rooms, along, request.eye, request.clearance, rng)
    return Observations(world, tuple(given), request, solution)


def check_rooms(domain: str, spaces: Sequence[Space]) -> None:
    """Raise :class:`InputError` where there are no rooms to stand in."""
    if not spaces or any(OPEN & set(space.functions) for space in spaces):
        fault = f"cameras stand in rooms, but the brief is of a {domain}"
        raise InputError(fault, "give a home or a hall")


def named_rooms(scene: Scene, names: Sequence[str]) -> frozenset[str]:
    """The ids of rooms called by name or id, else of those whose name or use has the word;
    InputError where there is none."""
    found: set[str] = set()
    for name in names:
        word = name.lower()
        same = [s.id for s in scene.spaces if word in (s.id.lower(), s.name.lower())] or [
            s.id
            for s in scene.spaces
            if word in s.functions or word in re.findall(r"\w+", s.name.lower())
        ]
        if not same:
            known = ", ".join(space.name or space.id for space in scene.spaces)
            raise InputError(f"there is no room '{name[:80]}'", f"use one of: {known[:200]}")
        found.update(same)
    return frozenset(found)


def _by_hand(world: VisibleWorld, pose: Pose) -> Viewpoint:
    """A camera set by hand; InputError where it is inside of something."""
    x, y, z, yaw, pitch = pose
    lower = [one for one in world.scene.levels if one.elevation <= z]
    level = max(lower, key=lambda one: one.elevation).id if lower else ""
    rooms = [
        space.id
        for space in world.scene.spaces
        if space.level == level
        and shapely.Polygon(space.outline, space.holes).contains(shapely.Point(x, y))
    ]
    found = Viewpoint((x, y, z), yaw, pitch, rooms[0] if rooms else "", level)
    if inside := inside_of(world, found):
        raise InputError(
            f"the camera at {x:g},{y:g},{z:g} is inside {inside}", "set it in the open"
        )
    return found
