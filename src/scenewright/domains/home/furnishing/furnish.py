"""Dress patches with furniture: the fitting case of each, checked piece by piece.

The paper puts the nearest case in the patch and stops. Here a patch takes the nearest case that
fits it, is drawn in to that case, and every piece is tried against the room, the doors, the
windows and the pieces placed; what is not essential to the group gives way.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from itertools import chain, islice
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import lowest
from scenewright.building.standing import RADIATOR
from scenewright.catalog.kinds import name_of
from scenewright.core.catalog import Catalog, Group, Member, footprint_of
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Piece, Pose
from scenewright.core.space import Outlet
from scenewright.domains.home.cases.library import SHIPPED, Library, cases, each_fitting, nearest
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.furnishing.whole import below
from scenewright.domains.home.grounds.hanging_walls import hanging_walls
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.wished.plugged import out_of_reach
from scenewright.geometry.compiled import compiled
from scenewright.geometry.fit import (
    AT_WINDOW,
    COLLIDES,
    IN_ZONE,
    OUTSIDE,
    faults,
    is_backed,
    side_gaps,
)

Floats = NDArray[np.float64]

UNDER_SLOPE = 5  # a code beside those of geometry.fit
SLACK = 0.003
BACKED = 0.03
FLUSH = 0.04
TRIED = 8
OPEN = 0.4  # what belongs to a wall and has none this near behind it is left out, metres


class FurnishedPatch(NamedTuple):
    """A patch with its furniture: the case, the box it was drawn in to, which of its members
    stand, how many had to give way, and how many metres they are out of reach of outlets."""

    case: Group
    box: Floats
    stands: tuple[bool, ...]
    lost: int
    far: float = 0.0


class Refused(NamedTuple):
    """Why nothing could stand on a patch."""

    reason: str


def furnish_patch(
    function: str,
    box: Floats,
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
    exact: bool = True,
    library: Library = SHIPPED,
    outlets: tuple[Outlet, ...] = (),
) -> FurnishedPatch | Refused:
    """The best case for a patch: fewest members lost, then least out of reach of the outlets, then
    nearest in size.

    With ``exact`` false the nearest case is taken as the paper prints, fitting or not. ``box``
    (5,) x, y, heading, width, depth; metres and radians.
    """
    if not exact:
        case = nearest(function, box[3], box[4], library)
        return FurnishedPatch(case, box, tuple(True for _ in case.members), 0)
    best: FurnishedPatch | None = None
    reason = Refused("no case of it is small enough for the free floor")
    known = cases(function, library)
    smallest = known.groups[known.smallest]
    for case in chain(islice(each_fitting(function, box[3], box[4], library), TRIED), (smallest,)):
        drawn = _drawn_in(case, box, ground)
        tried = _try(function, case, drawn, ground, standing, catalog, height)
        if outlets and isinstance(tried, FurnishedPatch):
            boxes = lay_case(case, drawn, catalog)[0]
            tried = tried._replace(far=out_of_reach(case.members, boxes, outlets))
        if isinstance(tried, Refused):
            reason = tried
        elif best is None or _worth(tried) < _worth(best):
            best = tried
        if best is not None and _worth(best) == (0, 0.0):
            break
    return best or reason


def dress_case(
    function: str,
    case: Group,
    box: Floats,
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
) -> FurnishedPatch | Refused:
    """One case on a box of its own size, whichever of its ends is at a side wall.

    ``box`` (5,) x, y, heading, width, depth; metres and radians.
    """
    return _try(function, case, box, ground, standing, catalog, height, lean=False)


def needed_of(case: Group) -> tuple[int, ...]:
    """The numbers of the members without which a group is refused."""
    must = _MUST | set(essential_of(case))
    return tuple(i for i, member in enumerate(case.members) if member.category in must)


def _worth(furnished: FurnishedPatch) -> tuple[int, float]:
    """What is wrong with a dressed patch; less is better."""
    return furnished.lost, furnished.far


def _drawn_in(case: Group, box: Floats, ground: Ground) -> Floats:
    """The patch drawn in to its case: the back edge stays, and a side that stands at a wall."""
    spare_width, spare_depth = box[3] - case.width, box[4] - case.depth
    left, right = side_gaps(box, ground.walls)
    shift = 0.0
    if spare_width > 0 and min(left, right) < FLUSH:
        shift = spare_width / 2 * (1 if right < left else -1)
    cos, sin = np.cos(box[2]), np.sin(box[2])
    x = box[0] + sin * shift - cos * spare_depth / 2
    y = box[1] - cos * shift - sin * spare_depth / 2
    return np.array([x, y, box[2], case.width, case.depth])


def _try(
    function: str,
    case: Group,
    box: Floats,
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
    lean: bool = True,
) -> FurnishedPatch | Refused:
    if lean and not _leans(function, case, box, ground):
        return Refused("its closed end would face open floor")
    if GROUPS[function].back == 1 and not is_backed(box, ground.walls, OPEN):
        return Refused(f"no free wall of {case.width:.1f} m to stand against")
    boxes, spans, flat = lay_case(case, box, catalog)
    codes, offenders = faults(
        boxes,
        spans,
        flat,
        ground.edges,
        ground.keep_free,
        ground.windows,
        standing.boxes,
        standing.spans,
        SLACK,
    )
    if len(ground.slopes) or _top_of(case, catalog) > height:
        codes = too_tall(boxes, spans, ground, height, codes)
    stands = _find_supported(case, (codes == 0).tolist(), boxes, ground, catalog)
    if all(stands):
        return FurnishedPatch(case, box, stands, 0)
    essential = essential_of(case)
    for i, member in enumerate(case.members):
        if member.category in essential and not stands[i]:
            return Refused(why_not(member, int(codes[i]), int(offenders[i]), standing))
    lost = [m for m, stood in zip(case.members, stands, strict=True) if not stood]
    heavy = sum(m.on < 0 and m.z < 0.05 and m.category != "rug" for m in lost)
    if _MUST & {m.category for m in lost} or _without_table(case, lost):
        return Refused(why_not(lost[0], int(codes[stands.index(False)]), -1, standing))
    return FurnishedPatch(case, box, stands, heavy)


def too_tall(
    boxes: Floats, spans: Floats, ground: Ground, height: float, codes: NDArray[np.int64]
) -> NDArray[np.int64]:
    """The codes of boxes without fault changed to :data:`UNDER_SLOPE` where they rise above the
    lowest ceiling over them; ``height`` is that of the flat ceiling.

    ``boxes`` (n, 5), ``spans`` (n, 2) heights of underside and top in metres, ``codes`` (n,).
    """
    if not len(ground.slopes) and spans[:, 1].max() <= height:
        return codes
    over = spans[:, 1] > lowest(boxes, ground.slopes, height) + 1e-9
    return np.where((codes == 0) & over, UNDER_SLOPE if len(ground.slopes) else OUTSIDE, codes)


def essential_of(case: Group) -> tuple[str, ...]:
    """The categories that make a group: its row's, or of a learned case without any of these that
    of its largest piece on the floor."""
    known = GROUPS[case.function].essential
    if any(m.category in known for m in case.members):
        return known
    floor = [m for m in case.members if m.on < 0 and m.category != "rug"]
    return (max(floor or case.members, key=lambda m: m.size.width * m.size.depth).category,)


_MUST = frozenset(
    ("hob_cabinet", "fridge", "office_chair", "dining_chair", "coffee_table", "tv", "outdoor_chair")
)


def _without_table(case: Group, lost: list[Member]) -> bool:
    tables = [m for m in case.members if m.category in ("coffee_table", "side_table")]
    return bool(tables) and all(m in lost for m in tables)


def _leans(function: str, case: Group, box: Floats, ground: Ground) -> bool:
    """Whether the end that belongs to a side wall is at the nearer one."""
    lean = GROUPS[function].lean
    xs = [m.x for m in case.members if m.category == lean]
    if not xs or abs(xs[0]) < 0.05:
        return True
    left, right = side_gaps(box, ground.walls)
    if abs(left - right) < 0.05 or min(left, right) > 0.6:
        return True
    return bool((xs[0] < 0) == (left < right))


def world(
    members: tuple[Member, ...], box: Floats, catalog: Catalog
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Members of a group on a box as boxes ``(m, 5)``, underside and top ``(m, 2)``, and which
    are flat: the latter two are those of all boxes, and not to be written to."""
    local, spans, flat = _laid(members, catalog)
    return _as_placed(local, box), spans, flat


def lay_case(
    case: Group, box: Floats, catalog: Catalog
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """:func:`world` of all members of a case."""
    local, spans, flat = _laid_case(case, catalog)
    return _as_placed(local, box), spans, flat


def _as_placed(local: Floats, box: Floats) -> Floats:
    """Boxes (m, 5) of a group's frame as they stand on the box (5,) of the group."""
    boxes, (x, y, heading) = np.empty_like(local), box[:3].tolist()
    place_boxes(local, x, y, heading, np.cos(box[2]), np.sin(box[2]), boxes)
    return boxes


@compiled
def place_boxes(
    local: Floats, x: float, y: float, heading: float, cos: float, sin: float, boxes: Floats
) -> None:
    """Write boxes (m, 5) of a group's frame, its front to +x, as they stand with the group at x,
    y and a heading with its cosine and sine."""
    for i in range(local.shape[0]):
        boxes[i, 0] = x + local[i, 0] * sin + local[i, 1] * cos
        boxes[i, 1] = y - local[i, 0] * cos + local[i, 1] * sin
        boxes[i, 2] = heading + local[i, 2]
        boxes[i, 3], boxes[i, 4] = local[i, 3], local[i, 4]


@lru_cache(maxsize=4096)
def _laid(
    members: tuple[Member, ...], catalog: Catalog
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Boxes of members in their group's frame ``(m, 5)``, underside and top ``(m, 2)``, and which
    are flat."""
    local = np.array([(m.x, m.y, m.heading, m.size.width, m.size.depth) for m in members])
    spans = np.array([(m.z, m.z + m.size.height) for m in members])
    return local, spans, np.array([catalog.kinds[m.category].flat for m in members])


@lru_cache(maxsize=4096)
def _laid_case(case: Group, catalog: Catalog) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """The same of all members of a case: its own hash is quicker than theirs."""
    return _laid(case.members, catalog)


@lru_cache(maxsize=4096)
def _top_of(case: Group, catalog: Catalog) -> float:
    """How high the tallest member of a case reaches, metres."""
    return float(_laid_case(case, catalog)[1][:, 1].max())


def _find_supported(
    case: Group, fits: list[bool], boxes: Floats, ground: Ground, catalog: Catalog
) -> tuple[bool, ...]:
    """Which members stand: those that fit, hang on a wall if they hang, stand on a placed one; what
    hangs above another only where that one is placed."""
    held_by = _held_by(case, catalog)
    if all(fits) and not any(hangs for _, hangs, _ in held_by):
        return (True,) * len(fits)
    stands: list[bool] = []
    for i, (on, hangs, _) in enumerate(held_by):
        held = fits[i] and (on < 0 or stands[on])
        held = held and (not hangs or bool(is_backed(boxes[i], hanging_walls(ground), BACKED)))
        stands.append(held)
    return tuple(
        held and (under < 0 or stands[under])
        for held, (_, _, under) in zip(stands, held_by, strict=True)
    )


@lru_cache(maxsize=4096)
def _held_by(case: Group, catalog: Catalog) -> tuple[tuple[int, bool, int], ...]:
    """Of each member of a case the number of the one it stands on (-1: none), whether it hangs on
    a wall alone, and the number of the one it hangs above."""
    pairs = zip(case.members, below(case.members), strict=True)
    return tuple(
        (m.on, m.on < 0 and catalog.kinds[m.category].support == "wall", under)
        for m, under in pairs
    )


def why_not(member: Member, code: int, offender: int, standing: StandingObstacles) -> str:
    """What is said of a member that cannot stand, by the code of its fault."""
    what = name_of(member.category)
    if code == OUTSIDE:
        size = member.size
        return (
            f"no place found: the {what} of {size.width:.2f} x {size.depth:.2f} m would stick out"
        )
    if code == UNDER_SLOPE:
        return f"no place found: the {what} of {member.size.height:.2f} m is too tall for the slope"
    if code == IN_ZONE:
        return f"no place found: the {what} would stand before a door"
    if code == AT_WINDOW:
        return f"no place found: the {what} would stand before a window"
    if code == COLLIDES and offender >= 0:
        other = standing.names[offender].replace("_", " ")
        if other == RADIATOR:
            return f"no place found: the {what} would stand before a radiator"
        return f"no place found: the {what} would run into the {other}"
    return f"no place found for the {what}"


def pieces_of(
    dressed: FurnishedPatch, space: str, group: str, function: str, catalog: Catalog
) -> tuple[Piece, ...]:
    """The standing members as placed pieces, named ``space/group/category``."""
    boxes = lay_case(dressed.case, dressed.box, catalog)[0][:, :3].tolist()
    found = []
    for i, name, on, member, asset, shape in _name_standing(dressed.case, dressed.stands, catalog):
        x, y, heading = boxes[i]
        pose = Pose(x, y, member.z, (heading + np.pi) % (2 * np.pi) - np.pi)
        what = (f"{group}/{name}", member.category, asset, space, pose, member.size)
        under = f"{group}/{on}" if on else None
        found.append(Piece(*what, group, function, under, footprint=shape))
    return tuple(found)


@lru_cache(maxsize=4096)
def _name_standing(
    case: Group, stands: tuple[bool, ...], catalog: Catalog
) -> tuple[tuple[int, str, str, Member, str, Footprint], ...]:
    """Each member that stands: its number, its name within the group and that of what it stands on
    (empty: none of it), the model that draws it, by id, and the footprint it covers."""
    shown, names = _choose_models(case, catalog), _names_of(case, stands)
    return tuple(
        (i, name, names.get(case.members[i].on, ""), case.members[i], *shown[i])
        for i, name in names.items()
    )


@lru_cache(maxsize=4096)
def _choose_models(case: Group, catalog: Catalog) -> tuple[tuple[str, Footprint], ...]:
    """The model that draws each member, by id, and the footprint it covers."""
    known = (
        catalog.assets.get(m.asset) or catalog.choose(m.category, m.size) for m in case.members
    )
    pairs = zip(known, case.members, strict=True)
    return tuple((a.id if a else "", footprint_of(a, m.size)) for a, m in pairs)


@lru_cache(maxsize=4096)
def _names_of(case: Group, stands: tuple[bool, ...]) -> Mapping[int, str]:
    """Names within their group of the members that stand, by number: the category, with a number
    from the second of its kind on."""
    names: dict[int, str] = {}
    for i, (member, there) in enumerate(zip(case.members, stands, strict=True)):
        if there:
            names[i] = _name(member.category, names)
    return names


def _name(wanted: str, taken: dict[int, str]) -> str:
    count = sum(n == wanted or n.startswith(f"{wanted}_") for n in taken.values())
    return f"{wanted}_{count + 1}" if count else wanted
