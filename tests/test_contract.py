"""Every domain behind one contract: the same tests for all of them."""

from __future__ import annotations

import importlib
import json
import math
import re
import sys
from dataclasses import replace
from functools import cache
from math import cos, sin
from pathlib import Path
from typing import Any, get_args

import pytest

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.domains import adjust, domain_of, draw_plan, plan_of, problems
from scenewright.domains.contract import NEEDED, Domain, Table, Verb
from scenewright.domains.home.changes.edits import leads
from scenewright.drawing.svg import write_svg
from scenewright.formats import solution_json

SAMPLES = {
    "home": "home-flat",
    "hall": "hall-shop",
    "site": "site-courtyards",
    "village": "village-hamlet",
    "extend": "extend-village",
}
PLUGINS = Path(__file__).parent / "plugins"
STEPS = {"home": 500, "hall": 1500, "site": 2, "village": 1, "extend": 1}
OUTDOORS = ("site", "village", "extend")


QUICK = {"extend": "quick"}
"""Presets of those whose default takes long to polish a layout."""


def arrange(domain: str, brief: sw.Brief, seed: int = 0) -> sw.Solution:
    return sw.solve(brief, seed=seed, steps=STEPS[domain], preset=QUICK.get(domain, "default"))


@cache
def arranged(domain: str) -> sw.Solution:
    """The sample of a domain, solved once."""
    return arrange(domain, sw.read(f"sample:{SAMPLES[domain]}"))


@pytest.fixture(scope="module", params=SAMPLES)
def solved(request: pytest.FixtureRequest) -> sw.Solution:
    return arranged(request.param)


def groups(solution: sw.Solution) -> list[list[sw.Piece]]:
    """What is locked together: furniture groups, groups of a hall, single buildings."""
    found: dict[str, list[sw.Piece]] = {}
    single = solution.brief.domain in OUTDOORS
    for piece in solution.pieces:
        furniture = piece.group and piece.function not in ("light", "partition", "fixed")
        if not piece.fixed and (piece.category == "building" if single else furniture):
            found.setdefault(piece.id if single else piece.group, []).append(piece)
    return list(found.values())


def save_locked(solution: sw.Solution, ids: set[str], path: Path) -> Path:
    document = json.loads(solution_json.dumps(solution))
    for piece in document["pieces"]:
        piece["fixed"] = piece["fixed"] or piece["id"] in ids
    path.write_text(json.dumps(document))
    return path


def test_what_is_locked_in_a_file_stands_where_it_stood(solved: sw.Solution, tmp_path: Path):
    chosen = [*groups(solved)[0], *groups(solved)[-1]]
    brief = sw.read(save_locked(solved, {p.id for p in chosen}, tmp_path / "locked.json"))
    again = arrange(solved.brief.domain, brief, seed=5)
    now = {piece.id: piece for piece in again.pieces}
    assert len(now) == len(again.pieces)
    for piece in chosen:
        assert now[piece.id] == replace(piece, fixed=True)
    report = sw.check(again)
    assert report.valid, [finding.message for finding in report.findings]
    assert len(again.left_out) <= len(solved.left_out)
    if solved.brief.domain != "home":
        assert sum(map(len, groups(again))) + len(chosen) == sum(map(len, groups(solved)))
    assert again.pieces != solved.pieces


def test_what_is_let_go_in_the_file_is_free_again(solved: sw.Solution, tmp_path: Path) -> None:
    chosen = {p.id for p in groups(solved)[0]}
    brief = sw.read(save_locked(solved, chosen, tmp_path / "locked.json"))
    again = arrange(solved.brief.domain, brief, seed=5)
    free = replace(
        again, pieces=tuple(replace(p, fixed=p.fixed and p.id not in chosen) for p in again.pieces)
    )
    sw.write(free, tmp_path / "free.json")
    files = (tmp_path / "free.json", save_locked(solved, set(), tmp_path / "none.json"))
    freed, never = (sw.read(file).model_copy(update={"input_report": None}) for file in files)
    assert freed == never or solved.brief.domain == "hall"


def test_everything_may_be_locked(solved: sw.Solution, tmp_path: Path) -> None:
    every = {p.id for group in groups(solved) for p in group}
    brief = sw.read(save_locked(solved, every, tmp_path / "locked.json"))
    again = arrange(solved.brief.domain, brief)
    was = {p.id: p.pose for p in solved.pieces}
    assert {p.id: p.pose for p in again.pieces if p.id in every} == {i: was[i] for i in every}
    assert sw.check(again).valid


def test_the_same_seed_gives_the_same_bytes_and_they_read_back(solved: sw.Solution) -> None:
    again = arrange(solved.brief.domain, solved.brief)
    text = solution_json.dumps(solved)
    assert solution_json.dumps(again) == text
    assert solution_json.dumps(solution_json.loads(text)) == text


def test_the_number_and_date_of_a_sheet_are_printed_on_every_plan(solved: sw.Solution) -> None:
    stated = solved.brief.model_copy(update={"sheet": "A-101", "date": "2026-11-22"})
    for brief, number, dates in ((solved.brief, "Sheet 1", 0), (stated, "Sheet A-101", 1)):
        drawn = write_svg(draw_plan(replace(solved, brief=brief)))
        assert f">{number}<" in drawn
        assert re.findall(r">(20\d\d-\d\d-\d\d)<", drawn) == ["2026-11-22"] * dates


def test_locks_by_hand_solve_nothing_again(solved: sw.Solution) -> None:
    name = groups(solved)[0][0].id
    locked = adjust(solved, lock=[name])
    assert not locked.changes
    assert {p.id: p.pose for p in locked.solution.pieces} == {p.id: p.pose for p in solved.pieces}
    fixed = {p.id for p in locked.solution.pieces if p.fixed}
    assert fixed == {p.id for p in groups(solved)[0]} | {p.id for p in solved.pieces if p.fixed}
    freed = adjust(locked.solution, unlock=[name]).solution
    assert freed.pieces == solved.pieces


def test_a_space_again_keeps_what_is_locked(solved: sw.Solution) -> None:
    group = groups(solved)[0]
    space = group[0].space
    steps = STEPS[solved.brief.domain]
    after = adjust(solved, lock=[group[0].id], again=[space], seed=9, steps=steps).solution
    now = {piece.id: piece for piece in after.pieces}
    assert all(now[p.id] == replace(p, fixed=True) for p in group)
    assert sw.check(after).valid
    assert {p.id for p in after.pieces if p.fixed} == {
        *(p.id for p in group),
        *(p.id for p in solved.pieces if p.fixed),
    }
    assert after.pieces != solved.pieces
    assert solution_json.loads(solution_json.dumps(after)).pieces == after.pieces


def test_wrong_names_are_refused_in_one_line(solved: sw.Solution) -> None:
    for edits in ({"lock": ["zeppelin"]}, {"again": ["zeppelin"]}, {"move": {"zeppelin": (0, 0)}}):
        with pytest.raises(InputError, match="zeppelin") as caught:
            adjust(solved, **edits)
        assert "\n" not in str(caught.value)


def test_nothing_is_moved_out_of_its_space(solved: sw.Solution) -> None:
    with pytest.raises(InputError, match="cannot stand at"):
        adjust(solved, move={groups(solved)[0][0].id: (900.0, 900.0)})


def layouts_of(solution: sw.Solution) -> dict[str, list[sw.NamedBox]]:
    """The layout of a solution: patches of a home, objects of a hall, buildings of a site."""
    found: dict[str, list[sw.NamedBox]] = {}
    for patch in solution.patches if solution.brief.domain == "home" else ():
        found.setdefault(patch.space, []).append(sw.NamedBox(patch.function, patch.box))
    if solution.brief.domain != "home":
        for piece in (p for group in groups(solution) for p in group):
            box = (*piece.pose[:2], piece.pose.heading, *piece.size[:2])
            found.setdefault(piece.space, []).append(sw.NamedBox(piece.function, box))
    return found


def test_a_layout_becomes_a_solution(solved: sw.Solution) -> None:
    layouts = layouts_of(solved)
    again = sw.solution_of(solved.brief, layouts)
    text = solution_json.dumps(again)
    assert solution_json.dumps(sw.solution_of(solved.brief, layouts)) == text
    assert solution_json.dumps(solution_json.loads(text)) == text
    if solved.brief.domain == "home":
        lacking = {p.group for p in solved.pieces} - {p.group for p in again.pieces}
        told = {f"{out.space}/{out.what}" for out in again.left_out}
        assert lacking <= told
        assert len(lacking) < 2
    else:
        was = sorted((p.category, *p.pose) for group in groups(solved) for p in group)
        now = sorted((p.category, *p.pose) for group in groups(again) for p in group)
        assert [row[0] for row in now] == [row[0] for row in was]
        for one, other in zip(now, was, strict=True):
            assert one[1:] == pytest.approx(other[1:], abs=1e-9)
    assert again.terms
    assert again.energies.keys() == solved.energies.keys()
    assert sw.check(again).valid


def test_an_empty_layout_leaves_all_out(solved: sw.Solution) -> None:
    again = sw.solution_of(solved.brief, {})
    assert not groups(again)
    assert again.left_out


def test_wrong_layouts_are_refused_in_one_line(solved: sw.Solution) -> None:
    space, rows = next(iter(layouts_of(solved).items()))
    box = rows[0].box
    for layouts in (
        {"zeppelin": rows},
        {space: [sw.NamedBox("zeppelin", box)]},
        {space: [rows[0]._replace(box=(*box[:3], 0.0, 1.0))]},
        {space: [rows[0]._replace(box=box[:4])]},
        {space: [rows[0]._replace(box=(float("nan"), *box[1:]))]},
    ):
        with pytest.raises(InputError) as caught:
            sw.solution_of(solved.brief, layouts)
        assert "\n" not in str(caught.value)


def move_off_its_wall(solved: sw.Solution, group: list[sw.Piece]) -> Any:
    """The scene with a group 0.2 m ahead of where it is, its lead and where that was put; or none,
    refused in one line because an arm of the group would leave the room."""
    lead = next((p for p in group if leads(p)), group[0])
    c, s = cos(lead.pose.heading), sin(lead.pose.heading)  # away from what it backs
    to = (lead.pose.x + 0.2 * c, lead.pose.y + 0.2 * s, lead.pose.heading)
    try:
        return adjust(solved, move={lead.id: to}, steps=STEPS[solved.brief.domain]), lead, to
    except InputError as error:
        told = str(error)
    assert re.search(r"would stick 0\.\d+ m out of its room", told)
    assert "\n" not in told
    return None


def test_what_is_moved_stays_where_it_was_put(solved: sw.Solution) -> None:
    tried = ((group, move_off_its_wall(solved, group)) for group in groups(solved))
    group, ((after, changes), lead, to) = next((g, moved) for g, moved in tried if moved)
    now = next(piece for piece in after.pieces if piece.id == lead.id)
    assert (*now.pose[:2], now.pose.heading) == pytest.approx(to)
    assert now.fixed
    assert any(c.piece == lead.id and c.reason == "moved by hand" for c in changes)
    gone = {c.piece for c in changes if c.reason} - {p.id for p in after.pieces}
    assert {p.id for p in after.pieces if p.fixed} == {
        *({p.id for p in group} - gone),  # what hung on the wall it left is gone, with the reason
        *(p.id for p in solved.pieces if p.fixed),
    }


def test_buildings_in_the_way_of_a_moved_one_make_room() -> None:
    site = arranged("site")
    one, *others = (group[0] for group in groups(site))
    near = min(others, key=lambda p: abs(p.pose.x - one.pose.x) + abs(p.pose.y - one.pose.y))
    after, changes = adjust(site, move={one.id: (*near.pose[:2], near.pose.heading)}, steps=2)
    was = {p.id: p for p in others}
    stayed = [p for p in after.pieces if p.id in was and p.pose == was[p.id].pose]
    assert near.id not in {p.id for p in stayed}
    assert len(others) / 2 < len(stayed) < len(others)
    assert {c.reason for c in changes} >= {"moved by hand"}


@pytest.mark.parametrize("domain", ["hall", "site", "village", "extend"])
def test_what_is_swapped_exchanges_places(domain: str) -> None:
    solution = arranged(domain)
    one, *others = (group[0] for group in groups(solution))
    near = [p for p in others if p.space == one.space]
    other = min(near, key=lambda p: math.dist(p.size[:2], one.size[:2]))
    steps = STEPS[domain]
    after = adjust(solution, swap=[(one.id, other.id)], steps=steps).solution
    now = {p.id: p for p in after.pieces}
    for first, second in ((one, other), (other, one)):
        apart = math.dist(now[first.id].pose[:2], second.pose[:2])
        assert apart <= abs(one.size.depth - other.size.depth) / 2 + 1e-9
        assert now[first.id].fixed


def test_a_nudge_in_a_hall_changes_little_outside_its_group() -> None:
    hall = arranged("hall")
    for group in groups(hall):
        lead = group[0]
        after, changes = adjust(hall, move={lead.id: (lead.pose.x + 0.1, lead.pose.y)})
        own = {p.id for p in group}
        assert sum(change.piece not in own for change in changes) <= 5
        assert after.brief == hall.brief


def every_domain() -> list[Domain]:
    """All shipped domains and the toy of another package."""
    sys.path.insert(0, str(PLUGINS))
    try:
        toy = importlib.import_module("picnic").DOMAIN
    finally:
        sys.path.remove(str(PLUGINS))
    return [*map(domain_of, SAMPLES), toy]


@pytest.mark.parametrize("domain", every_domain(), ids=lambda domain: domain.name)
def test_every_verb_is_there_or_refused_in_one_line(domain: Domain) -> None:
    assert set(NEEDED) <= domain.verbs.keys() <= set(get_args(Verb))
    for verb in get_args(Verb):
        if domain.has(verb):
            assert callable(domain.verb(verb))
            continue
        words = verb.replace("_", " ")
        with pytest.raises(InputError, match=f"'{domain.name}' do not support '{words}'") as caught:
            domain.verb(verb)
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize("domain", every_domain(), ids=lambda domain: domain.name)
def test_tables_are_those_of_the_contract(domain: Domain) -> None:
    assert {"presets", "solvers", "meanings"} <= domain.tables.keys() <= set(get_args(Table))
    for table in get_args(Table):
        assert bool(domain.table(table)) == (table in domain.tables)


def test_every_verb_and_table_of_the_contract_is_asked_for() -> None:
    source = Path(sw.__file__).parent
    text = "".join(f.read_text() for f in source.rglob("*.py") if f.name != "contract.py")
    asked = set(re.findall(r'\.(?:verb|table)\(\s*"(\w+)"', text))
    assert asked == {*get_args(Verb), *get_args(Table)}


@pytest.mark.parametrize("domain", SAMPLES)
def test_a_brief_becomes_problems(domain: str) -> None:
    brief = sw.read(f"sample:{SAMPLES[domain]}")
    plan = plan_of(brief)
    found = problems(brief, plan=plan)
    assert 0 < len(found) <= len(plan.spaces)
    assert [type(one) for one in problems(brief)] == [type(one) for one in found]


@pytest.mark.parametrize("name", sw.samples())
def test_samples_read_and_have_a_plan(name: str) -> None:
    brief = sw.read(name)
    assert domain_of(brief.domain).verb("plan")(brief).spaces
