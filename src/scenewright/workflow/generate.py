"""Briefs made by a seed, by the domain of a kind of scene."""

from __future__ import annotations

from typing import Any

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_names, domain_of


def generate(kind: str, *, seed: int = 0, **asked: Any) -> Brief:
    """A brief of a kind of scene, made by a seed: of a ``home`` for ``rooms``, ``area``,
    ``storeys`` and ``outline``, of a ``hall`` for ``use``, ``area`` and ``outline``; what is left
    out or None is as usual. Raises :class:`InputError` for what cannot be built.

    >>> brief = generate("home", rooms=4, area=90.0, seed=7)
    >>> brief == generate("home", rooms=4, area=90.0, seed=7), len(brief.rooms) > 5
    (True, True)
    """
    if kind not in domain_names():
        able = [name for name in domain_names() if domain_of(name).has("generate")]
        raise InputError(f"'{kind}' is no kind of scene", f"choose {', '.join(able)}")
    given = {key: value for key, value in asked.items() if value is not None}
    brief: Brief = domain_of(kind).verb("generate")(given, seed)
    return brief
