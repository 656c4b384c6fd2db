"""The kinds of scene there are: those shipped, and those other packages add by entry points.

Nothing is imported until it is asked for by name, so what lies below the domains can hand work to
one without knowing any.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

Row = TypeVar("Row")

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


def _entry_points() -> dict[str, EntryPoint]:
    return {entry.name: entry for entry in _entries(GROUP)}


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


@cache
def part_keys(name: str) -> tuple[str, ...]:
    """The keys that only briefs of a domain have, empty for what is no domain.

    >>> part_keys("site"), part_keys("castle")
    (('sites',), ())
    """
    model = domain_of(name).part_model() if name in domain_names() else None
    return tuple(model.model_fields) if model else ()


def load_added(group: str, domain: str, kind: type[Row]) -> tuple[Row, ...]:
    """Rows that other packages add to a table of a domain, by name: entry points of ``group``
    called ``domain.name``, each a value of ``kind``.

    Raises :class:`InputError` that names the package's entry if it cannot be loaded or is none.

    >>> load_added("scenewright.terms", "home", tuple)
    ()
    """
    found = [entry for entry in _entries(group) if entry.name.startswith(f"{domain}.")]
    return tuple(_load_row(entry, kind) for entry in sorted(found, key=lambda entry: entry.name))


def _entries(group: str) -> Iterable[EntryPoint]:
    """The entry points of a group; what finds them takes a tenth of the time of ``--help``."""
    from importlib.metadata import entry_points

    return entry_points(group=group)


def _load_row(entry: EntryPoint, kind: type[Row]) -> Row:
    """The row of an entry point."""
    place = f"the entry point '{entry.name}' of {entry.group}, {entry.value},"
    try:
        row = entry.load()
    except (ImportError, AttributeError) as error:
        remedy = "mend or uninstall the package that adds it"
        raise InputError(f"{place} cannot be loaded: {error}", remedy) from error
    if not isinstance(row, kind):
        raise InputError(f"{place} is no {kind.__name__}", "let it name one")
    return row
