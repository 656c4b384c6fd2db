"""Passages that no zones could have: wider than the hall itself is anywhere."""

from __future__ import annotations

from math import floor

import shapely

from scenewright.building.plan import place
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.space import Space
from scenewright.domains.hall.zoning.borders import floor_of

EXACT = 0.001
"""To how many metres the radius of the largest disc is found."""


def check_widths(brief: Brief, number: int, space: Space) -> None:
    """InputError where a passage of room ``number`` is to be wider than its floor is anywhere.

    The clear width of a passage is that of a disc which moves from wholly inside one zone to
    wholly inside another (:mod:`scenewright.domains.hall.check.passages`), so it is at most the
    diameter of the largest disc between the walls and columns of the hall.
    """
    links = brief.rooms[number].links
    wide = max((brief.passage_width, *(link.width or 0.0 for link in links)))
    line = shapely.maximum_inscribed_circle(floor_of(space), EXACT)
    widest = 2.0 * (line.length + EXACT)
    if wide <= widest:
        return
    asked = [
        (place(brief, number, f"links[{k}].width"), link.width) for k, link in enumerate(links)
    ]
    if not links or any(width is None for _, width in asked):
        asked.append(("passage_width", brief.passage_width))
    for where, width in asked:
        if width is not None and width > widest:
            raise InputError(
                f"{width:g} m is wider than {space.name or space.id} is anywhere: a disc of at "
                f"most {widest:.2f} m fits between its walls and columns",
                f"give at most {floor(10.0 * widest) / 10.0:g} (metres)",
                place=where,
            )
