"""The part of the brief that names models of the user's own: catalogues to draw and choose from."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from scenewright.core.brief.fields import Number, StrictModel, Switch

Direction = Literal["", "+x", "-x", "+y", "-y", "+z", "-z"]
PathText = Annotated[str, Field(min_length=1, max_length=4096)]


class CatalogBrief(StrictModel):
    """A catalogue whose files leave something open: ``scale`` tells metres a unit, ``up`` and
    ``front`` which way of the files' axes is up and which the fronts look (left out: as is usual
    for the format). Without ``fill`` its models are used only where the brief
    names them. With ``buildings`` every building of a scene (.glb) is a model of its own."""

    path: PathText
    scale: Annotated[Number, Field(gt=0, le=1e4)] = 1.0
    up: Direction = ""
    front: Direction = ""
    fill: Switch = True
    buildings: Switch = False


class GroupsBrief(StrictModel):
    """Furniture groups learned from furnished homes (``scenewright catalog learn``); they stand
    for the shipped ones of their functions, or ``beside`` them."""

    path: PathText
    beside: Switch = False


GroupsEntry = PathText | GroupsBrief
"""A file of learned groups by its path, or with how it is used."""

CatalogEntry = PathText | CatalogBrief
"""A folder of models, a model file or a library by its path, or with what its files leave open."""


def entry_of(entry: str | CatalogBrief) -> CatalogBrief:
    """An entry with everything stated.

    >>> entry_of("models").scale
    1.0
    """
    return CatalogBrief(path=entry) if isinstance(entry, str) else entry
