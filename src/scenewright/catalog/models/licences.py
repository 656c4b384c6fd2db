"""Who made the models of a folder and on what terms: its licence file, where models do not tell."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from scenewright.catalog.models.files import whole
from scenewright.catalog.models.model import Model, clean
from scenewright.core.errors import InputError

MOST_BYTES = 65536
NAMES = re.compile(r"(licen[cs]e|copying|copyright)([-_. ].*)?(\.(txt|md))?", re.I)
TERMS = (
    ("CC0-1.0", r"\bCC0\b|Creative Commons Zero|publicdomain/zero"),
    ("CC-BY-NC-SA", r"\bCC[- ]BY[- ]NC[- ]SA\b|by-nc-sa/"),
    ("CC-BY-NC", r"\bCC[- ]BY[- ]NC\b|by-nc/|Attribution-NonCommercial"),
    ("CC-BY-SA", r"\bCC[- ]BY[- ]SA\b|by-sa/|Attribution-ShareAlike"),
    ("CC-BY-ND", r"\bCC[- ]BY[- ]ND\b|by-nd/|Attribution-NoDerivat"),
    ("CC-BY", r"\bCC[- ]BY\b|creativecommons.org/licenses/by/|Creative Commons Attribution"),
    ("Apache-2.0", r"Apache License,?\s+Version 2"),
    ("MIT", r"\bMIT License\b|Permission is hereby granted, free of charge"),
)
"""Short names of usual licences and what their texts say, the narrower first."""
MAKER = r"(?:created(?:/distributed)?|made|modelled|designed) by:?\s+([^\n(]{2,80})"


class LicenceTerms(NamedTuple):
    """A licence in short and the author it names; either may be empty."""

    licence: str
    author: str


def apply_licences(models: Sequence[Model], top: Path) -> tuple[Model, ...]:
    """The models with the licence and author of the nearest licence file of their folders, up to
    ``top``, where they tell none themselves."""

    @cache
    def near(folder: Path) -> LicenceTerms:
        found = terms_in(folder)
        inside = folder != top and top in folder.parents
        return found or (near(folder.parent) if inside else LicenceTerms("", ""))

    return tuple(_apply_terms(model, near(Path(model.source).parent)) for model in models)


def terms_of(text: str, name: str = "") -> LicenceTerms:
    """What a licence file says.

    >>> terms_of("City kit. Created by Jane Doe (example.org). License: CC0")
    LicenceTerms(licence='CC0-1.0', author='Jane Doe')
    """
    licence = next((short for short, said in TERMS if re.search(said, text, re.I)), "")
    maker = re.search(MAKER, text, re.I)
    return LicenceTerms(
        licence or f"see {name}" * bool(name), clean(maker[1]).strip(" .,-") if maker else ""
    )


def terms_in(folder: Path) -> LicenceTerms | None:
    """What the licence file of a folder says; None without one."""
    try:
        files = sorted(f for f in folder.iterdir() if NAMES.fullmatch(f.name) and f.is_file())
        return (
            terms_of(whole(files[0], MOST_BYTES).decode("utf-8", "replace"), files[0].name)
            if files
            else None
        )
    except (OSError, InputError):
        return None


def _apply_terms(model: Model, terms: LicenceTerms) -> Model:
    if model.licence:
        return model
    return model._replace(licence=terms.licence, author=model.author or terms.author)
