"""What is wrong with how groups stand: before windows, adrift, too short for their wall."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, hypot, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import SOFAS
from scenewright.core.catalog import Group
from scenewright.core.same import once
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.bed_places import place_member
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.furnishing.enlarge import find_widest_screen
from scenewright.domains.home.measures import AT_WALL
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.every import FIRMNESS, SEEN, SHADES
from scenewright.domains.home.rules.weigh_home import LONE, compile_table, list_faults
from scenewright.domains.home.settings import ComposingSettings
from scenewright.geometry.boxes import common_area, make_frame
from scenewright.geometry.flanks import measure_flank_gaps

Floats = NDArray[np.float64]

SCREEN = "tv"
SHELVED = 0.75  # share of the longest wall that shelves of a storage room stand along
OPEN = 1.0  # width of the sight from a sofa to a fireplace in which nothing stands, metres
OFF_AXIS = 0.3  # a sofa this near to the axis of a fireplace is on it, metres
FARTHEST = 3.1  # most of its widths from which a screen is watched
DARK = 0.09  # metres of a window that may be covered before its light is taken


@once(1024)
def cost_of_group(group: FurnishedGroup, ground: Ground, rule: ComposingSettings) -> float:
    """What is wrong with one group as it stands, each fault half for being there and half by its
    degree, by the costs of ``rule``; of the same group on the same ground found once."""
    faults = list_faults(compile_table(LONE, rule.costs), (group,), (), ground)
    standing = sum(fault.cost for fault in faults)
    return standing + cost_of_case(list_standing(group), ground.area, rule)


@once(64)
def _read_strips(ground: Ground) -> list[tuple[list[float], bool, float]]:
    """The floor before openings: each strip, whether it is a window's, and how far its corners are
    from its middle, metres."""
    return [(s, s[5] == 1.0, hypot(s[3], s[4]) / 2) for s in ground.strips.tolist()]


def list_standing(group: FurnishedGroup) -> Group:
    """The case of a group without the members that gave way."""
    case, stands = group.dressed.case, group.dressed.stands
    if all(stands):
        return case
    held = (m for m, there in zip(case.members, stands, strict=True) if there)
    return case._replace(members=tuple(held))


def _box(piece: Piece) -> Floats:
    pose, size = piece.pose, piece.size
    return np.array([pose.x, pose.y, pose.heading, size.width, size.depth])


def _metres_before(piece: Piece, strip: Sequence[float]) -> float:
    """Metres of an opening that a piece stands before."""
    frame = make_frame(*_box(piece).tolist())
    return float(common_area(frame, make_frame(*strip[:5])) / strip[4])


@once(1024)
def measure_before_doors(group: FurnishedGroup, ground: Ground) -> float:
    """Metres of wide doors and passages that a group stands before, each from :data:`SEEN` on."""
    doors = [strip for strip, window, _ in _read_strips(ground) if not window]
    low = [p for p in group.pieces if p.pose.z <= AT_WALL and p.category != "rug"]
    metres = (_metres_before(piece, door) for piece in low for door in doors)
    return sum(found for found in metres if found > SEEN)


def measure_hung_over_doors(group: FurnishedGroup, ground: Ground) -> float:
    """Metres of wide doors and passages over which what a group hangs at a wall reaches: nothing
    holds it there."""
    doors = [strip for strip, window, _ in _read_strips(ground) if not window]
    hung = [p for p in group.pieces if p.pose.z > AT_WALL and not p.on]
    deep = ((p, door, min(door[4], p.size.depth)) for p in hung for door in doors)
    return sum(_metres_before(piece, door) * door[4] / depth for piece, door, depth in deep)


def cost_of_openings(case: Group, boxes: Floats, ground: Ground, rule: ComposingSettings) -> Floats:
    """What is wrong with a case on each of boxes (n, 5) as it stands before windows and wide doors:
    :func:`cost_of_group` of many places at once, for cases parallel to their wall."""
    cost = np.zeros(len(boxes))
    for member in case.members:
        if member.on >= 0 or member.z > AT_WALL or member.category == "rug":
            continue
        there = place_member(member, boxes)
        for strip in ground.strips:
            window = strip[5] == 1.0
            if not window or member.category in SHADES:
                share = _lengths_before(there, strip)
                each = rule.costs.window if window else rule.costs.opening
                each *= 1.0 if window else FIRMNESS.get(member.category, 1.0)
                cost += np.where(share > SEEN, each * (1.0 + np.minimum(share, 1.0)) / 2, 0.0)
    return cost


def _lengths_before(boxes: Floats, strip: Floats) -> Floats:
    """Metres of an opening that each of boxes (n, 5) parallel or square to it stands before."""
    x, y, heading, width, depth = strip[:5]
    dx, dy, turn = boxes[:, 0] - x, boxes[:, 1] - y, boxes[:, 2] - heading
    along, ahead = dx * np.sin(heading) - dy * np.cos(heading), dx * np.cos(heading)
    ahead = ahead + dy * np.sin(heading)
    c, s = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    half, deep = (boxes[:, 3] * c + boxes[:, 4] * s) / 2, (boxes[:, 4] * c + boxes[:, 3] * s) / 2
    common = np.minimum(along + half, width / 2) - np.maximum(along - half, -width / 2)
    inside = np.minimum(ahead + deep, depth / 2) - np.maximum(ahead - deep, -depth / 2)
    return np.asarray(np.maximum(common, 0.0) * np.maximum(inside, 0.0) / depth)


def cost_of_screen(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with a stand that has no room for a screen large enough for its distance."""
    pieces = [p for g in groups for p in g.pieces]
    under = {p.on for p in pieces if p.category == "tv"}
    stand = next((p for p in pieces if p.id in under), None)
    seats = [p for p in pieces if p.category in SOFAS]
    if stand is None or not seats:
        return 0.0
    away = min(hypot(p.pose.x - stand.pose.x, p.pose.y - stand.pose.y) for p in seats)
    short = 1.0 - find_widest_screen(stand, ground, pieces) * FARTHEST / away
    return cost * (1.0 + short) / 2 if short > 0.0 else 0.0


def cost_of_hearth(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with a sofa that does not look at the fireplace that stands: by how far it is
    off the fireplace's axis, turned from it, and what of other groups stands between."""
    seats = next((g for g in groups if any(p.category in SOFAS for p in g.pieces)), None)
    if seats is None or not len(ground.hearths):
        return 0.0
    sofa = next(p.pose for p in seats.pieces if p.category in SOFAS)
    x, y, c, s = min(ground.hearths.tolist(), key=lambda h: hypot(sofa.x - h[0], sofa.y - h[1]))
    turned = 1.0 + c * cos(sofa.heading) + s * sin(sofa.heading)
    off = max(abs((sofa.y - y) * c - (sofa.x - x) * s) - OFF_AXIS, 0.0) + turned
    away = (sofa.x - x) * c + (sofa.y - y) * s
    if away > SEEN:
        sight = make_frame(x + c * away / 2, y + s * away / 2, atan2(s, c), OPEN, away)
        between = (p for g in groups if g is not seats for p in g.pieces if p.pose.z < AT_WALL)
        off += sum(float(common_area(make_frame(*_box(p).tolist()), sight)) for p in between)
    return cost * (1.0 + min(off, 1.0)) / 2 if off > SEEN else 0.0


def cost_of_shelves(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with the shelves of a storage room that stand along less of its longest wall
    than :data:`SHELVED`."""
    shelves = [p for g in groups if g.wish.group == "storage" for p in g.pieces]
    if not shelves:
        return 0.0
    walls = ground.walls
    longest = float(np.hypot(walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]).max())
    short = 1.0 - sum(p.size.width for p in shelves) / (SHELVED * longest)
    return cost * (1.0 + short) / 2 if short > 0.0 else 0.0


def list_adrift(groups: Sequence[FurnishedGroup], ground: Ground) -> list[Piece]:
    """The single beds of groups with neither long side at a wall."""
    beds = [p for g in groups for p in g.pieces if p.category == "single_bed"]
    gaps = (float(measure_flank_gaps(_box(bed)[None], ground.walls).min()) for bed in beds)
    return [bed for bed, gap in zip(beds, gaps, strict=True) if gap > AT_WALL]


@once(1024)
def measure_before_windows(group: FurnishedGroup, ground: Ground) -> Floats:
    """Metres (w,) of each of the windows in walls before which one piece of a group stands that
    takes its light."""
    panes = [strip for strip, window, _ in _read_strips(ground) if window]
    low = [p for p in group.pieces if _takes_light(p.category, p.pose.z)]
    each = [[_metres_before(piece, pane) for pane in panes] for piece in low]
    return np.array(each).reshape(len(low), len(panes)).max(axis=0, initial=0.0)


def _takes_light(category: str, above: float) -> bool:
    """Whether a piece ``above`` metres over the floor takes light of a window behind it."""
    return category == SCREEN or (category in SHADES and above <= AT_WALL)


def measure_cases_before_windows(case: Group, boxes: Floats, ground: Ground) -> Floats:
    """:func:`measure_before_windows` (n, w) of a case parallel to its wall on each
    of boxes (n, 5)."""
    panes = [strip for strip in ground.strips if strip[5] == 1.0]
    metres = np.zeros((len(boxes), len(panes)))
    for member in case.members:
        if _takes_light(member.category, member.z):
            there = place_member(member, boxes)
            for k, pane in enumerate(panes):
                metres[:, k] = np.maximum(metres[:, k], _lengths_before(there, pane))
    return metres
