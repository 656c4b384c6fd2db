"""Values that are recognized by being the very same, however much they hold."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, Generic, TypeVar, cast

T = TypeVar("T")
Function = TypeVar("Function", bound=Callable[..., Any])


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


def once(most: int) -> Callable[[Function], Function]:
    """A function that gives the result it gave before for the very same arguments, however much
    they hold, of so many results at ``most``; arguments are not to change, nor to be named.

    >>> seen = once(2)(lambda row: [*row])
    >>> here = [1.0]
    >>> seen(here) is seen(here), seen(here) is seen([1.0])
    (True, False)
    """

    def remember(function: Function) -> Function:
        known: dict[tuple[int, ...], tuple[Any, tuple[object, ...]]] = {}

        @wraps(function)
        def call(*arguments: object) -> Any:
            key = tuple(map(id, arguments))  # kept with their result, so that none is used again
            found = known.get(key)
            if found is None:
                found = function(*arguments), arguments
                if len(known) >= most:
                    known.clear()
                known[key] = found
            return found[0]

        return cast(Function, call)

    return remember
