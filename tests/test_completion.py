"""The shell completes commands, options and values: its protocol is driven as the scripts do."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from scenewright.cli import completion


def complete(shell: str, line: str, folder: Path) -> list[str]:
    """What the program answers for a line that ends where the cursor is."""
    words = line.split(" ")
    asked = {
        "bash": {"COMP_WORDS": "\n".join(words), "COMP_CWORD": str(len(words) - 1)},
        "zsh": {"_TYPER_COMPLETE_ARGS": line},
        "fish": {"_TYPER_COMPLETE_ARGS": line, "_TYPER_COMPLETE_FISH_ACTION": "get-args"},
    }[shell]
    code = "import sys; sys.argv[0] = 'scenewright'; from scenewright.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=os.environ | asked | {"_SCENEWRIGHT_COMPLETE": f"complete_{shell}"},
        capture_output=True,
        text=True,
        cwd=folder,
        check=True,
    )
    assert not done.stderr
    return done.stdout.splitlines()


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_commands_and_samples_are_completed(shell: str, tmp_path: Path) -> None:
    (tmp_path / "sambuca.json").write_text("{}")
    (tmp_path / "sambuca.txt").write_text("")
    commands = "".join(complete(shell, "scenewright arr", tmp_path))
    assert "arrange" in commands
    assert "check" not in commands
    found = "\n".join(complete(shell, "scenewright plan sam", tmp_path)).replace("\\", "")
    assert "sample:home-flat" in found
    assert "sambuca.json" in found
    assert "sambuca.txt" not in found


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_of_each_shell_is_shown(shell: str) -> None:
    code = "import sys; sys.argv[0] = 'scenewright'; from scenewright.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", code, "--show-completion", shell],
        env=os.environ | {"_TYPER_COMPLETE_TEST_DISABLE_SHELL_DETECTION": "1"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert f"{completion.ASKED}=complete_{shell}" in done.stdout


def test_a_sample_is_completed_after_its_colon_in_bash(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(completion.ASKED, "complete_bash")
    for words in ("scenewright\narrange\nsample\n:\nhome-f", "scenewright\narrange\nsample\n:"):
        monkeypatch.setenv("COMP_WORDS", words)
        assert ("home-flat", "a sample") in completion.inputs("")


def test_outputs_get_the_suffixes_of_formats() -> None:
    found = dict(completion.outputs("out/flat."))
    assert {"out/flat.svg", "out/flat.glb", "out/flat.json"} <= found.keys()
    assert "out/flat.sh3d" not in found  # only read
    assert completion.outputs("flat") == []


@pytest.mark.parametrize(
    ("words", "start", "expected"),
    [
        (completion.presets, "pap", "paper"),
        (completion.solvers, "gd", "gd-mh"),
        (completion.styles, "nor", "nordic"),
        (completion.lists, "pre", "presets"),
        (completion.domains, "vil", "village"),
        (completion.schemas, "sol", "solution"),
        (completion.benchmarks, "ho", "home"),
    ],
)
def test_values_are_completed_by_name(words: object, start: str, expected: str) -> None:
    found = [name for name, _ in words(start)]  # type: ignore[operator]
    assert expected in found
    assert all(name.startswith(start) for name in found)
