"""The notebooks of the documents run, cell by cell, and hold no outputs."""

from __future__ import annotations

import ast
import json
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parent.parent / "docs" / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))
NEEDS = {"episode": ("mujoco",)}
"""What a notebook imports beside what everybody has."""
VIEWS = ("_repr_html_", "_repr_svg_", "_repr_png_")


def show(value: object) -> None:
    """What a notebook does with the last value of a cell: it asks for all its views."""
    assert repr(value)
    for view in VIEWS:
        if hasattr(value, view):
            assert getattr(value, view)()


def run_cell(source: str, names: dict[str, Any]) -> None:
    """Run a cell; its last line, where it is a value, is shown."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if isinstance(last, ast.Expr):
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)  # noqa: S307
        show(value)


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(notebook: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in NEEDS.get(notebook.stem, ()):
        pytest.importorskip(module)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    cells = json.loads(notebook.read_text("utf-8"))["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert len(code) > 3
    for cell in code:
        assert cell["outputs"] == []
        run_cell("".join(cell["source"]), names)


def test_there_are_notebooks() -> None:
    assert {path.stem for path in NOTEBOOKS} == {"dataset", "episode", "flat", "shop"}
