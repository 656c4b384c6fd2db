"""Credits: who made the models that draw a solution and the data its layout was learned from, and
on what terms they may be used."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

from scenewright.core.catalog import OWN, Catalog, asset_of
from scenewright.core.registry import domain_of
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution

UNKNOWN = "not stated"


class Credit(NamedTuple):
    """What one author gave on the same terms: ``assets`` by id, each with the name of its model
    and how often it stands; ``licence`` and ``author`` are ``not told`` where no file does."""

    author: str
    licence: str
    assets: tuple[tuple[str, str, int], ...]


def credits_of(pieces: Iterable[Piece], models: Catalog) -> tuple[Credit, ...]:
    """The credits of all models that draw some pieces, the user's own first."""
    counts: Counter[str] = Counter()
    for piece in pieces:
        asset = asset_of(piece, models)
        if asset:
            counts[asset.id] += 1
    rows: dict[tuple[bool, str, str], list[tuple[str, str, int]]] = {}
    for name, count in sorted(counts.items()):
        asset = models.assets[name]
        ours = not name.startswith(OWN)
        key = (ours, asset.author or UNKNOWN, asset.licence or UNKNOWN)
        rows.setdefault(key, []).append((name, asset.name, count))
    return tuple(
        Credit(author, licence, tuple(rows[ours, author, licence]))
        for ours, author, licence in sorted(rows)
    )


def credits_of_solution(solution: Solution, models: Catalog) -> tuple[Credit, ...]:
    """The credits of a solution: of the models that draw it, and of the data that its layout was
    learned from, as its domain names it."""
    domain = domain_of(solution.brief.domain)
    sources = domain.verb("sources")(solution.brief) if domain.has("sources") else ()
    return with_sources(credits_of(solution.pieces, models), sources)


def with_sources(
    rows: tuple[Credit, ...], sources: Iterable[tuple[str, str, str]]
) -> tuple[Credit, ...]:
    """Credits with those of data, each by its author, licence and what was learned from it.

    >>> line(with_sources((), [("OpenStreetMap contributors", "ODbL-1.0", "style europe")]))
    'OpenStreetMap contributors (ODbL-1.0)'
    """
    return (*rows, *(Credit(author, licence, ((of, of, 1),)) for author, licence, of in sources))


def document(rows: tuple[Credit, ...]) -> list[dict[str, object]]:
    """The credits as plain lists: of every author and licence the ids of the assets."""
    return [
        {
            "author": row.author,
            "licence": row.licence,
            "assets": [name for name, _, _ in row.assets],
        }
        for row in rows
    ]


def line(rows: tuple[Credit, ...]) -> str:
    """All authors and licences in one line.

    >>> line((Credit("Jane Doe", "CC0-1.0", ()), Credit("Scenewright", "Apache-2.0", ())))
    'Jane Doe (CC0-1.0); Scenewright (Apache-2.0)'
    """
    return "; ".join(f"{row.author} ({row.licence})" for row in rows)
