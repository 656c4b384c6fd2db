"""Tables of figures in the pages: written by their benchmark, with what they were made by.

A table lies between ``<!-- table NAME -->`` and ``<!-- table end -->``; ``scenewright bench NAME
--into docs/page.md`` writes it there. Its last line says the command, commit, seeds, machine and
the digest of the code (:mod:`.source_digest`). Once that code changes, a test asks for the table to
be made again, or for that line to begin with *Of before, made by*.
"""

from __future__ import annotations

import os
import platform
import re
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.source_digest import ROOT, source_digest
from scenewright.core.atomic_file import write_atomically
from scenewright.core.errors import InputError

Record = dict[str, Any]
BLOCK = re.compile(r"(<!-- table (\w+) -->\n)(.*?)(<!-- table end -->)", re.DOTALL)
MADE = re.compile(r"^\*(Made|Of before, made) by .*, code ([0-9a-f]{12})\.\*$", re.MULTILINE)
FAMILIES = ("AMD", "EPYC", "Ryzen", "Intel", "Xeon", "Core", "Apple", "Neoverse")
"""Words of a processor's name that are told; its number is not."""


class PageTable(NamedTuple):
    """A table of a page: its benchmark, its text, and whether it is said to be of older code."""

    name: str
    text: str
    before: bool
    code: str


def tables_in(page: str) -> list[PageTable]:
    """All tables of a page; those that were never made have no code.

    >>> tables_in("<!-- table one -->\\n<!-- table end -->")
    [PageTable(name='one', text='', before=False, code='')]
    """
    found = []
    for _, name, text, _ in BLOCK.findall(page):
        made = MADE.search(text)
        before = made is not None and made[1] != "Made"
        found.append(PageTable(name, text, before, made[2] if made else ""))
    return found


def check_page(path: Path, name: str) -> None:
    """InputError unless a page has a place for the table of a benchmark."""
    if not path.is_file():
        raise InputError("there is no such page", "name one that exists", file=str(path))
    if name not in {table.name for table in tables_in(path.read_text(encoding="utf-8"))}:
        raise InputError(
            f"has no place for the table of '{name}'",
            f"write two lines into it, <!-- table {name} --> and <!-- table end -->",
            file=str(path),
        )


def write_into(path: Path, name: str, command: str, records: Sequence[Record]) -> None:
    """Put the table of a benchmark in its place in a page."""
    check_page(path, name)
    lines = "\n".join([*list_lines(name, records), "", tell_making(name, command, records)])
    page = path.read_text(encoding="utf-8")
    page = BLOCK.sub(lambda m: f"{m[1]}{lines}\n{m[4]}" if m[2] == name else m[0], page)
    write_atomically(path, page)


def list_lines(name: str, records: Sequence[Record]) -> Iterable[str]:
    """The benchmark's table for pages (``page_lines``), else all it makes, else a plain one."""
    module = import_module(f"benchmarks.{name}")
    own = getattr(module, "page_lines", getattr(module, "markdown_lines", _plain_lines))
    return list(own(list(records)))


def _plain_lines(records: Sequence[Record]) -> Iterator[str]:
    yield "| case | measure | ours | beside | |"
    yield "|---|---|---|---|---|"
    for row in records:
        beside = "" if row["baseline"] is None else f"{row['baseline']:g}"
        yield (
            f"| {row['case']} | {row['metric']} | {row['ours']:g} | {beside} "
            f"| {row['baseline_name']} |"
        )


def tell_making(name: str, command: str, records: Sequence[Record]) -> str:
    """The last line of a table. Records may say their ``seeds`` and ``machine``; else seeds count
    from 0, one a run, and the machine is this one."""
    runs = sorted({row["runs"] for row in records})
    counted = f"{runs[0]} to {runs[-1]}" if len(runs) > 1 else f"{runs[0]}"
    seeds = "; ".join(dict.fromkeys(row["seeds"] for row in records if "seeds" in row))
    machine = "; ".join(dict.fromkeys(row["machine"] for row in records if "machine" in row))
    return (
        f"*Made by `{command}` at commit {find_commit()}, seeds {seeds or 'from 0'}, {counted} "
        f"runs a figure, {machine or tell_machine()}, code {source_digest(f'benchmarks.{name}')}.*"
    )


def find_commit(root: Path = ROOT) -> str:
    """The commit that last changed the code, and whether it has been changed since."""

    def ask(*words: str) -> str:
        return subprocess.run(
            ["git", *words], cwd=root, capture_output=True, text=True, check=False
        ).stdout.strip()

    changed = " with changes" if ask("status", "--porcelain", "src", "benchmarks") else ""
    code = ask("log", "-1", "--format=%h", "--abbrev=8", "--", "src", "benchmarks")
    return (code or "unknown") + changed


def tell_machine() -> str:
    """Cores, and the family of the processor; neither a name nor a number of the machine."""
    told, source = platform.processor(), Path("/proc/cpuinfo")
    if source.exists():
        told += " ".join(re.findall(r"model name\s*:(.*)", source.read_text(encoding="utf-8"))[:1])
    family = " ".join(word for word in FAMILIES if word in told) or platform.machine()
    return f"{os.cpu_count()} cores ({family})"
