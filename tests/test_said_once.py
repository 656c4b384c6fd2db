"""Classes of furniture and measures of homes are said once: no second definition or value."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

import scenewright
from scenewright.catalog import classes as kinds
from scenewright.domains.home import measures
from scenewright.domains.home.groups import classes as groups

HOME = Path(scenewright.__file__).parent / "domains" / "home"
REFEREE = HOME / "check"
"""The referee shares no code with the search, so it says what it goes by itself."""
FILES = sorted(file for file in HOME.rglob("*.py") if REFEREE not in file.parents)
TABLES = (kinds, groups, measures)


def list_constants(text: str) -> Iterator[tuple[str, ast.expr]]:
    """The constants of a module, by name, with what they are set to."""
    for node in ast.parse(text).body:
        if isinstance(node, ast.AnnAssign) and node.value is not None:
            yield ast.unparse(node.target), node.value
        for target in node.targets if isinstance(node, ast.Assign) else ():
            several = isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple)
            pairs = (
                zip(target.elts, node.value.elts, strict=False)
                if several
                else [(target, node.value)]
            )
            yield from ((ast.unparse(name), value) for name, value in pairs)


def read_class(value: ast.expr) -> frozenset[str]:
    """The names that a literal set, tuple or list holds, or one in a call of ``frozenset``; empty
    where there are fewer than two, or something else."""
    if isinstance(value, ast.Call) and ast.unparse(value.func) in ("frozenset", "set", "tuple"):
        return read_class(value.args[0]) if value.args else frozenset()
    if not isinstance(value, (ast.Tuple, ast.Set, ast.List)) or len(value.elts) < 2:
        return frozenset()
    names = [each.value for each in value.elts if isinstance(each, ast.Constant)]
    strings = [name for name in names if isinstance(name, str)]
    return frozenset(strings) if len(strings) == len(value.elts) else frozenset()


def list_faults(files: dict[str, str]) -> list[str]:
    """Second definitions among the texts of files: of a class, or of a name of the tables."""
    known = {name for table in TABLES for name in vars(table) if name.isupper()}
    where, again = defaultdict[frozenset[str], list[str]](list), list[str]()
    for table in TABLES:
        for name, value in vars(table).items():
            if isinstance(value, (frozenset, tuple)) and name.isupper():
                where[frozenset(value)].append(f"{table.__name__}:{name}")
    for file, text in files.items():
        for name, value in list_constants(text):
            if name.lstrip("_") in known:
                again.append(f"{file}:{name}")
            if found := read_class(value):
                where[found].append(f"{file}:{name}")
    return again + [" = ".join(places) for places in where.values() if len(places) > 1]


def test_no_class_and_no_measure_of_homes_is_defined_again() -> None:
    tables = {Path(str(table.__file__)) for table in TABLES}
    files = {str(file): file.read_text(encoding="utf-8") for file in FILES if file not in tables}
    assert list_faults(files) == []


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ('SEATED = ("loveseat", "corner_sofa", "sofa")', "scenewright.catalog.classes:SOFAS"),
        ('A = frozenset(("x", "y"))\nB = {"y", "x"}', "new.py:A = new.py:B"),
        ("HAIR = 1e-9", "new.py:HAIR"),
        ("_RAISED, LOW = 0.3, 0.1", "new.py:_RAISED"),
        ("ON_FLOOR: float = 0.2", "new.py:ON_FLOOR"),
    ],
)
def test_a_second_definition_is_refused(text: str, fault: str) -> None:
    (found,) = list_faults({"new.py": text})
    assert fault in found
