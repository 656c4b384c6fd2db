"""Classes of kinds in halls are stated once."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from scenewright.catalog.kinds import KINDS
from scenewright.domains import hall

FOLDER = Path(hall.__file__).parent


def list_values(file: Path) -> Iterator[ast.expr]:
    """What the names that a file assigns at its head stand for, calls by their first argument."""
    for node in ast.parse(file.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign):
            many = isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Tuple)
            values = node.value.elts if many and isinstance(node.value, ast.Tuple) else [node.value]
            yield from (v.args[0] if isinstance(v, ast.Call) and v.args else v for v in values)


def list_classes(file: Path) -> Iterator[frozenset[str]]:
    """Groups of two kinds or more, and of nothing else, that a file states as constants."""
    for value in list_values(file):
        if isinstance(value, ast.Tuple | ast.List | ast.Set) and len(value.elts) > 1:
            names = [e.value for e in value.elts if isinstance(e, ast.Constant)]
            kinds = frozenset(str(name) for name in names if name in KINDS)
            if len(kinds) == len(value.elts):
                yield kinds


def test_a_class_of_kinds_is_stated_in_one_file_only() -> None:
    stated = {file: list(list_classes(file)) for file in sorted(FOLDER.rglob("*.py"))}
    here = stated.pop(FOLDER / "classes.py")
    assert len(here) > 10
    assert len(set(here)) == len(here), "two classes are the same"
    elsewhere = {file.name: kinds for file, kinds in stated.items() if kinds}
    assert not elsewhere, "state it in classes.py"
