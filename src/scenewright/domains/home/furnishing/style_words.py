"""Words for the style of a home that mean nothing: reported, not passed over."""

from __future__ import annotations

from scenewright.building.palettes import STYLES, answers
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.report import Note
from scenewright.domains.home.cases.furnishing import Taste, misses, stock_of


def knows_style(words: str, catalog: Catalog) -> bool:
    """Whether some words name a style or palette, or a model of the user's own answers to them.

    >>> from scenewright.catalog.assets import shipped
    >>> [knows_style(words, shipped()) for words in ("", "zen", "nordic fjord", "baroque")]
    [True, True, True, False]
    """
    own = (asset for assets in stock_of(catalog).values() for asset in assets)
    return (
        not words.strip()
        or answers(words)
        or any(not misses(asset, Taste(style=words)) for asset in own)
    )


def knows_colour(words: str, catalog: Catalog) -> bool:
    """Whether some words name the hue of a palette, or the colour of a model of the user's own.

    >>> from scenewright.catalog.assets import shipped
    >>> [knows_colour(words, shipped()) for words in ("", "dark blue", "#ff0000")]
    [True, True, False]
    """
    own = {asset.colour.casefold() for assets in stock_of(catalog).values() for asset in assets}
    return not words.strip() or answers(words) or words.casefold() in own


def note_colours(brief: Brief, catalog: Catalog) -> list[Note]:
    """A note for each colour of a brief, of the home or a room, that means nothing."""
    named = dict.fromkeys((brief.colour, *(room.colour for room in brief.rooms)))
    remedy = "name a hue, such as blue, or a palette of scenewright list styles"
    return [
        Note("", "plan", "colour", f"colour '{words[:40]}' means nothing here; {remedy}")
        for words in named
        if not knows_colour(words, catalog)
    ]


def note_styles(brief: Brief, catalog: Catalog) -> list[Note]:
    """A note for each style of a brief, of the home or a room, that means nothing."""
    named = dict.fromkeys((brief.style, *(room.style for room in brief.rooms)))
    return [
        Note(
            "",
            "plan",
            "style",
            f"style '{words[:40]}' means nothing here; known are {', '.join(STYLES)}",
        )
        for words in named
        if not knows_style(words, catalog)
    ]
