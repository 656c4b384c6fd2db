"""Saved solutions that were tampered with: what the brief says counts, not what they say."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import pytest
from benchmarks.referee import HALL, KEPT, SITE

from every import every
from scenewright.core.brief import Brief
from scenewright.domains import check, solve
from scenewright.formats import read, solution_json

Document = dict[str, Any]
BRIEFS = {
    "home": KEPT,
    "hall": HALL,
    "site": SITE,
    "village": "sample:village-hamlet",
    "extend": "sample:extend-village",
}


@cache
def solved(domain: str) -> str:
    """A small solution of a domain, as text."""
    named = BRIEFS[domain]
    brief = read(named) if isinstance(named, str) else Brief.model_validate(named)
    return solution_json.dumps(solve(brief, seed=1))


def find(document: Document, word: str) -> Document:
    """The first piece of a kind or with an id that ends in a word."""
    named = (p for p in document["pieces"] if word in (p["category"], p["function"]))
    ended = (p for p in document["pieces"] if p["id"].endswith(word))
    piece: Document = next(named, None) or next(ended)
    return piece


def built(document: Document, space: str = "") -> list[Document]:
    """The buildings of a space that no brief fixes."""
    rows = [p for p in document["pieces"] if p["category"] == "building" and not p["fixed"]]
    return [p for p in rows if p["space"] == space or not space]


def fix_all(document: Document) -> None:
    for piece in document["pieces"]:
        piece["fixed"] = piece["category"] not in ("tree", "lamp_post")


def remove(document: Document, *pieces: Document) -> None:
    gone = [piece["id"] for piece in pieces]
    document["pieces"] = [p for p in document["pieces"] if not {p["id"], p["on"]} & {*gone}]
    for group in (document.get("graph") or {}).get("groups", ()):
        group["objects"] = [name for name in group["objects"] if name not in gone]


def remove_all(document: Document) -> None:
    remove(document, *(p for p in document["pieces"] if not p["fixed"]))


def move(piece: Document, x: float, y: float) -> None:
    piece["pose"][:2] = [piece["pose"][0] + x, piece["pose"][1] + y]


def put_on(document: Document, piece: Document, other: Document) -> None:
    """A piece where another stands, both said to be fixed."""
    piece["pose"], piece["fixed"], other["fixed"] = list(other["pose"]), True, True


def double(document: Document, piece: Document, x: float = 0.0, **more: Any) -> None:
    copied = copy.deepcopy(piece) | {"id": f"{piece['id']}-again"} | more
    move(copied, x, 0.0)
    document["pieces"].append(copied)


def leave_out(document: Document, space: str, what: str, reason: str) -> None:
    row = {"space": space, "what": what, "reason": reason, "required": True}
    document["left_out"].append(row)


def sources(document: Document) -> list[Document]:
    return [p for p in document["pieces"] if p["space"] == "source"]


def swing_before_door(d: Document) -> None:
    find(d, "wardrobe")["pose"] = [4.0, 0.35, 0.0, 1.5708]
    fix_all(d)


class Tampering(NamedTuple):
    """What is done to the document of a domain, and a kind of finding that tells it."""

    domain: str
    about: str
    change: Callable[[Document], Any]
    kind: str


TAMPERINGS = (
    Tampering(
        "home",
        "all fixed, the bed 100 m outside",
        lambda d: (fix_all(d), move(find(d, "bed"), 100, 0)),
        "out_of_bounds",
    ),
    Tampering(
        "home",
        "wardrobe on the stove, fixed",
        lambda d: put_on(d, find(d, "wardrobe"), find(d, "stove")),
        "collision",
    ),
    Tampering("home", "stove moved", lambda d: move(find(d, "stove"), 0.3, 0), "changed_given"),
    Tampering("home", "stove gone", lambda d: remove(d, find(d, "stove")), "changed_given"),
    Tampering("home", "stove renamed", lambda d: find(d, "stove").update(id="s"), "changed_given"),
    Tampering(
        "home",
        "stove called a rug",
        lambda d: find(d, "stove").update(category="rug"),
        "changed_given",
    ),
    Tampering(
        "home",
        "stove turned",
        lambda d: find(d, "stove")["pose"].__setitem__(3, 1.0),
        "changed_given",
    ),
    Tampering(
        "home",
        "stove made smaller",
        lambda d: find(d, "stove").update(size=[0.2, 0.2, 0.2]),
        "changed_given",
    ),
    Tampering("home", "stove doubled in place", lambda d: double(d, find(d, "stove")), "collision"),
    Tampering("home", "nothing placed", remove_all, "missing"),
    Tampering("home", "the bed gone", lambda d: remove(d, find(d, "sleeping")), "missing"),
    Tampering(
        "home",
        "the bed left out for no reason",
        lambda d: (remove(d, find(d, "sleeping")), leave_out(d, "room", "bed", " ")),
        "missing",
    ),
    Tampering("home", "wardrobe before the door, fixed", swing_before_door, "blocked_door"),
    Tampering(
        "home",
        "bed in the air, fixed",
        lambda d: (fix_all(d), find(d, "sleeping")["pose"].__setitem__(2, 0.5)),
        "floating",
    ),
    Tampering(
        "home",
        "wardrobe on the bed, with a footprint of a sliver",
        lambda d: (
            put_on(d, find(d, "wardrobe"), find(d, "sleeping")),
            find(d, "wardrobe").update(footprint=[[-1, -1], [-0.98, -1], [1, 1], [0.98, 1]]),
        ),
        "collision",
    ),
    Tampering("hall", "nothing placed", remove_all, "missing"),
    Tampering("hall", "a gondola gone", lambda d: remove(d, find(d, "gondola")), "missing"),
    Tampering(
        "hall",
        "two gondolas gone, one said to be left out",
        lambda d: (
            remove(d, *[p for p in d["pieces"] if p["category"] == "gondola"][:2]),
            leave_out(d, "shop", "1 of 4 gondolas", "no room"),
        ),
        "missing",
    ),
    Tampering("hall", "a gondola more", lambda d: double(d, find(d, "gondola"), 2.0), "surplus"),
    Tampering("hall", "no layout", lambda d: d.update(graph=None), "missing"),
    Tampering(
        "hall",
        "a zone gone",
        lambda d: d["graph"].update(zones=d["graph"]["zones"][:1], links=[]),
        "missing",
    ),
    Tampering(
        "hall",
        "a gondola of no demand",
        lambda d: find(d, "gondola").update(function=""),
        "missing",
    ),
    Tampering(
        "hall",
        "a gondola called a plinth",
        lambda d: find(d, "gondola").update(category="plinth"),
        "missing",
    ),
    Tampering(
        "hall",
        "a gondola on the till, fixed",
        lambda d: put_on(d, find(d, "gondola"), find(d, "checkout")),
        "collision",
    ),
    Tampering(
        "hall",
        "gondolas in a group of the front",
        lambda d: [g.update(zone="front") for g in d["graph"]["groups"] if "gondolas" in g["id"]],
        "outside_zone",
    ),
    Tampering(
        "hall",
        "a gondola in no group, at the front",
        lambda d: (
            put_on(d, find(d, "gondola"), find(d, "display_table")),
            d["graph"].update(groups=[]),
        ),
        "outside_zone",
    ),
    Tampering("site", "works not stated", lambda d: d.pop("works"), "missing"),
    Tampering(
        "site",
        "nothing laid out",
        lambda d: d["works"][0].update(pathways=[], areas=[]),
        "unserved_door",
    ),
    Tampering(
        "site", "landmark gone", lambda d: remove(d, find(d, "landmark")), "changed_landmark"
    ),
    Tampering(
        "site", "landmark moved", lambda d: move(find(d, "landmark"), 1, 0), "changed_landmark"
    ),
    Tampering(
        "site",
        "a villa outside, said to be a landmark",
        lambda d: (
            built(d)[0].update(function="landmark", fixed=True),
            move(find(d, "villa_1"), 300, 0),
        ),
        "out_of_bounds",
    ),
    Tampering("site", "a villa gone", lambda d: remove(d, built(d)[0]), "missing"),
    Tampering("site", "nothing built", remove_all, "missing"),
    Tampering("site", "a villa doubled", lambda d: double(d, built(d)[0], 0.5), "collision"),
    Tampering("site", "a villa more, afar", lambda d: double(d, built(d)[0], 300), "surplus"),
    Tampering(
        "site", "a villa called a tree", lambda d: built(d)[0].update(category="tree"), "missing"
    ),
    Tampering(
        "site",
        "a villa on the road, fixed",
        lambda d: (
            (fix_all(d), built(json.loads(solved("site"))), d["pieces"].reverse())
            and next(p for p in d["pieces"] if p["id"].endswith("villa_1")).update(
                pose=[55.0, 45.0, 0.0, 0.0]
            )
        ),
        "blocked_path",
    ),
    Tampering(
        "site", "a villa of another model", lambda d: built(d)[0].update(asset=""), "missing"
    ),
    Tampering(
        "site",
        "a villa made smaller",
        lambda d: built(d)[0].update(size=[3.0, 3.0, 3.0]),
        "missing",
    ),
    Tampering("village", "nothing built", remove_all, "missing"),
    Tampering("village", "a house gone", lambda d: remove(d, built(d)[0]), "missing"),
    Tampering(
        "village",
        "all fixed, a house 500 m away",
        lambda d: (move(built(d)[0], 500, 0), fix_all(d)),
        "out_of_bounds",
    ),
    Tampering(
        "village", "a house on another, both fixed", lambda d: put_on(d, *built(d)[:2]), "collision"
    ),
    Tampering("village", "the square gone", lambda d: d.update(patches=[]), "missing"),
    Tampering("village", "a house more", lambda d: double(d, built(d)[0], 500), "surplus"),
    Tampering(
        "village",
        "a house made smaller",
        lambda d: built(d)[0].update(size=[3.0, 3.0, 3.0]),
        "surplus",
    ),
    Tampering(
        "village",
        "a house of no library",
        lambda d: built(d)[0].update(function="Castle"),
        "surplus",
    ),
    Tampering("extend", "a source gone", lambda d: remove(d, sources(d)[0]), "changed_given"),
    Tampering("extend", "all sources gone", lambda d: remove(d, *sources(d)), "changed_given"),
    Tampering(
        "extend",
        "a source stacked on another",
        lambda d: put_on(d, *sources(d)[:2]),
        "changed_given",
    ),
    Tampering(
        "extend",
        "one more among the sources",
        lambda d: double(d, sources(d)[0], 40.0, fixed=True),
        "surplus",
    ),
    Tampering(
        "extend",
        "a grown house said to have stood before",
        lambda d: built(d)[0].update(space="source", fixed=True),
        "surplus",
    ),
    Tampering("extend", "nothing grown", remove_all, "missing"),
    Tampering(
        "extend",
        "a grown house on a source, fixed",
        lambda d: put_on(d, built(d)[0], sources(d)[0]),
        "collision",
    ),
    Tampering(
        "extend",
        "a grown house on the street, fixed",
        lambda d: built(d)[0].update(pose=[225.0, -16.0, 0.0, 0.0], fixed=True),
        "blocked_path",
    ),
    Tampering(
        "extend",
        "a grown house made smaller",
        lambda d: built(d)[0].update(size=[2.0, 2.0, 2.0]),
        "surplus",
    ),
)


@every(sorted(BRIEFS), str)
def test_what_was_not_tampered_with_is_valid_and_complete(domain: str) -> None:
    report = check(solution_json.loads(solved(domain)))
    assert report.complete, report.findings


@every(TAMPERINGS, lambda row: f"{row.domain}: {row.about}")
def test_what_was_tampered_with_is_not_valid(row: Tampering) -> None:
    document = json.loads(solved(row.domain))
    row.change(document)
    report = check(solution_json.of_document(document))
    assert not report.valid
    assert row.kind in {found.kind for found in report.findings if found.is_blamed}


def test_forty_kinds_of_tampering_are_tried() -> None:
    assert len({(row.domain, row.about) for row in TAMPERINGS}) >= 40


def test_what_is_left_out_with_a_reason_is_valid_and_not_complete() -> None:
    document = json.loads(solved("hall"))
    remove(document, find(document, "gondola"))
    leave_out(document, "shop", "1 of 4 gondolas", "no room")
    report = check(solution_json.of_document(document))
    assert report.valid
    assert not report.complete
    assert str(report) == "valid, not complete: 1 not placed"


@pytest.mark.parametrize("domain", ["home", "village"])
def test_what_a_person_locked_is_said_and_excuses_nothing(domain: str) -> None:
    document = json.loads(solved(domain))
    one, other = document["pieces"][-2:] if domain == "home" else built(document)[:2]
    put_on(document, one, other)
    report = check(solution_json.of_document(document))
    assert not report.valid
    assert all(found.locked for found in report.of("collision") if found.piece == one["id"])
