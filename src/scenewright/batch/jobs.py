"""What is to be done: the files of a batch, the names of their results, and what they depend on."""

from __future__ import annotations

import hashlib
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from scenewright._version import __version__
from scenewright.batch.fingerprints import Look as Stamps
from scenewright.batch.fingerprints import list_dependencies
from scenewright.batch.fingerprints import look as stamps_of_file
from scenewright.core.atomic_file import note_read
from scenewright.core.errors import InputError
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.formats import SAMPLE, formats, suffix_of
from scenewright.workflow.looks import OF_LOOKS

TAKEN = ("summary", "manifest")
"""Names in the folder of results that are not a scene's."""
MANIFEST = "manifest.jsonl"
"""What tells of a set of plans or scenes: no input, in whatever folder."""


class Limits(NamedTuple):
    """Workers, memory of each in GiB, and seconds for a file."""

    jobs: int
    memory: float
    time: float


class Variation(NamedTuple):
    """What is made of every plan: a home a seed of ``seeds`` (none: one, with the seed of the
    options), each in a number of ``looks`` (0: as it is asked for), and what of them varies."""

    seeds: Sequence[int] = ()
    looks: int = 0
    vary: tuple[str, ...] = OF_LOOKS


AS_ASKED = Variation()
"""One home a plan, as it is asked for."""


class BatchOptions(NamedTuple):
    """How every file is laid out and written."""

    formats: tuple[str, ...]
    preset: str
    solver: str | None
    seconds: float | None
    steps: int | None
    seed: int
    keep: bool
    catalogs: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()
    scale: float = 1.0
    hidden_levels: bool = False
    accessible: bool = False
    style: str = ""
    layouts: int | None = None
    map_options: MapOptions = AS_IT_IS
    vary: tuple[str, ...] = ()
    clutter: str = "none"


class Job(NamedTuple):
    """One file to be done: where it is, the name of its results without suffix (with ``/``
    between folders), where they go, a digest of all they depend on, the seed and the look."""

    source: str
    name: str
    outputs: tuple[Path, ...]
    key: str
    seed: int = 0
    look: int = 0


def list_jobs(
    sources: Sequence[str | os.PathLike[str]],
    out: Path,
    options: BatchOptions,
    variation: Variation = AS_ASKED,
) -> tuple[Job, ...]:
    """The files of a batch, each once, in the order given; folders are searched through.

    Results are named as the files, in the same folders below; the suffix of the file is kept
    where two files would share a name, and a number added where that is not enough. Of several
    seeds and looks the numbers follow: ``flat-7-2`` is the second look of seed 7.
    """
    found = _find_files(sources, out)
    if not found:
        raise InputError("no files to lay out", "give files or folders that hold briefs")
    once = cache(stamps_of_file)  # many files name one catalogue
    return tuple(
        job
        for source, name in zip(found, _names(found), strict=True)
        for job in _vary(
            source, name, out, options, variation, _digest_content(source, options, once)
        )
    )


def _vary(
    source: str, name: str, out: Path, options: BatchOptions, variation: Variation, content: bytes
) -> Iterator[Job]:
    """The jobs of one file: a scene a seed and a look."""
    for seed in variation.seeds or (options.seed,):
        for look in range(1, variation.looks + 1) if variation.looks else (0,):
            end = f"-{seed}" * bool(variation.seeds) + f"-{look}" * bool(look)
            outputs = tuple(out / f"{name}{end}{suffix}" for suffix in options.formats)
            said = repr((__version__, options._replace(seed=seed), look)).encode()
            key = hashlib.blake2b(said + content, digest_size=16).hexdigest()
            yield Job(source, f"{name}{end}", outputs, key, seed, look)


def _find_files(sources: Sequence[str | os.PathLike[str]], out: Path) -> dict[str, PurePosixPath]:
    """The files by where they are, with their place below the folder they were found in."""
    suffixes = {row.suffix for row in formats() if row.reader}
    found: dict[str, PurePosixPath] = {}
    seen: set[str] = set()
    for source in sources:
        text = os.fspath(source)
        if text.startswith(SAMPLE):
            found[text] = PurePosixPath(text.removeprefix(SAMPLE) + ".json")
            continue
        for path, place in _files(Path(text), out, suffixes):
            if os.path.realpath(path) not in seen:
                seen.add(os.path.realpath(path))
                found[str(path)] = place
    return found


def _files(path: Path, out: Path, suffixes: set[str]) -> Iterator[tuple[Path, PurePosixPath]]:
    """A file, or those of a folder that can be read, but for hidden ones and the results."""
    if not path.is_dir():
        yield path, PurePosixPath(path.name)
        return
    if os.path.realpath(path) == os.path.realpath(out):
        raise InputError("is where the results go", "give another -o", file=str(path))
    for top, folders, names in os.walk(path):
        folders[:] = sorted(
            f
            for f in folders
            if not f.startswith(".") and os.path.realpath(Path(top, f)) != os.path.realpath(out)
        )
        for name in sorted(names):
            file = Path(top, name)
            scene = suffix_of(name).lower() in suffixes and not name.startswith(".")
            if scene and name != MANIFEST and file.is_file():
                yield file, PurePosixPath(file.relative_to(path).as_posix())


def _names(found: dict[str, PurePosixPath]) -> list[str]:
    """A name for each, none twice, not even on systems that do not tell A from a."""
    places = list(found.values())
    stems = Counter(_stem(place).casefold() for place in places)
    names: list[str] = []
    taken = set(TAKEN)
    for place in places:
        plain = _stem(place)
        wanted = plain if stems[plain.casefold()] == 1 else str(place)
        name, count = wanted, 1
        while name.casefold() in taken:
            count += 1
            name = f"{wanted}-{count}"
        taken.add(name.casefold())
        names.append(name)
    return names


def _stem(place: PurePosixPath) -> str:
    """The place of a file without the suffix of its format.

    >>> _stem(PurePosixPath("old/town.city.json"))
    'old/town'
    """
    return str(place).removesuffix(suffix_of(place))


def _digest_content(source: str, options: BatchOptions, stamps: Stamps) -> bytes:
    """A digest of a file's content, and of names, times and sizes of the catalogues it names; a
    file that cannot be read has that of nothing."""
    named = (*options.catalogs, *options.groups, *filter(None, [options.style]))
    beside = [stamps(path) for path in list_dependencies(source, named)]
    digest = hashlib.blake2b(repr(beside).encode(), digest_size=16)
    try:
        if not source.startswith(SAMPLE) and os.path.isfile(source):
            note_read(source)
            with open(source, "rb") as file:
                digest.update(hashlib.file_digest(file, "blake2b").digest())
    except OSError:
        pass
    return digest.digest()
