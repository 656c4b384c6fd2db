"""Words the shell completes: samples and files to read, names of presets, suffixes to write.

Each function gives the words that may stand where ``incomplete`` is, with a line on each. Where
none fits, the shell completes names of files.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, MutableMapping
from pathlib import Path
from typing import TYPE_CHECKING

from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from scenewright.domains.contract import Table

Words = list[tuple[str, str]]

ASKED = "_SCENEWRIGHT_COMPLETE"
"""Set by the scripts of ``--install-completion`` while a word is completed."""


def split_colon(environ: MutableMapping[str, str]) -> None:
    """Bash takes a colon for a word: what follows that of ``sample:`` is a word still empty.

    >>> words = {ASKED: "complete_bash", "COMP_WORDS": "x\\nplan\\nsample\\n:", "COMP_CWORD": "3"}
    >>> split_colon(words)
    >>> words["COMP_CWORD"]
    '4'
    """
    if environ.get(ASKED) == "complete_bash" and environ.get("COMP_WORDS", "").endswith("\n:"):
        environ["COMP_CWORD"] = str(int(environ["COMP_CWORD"]) + 1)


def inputs(incomplete: str) -> Words:
    """Samples, and files in the folder that can be read."""
    from scenewright.formats import SAMPLE, formats, samples

    names = [(name, "a sample") for name in samples()]
    words = os.environ.get("COMP_WORDS", "").split("\n")
    if os.environ.get(ASKED) == "complete_bash" and ":" in words[-2:]:
        return [(name.removeprefix(SAMPLE), about) for name, about in names]
    readable = {row.suffix: row.about for row in formats() if row.reader}
    return [*names, *_files(incomplete, readable)]


def outputs(incomplete: str) -> Words:
    """The name so far with every suffix that can be written."""
    from scenewright.formats import formats

    folder, _, name = incomplete.rpartition("/")
    stem, dot, _ = name.partition(".")
    if not dot or not stem:
        return []
    start = f"{folder}/" * ("/" in incomplete) + stem
    return [(start + row.suffix, row.about) for row in formats() if row.writer]


def presets(incomplete: str) -> Words:
    """Presets of all domains, each once."""
    return _named("presets", incomplete)


def solvers(incomplete: str) -> Words:
    """Solvers of all domains, each once."""
    return _named("solvers", incomplete)


def styles(incomplete: str) -> Words:
    """Styles of all domains."""
    from scenewright.domains import domains

    rows = (row for kind in domains() if kind.has("styles") for row in kind.verb("styles")())
    return _starting(((row["name"], row.get("about", "")) for row in rows), incomplete)


def lists(incomplete: str) -> Words:
    """What can be listed."""
    from scenewright.workflow.lists import LISTS

    return _starting(((name, "") for name in LISTS), incomplete)


def domains(incomplete: str) -> Words:
    """Kinds of scenes."""
    from scenewright.domains import domains as all_domains

    return _starting(((kind.name, kind.about) for kind in all_domains()), incomplete)


def schemas(incomplete: str) -> Words:
    """Files that have a schema."""
    return _starting(
        [("brief", "what is asked for"), ("solution", "what was laid out")], incomplete
    )


def benchmarks(incomplete: str) -> Words:
    """The benchmarks of the checkout, if there is one."""
    from scenewright.cli.bench import find_folder, names

    try:
        return _starting(((name, "") for name in names(find_folder())), incomplete)
    except InputError:
        return []


def _named(table: Table, incomplete: str) -> Words:
    """Names in a table of every domain, each with its domain."""
    from scenewright.domains import domains as all_domains

    holders: dict[str, list[str]] = {}
    for kind in all_domains():
        for name in kind.table(table):
            holders.setdefault(name, []).append(kind.name)
    return _starting(((name, ", ".join(of)) for name, of in holders.items()), incomplete)


def _starting(words: Iterable[tuple[str, str]], incomplete: str) -> Words:
    return [word for word in words if word[0].startswith(incomplete)]


def _files(incomplete: str, suffixes: dict[str, str]) -> Iterator[tuple[str, str]]:
    """Files whose name begins so and ends in one of some suffixes, by name."""
    folder, slash, start = incomplete.rpartition("/")
    for path in sorted(Path(folder or slash or ".").glob("*")):
        about = next((suffixes[end] for end in suffixes if path.name.lower().endswith(end)), None)
        if about is not None and path.name.startswith(start) and path.is_file():
            yield f"{folder}{slash}{path.name}", about
