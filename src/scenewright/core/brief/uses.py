"""What buildings are to be used for: how many of each use, and how much of their floor."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import Field, model_validator

from scenewright.core.brief.fields import Number, StrictModel, Whole

UseName = Literal["dwelling", "outbuilding", "farm", "shop", "works", "public"]
USES: tuple[UseName, ...] = get_args(UseName)


class UseWish(StrictModel):
    """How many buildings of a use there are to be, or how many square metres of ``floor`` they are
    to have; of both given, as many as have about that floor."""

    count: Annotated[Whole, Field(ge=0, le=5000)] | None = None
    floor: Annotated[Number, Field(ge=0, le=1e6)] | None = None

    @model_validator(mode="after")
    def _says_something(self) -> UseWish:
        if self.count is None and self.floor is None:
            raise ValueError('give "count" or "floor"')
        return self


def use_words(use: UseName, count: int) -> str:
    """A use in words, for messages.

    >>> use_words("shop", 1), use_words("public", 2), use_words("works", 1)
    ('shop', 'public halls', 'workshop')
    """
    one = {"works": "workshop", "public": "public hall"}.get(use, use)
    return one if count == 1 else f"{one}s"
