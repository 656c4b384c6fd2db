"""Kinds that a name which is none may mean: what a message offers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches

from scenewright.core.kind import Kind

MOST = 4
"""Kinds offered at once."""


def suggest_kinds(name: str, kinds: Mapping[str, Kind]) -> list[str]:
    """The categories a name may mean: those with that word for them, in any language, those it is
    a part of, those in one of whose phrases it stands; else those spelt like it that have words.

    >>> from scenewright.catalog.kinds import KINDS
    >>> [suggest_kinds(name, KINDS)[:1] for name in ("couch", "till", "rope", "bokcase", "unicorn")]
    [['sofa'], ['checkout'], ['rope_barrier'], ['bookcase'], []]
    """
    said = name.casefold().replace("_", " ").strip()
    phrases = {key: list(_phrases(kind)) for key, kind in kinds.items()}
    named = [
        *(key for key in kinds if said in phrases[key]),
        *(key for key in kinds if said in key.split("_")),
        *(key for key in kinds if any(said in phrase.split() for phrase in phrases[key])),
    ]
    spelt = [key for key, kind in kinds.items() if kind.words]
    return list(dict.fromkeys(named or get_close_matches(name, spelt, MOST)))[:MOST]


def list_called(name: str, kinds: Mapping[str, Kind]) -> list[str]:
    """The categories a name, or else its last word, says exactly, in any language.

    >>> from scenewright.catalog.kinds import KINDS
    >>> [list_called(name, KINDS)[:1] for name in ("leather sofa", "Kleiderschrank", "kayak")]
    [['sofa'], ['wardrobe'], []]
    """
    said = name.casefold().replace("_", " ").split() or [""]
    for word in (" ".join(said), said[-1]):
        found = [
            key
            for key, kind in kinds.items()
            if word == key.replace("_", " ") or word in _phrases(kind)
        ]
        if found:
            return found
    return []


def offer_kinds(name: str, kinds: Mapping[str, Kind]) -> str:
    """What to write instead of a name that is no kind.

    >>> offer_kinds("unicorn", {})
    'see: scenewright list assets'
    """
    near = suggest_kinds(name, kinds)
    return f"use one of: {', '.join(near)}" if near else "see: scenewright list assets"


def _phrases(kind: Kind) -> Iterable[str]:
    return (phrase for words in kind.words for _, listed in words.phrases for phrase in listed)
