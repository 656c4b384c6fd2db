"""Tables and lines: whatever the width of the terminal, names and reasons can be copied."""

from __future__ import annotations

import json
import re
import sys
from io import StringIO
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.cells import cell_len
from rich.console import Console

from scenewright import cli
from scenewright.cli.tables import output_console, print_line, table
from scenewright.workflow import lists

FOLDER = "/home/somebody/" + "a-folder-with-a-long-name/" * 8
REASON = "there is no wall long enough between the door and the window for the whole run"
ROWS = [
    {"file": FOLDER + "my flat.json", "status": "failed", "message": REASON},
    {"file": FOLDER + "b.json", "status": "not valid", "message": f"{FOLDER}x.sh3d: is empty"},
]
WIDTHS = [10, 20, 40, 80, 100, 200, 400]


def terminal(width: int) -> Console:
    """A terminal without colours whose output can be read."""
    return Console(
        file=StringIO(),
        force_terminal=True,
        width=width,
        height=25,
        color_system=None,
        legacy_windows=False,
    )


def output(console: Console) -> str:
    assert isinstance(console.file, StringIO)
    return console.file.getvalue()


def words(text: str) -> list[str]:
    return text.split()


@pytest.mark.parametrize("width", WIDTHS)
def test_a_terminal_of_any_width_shows_every_word_whole(width: int) -> None:
    console = terminal(width)
    table(console, ROWS, "files to look at", whole=("file",))
    shown = output(console)
    for row in ROWS:
        assert row["file"] in shown
        assert set(words(row["message"])) <= set(words(shown))
    if width < 200:
        assert f"message: {REASON}" in shown


@given(
    st.lists(
        st.lists(st.text("abc 家", max_size=30), min_size=3, max_size=3), min_size=1, max_size=6
    ),
    st.integers(5, 120),
)
def test_no_line_of_a_table_is_wider_than_its_terminal(cells: list[list[str]], width: int) -> None:
    console = terminal(width)
    rows = [dict(zip(("name", "one", "two"), row, strict=True)) for row in cells]
    table(console, rows, "things")
    shown = output(console)
    assert set(words(" ".join(map(" ".join, cells)))) <= set(words(shown.replace(":", " ")))
    if "─" in shown:
        assert max(map(cell_len, shown.splitlines()[1:])) <= width, shown


def test_a_row_is_one_line_in_a_file(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    console = output_console()
    table(console, ROWS, "files to look at")
    print_line(console, f"wrote {FOLDER}a b.json and {REASON}")
    lines = capsys.readouterr().out.splitlines()
    assert any(all(cell in line for cell in ROWS[0].values()) for line in lines)
    assert f"wrote {FOLDER}a b.json and {REASON}" in lines


def test_lines_of_a_terminal_break_between_words_only() -> None:
    console = terminal(40)
    print_line(console, REASON)
    print_line(console, f"wrote {FOLDER}my flat.json", whole=True)
    shown = output(console)
    assert words(REASON) == words(shown)[: len(words(REASON))]
    assert max(map(len, shown.splitlines()[:2])) <= 40
    assert f"wrote {FOLDER}my flat.json\n" in shown


def test_a_dumb_terminal_breaks_lines_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "dumb")
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    assert output_console().width > 1000


def test_a_table_without_rows_names_what_is_missing() -> None:
    console = terminal(40)
    table(console, [], "plans")
    assert output(console) == "no plans\n"


@pytest.mark.parametrize("columns", ["40", "80"])
def test_lists_name_everything_on_a_narrow_terminal(
    columns: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """What stands in the first column of every list is whole, however few columns there are."""
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    for what in lists.LISTS:
        assert cli.run(["list", what, "--json"]) == 0
        rows = json.loads(capsys.readouterr().out)
        assert cli.run(["list", what]) == 0
        shown = set(words(re.sub(r"\x1b\[[\d;]*m", "", capsys.readouterr().out)))
        key = next(iter(lists.SHOWN.get(what, rows[0])))
        for row in lists.select_columns(what, rows):
            assert set(words(str(row[key]))) <= shown, what


def test_the_file_that_failed_is_named_in_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    folder = tmp_path / "a-long-name-of-a-folder" / "another-long-name-of-a-folder"
    folder.mkdir(parents=True)
    (folder / "bad.json").write_text("[]")
    output = str(tmp_path / "out")
    assert cli.run(["arrange", "--batch", "-o", output, str(folder / "bad.json")]) == 2
    assert str(folder / "bad.json") in capsys.readouterr().out
