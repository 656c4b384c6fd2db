"""The catalog of a brief: what is shipped, and every model of the catalogues it names.

A catalogue is a folder of model files, a library or one file (:mod:`scenewright.models`). It is
read once and kept until a file of it changes.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path, PurePath
from typing import NamedTuple

from scenewright.assets import shipped
from scenewright.brief_catalog import CatalogBrief, entry_of
from scenewright.catalog import Asset, Catalog
from scenewright.errors import InputError
from scenewright.models import MOST_IN_ALL, LibraryReport, report, suffixes
from scenewright.models.as_asset import asset_of
from scenewright.models.categories import BUILDING, category_of
from scenewright.models.model import Model, Options

__all__ = ["BUILDING", "OWN", "catalog_of", "named"]

OWN = "model:"
"""How the ids of assets begin that are models of a user's catalogues."""
Stamp = tuple[tuple[str, int, int], ...]
"""Name, time of the last change and bytes of every file."""


class Taken(NamedTuple):
    """A catalogue as read: its entry in the brief and what its files hold."""

    entry: CatalogBrief
    report: LibraryReport


def catalog_of(catalogs: Sequence[str | CatalogBrief]) -> Catalog:
    """What is shipped and every asset of some catalogues; InputError for one without any.

    >>> catalog_of([]) is shipped()
    True
    """
    if not catalogs:
        return shipped()
    entries = tuple(entry_of(entry) for entry in catalogs)
    return _stocked(entries, tuple(_stamp(Path(entry.path)) for entry in entries))


def named(catalog: Catalog, name: str) -> Asset:
    """The asset a brief means: one of its own catalogues by its id, name or file (``tower``,
    ``towers/tall.glb``, ``city.sh3f/12``), else a shipped one by its id.

    Raises InputError that tells what comes near, or what the name could mean.
    """
    meant = catalog.names.get(name.casefold(), ())
    if len(meant) == 1:
        return catalog.assets[meant[0]]
    if name in catalog.assets:
        return catalog.assets[name]
    if meant:
        shown = ", ".join(meant[:4]) + ", …" * (len(meant) > 4)
        raise InputError(f"'{name}' may be any of {len(meant)} models", f"use one of: {shown}")
    if name.casefold() in catalog.broken:
        raise InputError(f"'{name}' cannot be used: {catalog.broken[name.casefold()]}",
                         "mend the file or use another model")  # fmt: skip
    raise InputError(f"there is no model '{name}'", _near(name, catalog))


def _near(name: str, catalog: Catalog) -> str:
    buildings = [asset.id for asset in catalog.of(BUILDING)]
    own = [asset for asset in catalog.assets if asset.startswith(OWN)]
    found = get_close_matches(name.casefold(), {*catalog.names, *buildings}, 4)
    found = found or get_close_matches(name, catalog.assets, 4) or [*own, *buildings][:8]
    return f"use one of: {', '.join(found)}"


@lru_cache(maxsize=2)
def _stocked(entries: tuple[CatalogBrief, ...], stamps: tuple[Stamp, ...]) -> Catalog:
    del stamps
    taken = [Taken(entry, _report(entry)) for entry in entries]
    faces = sum(len(part.faces) for one in taken for m in one.report.models for part in m.parts)
    if faces > MOST_IN_ALL:
        raise InputError(f"the catalogues hold {faces:,} triangles",
                         f"{MOST_IN_ALL:,} can be held: give smaller ones")  # fmt: skip
    usual = shipped()
    assets = dict(usual.assets)
    names: dict[str, tuple[str, ...]] = {}
    for one in taken:
        for model in one.report.models:
            asset = asset_of(_fresh(model, assets), category_of(model))
            assets[asset.id] = asset
            for name in {told.casefold() for told in _names(model, asset, one.entry)}:
                names[name] = (*names.get(name, ()), asset.id)
    broken = {
        name.casefold(): row.reason
        for one in taken for row in one.report.skipped for name in _broken(row.name)
    }  # fmt: skip
    return Catalog(usual.kinds, assets, names, broken)


def _report(entry: CatalogBrief) -> LibraryReport:
    """What a catalogue holds; it must be something."""
    found = report(entry.path, Options(entry.up, entry.front, entry.scale))
    if not found.models:
        first, more = found.skipped[:1], len(found.skipped) - 1
        told = f"{first[0].name}: {first[0].reason}" if first else "there are no model files"
        fault = f"holds no usable model ({told})" + f" and {more} more" * (more > 0)
        raise InputError(fault, f"give one of: {', '.join(suffixes())}", file=entry.path)
    return found


def _fresh(model: Model, taken: dict[str, Asset]) -> Model:
    """The model under an id that no asset has yet."""
    number, name = 1, model.id
    while f"{OWN}{name}" in taken:
        number, name = number + 1, f"{model.id}-{number + 1}"
    return model._replace(id=name)


def _names(model: Model, asset: Asset, entry: CatalogBrief) -> Iterator[str]:
    """What a model may be called: its id, its own name, its file below the catalogue."""
    top, file = PurePath(entry.path), PurePath(model.source)
    inner = model.id.partition("/")[2]
    below = file.relative_to(top) if file != top else PurePath(file.name)
    yield from (asset.id, asset.id.removeprefix(OWN), model.name)
    for path in {below, PurePath(top.name) / below if file != top else below}:
        for told in (path.as_posix(), path.with_suffix("").as_posix()):
            yield f"{told}/{inner}" if inner else told
    if inner:
        yield inner


def _broken(name: str) -> tuple[str, ...]:
    path = PurePath(name)
    return (name, path.with_suffix("").as_posix(), path.stem) if path.name else (name,)


def _stamp(path: Path) -> Stamp:
    """Every file of a catalogue with its time and size; empty if there is nothing."""
    if not path.is_dir():
        files = [path]
    else:
        files = [Path(top, name) for top, _, names in os.walk(path) for name in names]
    found = []
    for file in files:
        try:
            told = file.stat(follow_symlinks=False)
        except OSError:
            continue
        found.append((str(file), told.st_mtime_ns, told.st_size))
    return tuple(sorted(found))
