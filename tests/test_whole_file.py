"""Files that appear whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from scenewright.core.atomic_file import atomic_write, write_atomically


def test_a_text_replaces_what_was_there(tmp_path: Path) -> None:
    target = tmp_path / "plan.svg"
    target.write_text("old")
    write_atomically(target, "garden ☘\n")
    assert target.read_text(encoding="utf-8") == "garden ☘\n"
    assert list(tmp_path.iterdir()) == [target]


def test_what_fails_half_way_leaves_nothing_and_harms_nothing(tmp_path: Path) -> None:
    target = tmp_path / "plan.svg"
    target.write_text("old")
    with pytest.raises(TypeError), atomic_write(target) as partial, partial.open("w") as file:
        file.writelines(["half", None])  # type: ignore[list-item]
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_folder_that_is_missing_is_told(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        write_atomically(tmp_path / "none" / "plan.svg", "text")
