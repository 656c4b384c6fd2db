"""The verbs of the studio: one row each, for the page and for agents.

A verb is a JSON object, ``{"verb": "move", "piece": "sofa", "pose": [x, y, heading]}``. Its row
says in a sentence what it does, its keys as JSON Schema, and who may use it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from scenewright.core.edits import Addition
from scenewright.core.errors import InputError
from scenewright.render.daylight import HOURS
from scenewright.render.photo.photograph import SIZE as PHOTO_SIZE
from scenewright.studio.asked import (
    list_words,
    read_list,
    read_names,
    read_pose,
    read_poses,
    read_request,
    read_sample,
    read_text,
    read_whole,
    word_of,
)
from scenewright.studio.drafting import ACTS, NOUNS
from scenewright.studio.people import AUTHOR, EDIT, OWN, OWNER, RATE, Person, may
from scenewright.studio.photos import View
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.workflow.accepting import accept_findings_by_hand
from scenewright.workflow.editing import edit_pieces

PIECE: Json = {"type": "string", "description": "id of a piece"}
PIECES: Json = {"type": "array", "items": {"type": "string"}, "description": "ids of pieces"}
POSE: Json = {
    "type": "array",
    "items": {"type": "number"},
    "minItems": 3,
    "maxItems": 3,
    "description": "x, y in metres and the heading of the front in radians, from +x to the left",
}
POSES: Json = {"type": "object", "additionalProperties": POSE, "description": "poses by id"}
AT: Json = {
    "type": "array",
    "items": {"type": "number"},
    "minItems": 2,
    "maxItems": 2,
    "description": "x, y in metres",
}
STYLES = ["boho", "classic", "industrial", "japandi", "modern", "nordic", "retro"]
SIZE: Json = {**POSE, "description": "width, depth and height in metres"}
SEED: Json = {"type": "integer", "minimum": 0, "description": "another one, another answer"}
ASSET: Json = {"type": "string", "description": "id of a model, from the shelf"}
TEXT: Json = {"type": "string"}
NUMBER: Json = {"type": "integer", "minimum": 0, "description": "number of a layout"}


class Verb(NamedTuple):
    """What a verb does, in a sentence; its keys by JSON Schema; what does it; which keys it cannot
    do without; what one must be allowed; and whether it goes on after it has answered."""

    about: str
    keys: Mapping[str, Json]
    do: Callable[[Any, Json], Json | None]
    needed: tuple[str, ...] = ()
    right: str = EDIT
    goes_on: bool = False

    def schema(self) -> Json:
        """The JSON Schema of its keys."""
        keys = {"type": "object", "properties": dict(self.keys), "additionalProperties": False}
        return keys | ({"required": [*self.needed]} if self.needed else {})


def do_verb(session: Session, body: bytes, person: Person = OWNER) -> Json:
    """Do what a person asks, if she may; InputError in one line for what cannot be done."""
    asked = read_request(body)
    row = VERBS.get(str(asked.get("verb")))
    if row is None:
        raise InputError(f"there is no verb {asked.get('verb')!r}", f"use {', '.join(VERBS)}")
    if not may(person.right, row.right):
        raise InputError(f"your link does not let you {asked['verb']}", "ask whoever sent it")
    AUTHOR.set(person.name)
    return row.do(session if may(person.right, EDIT) else session.desk_of(person), asked) or {}


def _move(session: Session, asked: Json) -> Json:
    poses = read_poses(asked)
    return session.change(f"moved {list_words(poses)}", {"move": poses})


def _swap(session: Session, asked: Json) -> Json:
    pair = read_text(asked, "piece"), read_text(asked, "other")
    return session.change(f"swapped {list_words(pair)}", {"swap": [pair]})


def _by_name(verb: str, **more: Any) -> Callable[[Session, Json], Json]:
    """A verb about pieces by id, which :mod:`scenewright.domains` or ``by`` calls alike."""

    def do(session: Session, asked: Json) -> Json:
        names = read_names(asked)
        return session.change(
            f"{verb.removesuffix('e')}ed {list_words(names)}", {verb: names}, **more
        )

    return do


def _exchange(session: Session, asked: Json) -> Json:
    piece = read_text(asked, "piece")
    edits = {"exchange": {piece: read_text(asked, "asset")}}
    return session.change(f"exchanged {word_of(piece)}", edits, edit_pieces)


def _add(session: Session, asked: Json) -> Json:
    x, y, _ = read_pose([*read_list(asked.get("at")), 0.0])
    new = Addition(read_text(asked, "asset"), x, y)
    return session.change(f"added {word_of(new.asset)}", {"add": [new]}, edit_pieces)


def _resize(session: Session, asked: Json) -> Json:
    piece, size = read_text(asked, "piece"), list(read_pose(asked.get("size")))
    return session.change(f"resized {word_of(piece)}", {"resize": {piece: size}}, edit_pieces)


def _accept(session: Session, asked: Json) -> Json:
    kind, thing = read_text(asked, "kind"), read_text(asked, "piece") or read_text(asked, "space")
    accept = {f"{kind}:{thing}" if thing else kind: read_text(asked, "reason")}
    what = f"accepted {kind.replace('_', ' ')}"
    return session.change(what, {"accept": accept}, accept_findings_by_hand)


def _restyle(session: Session, asked: Json) -> Json:
    piece, style = read_text(asked, "piece"), read_text(asked, "style")
    if not piece:
        return session.restyle(style, read_text(asked, "palette"))
    edits = {"restyle": {piece: style}}
    return session.change(f"restyled {word_of(piece)}, {style}", edits, edit_pieces)


def _photo(session: Session, asked: Json) -> None:
    x, y, heading = read_pose([*read_list(asked.get("eye"))[:2], asked.get("heading")])
    z, _, _ = read_pose([*read_list(asked.get("eye"))[2:], 0.0, 0.0])
    wide, tall, _ = read_pose([*(read_list(asked.get("size")) or PHOTO_SIZE), 0.0])
    hour = read_text(asked, "hour") or "day"
    session.photograph(View((x, y, z), heading, hour, (int(wide), int(tall))))


def _again(session: Session, asked: Json) -> Json:
    space, seed = read_text(asked, "space"), read_whole(asked, "seed")
    edits = {"again": [space], "seed": seed}
    return session.change(f"arranged {space} again, seed {seed}", edits)


def _judge(session: Session, asked: Json) -> Json:
    return {"findings": session.judge(read_poses(asked))}


def _compare(session: Session, asked: Json) -> Json:
    return {
        "differences": session.breeding.compare(
            read_whole(asked, "one"), read_whole(asked, "other")
        )
    }


def _say(session: Session, asked: Json) -> None:
    session.breeding.say(read_text(asked, "line"), read_whole(asked, "sheet"))


SHEET: Json = {"type": "integer", "minimum": 0, "description": "the sheet it is said of, from 0"}
LINE: Json = {
    "type": "string",
    "description": "by places from 1: 3 (the best) · worst 5 · 3 > 7 · 3=5 (stars) · "
    "why 3 REASON · lock NAME · keep · undo",
}
VERBS: Mapping[str, Verb] = {
    "open": Verb(
        "begin with a sample",
        {"source": {"type": "string", "description": "sample:NAME"}},
        lambda session, asked: session.open(read_sample(asked)),
        ("source",),
    ),
    "arrange": Verb(
        "furnish the plan anew; what is locked stays",
        {"seed": SEED},
        lambda session, asked: session.arrange(read_whole(asked, "seed")),
        goes_on=True,
    ),
    "stop": Verb("end the search with the best so far", {}, lambda session, _: session.stop()),
    "undo": Verb("go back to the version before", {}, lambda session, _: session.undo()),
    "redo": Verb("go forward to what was undone last", {}, lambda session, _: session.redo()),
    "go": Verb(
        "show another version of the history",
        {"version": {"type": "integer", "minimum": 1}},
        lambda session, asked: session.go(read_whole(asked, "version")),
        ("version",),
    ),
    "judge": Verb(
        "what the referee would say if pieces were put there; nothing is changed",
        {"poses": POSES, "piece": PIECE, "pose": POSE},
        _judge,
    ),
    "fit": Verb(
        "the nearest place to a wanted one where a piece fits; nothing is changed",
        {"piece": PIECE, "pose": POSE},
        lambda session, asked: session.fit(read_text(asked, "piece"), read_pose(asked.get("pose"))),
        ("piece", "pose"),
    ),
    "move": Verb(
        "put pieces, with what lies on them, at places; the rest gives way as little as it can",
        {"poses": POSES, "piece": PIECE, "pose": POSE},
        _move,
    ),
    "swap": Verb(
        "two pieces change places", {"piece": PIECE, "other": PIECE}, _swap, ("piece", "other")
    ),
    "lock": Verb(
        "keep pieces where they are", {"pieces": PIECES, "piece": PIECE}, _by_name("lock")
    ),
    "unlock": Verb(
        "let pieces be moved again", {"pieces": PIECES, "piece": PIECE}, _by_name("unlock")
    ),
    "remove": Verb(
        "take pieces away", {"pieces": PIECES, "piece": PIECE}, _by_name("remove", by=edit_pieces)
    ),
    "duplicate": Verb(
        "put in the same pieces once more, beside",
        {"pieces": PIECES, "piece": PIECE},
        _by_name("duplicate", by=edit_pieces),
    ),
    "exchange": Verb(
        "another model in the place of a piece",
        {"piece": PIECE, "asset": ASSET},
        _exchange,
        ("piece", "asset"),
    ),
    "add": Verb(
        "put in a model near a place; it is locked there",
        {"asset": ASSET, "at": AT},
        _add,
        ("asset", "at"),
    ),
    "resize": Verb(
        "give a piece another size, where its model comes in that",
        {"piece": PIECE, "size": SIZE},
        _resize,
        ("piece", "size"),
    ),
    "restyle": Verb(
        "models of a style for a piece, or for all of a space; with neither for the whole home, "
        "whose materials become those of a palette of the style",
        {"piece": PIECE, "style": {"enum": STYLES}, "palette": TEXT},
        _restyle,
        ("style",),
    ),
    "accept": Verb(
        "accept what the referee finds, with the reason",
        {"kind": TEXT, "piece": PIECE, "space": TEXT, "reason": TEXT},
        _accept,
        ("kind", "reason"),
    ),
    "photo": Verb(
        "photograph the scene from a place in a room; a minute or less",
        {
            "eye": {**POSE, "description": "x, y, z in metres"},
            "heading": {"type": "number", "description": "radians, from +x to the left"},
            "hour": {"enum": [*HOURS]},
            "size": {**AT, "description": "pixels, 1280 by 800 if left out"},
        },
        _photo,
        ("eye", "heading"),
        goes_on=True,
    ),
    "wish": Verb(
        "say what is asked of a room, hall, site or block; heeded when it is arranged",
        {
            "space": TEXT,
            "wishes": {
                "description": "all rows: [{'what': 'tv', 'forbid': true}] of a room, demands of "
                "a hall, buildings of a site; or keys: {'coverage': 0.3}"
            },
        },
        lambda session, asked: session.wish(read_text(asked, "space"), asked.get("wishes")),
        ("space", "wishes"),
    ),
    "again": Verb(
        "another answer for one room, around what is locked",
        {"space": {"type": "string", "description": "id of the room"}, "seed": SEED},
        _again,
        ("space",),
    ),
    "begin": Verb(
        "begin a plan to be drawn",
        {"kind": {"enum": [*NOUNS], "description": "of scene; a home if left out"}},
        lambda session, asked: session.begin(str(asked.get("kind") or "home")),
    ),
    "redraw": Verb(
        "take a home or hall that was brought over into a drawing; what that cannot hold is listed",
        {},
        lambda session, _: session.redraw(),
    ),
    "draw": Verb(
        f"change the drawn plan: {', '.join(ACTS)}",
        {
            "act": {"type": "string"},
            "outline": {"type": "array", "description": "[[x, y], …], metres, middles of walls"},
            "line": {"type": "array", "description": "of a street: [[x, y], …], metres"},
            "name": {"type": "string", "description": "what the room is for: Bedroom, Kitchen …"},
            "kind": {"type": "string", "description": "door, passage, window; road, path"},
            "level": {"type": "string", "description": "id of a storey; the first if left out"},
            "heading": {"type": "number", "description": "radians, the way stairs lead up"},
            "copy": {"type": "boolean", "description": "a storey with the rooms of that below"},
            "asked": {"type": "object", "description": "as wishes, by key"},
            "at": AT,
            "points": {"type": "array", "description": "corners, or two ends of a wall, to move"},
            "by": AT,
            "id": {"type": "string"},
            "edge": {"type": "integer"},
            "metres": {"type": "number"},
            "key": {"type": "string", "description": "what of it to set"},
            "value": {},
        },
        lambda session, asked: session.sketch(asked),
        ("act",),
    ),
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
    "give": Verb(
        "give the plan out to be rated by those who have a link for it",
        {},
        lambda session, _: session.give(),
        right=OWN,
    ),
    "take": Verb(
        "take a layout that people rated over to the plan",
        {"number": NUMBER},
        lambda session, asked: session.take(read_whole(asked, "number")),
        ("number",),
        OWN,
    ),
    "invite": Verb(
        "make a link for a person",
        {"name": TEXT, "right": {"enum": ["view", "rate", "edit"]}},
        lambda session, asked: session.invite(read_text(asked, "name"), read_text(asked, "right")),
        ("name", "right"),
        OWN,
    ),
    "renew": Verb(
        "make another link for a person; the one before lets nobody in",
        {"person": NUMBER},
        lambda session, asked: {"token": session.people.renew(read_whole(asked, "person"))},
        ("person",),
        OWN,
    ),
    "drop": Verb(
        "let a person in no more",
        {"person": NUMBER},
        lambda session, asked: session.people.drop(read_whole(asked, "person")),
        ("person",),
        OWN,
    ),
}
