"""A case with other members' sizes: real furniture in the place of the generator's.

Members hang on the piece that makes the group like a chain: each keeps its gap to the neighbour it
hangs on, side by side or one before the other, and its line with it at the back. So a bed 4 cm
wider pushes its nightstands out by 2 cm each, and a longer table takes its chairs along.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog, Group, Member
from scenewright.core.scene import Size

Floats = NDArray[np.float64]

LINED = 0.06  # backs nearer to one line than this stay in line, metres
SHARED = 0.02  # what two members may newly share of their floor, metres
CARRIED = 0.05  # a member this high above the floor hangs or stands on another, metres
ABOVE = 0.12  # least gap between a piece and what hangs above it, metres
HIGHEST = 2.35
ROW = ("wall_cabinet", "hood")
"""What hangs in a row above another is as wide as that, or the shipped one is."""


class Chosen(NamedTuple):
    """What is to stand for a member: the asset and its size."""

    asset: str
    size: Size


def refit_case(
    case: Group, chosen: Mapping[int, Chosen], anchor: int, catalog: Catalog
) -> Group | None:
    """The case with some members chosen anew; None if they do not go together.

    ``chosen`` is by the members' numbers, ``anchor`` the one that stays in the middle of things.
    """
    members = list(case.members)
    for i, one in chosen.items():
        members[i] = members[i]._replace(size=one.size, asset=one.asset)
    moved = _place_members(case.members, members, anchor, catalog)
    if _clash(case.members, moved, catalog) or any(m.z + m.size.height > HIGHEST for m in moved):
        return None
    return _rebuild_case(case, moved)


def reach(member: Member) -> tuple[float, float]:
    """Half of what a member takes along x and y of its group."""
    across = abs(np.sin(member.heading)) > 0.7
    w, d = member.size.width / 2, member.size.depth / 2
    return (d, w) if across else (w, d)


def _place_members(
    old: tuple[Member, ...], new: list[Member], anchor: int, catalog: Catalog
) -> tuple[Member, ...]:
    """Members of new sizes, moved along the chain from the anchor."""
    done = {anchor: new[anchor]}
    floor = [i for i, m in enumerate(old) if _on_floor(m, catalog) and i != anchor]
    while floor:
        i, parent = min(
            ((i, p) for i in floor for p in done),
            key=lambda pair: _apart(old, pair[0], pair[1], anchor),
        )
        done[i] = _beside(old[i], old[parent], new[i], done[parent])
        floor.remove(i)
    standing = tuple(done)
    for i, member in enumerate(old):
        if i not in done:
            on = member.on if member.on >= 0 else _below(old, i, standing, anchor)
            done[i] = _over(member, old[on], new[i], done[on])
    return tuple(done[i] for i in range(len(old)))


def _below(old: tuple[Member, ...], i: int, standing: tuple[int, ...], anchor: int) -> int:
    """What a member hangs above, or the anchor for what lies on the floor."""
    if old[i].z < CARRIED:
        return anchor
    return min(standing, key=lambda k: abs(old[k].x - old[i].x) + abs(old[k].y - old[i].y) / 4)


def _on_floor(member: Member, catalog: Catalog) -> bool:
    return member.on < 0 and member.z < CARRIED and not catalog.kinds[member.category].flat


def _apart(old: tuple[Member, ...], i: int, parent: int, anchor: int) -> float:
    """How far two members are apart; the anchor is preferred."""
    gaps = [gap for gap, _ in _gaps(old[i], old[parent])]
    return float(np.hypot(*np.maximum(gaps, 0.0))) + (0.0 if parent == anchor else LINED)


def _gaps(a: Member, b: Member) -> tuple[tuple[float, float], tuple[float, float]]:
    """Along x and y: the gap between two members (negative: they overlap) and on which side."""
    (ax, ay), (bx, by) = reach(a), reach(b)
    dx, dy = a.x - b.x, a.y - b.y
    return (abs(dx) - ax - bx, np.sign(dx)), (abs(dy) - ay - by, np.sign(dy))


def _beside(old: Member, parent: Member, new: Member, to: Member) -> Member:
    """A member beside, before or behind the one it hangs on, with the same gap."""
    (gap_x, side_x), (gap_y, side_y) = _gaps(old, parent)
    half, other = reach(new), reach(to)
    if gap_x >= gap_y:
        x = to.x + side_x * (gap_x + half[0] + other[0])
        return new._replace(x=float(x), y=_in_line(old, parent, new, to))
    y = to.y + side_y * (gap_y + half[1] + other[1])
    share = other[0] / reach(parent)[0]
    return new._replace(x=to.x + (old.x - parent.x) * share, y=float(y))


def _in_line(old: Member, parent: Member, new: Member, to: Member) -> float:
    """The y of a member whose back, or front, was in line with its neighbour's."""
    for side in (-1.0, 1.0):
        off = (old.y + side * reach(old)[1]) - (parent.y + side * reach(parent)[1])
        if abs(off) < LINED:
            return to.y + side * (reach(to)[1] - reach(new)[1]) + off
    return to.y + (old.y - parent.y) * reach(to)[1] / reach(parent)[1]


def _over(old: Member, parent: Member, new: Member, to: Member) -> Member:
    """A member on, above or below another: at the same place of it, on its top if it was."""
    share = np.array(reach(to)) / np.array(reach(parent))
    x, y = (np.array([old.x - parent.x, old.y - parent.y]) * share + (to.x, to.y)).tolist()
    if old.on >= 0:
        slack = np.maximum(np.array(reach(to)) - reach(new), 0.0)
        x = float(np.clip(x, to.x - slack[0], to.x + slack[0]))
        y = float(np.clip(y, to.y - slack[1], to.y + slack[1]))
        return new._replace(x=x, y=y, z=to.z + to.size.height)
    if old.category in ROW and abs(new.size.width - to.size.width) > SHARED:
        new = new._replace(size=old.size, asset="")
    size = new.size if new.asset else _scale_size(new.size, float(share[0]))
    if old.z >= CARRIED:
        back = old.y - reach(old)[1] - (parent.y - reach(parent)[1])
        y = to.y - reach(to)[1] + back + reach(new)[1]
        under = abs(x - to.x) < reach(to)[0] + reach(new)[0]
        high = to.z + to.size.height + ABOVE if under and old.z > parent.size.height else 0.0
        return new._replace(x=x, y=y, z=max(old.z, high), size=size)
    return new._replace(x=x, y=y, size=size)


def _scale_size(size: Size, share: float) -> Size:
    return Size(size.width * share, size.depth, size.height)


def _clash(old: tuple[Member, ...], new: tuple[Member, ...], catalog: Catalog) -> bool:
    """Whether two members share floor that did not before, or one sticks out of what holds it."""
    for i, a in enumerate(new):
        if a.on >= 0:
            over = np.array(reach(a)) - reach(new[a.on])
            if over.max() > SHARED:
                return True
            continue
        for k in range(i):
            if new[k].on >= 0 or catalog.kinds[a.category].flat or not _level(a, new[k]):
                continue
            flat = catalog.kinds[new[k].category].flat
            before = min(_common(old[i], old[k]))
            if not flat and min(_common(a, new[k])) > max(before, 0.0) + SHARED:
                return True
    return False


def _common(a: Member, b: Member) -> tuple[float, float]:
    """Lengths that two members share along x and y."""
    (gap_x, _), (gap_y, _) = _gaps(a, b)
    return -gap_x, -gap_y


def _level(a: Member, b: Member) -> bool:
    """Whether two members share some height."""
    return bool(a.z < b.z + b.size.height - SHARED and b.z < a.z + a.size.height - SHARED)


def _rebuild_case(case: Group, members: tuple[Member, ...]) -> Group:
    """The case about its new members, with the margins the old one had."""
    low, high = _extent(case.members)
    new_low, new_high = _extent(members)
    half = np.array([case.width, case.depth]) / 2
    new_low, new_high = new_low - (low + half), new_high + (half - high)
    middle, size = (new_low + new_high) / 2, new_high - new_low
    moved = tuple(m._replace(x=m.x - float(middle[0]), y=m.y - float(middle[1])) for m in members)
    return case._replace(width=float(size[0]), depth=float(size[1]), members=moved)


def _extent(members: tuple[Member, ...]) -> tuple[Floats, Floats]:
    """The corners of the box round the members on the floor."""
    standing = [m for m in members if m.on < 0 and m.z < CARRIED]
    at = np.array([(m.x, m.y) for m in standing])
    half = np.array([reach(m) for m in standing])
    return (at - half).min(0), (at + half).max(0)
