"""Values that are recognized by being the very same, however much they hold."""

from __future__ import annotations

from typing import Generic, TypeVar

T = TypeVar("T")


class Same(Generic[T]):
    """A value as the key of a cache: equal to another only if both hold one and the same object.

    >>> here = [1.0]
    >>> Same(here) == Same(here), Same(here) == Same([1.0])
    (True, False)
    """

    __slots__ = ("value",)

    def __init__(self, value: T) -> None:
        """``value``, which is not to change while it is a key."""
        self.value = value

    def __hash__(self) -> int:
        """Of where the value is kept."""
        return id(self.value)

    def __eq__(self, other: object) -> bool:
        """Whether both hold the same object."""
        return isinstance(other, Same) and self.value is other.value
