"""The uses of buildings by the words and tags of maps."""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.core.brief.uses import UseName
from scenewright.ground.maps.kinds import NO_BUILDING, PLAIN, PUBLIC, SOLID, use_of, words_of

WORDS: dict[UseName, tuple[str, ...]] = {
    "dwelling": words_of(
        "dwelling house detached semidetached_house terrace bungalow apartments residential "
        "dormitory villa cabin static_caravan houseboat"
    ),
    "outbuilding": words_of(
        "outbuilding garage garages carport shed hut barn stable cowshed sty greenhouse "
        "farm_auxiliary roof toilets boathouse wash_house"
    ),
    "farm": words_of("farm farmhouse"),
    "shop": words_of(
        "shop retail commercial kiosk supermarket mall hotel hostel guest_house motel restaurant "
        "cafe pub bar biergarten fast_food ice_cream bank pharmacy marketplace office"
    ),
    "works": words_of(
        "works industrial factory warehouse hangar manufacture workshop depot brewery sawmill "
        "car_repair fuel service transformer_tower substation"
    )
    + SOLID,
    "public": words_of(
        "public civic government church chapel cathedral basilica minster abbey monastery mosque "
        "temple synagogue shrine religious museum gallery sports_hall sports_centre gymnasium "
        "train_station transportation post_office"
    )
    + PUBLIC,
}
"""The words of maps for each use."""
_USE = {word: use for use, words in WORDS.items() for word in words}
TAGGED: tuple[tuple[str, UseName | None], ...] = (
    ("amenity", None),
    ("shop", "shop"),
    ("craft", "works"),
    ("man_made", None),
    ("tourism", None),
    ("office", "shop"),
    ("leisure", None),
)
"""Keys that tell the use of a plain building, by their value or as such."""


ROOFS = {
    "gabled": "gabled",
    "hipped": "hipped",
    "flat": "flat",
    "half-hipped": "hipped",
    "pyramidal": "hipped",
    "saltbox": "gabled",
    "gambrel": "gabled",
}
"""Forms of roofs by the tag ``roof:shape``."""


TAG_OF_USE: dict[UseName, str] = {
    "dwelling": "house",
    "outbuilding": "outbuilding",
    "farm": "farm",
    "shop": "retail",
    "works": "industrial",
    "public": "public",
}
"""The value of the tag ``building`` that tells each use."""


def use_of_word(word: str) -> UseName | None:
    """The use that a word of a map tells.

    >>> use_of_word("bakery"), use_of_word("retail"), use_of_word("barn")
    (None, 'shop', 'outbuilding')
    """
    return _USE.get(word)


def use_of_tags(tags: Mapping[str, str]) -> UseName | None:
    """The use of a building by the tags of OpenStreetMap; ``None`` if they tell none. A shop in a
    house tells more than that it is a house.

    >>> use_of_tags({"building": "house", "shop": "bakery"}), use_of_tags({"building": "yes"})
    ('shop', None)
    >>> use_of_tags({"building": "yes", "amenity": "townhall"})
    'public'
    """
    kind = tags.get("building", "yes")
    told = None if kind in PLAIN or kind in NO_BUILDING else use_of_word(kind)
    if told not in (None, "dwelling"):
        return told
    for key, use in TAGGED:
        value = tags.get(key, "no")
        found = None if value == "no" else use or use_of_word(value)
        if found is not None:
            return found
    return told


def word_of_tags(tags: Mapping[str, str]) -> str:
    """What a building is, in a word: that of its tags where it tells the use, else the use.

    >>> word_of_tags({"building": "church"}), word_of_tags({"building": "yes", "shop": "bakery"})
    ('church', 'shop')
    """
    word, use = use_of(tags), use_of_tags(tags)
    return word if use is not None and use_of_word(word) == use else use or ""
