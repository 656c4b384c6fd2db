"""What belongs to other kinds of scene: a brief says nothing of another's."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.registry import DEFAULT, SHIPPED, domain_names, domain_of, part_keys

FORMAT = Brief.model_fields["format"].default


def check_domain(brief: Brief) -> None:
    """InputError where a brief says what its domain does not know (:attr:`Domain.lacks`).

    >>> check_domain(Brief.model_validate({"domain": "hall", "accessible": True,
    ...     "rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]}))
    Traceback (most recent call last):
    scenewright.core.errors.InputError: accessible: is given, but the brief is of a hall; leave it \
out, or set "domain": "home"
    """
    domain = domain_of(brief.domain)
    for key in domain.lacks:
        if getattr(brief, key):
            raise _foreign(brief.domain, _knowing("lacks", key), key)
    for number, room in enumerate(brief.rooms):
        for key in domain.rooms_lack:
            if getattr(room, key):
                raise _foreign(brief.domain, _knowing("rooms_lack", key), f"rooms[{number}].{key}")


def check_parts(document: Mapping[str, Any]) -> None:
    """InputError where a document has keys that belong to the part of another domain.

    >>> check_parts({"rooms": [], "sites": [{}]})
    Traceback (most recent call last):
    scenewright.core.errors.InputError: sites: are given, but the brief is of a home; leave them \
out, or set "domain": "site"
    """
    own = document.get("domain", DEFAULT)
    if own not in domain_names():
        return
    for name in domain_names():
        for key in part_keys(name):
            if document.get(key) and key not in part_keys(own):
                raise _foreign(own, (name,), key)


def is_brief(document: object) -> bool:
    """Whether a JSON document is meant as a brief: it says so, or has rooms or the part of a
    domain and no other format.

    >>> is_brief({"rooms": []}), is_brief({"format": "scenewright/solution", "brief": {}})
    (True, False)
    """
    if not isinstance(document, Mapping) or document.get("format", FORMAT) != FORMAT:
        return False
    keys = {"rooms"}.union(*map(part_keys, domain_names()))
    return "format" in document or not keys.isdisjoint(document)


def _knowing(field: str, key: str) -> tuple[str, ...]:
    """The shipped domains that know a key."""
    rows = [domain_of(name) for name in SHIPPED]
    return tuple(
        row.name
        for row in rows
        if key not in getattr(row, field) and (row.rooms or field == "lacks")
    )


def _foreign(domain: str, knowing: tuple[str, ...], place: str) -> InputError:
    many = place.endswith("s")
    fault = f"{'are' if many else 'is'} given, but the brief is of a {domain}"
    instead = " or ".join(f'"{name}"' for name in knowing)
    remedy = f'leave {"them" if many else "it"} out, or set "domain": {instead}'
    return InputError(fault, remedy, place=place)
