"""What a compiled function is made of, read from its code: not from files, lines or dates.

The compiler copies into a kernel the functions it calls and the constants it names. So the digest
of a kernel is that of its own instructions and of all they name, to the end. Comments, line
numbers, the words of docstrings and whatever else stands in the file make no difference.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from hashlib import blake2b
from inspect import unwrap
from types import CodeType, FunctionType, ModuleType
from typing import Any, NamedTuple

import numpy as np

SIZE = 12
"""Bytes of a digest."""
FOREIGN = ("math", "numba", "numpy")
"""Packages that have versions: what is named in them is not looked at."""


class CodeParts(NamedTuple):
    """The digest of one function's own code, and the compiled functions it names."""

    own: bytes
    named: tuple[Callable[..., Any], ...]


def code_digest(function: Callable[..., Any]) -> bytes:
    """The digest of a function and of all functions, records and constants its code names.

    >>> def half(x): return x / 2
    >>> before = code_digest(half)
    >>> def half(x): return x / 2  # the same, elsewhere
    >>> code_digest(half) == before
    True
    >>> def half(x): return x / 3
    >>> code_digest(half) == before
    False
    """
    reached, waiting = {function: None}, [function]
    while waiting:
        for part in code_parts(waiting.pop()).named:
            if part not in reached:
                reached[part] = None
                waiting.append(part)
    digest = blake2b(digest_size=SIZE)
    for part in reached:
        digest.update(code_parts(part).own)
    return digest.digest()


@cache
def code_parts(function: Callable[..., Any]) -> CodeParts:
    """What one function, compiled or plain, is made of, without those it calls."""
    plain = _plain_function(function)
    if plain is None:
        raise TypeError(f"{function!r} has no Python code")
    digest, named = blake2b(digest_size=SIZE), []
    options = sorted(getattr(function, "targetoptions", {}).items())
    digest.update(repr((plain.__qualname__, plain.__defaults__, options)).encode())
    for text in _describe_code(plain.__code__, plain.__doc__):
        digest.update(text.encode())
    for name, value in _named_values(plain):
        digest.update(f"{name}=".encode())
        for part in _flatten(value):
            if _plain_function(part) is not None:
                named.append(part)
            else:
                digest.update(_describe_value(part).encode())
    return CodeParts(digest.digest(), tuple(named))


def _plain_function(value: Any) -> FunctionType | None:
    """The Python function behind a compiled one, or itself; ``None`` of what has no code."""
    function = getattr(value, "py_func", value)
    function = unwrap(function) if callable(function) else function
    return function if isinstance(function, FunctionType) else None


def _describe_code(code: CodeType, words: str | None = None) -> Iterator[str]:
    """Instructions, names and constants; the docstring is ``words`` and left out."""
    yield repr((code.co_code, code.co_names, code.co_varnames, code.co_freevars))
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _describe_code(constant)
        elif words is None or constant != words:
            yield repr(sorted(constant) if isinstance(constant, frozenset) else constant)


def _named_values(function: FunctionType) -> Iterator[tuple[str, Any]]:
    """The objects a function's code names: of its closure, globals, and taken from modules."""
    for cell in function.__closure__ or ():
        yield "cell", cell.cell_contents
    names = _names(function.__code__)
    for name in names:
        value = function.__globals__.get(name)
        if not isinstance(value, ModuleType):
            yield name, value
        elif value.__name__.partition(".")[0] not in FOREIGN:
            yield from ((part, getattr(value, part)) for part in names if hasattr(value, part))


def _names(code: CodeType) -> list[str]:
    inner = [_names(part) for part in code.co_consts if isinstance(part, CodeType)]
    return sorted({*code.co_names, *(name for part in inner for name in part)})


def _flatten(value: Any) -> Iterator[Any]:
    """The value, or those in a tuple or list of values."""
    if isinstance(value, tuple | list):
        for part in value:
            yield from _flatten(part)
    else:
        yield value


def _describe_value(value: Any) -> str:
    """Records by their fields, constants by their value, all else by its type's name."""
    if isinstance(value, np.ndarray):
        return f"{value.dtype} {value.shape} {value.tobytes()!r};"
    if isinstance(value, type):
        return f"{value.__qualname__} {getattr(value, '_fields', ())};"
    if isinstance(value, bool | int | float | complex | str | bytes | np.generic | None):
        return f"{value!r};"
    return f"{type(value).__qualname__};"
