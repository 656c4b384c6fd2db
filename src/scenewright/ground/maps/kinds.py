"""What a feature of a map is, in words, by the tags of OpenStreetMap: for reports and for readers.

Registers of buildings carry tags of their own (a number, a year, a height): a polygon that no tag
names as something else is a footprint.
"""

from __future__ import annotations

from collections.abc import Mapping


def words_of(text: str) -> tuple[str, ...]:
    """The words of a text, for tables of many."""
    return tuple(text.split())


ELSE = words_of(
    "landuse natural leisure highway waterway water amenity place boundary railway indoor parking "
    "site block extend street_side aeroway aerialway power surface public_transport golf sport "
    "room level barrier man_made historic tourism shop office craft emergency route area:highway "
    "area laid_out entrance door buildingpart terrain"
)
"""Keys that say what an area is, if it is no building."""
FOOTWAYS = words_of("footway path steps pedestrian cycleway bridleway corridor")
SOLID = words_of(
    "silo storage_tank water_tower chimney tower works gasometer bunker_silo kiln lighthouse "
    "cooling_tower windmill"
)
"""Values of ``man_made`` that stand as a building does."""
PUBLIC = words_of(
    "school kindergarten college university hospital clinic place_of_worship townhall library "
    "theatre cinema community_centre fire_station police courthouse"
)
"""Amenities that are a building, or the ground around one."""
NO_BUILDING = words_of("no none false 0 proposed demolished razed")
FAITHS = {
    "christian": "church",
    "muslim": "mosque",
    "buddhist": "temple",
    "taoist": "temple",
    "shinto": "shrine",
    "jewish": "synagogue",
}
FOLDED = {
    "water": "water waterway",
    "street furniture": "highway barrier",
    "land use": "landuse natural leisure golf",
    "transport": "railway route aeroway aerialway public_transport",
    "supply": "power",
    "boundary or place": "boundary place",
    "place of interest": "amenity historic tourism shop office craft emergency man_made sport",
    "entrance": "entrance",
    "part of a storey": "level",
}
"""Kinds of a report, and the keys whose values it counts together."""
TOLD = {
    ("place", "plot"): "plot",
    ("natural", "tree"): "tree",
    ("natural", "water"): "water",
    ("terrain", "yes"): "terrain",
}
"""Values that are kinds of their own."""
_KINDS = {key: kind for kind, keys in FOLDED.items() for key in keys.split()}
PLAIN = words_of("yes building true 1")


def stands(tags: Mapping[str, str]) -> bool:
    """Whether tags say that something is built that nothing else can stand on.

    >>> stands({"building": "church"}), stands({"man_made": "silo"}), stands({})
    (True, True, False)
    """
    if tags.get("building", "no") not in NO_BUILDING or tags.get("fclass") == "building":
        return True
    part = tags.get("building:part", "no") not in NO_BUILDING
    return part or (tags.get("man_made", "") in SOLID and "building" not in tags)


def is_footprint(tags: Mapping[str, str]) -> bool:
    """Whether no tag of a polygon says that it is anything but a footprint.

    >>> is_footprint({"height": "9.2", "bin": "1000"}), is_footprint({"landuse": "grass"})
    (True, False)
    """
    named = "fclass" in tags and tags["fclass"] != "building"
    return not named and "building" not in tags and not any(key in tags for key in ELSE)


def use_of(tags: Mapping[str, str]) -> str:
    """What a building is, in a word of its tags; empty if they say no more than that it stands.

    >>> use_of({"building": "church"}), use_of({"building": "yes", "amenity": "school"})
    ('church', 'school')
    """
    kind, amenity = tags.get("building", "yes"), tags.get("amenity", "")
    if kind not in PLAIN and kind not in NO_BUILDING:
        return kind
    if amenity == "place_of_worship":
        return FAITHS.get(tags.get("religion", ""), amenity)
    keys = ("amenity", "man_made", "historic", "tourism", "shop", "office", "leisure")
    return next((tags[key] for key in keys if tags.get(key, "no") not in ("no", "yes")), "")


def kind_of(tags: Mapping[str, str], shape: str) -> str:
    """The kind of a feature for a report, ``shape`` being its geometry in a word.

    >>> kind_of({"building": "yes"}, "area"), kind_of({"highway": "footway"}, "line")
    ('building', 'path')
    >>> kind_of({"natural": "tree"}, "point"), kind_of({"objectid": "7"}, "area")
    ('tree', 'area without tags of a map')
    >>> kind_of({"highway": "crossing"}, "point"), kind_of({"landuse": "meadow"}, "area")
    ('street furniture', 'land use')
    """
    if stands(tags):
        return "building"
    if tags.get("building", "no") not in ("no", "none", "false", "0"):
        return f"building={tags['building']}"
    for key in ("site", "block", "extend", "street_side"):
        if tags.get(key, "no") != "no":
            return key.replace("_", " ")
    way = tags.get("highway", "")
    if way and shape != "point":
        return "path" if way in FOOTWAYS else "road"
    keys = [key for key in ("indoor", "door", "entrance", "highway", *ELSE) if key in tags]
    if not keys:
        return f"{shape} without tags of a map"
    key, value = keys[0], tags[keys[0]]
    return TOLD.get((key, value)) or _KINDS.get(key, f"{key}={value}")
