"""Verbs that judge and change pieces by hand."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from scenewright.core.edits import Addition
from scenewright.studio.asked import (
    list_words,
    read_list,
    read_names,
    read_pose,
    read_poses,
    read_text,
    read_whole,
    word_of,
)
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.verbs.rows import AT, POSE, SEED, TEXT, Verb
from scenewright.workflow.accepting import accept_findings_by_hand
from scenewright.workflow.editing import edit_pieces

PIECE: Json = {"type": "string", "description": "id of a piece"}
PIECES: Json = {"type": "array", "items": {"type": "string"}, "description": "ids of pieces"}
POSES: Json = {"type": "object", "additionalProperties": POSE, "description": "poses by id"}
STYLES = ["boho", "classic", "industrial", "japandi", "modern", "nordic", "retro"]
SIZE: Json = {**POSE, "description": "width, depth and height in metres"}
ASSET: Json = {"type": "string", "description": "id of a model, from the shelf"}


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


def _again(session: Session, asked: Json) -> Json:
    space, seed = read_text(asked, "space"), read_whole(asked, "seed")
    edits = {"again": [space], "seed": seed}
    return session.change(f"arranged {space} again, seed {seed}", edits)


def _judge(session: Session, asked: Json) -> Json:
    return {"findings": session.judge(read_poses(asked))}


EDITING_VERBS: Mapping[str, Verb] = {
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
    "again": Verb(
        "another answer for one room, around what is locked",
        {"space": {"type": "string", "description": "id of the room"}, "seed": SEED},
        _again,
        ("space",),
    ),
}
