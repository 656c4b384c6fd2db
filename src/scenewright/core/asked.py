"""What a person asks for by name and value, as the named tuple it is for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, TypeVar

from scenewright.core.errors import InputError

Request = TypeVar("Request", bound="NamedTuple")


def read_asked(request: type[Request], asked: Mapping[str, Any], kind: str) -> Request:
    """The request with what was ``asked``, its defaults else; a key it does not have is refused.

    >>> class Size(NamedTuple):
    ...     area: float = 1.0
    >>> read_asked(Size, {"area": 2.0}, "home")
    Size(area=2.0)
    """
    unknown = next((key for key in asked if key not in request._fields), None)
    if unknown is not None:
        known = ", ".join(request._fields)
        raise InputError(f"a {kind} is not asked for by '{unknown}'", f"give any of {known}")
    make: Callable[..., Request] = request
    return make(**asked)
