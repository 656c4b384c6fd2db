"""Tables of figures in the pages are of the code as it is, or say that they are of before."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from benchmarks.page_tables import PageTable, tables_in, tell_making, write_into
from benchmarks.source_digest import imports_of, source_digest

from scenewright.cli import bench as cli_bench
from scenewright.core.errors import InputError

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
CHECKED_ELSEWHERE = ("| style | quality |",)
"""Heads of tables of figures that another test compares with what they are of."""


def say_stale(page: Path, table: PageTable) -> str:
    """What is wrong with a table and what sets it right; empty if nothing is."""
    if not table.code:
        return f"{page.name}: '{table.name}' was never made; bench {table.name} --into {page.name}"
    now = source_digest(f"benchmarks.{table.name}")
    if table.before or table.code == now:
        return ""
    return (
        f"{page.name}: the code of table '{table.name}' has changed ({table.code}, now {now}): "
        f"make it again by 'scenewright bench {table.name} --into docs/{page.name}', or let its "
        "last line begin with 'Of before, made by'"
    )


def test_tables_are_of_the_code_as_it_is_or_say_that_they_are_not() -> None:
    found = [(page, table) for page in PAGES for table in tables_in(page.read_text("utf-8"))]
    known = cli_bench.names(ROOT / "benchmarks")
    assert [table.name for _, table in found if table.name not in known] == []
    assert [told for told in (say_stale(*one) for one in found) if told] == []


def is_of_figures(table: str) -> bool:
    """Whether most of a table's cells, the first column aside, are numbers."""
    cells = [cell for row in table.splitlines()[2:] for cell in row.strip("|").split("|")[1:]]
    numbers = [cell for cell in cells if re.fullmatch(r"[\s*–−+%.,\d]*\d[\s*%.\d]*(s|m)?\s*", cell)]
    return len(numbers) > 0.5 * len(cells)


def test_every_table_of_figures_is_written_by_a_benchmark() -> None:
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for table in tables_in(text):
            text = text.replace(table.text, "")
        for block in re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE):
            known = block.startswith(CHECKED_ELSEWHERE)
            assert known or not is_of_figures(block), f"{page.name}: who wrote this?\n{block}"
    assert is_of_figures("| a | b |\n|---|---|\n| x | 1.5 |\n| y | 20 % |\n")
    assert not is_of_figures("| a | b |\n|---|---|\n| x | why |\n| y | 20 |\n")


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A copy of the source that may be changed."""
    for name in ("benchmarks", "src/scenewright/domains/extend", "src/scenewright/engine"):
        ignored = shutil.ignore_patterns("__pycache__", ".kept", "*.npz", "scenes")
        shutil.copytree(ROOT / name, tmp_path / name, ignore=ignored)
    return tmp_path


def test_a_digest_follows_what_runs_and_no_words(checkout: Path) -> None:
    def digest() -> str:
        source_digest.__globals__["_parse"].cache_clear()
        return source_digest("benchmarks.extend_paper", checkout)

    first = digest()
    ants = checkout / "src/scenewright/domains/extend/solvers/ants.py"
    text = ants.read_text("utf-8")
    words = text.replace('"""', '"""Other words. ', 1).replace("\n\n\n", "\n\n\n# a remark\n")
    ants.write_text(words, "utf-8")
    assert digest() == first
    ants.write_text(f"{text}\nMORE = 1\n", "utf-8")
    assert digest() != first
    ants.write_text(text, "utf-8")
    (checkout / "src/scenewright/domains/extend/drawing.py").write_text("MORE = 2\n", "utf-8")
    assert digest() == first


def test_rows_of_solvers_are_followed() -> None:
    rows = imports_of("scenewright.domains.site.solvers")
    assert "scenewright.domains.site.solvers.genetic" in rows
    assert not [name for name in rows if name.startswith("scenewright.cli")]


def test_a_table_is_put_in_its_place_and_told_what_made_it(tmp_path: Path) -> None:
    record = {"case": "a", "metric": "time", "ours": 1.5, "baseline": 2.0, "baseline_name": "b"}
    page = tmp_path / "page.md"
    page.write_text(
        "before\n<!-- table extend_paper -->\nold\n<!-- table end -->\nafter\n", "utf-8"
    )
    told = [record | {"runs": 3}]
    write_into(page, "extend_paper", "scenewright bench extend_paper --quick", told)
    text = page.read_text("utf-8")
    (table,) = tables_in(text)
    assert text.startswith("before\n")
    assert text.endswith("<!-- table end -->\nafter\n")
    assert "| time | 1.500 |" in table.text
    assert "old" not in table.text
    assert not say_stale(page, table)
    assert not table.before
    stale = PageTable(table.name, "", False, "0" * 12)
    assert "has changed (000000000000" in say_stale(page, stale)
    (marked,) = tables_in(text.replace("*Made by", "*Of before, made by"))
    assert marked.before
    assert not say_stale(page, marked._replace(code="0" * 12))
    with pytest.raises(InputError, match="no place for the table of 'home'"):
        write_into(page, "home", "", told)


def test_the_line_says_seeds_and_machine_of_the_records() -> None:
    rows: list[dict[str, object]] = [
        {"runs": 2, "seeds": "4 to 5", "machine": "1 GPU"},
        {"runs": 5},
    ]
    line = tell_making("kept", "scenewright bench kept", rows)
    assert "seeds 4 to 5, 2 to 5 runs a figure, 1 GPU, code " in line
