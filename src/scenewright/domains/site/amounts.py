"""Filling a site that asks only for an amount of floor: which models, and how many of each."""

from __future__ import annotations

from itertools import takewhile
from math import sqrt

from scenewright.catalog.loading import BUILDING, ONLY_NAMED
from scenewright.catalog.models.words import ASIDE, tokens_of
from scenewright.core.catalog import OWN, Asset, Catalog
from scenewright.core.errors import InputError
from scenewright.domains.site.brief import Site
from scenewright.ground.fit import fits
from scenewright.ground.plan import SitePlan

STOREY = 3.0
HOUSING = ("modern_residential", "point_tower", "row_houses", "villa")
"""Models that fill a site where the brief names no catalogues."""
USUAL_COVERAGE = 0.25
MOST_MODELS = 200
"""Models of a large catalogue that are mixed on one site."""
MOST = 20_000
SLENDER, LOW = 3.0, 2.0
"""Least side in plan and height of what fills a site, in metres."""
BESIDE = (
    "road",
    "street",
    "crossing",
    "pavement",
    "path",
    "bridge",
    "grass",
    "ground",
    "terrain",
    "tile",
    "base",
    "floor",
    "hill",
    "water",
    "tree",
    "trees",
    "bush",
    "hedge",
    "plant",
    "rock",
    "mountain",
    "cloud",
    "fence",
    "wall",
    "gate",
    "lamp",
    "light",
    "lights",
    "sign",
    "car",
    "truck",
    "bus",
    "van",
    "taxi",
    "train",
    "boat",
    "ship",
    "plane",
    "vehicle",
    "person",
    "animal",
    "fountain",
    "wheel",
    "turret",
    "roof",
    "top",
    "door",
    "window",
    "stairs",
    "chimney",
    "part",
    "saw",
    "arm",
    "projectile",
)
"""Words of large things that are no buildings, or parts of one."""


def amounts(site: Site, plan: SitePlan, place: str, catalog: Catalog) -> list[tuple[Asset, int]]:
    """Models and their counts, all together what coverage and floor-area ratio ask for: those of
    the brief's catalogues less landmarks, each as often; else dwellings, each on as much ground."""
    models = _models(site, plan, place, catalog)
    areas = [asset.usual.width * asset.usual.depth for asset in models]
    floors = [
        area * max(round(a.usual.height / STOREY), 1) for a, area in zip(models, areas, strict=True)
    ]
    weights = [1.0 if a.id.startswith(OWN) else area for a, area in zip(models, areas, strict=True)]
    counts = count_models(areas, floors, weights, *find_target(site, plan))
    rows = [(asset, count) for asset, count in zip(models, counts, strict=True) if count]
    return rows or [(min(models, key=lambda a: a.usual.width * a.usual.depth), 1)]


def find_target(site: Site, plan: SitePlan) -> tuple[float, float]:
    """The ground to be covered and the floor area (infinite: any) in square metres."""
    ratio = site.floor_area_ratio
    floor = float("inf") if ratio is None else ratio * plan.buildable
    usual = USUAL_COVERAGE if ratio is None or not site.library else 0.9
    return (site.coverage or usual) * plan.buildable, floor


def count_models(
    areas: list[float], floors: list[float], weights: list[float], cover: float, floor: float
) -> list[int]:
    """How many of each model it takes for ``cover`` and ``floor`` square metres: one more at a
    time of the model with the fewest, divided by its weight.

    >>> count_models([100.0, 50.0], [100.0, 150.0], [1.0, 2.0], 500.0, 1e9)
    [4, 2]
    """
    counts = [0] * len(areas)
    open_ = list(range(len(areas)))
    while open_ and sum(counts) < MOST:
        k = min(open_, key=lambda i: (counts[i] + 0.5) * weights[i])
        # half a building too much is as near as half too little
        if areas[k] / 2 > cover or floors[k] / 2 > floor:
            open_.remove(k)
            continue
        counts[k] += 1
        cover, floor = cover - areas[k], floor - floors[k]
    return counts


def _models(site: Site, plan: SitePlan, place: str, catalog: Catalog) -> list[Asset]:
    """The models that may be used; InputError if the catalogues hold some but none will do."""
    limit = site.height_limit or float("inf")
    standing = {row.model for row in plan.landmarks}
    own = [a for a in catalog.assets.values() if a.id.startswith(OWN) and a.id not in standing]
    own = [a for a in own if a.category != ONLY_NAMED]
    if not own:
        usual = [catalog.assets[name] for name in HOUSING]
        low = [a for a in usual if a.usual.height <= limit]
        if not low:
            least = min(usual, key=lambda a: a.usual.height)
            raise InputError(
                f"no dwelling is as low as the height limit of {limit:g} m: the lowest, "
                f"{least.id}, is {least.usual.height:g} m high",
                "raise height_limit, or list buildings with their size",
                place=place,
            )
        return low
    built = [a for a in own if fills(a)]
    if not built:
        raise InputError(
            f"none of the {len(own)} models of the catalogues is as large as a building: "
            f"{_describe_range(own)}",
            "give the catalogue a scale, or list buildings with their size",
            place=place,
        )
    spread = _spread([a for a in built if a.usual.height <= limit])
    found = [a for a in spread if fits(plan, a.usual.width, a.usual.depth)]
    if not found:
        raise InputError(
            f"none of the {len(built)} buildings of the catalogues fits the ground or the height "
            f"limit: {_describe_range(built)}",
            "give the catalogue a scale, or other models",
            place=place,
        )
    return found


def fills(asset: Asset) -> bool:
    """Whether a model may fill a site alone: a building, neither slender nor low, and not
    named like things that accompany buildings.

    >>> from scenewright.catalog.assets import shipped
    >>> [fills(shipped().assets[name]) for name in ("villa", "sofa")]
    [True, False]
    """
    width, depth, height = asset.usual
    built = asset.category == BUILDING and min(width, depth) >= SLENDER and height >= LOW
    names = (asset.id.removeprefix(OWN).rpartition("/")[2], asset.name)
    return built and not any(
        _beside(word)
        for name in names
        for word in takewhile(lambda word: word not in ASIDE, tokens_of(name))
    )


def _beside(word: str) -> bool:
    """Whether a word, or the end of a long one, tells what is no building (*trafficlight*)."""
    return word in BESIDE or any(word.endswith(end) for end in BESIDE if len(end) > 3)


def _describe_range(assets: list[Asset]) -> str:
    """The largest and the smallest, in words."""
    order = sorted(assets, key=lambda a: a.usual.width * a.usual.depth * a.usual.height)
    rows = {"the largest": order[-1], "the smallest": order[0]} if order[1:] else {"": order[0]}
    return ", ".join(
        f"{word} '{a.id.removeprefix(OWN)}' is {a.usual.width:.3g} x {a.usual.depth:.3g} x "
        f"{a.usual.height:.3g} m".strip()
        for word, a in rows.items()
    )


def _spread(assets: list[Asset]) -> list[Asset]:
    """The models in steps of the golden section, so that the first few are from all over the list;
    of many the first."""
    golden = (sqrt(5) - 1) / 2
    order = sorted(range(len(assets)), key=lambda k: k * golden % 1)
    return [assets[k] for k in order[:MOST_MODELS]]
