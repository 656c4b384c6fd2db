"""Round trips by the table of formats: what is written is read back, less what its row lacks."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
import shapely

from flat import flat_brief, flat_solution
from scenewright import formats
from scenewright.core.brief import Room
from scenewright.core.errors import InputError
from scenewright.core.registry import Format
from scenewright.core.solution import Solution
from scenewright.formats.losses import COUNTED, losses
from scenewright.workflow.arrange import arrange
from scenewright.workflow.events import Event, Notice

WRITTEN = [row for row in formats.formats() if row.writer]


def holds_homes(row: Format) -> bool:
    """Whether a home can be written in a format, if its library is there."""
    with suppress(InputError):
        formats.check_output(f"flat{row.suffix}", flat_brief())
        return True
    return False


OF_HOMES = [row for row in WRITTEN if row.holds("home") and holds_homes(row)]
READ_BACK = [row for row in OF_HOMES if row.reader]
PACKED = (".usdc", ".usdz")
"""What is compressed; that names are kept in it is tested in test_usd."""
NAMING = [
    row
    for row in OF_HOMES
    if not {"names", "ids"} & {*row.lacks} and row.lacks and row.suffix not in PACKED
]


@pytest.fixture(scope="module")
def solution() -> Solution:
    return flat_solution()


def write(solution: Solution, row: Format, folder: Path) -> Path:
    path = folder / f"flat{row.suffix}"
    formats.write(solution, path)
    return path


@pytest.mark.parametrize("row", WRITTEN, ids=lambda row: f"{row.suffix} {row.domain}")
def test_what_a_format_lacks_is_said(row: Format) -> None:
    """Only saved solutions hold the reasons; files of authors hold nothing else."""
    if row.suffix in (".json", ".credits.txt"):
        assert not row.lacks
    else:
        assert {"reasons", "things not placed"} <= set(row.lacks)
    assert len(set(row.lacks)) == len(row.lacks)


def test_every_count_is_used_by_a_format() -> None:
    assert {kind for row in WRITTEN for kind in row.lacks} >= set(COUNTED)


@pytest.mark.parametrize("row", READ_BACK, ids=lambda row: row.suffix)
def test_rooms_are_read_back_less_what_is_lost(
    row: Format, solution: Solution, tmp_path: Path
) -> None:
    path = write(solution, row, tmp_path)
    lost = {loss.kind for loss in losses(solution, path)}
    drawn, brief = solution.brief, formats.read(path, keep=True)
    for before, after in zip(drawn.rooms, sorted(brief.rooms, key=order_of), strict=True):
        floors = [shapely.Polygon(room.outline, room.holes) for room in (before, after)]
        assert floors[0].symmetric_difference(floors[1]).area < 0.01
        assert after.name == before.name
        assert len(after.windows) == len(before.windows)
        if "heights of rooms" not in lost:
            assert (after.height or 2.6) == pytest.approx(before.height or 2.6)
    doors = [sum(len(room.doors) for room in one.rooms) for one in (drawn, brief)]
    assert doors[0] == doors[1]
    if "3D shapes" not in lost and row.suffix != ".json":  # of these only locked pieces are kept
        kept = {item.id for room in brief.rooms for item in room.fixed}
        assert kept >= {piece.id for piece in solution.pieces}


def order_of(room: Room) -> float:
    return min(x for x, _ in room.outline)


@pytest.mark.parametrize("row", NAMING, ids=lambda row: row.suffix)
def test_names_of_pieces_are_in_the_file_unless_lost(
    row: Format, solution: Solution, tmp_path: Path
) -> None:
    data = write(solution, row, tmp_path).read_bytes()
    assert [piece.id for piece in solution.pieces if piece.id.encode() not in data] == []


def test_losses_are_counted_and_none_is_not_listed() -> None:
    solution = flat_solution()
    found = {loss.kind: loss.number for loss in losses(solution, "flat.mm.dxf")}
    assert found["things not placed"] == len(solution.left_out) > 0
    assert "hanging lamps" not in found
    assert losses(solution, "flat.json") == ()


def test_losses_are_told_once_a_format(tmp_path: Path) -> None:
    heard: list[Event] = []
    paths = [tmp_path / name for name in ("a.svg", "b.svg", "a.json")]
    arrange("sample:home-room", paths, steps=20, hear=heard.append)
    told = [event.text for event in heard if isinstance(event, Notice)]
    (line,) = [text for text in told if "left out:" in text]
    assert line.startswith("b.svg: left out: ids, heights of rooms, 3D shapes, reasons")
