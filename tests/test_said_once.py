"""Classes of furniture and measures of homes are said once: no second definition or value."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

import scenewright
from scenewright.catalog import classes as kinds
from scenewright.domains.hall import measures as hall_measures
from scenewright.domains.home import measures
from scenewright.domains.home.groups import classes as groups

DOMAINS = Path(scenewright.__file__).parent / "domains"
HOME = DOMAINS / "home"
REFEREE = HOME / "check"
"""The referee shares no code with the search, so it says what it goes by itself."""
FILES = sorted(file for file in HOME.rglob("*.py") if REFEREE not in file.parents)
TABLES = (kinds, groups, measures)
MEASURED = {"home": measures, "hall": hall_measures}
UNMEASURED = ("check", "drawing")
"""The referee, and what is measured in millimetres of paper."""
VARYING = {
    "home": """
        ACROSS AHEAD ALONG AMID APART AT BACK BACKED BARE BEFORE BETTER BETWEEN BEYOND CELL
        CLOSE CORNER DEEP EYES FACING FAR FARTHEST FILLED FLUSH FREE HIGHEST HUNG INSIDE IN_LINE
        LEAST LEAST_FLOOR LESS LONG LOW MORE NARROWEST NEAR OFF_AXIS OFF_COUNTED ON_AXIS OPEN
        PASSED PAST PLACE REACH ROOMY SEAT SEEN SHALLOW SHARED SHELVED SIDEWAYS SIGHT SLACK SLIM
        SLIVER SPARE STAND STEP TALL TOUCH TOUCHING TURNED UNLIKE UNSEEN USUAL WAY WIDEST WORTH
    """,
    "hall": "",
}
"""Names that several rules still give numbers of their own: none may join them."""


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


def list_files(domain: str) -> dict[str, str]:
    """The texts of a domain's files in which rules say distances."""
    root = DOMAINS / domain
    apart = {root / name for name in UNMEASURED}
    return {
        str(file.relative_to(root)): file.read_text(encoding="utf-8")
        for file in root.rglob("*.py")
        if not apart & set(file.parents)
    }


def list_varying(files: dict[str, str]) -> set[str]:
    """Names that the texts of files give more than one number, whole numbers apart."""
    values = defaultdict[str, set[float]](set)
    for text in files.values():
        for name, value in list_constants(text):
            if isinstance(value, ast.Constant) and isinstance(value.value, float):
                values[name.lstrip("_")].add(value.value)
    return {name for name, found in values.items() if len(found) > 1}


@pytest.mark.parametrize("domain", VARYING)
def test_no_further_name_stands_for_two_distances(domain: str) -> None:
    assert list_varying(list_files(domain)) - set(VARYING[domain].split()) == set()


@pytest.mark.parametrize("domain", MEASURED)
def test_no_measure_of_a_domain_is_said_again(domain: str) -> None:
    known = {name for name in vars(MEASURED[domain]) if name.isupper()}
    files = {name: text for name, text in list_files(domain).items() if name != "measures.py"}
    named = {(file, name) for file, text in files.items() for name, _ in list_constants(text)}
    assert [each for each in named if each[1].lstrip("_") in known] == []


def test_a_second_number_of_a_name_is_found() -> None:
    assert list_varying({"a": "NEAR = 0.1\nFAR = 2.0", "b": "NEAR, TRIED = 0.2, 3"}) == {"NEAR"}


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
