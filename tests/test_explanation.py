"""What is not placed and what is given up is said with what helps, by the tables of the domains."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

import scenewright as sw
from every import every
from scenewright import cli
from scenewright.core.explanation import describe_advice, find_remedy
from scenewright.core.registry import SHIPPED, domain_of
from scenewright.core.solution import LeftOut, TermValue

DOMAINS = Path(sw.__file__).parent / "domains"
GIVEN_UP = {"Missing": 1, "Refused": 0, "LeftOut": 2}
"""The argument that is the reason, by what is made."""
NAMED = re.compile(r"REASON|BARRING|LONE|STRAY|FEWER|LESS|MADE_ROOM|reason|full")


def text_of(node: ast.AST | None) -> str:
    """A text of the source, with a number for what is filled in; empty for anything else."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else ""
    if isinstance(node, ast.JoinedStr):
        return "".join(text_of(part) or "1.2" for part in node.values)
    return ""


def list_reasons(domain: str) -> Iterator[tuple[str, str]]:
    """The reasons in the source of a domain for which something is left out."""
    for file in (DOMAINS / domain).rglob("*.py"):
        if {"check", "reading", "drawing", "changes", "advice.py"} & set(
            file.relative_to(DOMAINS).parts
        ):
            continue
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            found = None
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                place = GIVEN_UP.get(node.func.id)
                found = node.args[place] if place is not None and len(node.args) > place else None
            elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                found = node.value if NAMED.fullmatch(node.targets[0].id) else None
            if found and len(re.findall("[a-z]{2,}", text := text_of(found))) > 2:
                yield domain, text


@cache
def all_reasons() -> tuple[tuple[str, str], ...]:
    return tuple(sorted({row for domain in SHIPPED for row in list_reasons(domain)}))


@every(all_reasons)
def test_every_reason_has_a_remedy(domain: str, reason: str) -> None:
    rows = domain_of(domain).table("remedies")
    silent = [row.pattern for row in rows if not row.text and re.search(row.pattern, reason)]
    assert find_remedy(reason, rows) or silent


def test_the_reasons_are_found() -> None:
    assert {domain for domain, _ in all_reasons()} == set(SHIPPED)
    assert ("home", "no free wall of 1.2 m to stand against") in all_reasons()


def test_a_remedy_names_what_is_lacking() -> None:
    helps = find_remedy(
        "no free wall of 1.2 m to stand against", domain_of("home").table("remedies")
    )
    assert "1.2 m of wall" in helps


@pytest.mark.parametrize("domain", SHIPPED)
def test_compromises_are_said_of_terms(domain: str) -> None:
    kind = domain_of(domain)
    rows = kind.table("compromises")
    assert rows.keys() <= kind.table("meanings").keys()
    for row in rows.values():
        assert row.remedy
        assert row.text.format(value=1.5)


def test_what_is_not_placed_comes_first_and_alike_things_once(solution: sw.Solution) -> None:
    space = next(iter(solution.energies), "living")
    spare = LeftOut(space, "plant", "no room is left beside the rest", False)
    bed = LeftOut(space, "single", "no free wall of 2.0 m to stand against", True)
    dark = TermValue(space, "desk", "daylight", 0.9, 30.0, 27.0)
    told = sw.explain(replace(solution, left_out=(spare, spare, bed), terms=(dark,)))
    assert [advice.number for advice in told.left_out] == [1, 2]
    first = describe_advice(told.left_out[0])
    assert first.startswith("not placed: single bed")
    assert "what helps: keep 2.0 m of wall free" in first
    assert "optional, not placed: 2 × plant" in str(told)
    assert "wish for it by the window" in str(told)
    assert "desk: far from the window" in str(told)


def test_explain_says_words_and_terms_only_if_asked(
    solution: sw.Solution, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    term = TermValue(next(iter(solution.energies), "living"), "desk", "daylight", 0.9, 30.0, 27.0)
    path = str(tmp_path / "flat.json")
    sw.write(replace(solution, terms=(term,)), path)
    assert cli.run(["explain", path]) == 0
    plain = capsys.readouterr().out
    assert "far from the window" in plain
    assert "27.00" not in plain
    assert cli.run(["explain", path, "--terms"]) == 0
    assert "27.00" in capsys.readouterr().out
    assert cli.run(["explain", path, "--json"]) == 0
    (remark,) = json.loads(capsys.readouterr().out)["remarks"]
    assert remark["items"] == ["desk"]
