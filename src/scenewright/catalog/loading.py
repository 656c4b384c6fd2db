"""The catalog of a brief: what is shipped, and every model of the catalogues it names.

A catalogue is a folder of model files, a library or one file (:mod:`scenewright.catalog.models`),
or a name under which one is registered. What each model is, is inferred and corrected by the
catalogue's table (:mod:`scenewright.catalog.models.listing`). It is read once and kept until a file
of it changes.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from difflib import get_close_matches
from functools import lru_cache
from hashlib import sha256
from pathlib import Path, PurePath
from typing import NamedTuple

from scenewright._version import __version__
from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import KINDS
from scenewright.catalog.models import MOST_IN_ALL, ROWS, SIDECARS, LibraryReport, report, suffixes
from scenewright.catalog.models.as_asset import asset_of
from scenewright.catalog.models.categories import BUILDING, CITY
from scenewright.catalog.models.fates import list_fates
from scenewright.catalog.models.licences import apply_licences
from scenewright.catalog.models.listing import Listed, list_models, table_beside, table_of
from scenewright.catalog.models.model import ImportOptions, Model, SkippedModel
from scenewright.catalog.models.model_cache import keep, load_cached
from scenewright.catalog.models.register import table_file, where
from scenewright.core.atomic_file import note_read
from scenewright.core.brief.catalog import CatalogBrief, entry_of
from scenewright.core.brief.fields import BUILDING as BUILDING_SIDE
from scenewright.core.brief.fields import FURNITURE
from scenewright.core.brief.input_report import InputReport, report_input
from scenewright.core.catalog import OWN, Asset, Catalog
from scenewright.core.errors import InputError
from scenewright.core.workspace import check_inside

__all__ = [
    "BUILDING",
    "ONLY_NAMED",
    "ReadCatalog",
    "Stamp",
    "catalog_of",
    "find_asset",
    "read_entry",
    "stamps_of",
]

ONLY_NAMED = "named"
"""The category of models that are used only where a brief names them."""
COPY = "models.npz"
"""What is kept of a registered catalogue's models, beside its table."""
Stamp = tuple[tuple[str, int, int], ...]
"""Name, time of the last change and bytes of every file."""


class ReadCatalog(NamedTuple):
    """A catalogue as read: where it is, what each of its models is taken for, and what could not
    be used and why."""

    path: Path
    models: tuple[Listed, ...]
    skipped: tuple[SkippedModel, ...]

    @property
    def report(self) -> InputReport:
        """What became of each of its models."""
        known = [row.about for row in ROWS if row.suffix == self.path.suffix.lower()]
        fates = list_fates(self.models, self.skipped)
        return report_input(fates, format=known[0] if known else "models")


def catalog_of(catalogs: Sequence[str | CatalogBrief]) -> Catalog:
    """What is shipped and every asset of some catalogues; InputError for one without any.

    >>> catalog_of([]) is shipped()
    True
    """
    if not catalogs:
        return shipped()
    entries = tuple(entry_of(entry) for entry in catalogs)
    return _load_catalog(entries, tuple(stamp for entry in entries for stamp in stamps_of(entry)))


def read_entry(entry: CatalogBrief) -> ReadCatalog:
    """The models of a catalogue, understood and corrected by its table."""
    path, table = _source(entry)
    corrections = table_of(table) if table else table_beside(path)
    found = _report(entry, path)
    stated = entry.scale != 1.0 or bool(entry.up or entry.front)
    models = list_models(apply_licences(found.models, path), corrections, stated)
    faults = ["" if one.skip else _size_fault(one) for one in models]
    usable = tuple(one for one, fault in zip(models, faults, strict=True) if not fault)
    large = (
        SkippedModel(one.model.id, fault)
        for one, fault in zip(models, faults, strict=True)
        if fault
    )
    return ReadCatalog(path, usable, (*found.skipped, *large))


def _size_fault(one: Listed) -> str:
    """Why a model is too large for what it is taken for; empty if it is not, or stands in a city
    model, whose buildings are drawn as they are."""
    if PurePath(one.model.source).suffix.lower() in CITY:
        return ""
    most = FURNITURE if one.category in KINDS and one.category != BUILDING else BUILDING_SIDE
    side = max(one.model.size)
    if side <= most:
        return ""
    return f"is {side:,.0f} m large; its category goes up to {most:.0f} m: give another scale"


def find_asset(catalog: Catalog, name: str) -> Asset:
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
        raise InputError(
            f"'{name}' cannot be used: {catalog.broken[name.casefold()]}",
            "mend the file or use another model",
        )
    raise InputError(f"unknown model '{name}'", _near(name, catalog))


def _near(name: str, catalog: Catalog) -> str:
    buildings = [asset.id for asset in catalog.of(BUILDING)]
    own = [asset for asset in catalog.assets if asset.startswith(OWN)]
    found = get_close_matches(name.casefold(), {*catalog.names, *buildings}, 4)
    found = found or get_close_matches(name, catalog.assets, 4) or [*own, *buildings][:8]
    return f"use one of: {', '.join(found)}"


@lru_cache(maxsize=2)
def _load_catalog(entries: tuple[CatalogBrief, ...], stamps: tuple[Stamp, ...]) -> Catalog:
    del stamps
    catalogues = [read_entry(entry) for entry in entries]
    faces = sum(len(p.faces) for c in catalogues for one in c.models for p in one.model.parts)
    if faces > MOST_IN_ALL:
        raise InputError(
            f"the catalogues hold {faces:,} triangles",
            f"{MOST_IN_ALL:,} can be held: give smaller ones",
        )
    usual = shipped()
    assets = dict(usual.assets)
    names: dict[str, tuple[str, ...]] = {}
    for entry, catalogue in zip(entries, catalogues, strict=True):
        for one in catalogue.models:
            if one.skip:
                continue
            asset = asset_of(_fresh(one.model, assets), one.category, one.style, one.colour)
            assets[asset.id] = asset if entry.fill else replace(asset, category=ONLY_NAMED)
            for name in {alias.casefold() for alias in _names(one.model, asset, catalogue.path)}:
                names[name] = (*names.get(name, ()), asset.id)
    broken = {name.casefold(): reason for c in catalogues for name, reason in _unusable(c)}
    return Catalog(usual.kinds, assets, names, broken)


def _unusable(catalogue: ReadCatalog) -> Iterator[tuple[str, str]]:
    """What a model may be called that cannot be used, and why."""
    for row in catalogue.skipped:
        yield from ((name, row.reason) for name in _broken(row.name))
    for one in catalogue.models:
        if one.skip:
            yield from ((name, "the table skips it") for name in _broken(one.model.id))


def _source(entry: CatalogBrief) -> tuple[Path, Path | None]:
    """Where a catalogue's models are; of a registered one, given by its name, also its table."""
    path = Path(entry.path)
    check_inside(path)
    if path.exists() or path.name != entry.path or path.suffix:
        return path, None
    table = table_file(entry.path)
    return where(entry.path), table if table.is_file() else None


def _report(entry: CatalogBrief, path: Path) -> LibraryReport:
    """What a catalogue holds; it must be something. Of a registered one a copy is kept."""
    options = ImportOptions(entry.up, entry.front, entry.scale, buildings=entry.buildings)
    copy = None if path == Path(entry.path) else table_file(entry.path).with_name(COPY)
    made_of = sha256(repr((_stamp(path), options, __version__)).encode()).hexdigest()
    ready = load_cached(copy, made_of) if copy else None
    found = ready or report(path, options)
    if copy and not ready:
        keep(copy, found, made_of)
    if not found.models:
        first, more = found.skipped[:1], len(found.skipped) - 1
        text = f"{first[0].name}: {first[0].reason}" if first else "there are no model files"
        fault = f"holds no usable model ({text})" + f" and {more} more" * (more > 0)
        raise InputError(fault, f"give one of: {', '.join(suffixes())}", file=str(path))
    return found


def _fresh(model: Model, taken: dict[str, Asset]) -> Model:
    """The model under an id that no asset has yet."""
    number, name = 1, model.id
    while f"{OWN}{name}" in taken:
        number, name = number + 1, f"{model.id}-{number + 1}"
    return model._replace(id=name)


def _names(model: Model, asset: Asset, top: Path) -> Iterator[str]:
    """What a model may be called: its id, its own name, its file below the catalogue."""
    file = PurePath(model.source)
    inner = model.id.partition("/")[2]
    below = file.relative_to(top) if file != top else PurePath(file.name)
    yield from (asset.id, asset.id.removeprefix(OWN), model.name)
    for path in {below, PurePath(top.name) / below if file != top else below}:
        for name in (path.as_posix(), path.with_suffix("").as_posix()):
            yield f"{name}/{inner}" if inner else name
    if inner:
        yield inner


def _broken(name: str) -> tuple[str, ...]:
    path = PurePath(name)
    return (name, path.with_suffix("").as_posix(), path.stem) if path.name else (name,)


def stamps_of(entry: CatalogBrief) -> tuple[Stamp, ...]:
    """Name, time and size of a catalogue's files and of the tables that correct it: what is read
    again once it changes."""
    path, table = _source(entry)
    beside = [table] if table else [path.with_name(f"{path.stem}.{name}") for name in SIDECARS]
    return tuple(_stamp(one) for one in (path, *beside))


def _stamp(path: Path) -> Stamp:
    """Every file of a catalogue with its time and size; empty if there is nothing."""
    if not path.is_dir():
        files = [path]
    else:
        files = [Path(top, name) for top, _, names in os.walk(path) for name in names]
    found = []
    for file in files:
        try:
            status = file.stat(follow_symlinks=False)
        except OSError:
            continue
        note_read(file)
        found.append((str(file), status.st_mtime_ns, status.st_size))
    return tuple(sorted(found))
