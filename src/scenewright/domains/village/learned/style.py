"""A style: all that was learned of how houses of a region stand, and its file.

The file is a plain ``.npz`` of arrays without pickled objects; ``card`` holds, as JSON, where it is
from. Of a file nothing is run: names and shapes must be those of the net, all numbers finite.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.array_archive import read_arrays
from scenewright.core.errors import InputError
from scenewright.core.stored_file import report_damage
from scenewright.domains.village.learned.fullness import FIGURES, MoreLaw
from scenewright.domains.village.learned.mix import EMPTY, HouseMix
from scenewright.domains.village.learned.pose_net import Weights, shapes_of_net
from scenewright.domains.village.settings import OURS, Manner, Relations

FORMAT = 2
SUFFIX = ".npz"
LARGEST = 16_000_000
"""Bytes of a file of a style at most, once unpacked."""
MOST_REGIONS = 100
SHIPPED = Path(__file__).parent / "europe.npz"
TABLES = ("gap", "turn", "street", "street_turn")
REMEDY = "give a file that scenewright learn village has written"

Arrays = Mapping[str, np.ndarray]


class Region(NamedTuple):
    """What differs between regions: how houses stand to each other and to the street, and which
    stand together."""

    manner: Manner
    mix: HouseMix


class VillageStyle(NamedTuple):
    """How houses of a region stand: tables of single relations and the law of counts, the weights
    of the net of poses, the law that tells full blocks, which houses stand together; its card
    (data, licence, split, figures); and the same tables and houses of single ``regions``."""

    manner: Manner
    poses: Weights
    more: MoreLaw
    card: dict[str, Any]
    mix: HouseMix
    regions: Mapping[str, Region] = MappingProxyType({})


def is_file(style: str) -> bool:
    """Whether a style is a file, not a name.

    >>> is_file("hui"), is_file("mine.npz")
    (False, True)
    """
    return style.endswith(SUFFIX)


def style_named(style: str) -> VillageStyle:
    """The style of a file, else the one that ships."""
    return read_style(Path(style)) if is_file(style) else shipped_style()


def style_in_region(style: VillageStyle, region: str) -> VillageStyle:
    """The style as it is in one of its regions; itself for a region it does not know.

    >>> sorted(shipped_style().regions)
    ['bayreuth', 'liechtenstein', 'monaco_hills']
    """
    own = style.regions.get(region)
    return style if own is None else style._replace(manner=own.manner, mix=own.mix)


def bare_style(manner: Manner) -> VillageStyle:
    """A style of tables alone, to propose poses before anything else is learned."""
    none = np.zeros(FIGURES)
    return VillageStyle(manner, {}, MoreLaw(none, none + 1.0, none, 0.0), {}, EMPTY)


@lru_cache(maxsize=1)
def shipped_style() -> VillageStyle:
    """The style that ships, learned from villages of Franconia, Liechtenstein, Lower Austria and
    the Riviera (© OpenStreetMap contributors, ODbL).

    >>> shipped_style().card["licence"][:4]
    'ODbL'
    """
    return read_style(SHIPPED)


def write_style(path: Path, style: VillageStyle) -> None:
    """Write a style; the same style gives the same bytes."""
    with path.open("wb") as file:
        np.savez(file, allow_pickle=False, **arrays_of(style))


def arrays_of(style: VillageStyle) -> dict[str, np.ndarray]:
    """A style as the arrays of its file."""
    found: dict[str, np.ndarray] = {
        f"poses/{name}": np.asarray(value) for name, value in style.poses.items()
    }
    found |= _arrays_of_manner(style.manner, "manner")
    found["more/law"] = np.stack([style.more.mean, style.more.spread, style.more.weights])
    found["more/constant"] = np.array([style.more.constant])
    found["mix/blocks"], found["mix/houses"] = style.mix
    for name, region in style.regions.items():
        found |= _arrays_of_manner(region.manner, f"region/{name}")
        found[f"region/{name}/blocks"], found[f"region/{name}/houses"] = region.mix
    card = {"format": FORMAT, **style.card, "regions": list(style.regions)}
    document = json.dumps(card, sort_keys=True, ensure_ascii=False)
    return found | {"card": np.frombuffer(document.encode(), np.uint8)}


def _arrays_of_manner(manner: Manner, at: str) -> dict[str, np.ndarray]:
    found = {}
    for name in TABLES:
        table: Relations = getattr(manner, name)
        found[f"{at}/{name}"] = np.array([table.small, table.large])
    found[f"{at}/count_law"] = np.array(manner.count_law)
    found[f"{at}/sizes"] = np.array(manner.sizes)
    return found


def read_style(path: Path) -> VillageStyle:
    """The style of a file; InputError, in one line, for anything that is none."""
    with report_damage(path, "a style file", REMEDY):
        return style_of(read_arrays(path, LARGEST))


def style_of(arrays: Arrays) -> VillageStyle:
    """The style of the arrays of a file; InputError for arrays of another kind."""
    card = _card(arrays)
    weights = {
        name: _array(arrays, f"poses/{name}", shape).astype(np.float32)
        for name, shape in shapes_of_net().items()
    }
    rows = _array(arrays, "more/law", (3, FIGURES))
    constant = float(_array(arrays, "more/constant", (1,))[0])
    more = MoreLaw(rows[0], np.maximum(rows[1], 1e-6), rows[2], constant)
    regions = {
        name: Region(_manner(arrays, f"region/{name}"), _mix(arrays, f"region/{name}"))
        for name in _regions_told(card)
    }
    return VillageStyle(_manner(arrays), weights, more, card, _mix(arrays), regions)


def _regions_told(card: dict[str, Any]) -> list[str]:
    named = card.get("regions", [])
    if not isinstance(named, list) or not all(isinstance(name, str) for name in named):
        raise InputError("is no style file: its regions are no names", REMEDY)
    return named[:MOST_REGIONS]


def _card(arrays: Arrays) -> dict[str, Any]:
    text = arrays.get("card", np.zeros(0))
    try:
        card = json.loads(bytes(text.astype(np.uint8)).decode()) if text.ndim == 1 else None
    except (ValueError, RecursionError):
        card = None
    if not isinstance(card, dict):
        raise InputError("is no style file: its card is missing", REMEDY)
    if card.get("format") != FORMAT:
        raise InputError(f"is of format {str(card.get('format'))[:20]}, not {FORMAT}", REMEDY)
    return card


def _manner(arrays: Arrays, at: str = "manner") -> Manner:
    tables = []
    for name in TABLES:
        ours: Relations = getattr(OURS, name)
        rows = _shares(_array(arrays, f"{at}/{name}", (2, len(ours.small))), name)
        tables.append(Relations(ours.edges, tuple(rows[0].tolist()), tuple(rows[1].tolist())))
    a, b, c, spread = _array(arrays, f"{at}/count_law", (4,)).tolist()
    small, medium, large = _shares(_array(arrays, f"{at}/sizes", (3,)), "sizes").tolist()
    gap, turn, street, street_turn = tables
    law = (a, b, c, abs(spread))
    return Manner(gap, turn, street, street_turn, law, (small, medium, large))


def _mix(arrays: Arrays, at: str = "mix") -> HouseMix:
    blocks = arrays.get(f"{at}/blocks", np.zeros(0))
    count = len(blocks) if blocks.ndim else 0
    blocks = _array(arrays, f"{at}/blocks", (max(count, 1), 3))
    held = np.clip(blocks[:, 2], 1, 1e6).round()
    houses = _array(arrays, f"{at}/houses", (int(held.sum()), 2))
    if (held != blocks[:, 2]).any() or (houses[:, 0] <= 0).any() or (houses[:, 1] < 1).any():
        raise InputError("is no style file: its lists of houses are none", REMEDY)
    return HouseMix(blocks, houses)


def _shares(values: np.ndarray, name: str) -> np.ndarray:
    if (values < 0).any() or (values.sum(-1) < 1e-3).any():
        raise InputError(f"is no style file: the shares of '{name}' are not positive", REMEDY)
    whole = values.sum(-1, keepdims=True)
    return np.asarray(np.where(np.abs(whole - 1) < 1e-9, values, values / whole))


def _array(arrays: Arrays, name: str, shape: tuple[int, ...]) -> np.ndarray:
    value = arrays.get(name)
    if value is None:
        raise InputError(f"is no style file: the array '{name}' is missing", REMEDY)
    if value.shape != shape or value.dtype.kind != "f":
        form = "x".join(map(str, shape))
        raise InputError(f"is no style file: the array '{name}' is not {form} numbers", REMEDY)
    if not np.isfinite(value).all() or np.abs(value).max() > 1e6:
        raise InputError(f"is no style file: the array '{name}' holds no usable numbers", REMEDY)
    return np.asarray(value)
