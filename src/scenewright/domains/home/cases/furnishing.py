"""The case library of a user's own furniture: every case with real models in it.

For each case of the shipped library the models nearest in size take the place of the generated
members, at their own sizes, so nothing is stretched (:mod:`.refit`). Like members of a case are
the same model. Where no model suits, the shipped asset stays.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from math import log
from typing import NamedTuple

from scenewright.catalog.kinds import SIZES
from scenewright.core.catalog import OWN, Asset, Catalog, Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.cases.refit import Chosen, refit_case
from scenewright.domains.home.groups import GROUPS

REACH = 1.6  # how many times longer or shorter a model may be than the member it stands for
FLAT = 1.25  # the same for rugs, pictures, mirrors
LOOSE: dict[str, tuple[int, int]] = {
    "rug": (0, 1),
    "picture": (0, 2),
    "mirror": (0, 2),
    "curtain": (0, 2),
}
"""Sheets, and which two of their sides count."""
HEIGHT = 0.3  # what a different height counts beside a different footprint
UNLIKE = 0.4  # what the wrong style or colour counts, as the logarithm of a side's ratio
ONE_TOP = (
    "base_cabinet",
    "drawer_cabinet",
    "sink_cabinet",
    "hob_cabinet",
    "oven_cabinet",
    "dishwasher",
)
"""Units of one worktop: of one height and depth."""
LIKE_KINDS: dict[str, tuple[str, ...]] = {
    "dining_table": ("round_table",),
    "drawer_cabinet": ("base_cabinet",),
    "base_cabinet": ("drawer_cabinet",),
    "basin": ("pedestal_basin",),
    "pedestal_basin": ("basin",),
    "sofa": ("loveseat",),
    "loveseat": ("sofa",),
    "bookcase": ("shelf_unit",),
    "storage_shelf": ("shelf_unit",),
}
"""Kinds that may stand for another."""


class Real(NamedTuple):
    """A case with real models in it, and how far it is from the case it was made of."""

    case: Group
    strain: float


class Taste(NamedTuple):
    """Style and colour wished for, as words; empty for no wish."""

    style: str = ""
    colour: str = ""


Stock = Mapping[str, tuple[Asset, ...]]


@lru_cache(maxsize=8)
def stock_of(catalog: Catalog) -> Stock:
    """The models of a user's own by the categories they may stand for."""
    own = [asset for asset in catalog.assets.values() if asset.id.startswith(OWN)]
    found: dict[str, list[Asset]] = {}
    for asset in own:
        found.setdefault(asset.category, []).append(asset)
    for kind, others in LIKE_KINDS.items():
        more = [asset for other in others for asset in own if asset.category == other]
        if more:
            found.setdefault(kind, []).extend(more)
    return {kind: tuple(assets) for kind, assets in found.items()}


def nearest_own(category: str, size: Size, catalog: Catalog) -> Asset | None:
    """The model of a user's own that may stand for a piece of a size, nearest to it."""
    like = Member(category, 0, 0, 0, 0, size)
    suited = [a for a in stock_of(catalog).get(category, ()) if _suits(like, a)]
    return min(suited, key=lambda a: _unlike(like, a, Taste()), default=None)


def substitute_models(
    function: str, cases: tuple[Group, ...], stock: Stock, catalog: Catalog, taste: Taste
) -> tuple[Group, ...]:
    """The cases of a function with real models; as they are where none suits.

    Of each case there is one with the models nearest to its sizes, and for each model that makes
    the group one more of the case nearest to it.
    """
    essential = GROUPS[function].essential if function in GROUPS else ()
    real = [one for case in cases for one in (_with(case, {}, stock, catalog, taste),) if one]
    used = {m.asset for one in real for m in one.case.members}
    for asset in (a for kind in essential for a in stock.get(kind, ()) if a.id not in used):
        real += _about(asset, cases, essential, stock, catalog, taste)
    if not real:
        return cases
    least = min(one.case.width * one.case.depth for one in real)
    smaller = [case for case in cases if case.width * case.depth < 0.9 * least]
    return (*_once(real), *smaller)


def _about(
    asset: Asset,
    cases: tuple[Group, ...],
    essential: tuple[str, ...],
    stock: Stock,
    catalog: Catalog,
    taste: Taste,
) -> Iterator[Real]:
    """The case nearest to a model that makes the group, with that model."""

    def off(case: Group) -> float:
        return min(
            (_unlike(m, asset, Taste()) for m in case.members if m.category in essential),
            default=9.0,
        )

    for case in sorted(cases, key=off)[:2]:
        fixed = {
            i: Chosen(asset.id, asset.usual)
            for i, m in enumerate(case.members)
            if m.category in essential and _suits(m, asset)
        }
        found = _with(case, fixed, stock, catalog, taste) if fixed else None
        if found:
            yield found
            return


def _with(
    case: Group, fixed: Mapping[int, Chosen], stock: Stock, catalog: Catalog, taste: Taste
) -> Real | None:
    """The case with models: all that suit, else only the piece that makes it; None if neither."""
    anchor = anchor_of(case)
    chosen = {**_choice(case, stock, taste), **fixed}
    if not chosen:
        return None
    for some in (chosen, {i: c for i, c in chosen.items() if i == anchor or i in fixed}):
        sized = _level_worktops(case, some)
        found = refit_case(case, sized, anchor, catalog) if some else None
        if found:
            return Real(
                found._replace(name=_rename_case(case, found, catalog)), _strain(case, found)
            )
    return None


def _strain(case: Group, found: Group) -> float:
    """How far the sizes of a case had to change, and how many of its members are not real."""
    change = sum(
        abs(log(a / b))
        for old, new in zip(case.members, found.members, strict=True)
        for a, b in zip(new.size, old.size, strict=True)
    )
    return change + UNLIKE * sum(not m.asset for m in found.members)


def anchor_of(case: Group) -> int:
    """The number of the member that makes the group: essential, else the largest on the floor."""
    essential = GROUPS[case.function].essential if case.function in GROUPS else ()
    order = [i for i, m in enumerate(case.members) if m.on < 0 and m.category != "rug"]
    return max(
        order,
        key=lambda i: (
            case.members[i].category in essential,
            case.members[i].size.width * case.members[i].size.depth,
        ),
    )


def _choice(case: Group, stock: Stock, taste: Taste) -> dict[int, Chosen]:
    """The model for each member that one suits; like members get the same."""
    chosen: dict[int, Chosen] = {}
    alike: dict[tuple[str, Size], Chosen | None] = {}
    for i, member in enumerate(case.members):
        key = (member.category, member.size)
        if key not in alike:
            fit = [a for a in stock.get(member.category, ()) if _suits(member, a)]
            best = min(fit, key=lambda a: _unlike(member, a, taste), default=None)
            alike[key] = Chosen(best.id, best.usual) if best else None
        found = alike[key]
        if found:
            chosen[i] = found
    return chosen


def _suits(member: Member, asset: Asset) -> bool:
    """Whether a model may stand for a member at all."""
    most = log(FLAT if member.category in LOOSE else REACH)
    count = LOOSE.get(member.category, (0, 1))
    return all(abs(log(asset.usual[k] / member.size[k])) <= most for k in count)


def _unlike(member: Member, asset: Asset, taste: Taste) -> float:
    """How far a model is from a member in size, and from the taste."""
    sides = [abs(log(a / b)) for a, b in zip(asset.usual, member.size, strict=True)]
    return max(sides[0], sides[1], HEIGHT * sides[2]) + UNLIKE * misses(asset, taste)


def misses(asset: Asset, taste: Taste) -> int:
    """How many of the wishes for style and colour a model does not meet."""
    words = f"{asset.style} {asset.name} {asset.id}".casefold()
    style = taste.style.casefold().split()
    lacks = bool(style) and not any(word in words for word in style)
    return lacks + (bool(taste.colour) and asset.colour.casefold() != taste.colour.casefold())


def _level_worktops(case: Group, chosen: dict[int, Chosen]) -> dict[int, Chosen]:
    """Units of a worktop beside real ones get their depth and height."""
    units = [
        chosen[i].size for i, m in enumerate(case.members) if i in chosen and m.category in ONE_TOP
    ]
    if not units:
        return chosen
    depth, height = units[0].depth, sorted(size.height for size in units)[0]
    return chosen | {
        i: Chosen("", Size(m.size.width, *_within(m.category, depth, height)))
        for i, m in enumerate(case.members)
        if m.category in ONE_TOP and i not in chosen
    }


def _within(kind: str, depth: float, height: float) -> tuple[float, float]:
    low, _, high = SIZES[kind]
    return (min(max(depth, low.depth), high.depth), min(max(height, low.height), high.height))


def _rename_case(case: Group, found: Group, catalog: Catalog) -> str:
    """The case's name, after the model that makes it."""
    anchor = found.members[anchor_of(case)]
    name = catalog.assets[anchor.asset].name if anchor.asset else ""
    others = [m.category for i, m in enumerate(found.members) if i != anchor_of(case)]
    text = f"{name} of {anchor.size.width:.2f} m" + f", {len(others)} more" * bool(others)
    return text if name else case.name


def _once(real: list[Real]) -> Iterator[Group]:
    """Of cases about the same model and of like size and members the one least strained."""
    seen = set()
    for case, _ in sorted(real, key=lambda one: one.strain):
        anchor = case.members[anchor_of(case)]
        key = (
            anchor.asset,
            anchor.size,
            round(case.width, 1),
            round(case.depth, 1),
            tuple(sorted(m.category for m in case.members if m.z == 0)),
            tuple(m.category for m in case.members[:2]),
        )
        if key not in seen:
            seen.add(key)
            yield case
