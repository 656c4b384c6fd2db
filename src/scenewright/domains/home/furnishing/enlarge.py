"""What grows to its surroundings once all stands: the rug before a sofa, the screen one watches.

Groups keep both small, so that they find their place. A rug that ends with its sofa looks like a
mat, and a screen is watched from 1.5 to 2.5 times its width (THX asks for 36 to 40 degrees, 1.4 to
1.5 widths; SMPTE 30 degrees, 1.9 widths); from more than three its picture is small.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import chain, product
from math import cos, hypot, sin

import numpy as np

from scenewright.catalog.classes import SOFAS, TABLE_SEATS
from scenewright.catalog.kinds import SIZES
from scenewright.core.catalog import OWN, Catalog
from scenewright.core.same import Same
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.furnishing.furnish import too_tall
from scenewright.domains.home.furnishing.obstacles import (
    StandingObstacles,
    find_faults,
    find_faults_of,
    flat_kinds,
    standing_of,
)
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import Frame, common_area, make_frame

BEYOND = (0.6, 0.5, 0.4, 0.3, 0.2)  # a rug reaches beyond its sofa, both ends together, metres
FRAME = (0.3, 0.2, 0.155)  # and beyond the coffee table at its far side, metres
RUGS_APART = 0.1  # between rugs of one room, metres
WIDTHS = 2.3  # distance from seat to screen in widths of the screen that is aimed at
MOST_WIDTHS = 3.15  # and no further in widths of one that reaches beyond its stand
OVERHANG = 0.36  # a screen may be wider than its stand, metres
ONE_SIDE = 0.16  # and one that reaches beyond one end of it only, metres
ELBOW = 0.2
"""What one sits on beside a stand, and metres from it to a screen that is wider than its stand."""
STEP = 0.1  # screens are tried in steps, metres
LEAST_SCREEN, SCREEN_DEPTH, SCREEN_RATIO = 0.75, 0.22, 0.62
"""The narrowest screen, how deep it stands, metres, and its height as a share of its width."""


def enlarge_pieces(
    placed: Sequence[Piece],
    others: Sequence[Piece],
    ground: Ground,
    height: float,
    catalog: Catalog,
) -> list[Piece]:
    """The pieces placed in a room, rugs and screens as large as they should be and can be.

    ``others`` stand in the room as well, whose flat ceiling is at ``height`` metres. A rug that can
    nowhere reach beyond its sofa is left out. A fixed piece stays as it is, and so does a model of
    a user's own.
    """
    found, mats = list(placed), set()
    flat = flat_kinds(catalog)
    for i, piece in enumerate(found):
        forms = FORMS.get(piece.category)
        if forms is None or piece.fixed or piece.asset.startswith(OWN):
            continue
        own = piece.group if piece.category in flat else ""
        rest = (p for p in (*found, *others) if p is not piece and (not own or p.group != own))
        standing = standing_of(tuple(rest), flat)
        for form in forms(piece, found):
            if _fits(form, standing, ground, height):
                asset = catalog.choose(form.category, form.size)
                found[i] = replace(form, asset=asset.id if asset else "")
                break
        else:
            if piece.category == "rug" and _is_mat(piece, found):
                mats.add(piece.id)
    return without_overlaps([piece for piece in found if piece.id not in mats])


def without_overlaps(pieces: Sequence[Piece]) -> list[Piece]:
    """Pieces without each rug that lies over, or hard at, a larger one: one rug serves both groups
    then. Those that came with the brief stay.

    >>> large = Piece("a", "rug", "", "r", Pose(0, 0, 0, 0), Size(2.0, 1.4, 0.012))
    >>> small = Piece("b", "rug", "", "r", Pose(1.0, 0, 0, 0), Size(1.2, 0.8, 0.012))
    >>> [piece.id for piece in without_overlaps([small, large])]
    ['a']
    """
    rugs = [p for p in pieces if p.category == "rug"]
    if len(rugs) < 2:
        return list(pieces)
    kept = [p for p in rugs if p.fixed]
    for rug in sorted((p for p in rugs if not p.fixed), key=lambda p: -p.size.width * p.size.depth):
        wide = _frame(rug, RUGS_APART)
        if all(float(common_area(wide, _frame(other, 0.0))) == 0.0 for other in kept):
            kept.append(rug)
    return [p for p in pieces if p.category != "rug" or any(p is rug for rug in kept)]


def _frame(piece: Piece, margin: float) -> Frame:
    """A piece, and a ``margin`` round it, as a frame."""
    (x, y, _, heading), (width, depth, _) = piece.pose, piece.size
    return make_frame(x, y, heading, width + 2 * margin, depth + 2 * margin)


def _is_mat(rug: Piece, pieces: Sequence[Piece]) -> bool:
    """Whether a rug ends with the sofa it lies before."""
    sofas = (p for p in pieces if p.group == rug.group and p.category in SOFAS)
    return any(rug.size.width <= sofa.size.width for sofa in sofas)


def _rugs(rug: Piece, pieces: Sequence[Piece]) -> Iterator[Piece]:
    """Larger forms of the rug of a seating group, the largest first."""
    group = [p for p in pieces if p.group == rug.group]
    sofa = next((p for p in group if p.category in SOFAS), None)
    table = next((p for p in group if p.category == "coffee_table"), None)
    if sofa is None or table is None:
        return
    c, s = cos(sofa.pose.heading), sin(sofa.pose.heading)
    ahead = c * (rug.pose.x - sofa.pose.x) + s * (rug.pose.y - sofa.pose.y)
    reach = c * (table.pose.x - sofa.pose.x) + s * (table.pose.y - sofa.pose.y)
    back, front = ahead - rug.size.depth / 2, ahead + rug.size.depth / 2
    edge = reach + table.size.depth / 2
    rows = ((FRAME, (0,)), (FRAME, (1, -1)), ((None,), (0,)), ((None,), (1, -1)))
    forms = chain.from_iterable(product(BEYOND, frames, sides) for frames, sides in rows)
    for beyond, frame, side in forms:
        far = front if frame is None else max(front, edge + frame)
        size = Size(max(rug.size.width, sofa.size.width + beyond), far - back, rug.size.height)
        out, beside = (far + back) / 2, side * beyond / 2
        x = sofa.pose.x + c * out + s * beside
        y = sofa.pose.y + s * out - c * beside
        pose = rug.pose._replace(x=x, y=y, heading=sofa.pose.heading)
        yield replace(rug, pose=pose, size=size)


def _screens(screen: Piece, pieces: Sequence[Piece]) -> Iterator[Piece]:
    """Larger screens on the same stand, the largest first: as wide as the stand, but no larger than
    its distance asks, and wider where it were too small to be watched from there; in the middle of
    the stand, else with an end over one of its ends, as beside a wall or window.
    """
    stand = next((p for p in pieces if p.id == screen.on), None)
    seats = [p for p in pieces if p.category in SOFAS]
    if stand is None or not seats:
        return
    away = min(hypot(p.pose.x - screen.pose.x, p.pose.y - screen.pose.y) for p in seats)
    wanted = min(max(stand.size.width, away / MOST_WIDTHS), away / WIDTHS)
    most = min(wanted, stand.size.width + OVERHANG, SIZES["tv"][2].width)
    chairs = [_frame(p, ELBOW) for p in pieces if p.category in TABLE_SEATS]
    ratio = screen.size.height / screen.size.width
    x, y, z, heading = screen.pose
    for wide in np.arange(most, screen.size.width, -STEP).round(2).tolist():
        over = max(wide - stand.size.width, 0.0) / 2
        for aside in (0.0, over, -over) if 0.0 < over <= ONE_SIDE / 2 + HAIR else (0.0,):
            pose = Pose(x - sin(heading) * aside, y + cos(heading) * aside, z, heading)
            size = Size(wide, screen.size.depth, ratio * wide)
            own = make_frame(*pose[:2], heading, wide, screen.size.depth)
            if over == 0.0 or not any(float(common_area(own, chair)) for chair in chairs):
                yield replace(screen, pose=pose, size=size)


def find_widest_screen(stand: Piece, ground: Ground, others: Sequence[Piece] = ()) -> float:
    """Metres of the widest screen that walls, windows, doors and ``others`` that stand in the room
    leave room for on a stand; beside the same pieces looked for once."""
    near = tuple(Same(p) for p in others if _is_beside(p, stand))
    return _find_widest(Same(stand), Same(ground), near)


@lru_cache(maxsize=256)
def _find_widest(stood: Same[Piece], on: Same[Ground], near: tuple[Same[Piece], ...]) -> float:
    """The same beside what is ``near`` enough to matter."""
    stand = stood.value
    widths = np.arange(stand.size.width + OVERHANG, LEAST_SCREEN, -STEP)
    over = np.maximum(widths - stand.size.width, 0.0) / 2
    beyond = np.where(over <= ONE_SIDE / 2 + HAIR, over, 0.0)
    aside = np.concatenate([np.zeros_like(over), beyond, -beyond])
    wide, (x, y, z, heading) = np.tile(widths, 3), stand.pose
    turn, deep = np.full_like(wide, heading), np.full_like(wide, SCREEN_DEPTH)
    boxes = np.column_stack([x - sin(heading) * aside, y + cos(heading) * aside, turn, wide, deep])
    low = z + stand.size.height
    spans = np.column_stack([np.full_like(wide, low), low + SCREEN_RATIO * wide])
    standing = standing_of(tuple(p.value for p in near), frozenset())
    codes = find_faults(boxes, spans, on.value, standing)
    return float(wide[codes == 0].max(initial=LEAST_SCREEN))


def _is_beside(piece: Piece, stand: Piece) -> bool:
    """Whether a piece of another group rises above a stand, near enough to keep a screen from
    reaching beyond it."""
    (x, y, z, _), (u, v, low, _) = piece.pose, stand.pose
    far = (stand.size.width + OVERHANG + hypot(piece.size.width, piece.size.depth)) / 2
    tall = z + piece.size.height > low + stand.size.height
    return tall and piece.group != stand.group and hypot(x - u, y - v) < far + SCREEN_DEPTH


FORMS: dict[str, Callable[[Piece, Sequence[Piece]], Iterator[Piece]]] = {
    "rug": _rugs,
    "tv": _screens,
}
"""The larger forms of a piece, by category."""


def _fits(form: Piece, standing: StandingObstacles, ground: Ground, height: float) -> bool:
    """Whether it is under the ceiling and meets nothing that stands outside its group: a rug lies
    under that."""
    box, span, codes = find_faults_of(form, ground, standing)
    return bool(too_tall(box, span, ground, height, codes)[0] == 0)
