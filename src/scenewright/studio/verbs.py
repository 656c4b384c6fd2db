"""The verbs of the studio: one JSON object each, checked before it reaches the session."""

from __future__ import annotations

import json
import math
from collections.abc import Collection
from typing import Any

from scenewright.core.errors import InputError
from scenewright.formats import samples
from scenewright.studio.drawable import Json
from scenewright.studio.session import Session
from scenewright.workflow.editing import Addition, edit_pieces

MOST = 500
"""Pieces that one verb may name."""


def do_verb(session: Session, body: bytes) -> Json:
    """Do what a request asks: ``{"verb": "move", "piece": "sofa", "pose": [x, y, heading]}``."""
    asked = read_request(body)
    verb, piece = asked.get("verb"), str(asked.get("piece", ""))
    match verb:
        case "open":
            session.open(_sample(asked))
        case "arrange":
            session.arrange(_whole(asked, "seed"))
        case "stop":
            session.stop()
        case "undo" | "redo":
            getattr(session, verb)()
        case "go":
            session.go(_whole(asked, "version"))
        case "judge":
            return {"findings": session.judge(_poses(asked))}
        case "move":
            poses = _poses(asked)
            return session.change(f"moved {_list(poses)}", {"move": poses})
        case "swap":
            other = str(asked.get("other", ""))
            return session.change(f"swapped {_list([piece, other])}", {"swap": [(piece, other)]})
        case "lock" | "unlock":
            names = _names(asked)
            return session.change(f"{verb}ed {_list(names)}", {verb: names})
        case "remove" | "duplicate":
            names, done = _names(asked), verb.removesuffix("e") + "ed"
            return session.change(f"{done} {_list(names)}", {verb: names}, edit_pieces)
        case "exchange":
            model = str(asked.get("asset", ""))
            done = f"exchanged {_word(piece)}"
            return session.change(done, {"exchange": {piece: model}}, edit_pieces)
        case "add":
            x, y, _ = _pose([*_listed(asked.get("at")), 0.0])
            new = Addition(str(asked.get("asset", "")), x, y)
            return session.change(f"added {_word(new.asset)}", {"add": [new]}, edit_pieces)
        case "again":
            space, seed = str(asked.get("space", "")), _whole(asked, "seed")
            done = f"arranged {space} again, seed {seed}"
            return session.change(done, {"again": [space], "seed": seed})
        case "begin":
            session.begin()
        case "draw":
            session.sketch(asked)
        case "breed":
            session.breed()
        case "next":
            session.breeding.next()
        case "say":
            session.breeding.say(str(asked.get("line", "")), _whole(asked, "sheet"))
        case "compare":
            pair = _whole(asked, "one"), _whole(asked, "other")
            return {"differences": session.breeding.compare(*pair)}
        case "choose":
            session.choose(_whole(asked, "number"))
        case _:
            raise InputError(f"there is no verb {verb!r}", "see the page's requests")
    return {}


def read_request(body: bytes) -> Json:
    """The JSON object that a request brings; InputError for anything else."""
    try:
        asked = json.loads(body)
    except ValueError:
        asked = None
    if not isinstance(asked, dict):
        raise InputError("the request is no JSON object", "send one verb with its keys")
    return asked


def _whole(asked: Json, key: str) -> int:
    number = asked.get(key, 0)
    if not isinstance(number, int) or not 0 <= number < 1 << 53:
        raise InputError(f"{key}: {number!r} is no whole number", "give one from 0 on")
    return number


def _pose(value: Any) -> tuple[float, float, float]:
    listed = value if isinstance(value, list) and len(value) == 3 else [None]
    if not all(isinstance(number, int | float) and math.isfinite(number) for number in listed):
        raise InputError("pose: is no place", "give [x, y, heading] in metres and radians")
    x, y, heading = map(float, listed)
    return x, y, math.remainder(heading, math.tau)


def _poses(asked: Json) -> dict[str, tuple[float, float, float]]:
    """Where each piece is to stand: ``poses`` by id, or one ``piece`` and its ``pose``."""
    given = asked.get("poses") or {str(asked.get("piece", "")): asked.get("pose")}
    if not isinstance(given, dict) or len(given) > MOST:
        raise InputError("poses: are no places", f"give at most {MOST} by id")
    return {str(name): _pose(pose) for name, pose in given.items()}


def _names(asked: Json) -> list[str]:
    """Ids of ``pieces``, or of one ``piece``."""
    return [str(name) for name in _listed(asked.get("pieces")) or [asked.get("piece", "")]][:MOST]


def _listed(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _word(name: str) -> str:
    return name.rpartition("/")[2].replace("_", " ")


def _list(names: Collection[str]) -> str:
    """Names for the history: not more than a few."""
    first = ", ".join(map(_word, [*names][:3]))
    return first if len(names) <= 3 else f"{first} and {len(names) - 3} more"


def _sample(asked: Json) -> str:
    """The name of a sample: the page names no other file of this machine."""
    name = str(asked.get("source", ""))
    if name not in samples():
        raise InputError(f"there is no sample {name!r}", "choose one of the list")
    return name
