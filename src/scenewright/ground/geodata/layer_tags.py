"""What the layers and columns of GIS files say, in the tags of OpenStreetMap.

A layer called "buildings" (or Gebäude, bâti, 建筑) has no column that says so; columns have names
of their own in every office, and shapefiles cut them after ten letters. What a feature says of
itself comes first: values before names, columns before layers.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from scenewright.ground.maps.kinds import ELSE, stands, words_of

Tags = dict[str, Any]
COLUMNS = {
    "building:levels": "building:l building_l levels floors storeys stories num_floors nb_etages "
    "etages geschosse vollgeschosse pisos plantas piani bouwlagen gebouwlagen floor_count",
    "height": "hauteur hoehe höhe altura altezza hoogte height_m bldg_height heightroof "
    "building_height measuredheight measuredhe gebhoehe roofheight",
    "name": "nom nombre bezeichnung nome naam nimi",
    "ele": "elevation elev altitude",
}
"""Columns by the tag that they are, besides the tag's own name."""
LAYERS: tuple[tuple[str, str, Tags], ...] = (
    (
        "polygon",
        "plot parcel parcelle lot cadast kataster flurst parzelle grundst parcela particella "
        "pozem dzialk działk perceel tessellation участ 地块 宗地",
        {"place": "plot"},
    ),
    (
        "polygon",
        "building bldg house footprint gebaeude gebäude haus häuser hausumringe bati bâti batiment "
        "bâtiment immeuble edific budov budynk rakennu byggnad bygning pand gebouw здани дом nha "
        "nhà 建筑 建物 房屋",
        {"building": "yes"},
    ),
    ("polygon", "site baufeld plangebiet emprise projektgebiet", {"site": "yes"}),
    ("polygon", "block baublock ilot îlot manzana", {"block": "yes"}),
    ("polygon", "extend extension erweiterung", {"extend": "yes"}),
    (
        "any",
        "tree baum baeume bäume arbre arbol árbol albero boom drzew strom 树",
        {"natural": "tree"},
    ),
    (
        "any",
        "contour hoehenlinie höhenlinie hoehenpunkt höhenpunkt isohyp courbe terrain dem relief "
        "gelaende gelände spotheight 等高线",
        {"terrain": "yes"},
    ),
    ("any", "rail bahn gleis ferrocarril 铁路", {"railway": "rail"}),
    (
        "line",
        "river stream canal water gewaesser gewässer fluss bach riviere rivière rio 河",
        {"waterway": "stream"},
    ),
    (
        "polygon",
        "water river lake pond gewaesser gewässer fluss see riviere rivière eau hydro agua rio "
        "acqua voda 水",
        {"natural": "water"},
    ),
    (
        "line",
        "road street way strasse straße verkehr weg wege route rue voie voirie chemin troncon "
        "tronçon carretera calle camino strada via ulice ulica droga gata vej network highway "
        "centerline centreline дорог улиц duong đường 道路 路",
        {"highway": "residential"},
    ),
    ("polygon", "road street strasse straße verkehr voirie 道路", {"area:highway": "yes"}),
    (
        "any",
        "landuse nutzung park green gruen grün forest wald foret forêt vegetation natural zone "
        "zoning district boundary border admin grenz commune kommune region quartier ward sea "
        "limite pois places traffic transport",
        {"landuse": "yes"},
    ),
)
"""Words that the names of layers hold, by the shape of what is on them, and the tags that they
stand for."""
WAYS = frozenset(
    words_of(
        "motorway trunk primary secondary tertiary unclassified residential living_street service "
        "motorway_link trunk_link primary_link secondary_link tertiary_link pedestrian footway "
        "path cycleway steps bridleway track"
    )
)
OWN = ("site", "block", "extend")
NUMBERED = frozenset(ELSE) - {"level"}
"""Tags that are words: a number under such a name is a measure or a code of somebody's own."""
_COLUMNS = {word: tag for tag, words in COLUMNS.items() for word in words.split()}


def tags_of_row(properties: Mapping[str, Any], layer: str, shape: str) -> Tags:
    """The tags of a row of a layer, whose geometry is of a ``shape`` (``polygon``, ``line``,
    ``point``).

    >>> tags_of_row({"HOEHE": 9.5, "area": 134.2}, "Gebäude_2024", "polygon")
    {'height': 9.5, 'building': 'yes'}
    >>> tags_of_row({"": "tertiary"}, "roads", "line")
    {'highway': 'tertiary'}
    >>> tags_of_row({"building": "church"}, "parcels", "polygon")
    {'building': 'church'}
    """
    tags: Tags = {}
    for column, value in properties.items():
        key = column.strip().casefold()
        tag = _COLUMNS.get(key, key)
        if tag and _is_tag(tag, value) and (tag == key or tag not in properties):
            tags[tag] = value
    said = stands({k: str(v) for k, v in tags.items()}) or any(key in tags for key in ELSE)
    if said:
        return tags
    way = _way_class(properties) if shape == "line" else ""
    return tags | ({"highway": way} if way else dict(_tags_of_layer(layer, shape)))


def _is_tag(tag: str, value: Any) -> bool:
    """Whether a value can be that of a tag: words are no numbers, and our own say yes."""
    if tag in OWN:
        return str(value).casefold() in ("yes", "true")
    number = isinstance(value, int | float) or re.fullmatch(r"-?\d+([.,]\d+)?", str(value))
    return not (number and tag in NUMBERED)


def _way_class(properties: Mapping[str, Any]) -> str:
    """The class of a way that any column states."""
    return next((str(v) for v in properties.values() if isinstance(v, str) and v in WAYS), "")


@lru_cache(maxsize=1024)
def _tags_of_layer(layer: str, shape: str) -> Mapping[str, Any]:
    """The tags that the name of a layer stands for: the first row of the table that knows one of
    its words.

    >>> _tags_of_layer("gis_osm_roads_free_1", "line")["highway"]
    'residential'
    >>> dict(_tags_of_layer("RedRiver", "polygon")), dict(_tags_of_layer("export", "polygon"))
    ({'natural': 'water'}, {})
    """
    split = re.sub(r"(?<=[a-zà-ÿ])(?=[A-Z])", " ", layer).casefold()
    words = [word for word in re.split(r"[\W\d_]+", split) if word]
    for wanted, stems, tags in LAYERS:
        if wanted not in ("any", shape):
            continue
        if any(_begins(word, stem) for stem in stems.split() for word in words):
            return MappingProxyType(tags)
    return MappingProxyType({})


def _begins(word: str, stem: str) -> bool:
    """Whether a word begins with a stem; stems of three letters are whole words.

    >>> _begins("roads", "road"), _begins("seats", "sea"), _begins("lots", "lot")
    (True, False, True)
    """
    short = len(stem) < 4 and stem.isascii()
    return word in (stem, f"{stem}s") if short else word.startswith(stem)
