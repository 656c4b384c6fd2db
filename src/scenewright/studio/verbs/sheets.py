"""Verbs of sheets of layouts: breed them, say what is liked, take one over."""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.studio.asked import read_text, read_whole
from scenewright.studio.people import RATE
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.verbs.rows import NUMBER, Verb

SHEET: Json = {"type": "integer", "minimum": 0, "description": "the sheet it is said of, from 0"}
LINE: Json = {
    "type": "string",
    "description": "by places from 1: 3 (the best) · worst 5 · 3 > 7 · 3=5 (stars) · "
    "why 3 REASON · lock NAME · keep · undo",
}


def _compare(session: Session, asked: Json) -> Json:
    return {
        "differences": session.breeding.compare(
            read_whole(asked, "one"), read_whole(asked, "other")
        )
    }


def _say(session: Session, asked: Json) -> None:
    session.breeding.say(read_text(asked, "line"), read_whole(asked, "sheet"))


SHEET_VERBS: Mapping[str, Verb] = {
    "breed": Verb(
        "breed twelve layouts of the plan to choose from",
        {},
        lambda session, _: session.breed(),
        right=RATE,
        goes_on=True,
    ),
    "next": Verb(
        "breed the next sheet towards what was said",
        {},
        lambda session, _: session.breeding.next(),
        right=RATE,
        goes_on=True,
    ),
    "say": Verb(
        "say what is liked of a sheet", {"line": LINE, "sheet": SHEET}, _say, ("line",), RATE
    ),
    "compare": Verb(
        "how one layout differs from another, in words",
        {"one": NUMBER, "other": NUMBER},
        _compare,
        ("one", "other"),
        RATE,
    ),
    "choose": Verb(
        "take a layout that was bred over to the plan",
        {"number": NUMBER},
        lambda session, asked: session.choose(read_whole(asked, "number")),
        ("number",),
    ),
}
