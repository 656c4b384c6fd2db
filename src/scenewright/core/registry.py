"""The kinds of scene there are: those shipped, and those other packages add by entry points.

Nothing is imported until it is asked for by name, so what lies below the domains can hand work to
one without knowing any.
"""

from __future__ import annotations

from functools import cache
from importlib import import_module
from importlib.metadata import entry_points
from typing import Any, NamedTuple

from scenewright.core.errors import InputError

DEFAULT = "home"
"""The domain of a brief that states none."""
SHIPPED = ("home", "hall", "site", "village", "extend")
"""One name a package of :mod:`scenewright.domains`."""
GROUP = "scenewright.domains"
"""The entry points by which other packages add theirs: ``meadow = "picnic.meadow:DOMAIN"``."""


class Format(NamedTuple):
    """One row of the table of files: its suffix, what it is for, the modules that read and write
    it (empty if they do not), and the domain it belongs to (empty: any)."""

    suffix: str
    about: str
    reader: str = ""
    writer: str = ""
    domain: str = ""

    def holds(self, kind: str) -> bool:
        """Whether such files hold what is of a domain, named by its ``kind``."""
        return not self.domain or kind == self.domain


@cache
def domain_names() -> tuple[str, ...]:
    """The names of all domains, those shipped first.

    >>> domain_names()[:3]
    ('home', 'hall', 'site')
    """
    return (*SHIPPED, *sorted(_entry_points().keys() - set(SHIPPED)))


def _entry_points() -> dict[str, Any]:
    return {entry.name: entry for entry in entry_points(group=GROUP)}


@cache
def domain_of(name: str) -> Any:
    """The :class:`scenewright.domains.contract.Domain` of a name.

    Raises :class:`InputError` if there is none of that name.

    >>> domain_of("hall").name
    'hall'
    """
    if name in SHIPPED:
        return import_module(f"{GROUP}.{name}").DOMAIN
    entry = _entry_points().get(name)
    if entry is None:
        known = ", ".join(domain_names())
        raise InputError(f"unknown domain '{name[:40]}'", f"use one of: {known}")
    return entry.load()
