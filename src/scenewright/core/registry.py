"""The kinds of scene there are: those shipped, and those other packages add by entry points.

Nothing is imported until it is asked for by name, so what lies below the domains can hand work to
one without knowing any.
"""

from __future__ import annotations

from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from scenewright.core.errors import InputError
from scenewright.core.plugins import load_plugins

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

Row = TypeVar("Row")

DEFAULT = "home"
"""The domain of a brief that states none."""
SHIPPED = ("home", "hall", "site", "village", "extend")
"""One name a package of :mod:`scenewright.domains`."""
GROUP = "scenewright.domains"
"""The entry points by which other packages add theirs: ``meadow = "picnic.meadow:DOMAIN"``."""


JUDGED = ("reasons", "things not placed")
"""Contents of saved solutions alone: why things stand where they do, and what does not."""
SEEN = ("names", "measures", *JUDGED)
"""Contents that pictures cannot hold."""
MAPPED = ("trees and street furniture", "colours", *JUDGED)
"""Contents that maps and city models cannot hold."""


class Format(NamedTuple):
    """One row of the table of files: its suffix, what it is for, the modules that read and write
    it (empty if they do not), and the domain it belongs to (empty: any). A format that ``extends``
    is written into a copy of the file of its kind that was read, whose furniture stays; ``lacks``
    are the kinds of things such a file does not hold of a solution, in users' words."""

    suffix: str
    about: str
    reader: str = ""
    writer: str = ""
    domain: str = ""
    extends: bool = False
    lacks: tuple[str, ...] = ()

    def holds(self, kind: str) -> bool:
        """Whether such files hold what is of a domain, named by its ``kind``."""
        return not self.domain or kind == self.domain


@cache
def domain_names() -> tuple[str, ...]:
    """The names of all domains, those shipped first.

    >>> domain_names()[:3]
    ('home', 'hall', 'site')
    """
    return (*SHIPPED, *sorted(_added_domains().keys() - set(SHIPPED)))


@cache
def _added_domains() -> dict[str, Any]:
    """The domains of other packages by name; those that cannot be used are left out."""
    return dict(load_plugins(GROUP, _check_domain))


def _check_domain(entry: EntryPoint, domain: Any) -> Any:
    """A domain that has what it is asked for: its own name, verbs and tables by name."""
    whole = all(hasattr(domain, key) for key in ("name", "package", "verbs", "tables", "formats"))
    if not whole or domain.name != entry.name:
        raise TypeError(f"is no domain called '{entry.name}'")
    missing = [verb for verb in ("plan", "solve", "check", "scene", "draw") if not domain.has(verb)]
    if missing:
        raise TypeError(f"is a domain without the verb '{missing[0]}'")
    return domain


@cache
def domain_of(name: str) -> Any:
    """The :class:`scenewright.domains.contract.Domain` of a name.

    Raises :class:`InputError` if there is none of that name.

    >>> domain_of("hall").name
    'hall'
    """
    if name in SHIPPED:
        return import_module(f"{GROUP}.{name}").DOMAIN
    if name not in _added_domains():
        known = ", ".join(domain_names())
        raise InputError(f"unknown domain '{name[:40]}'", f"use one of: {known}")
    return _added_domains()[name]


@cache
def part_keys(name: str) -> tuple[str, ...]:
    """The keys that only briefs of a domain have, empty for what is no domain.

    >>> part_keys("site"), part_keys("castle")
    (('sites', 'terrain'), ())
    """
    model = domain_of(name).part_model() if name in domain_names() else None
    return tuple(model.model_fields) if model else ()


def load_added(group: str, domain: str, kind: type[Row]) -> tuple[Row, ...]:
    """Rows that other packages add to a table of a domain, by name: entry points of ``group``
    called ``domain.name``, each a value of ``kind``; what is none is left out with a warning.

    >>> load_added("scenewright.terms", "home", tuple)
    ()
    """

    def check(_: EntryPoint, row: Any) -> Row:
        if not isinstance(row, kind):
            raise TypeError(f"is no {kind.__name__}")
        return row

    return tuple(row for _, row in load_plugins(group, check, f"{domain}."))
