"""The verbs of the studio: one JSON object each, checked before it reaches the session."""

from __future__ import annotations

import json
import math

from scenewright.core.errors import InputError
from scenewright.formats import samples
from scenewright.studio.drawable import Json
from scenewright.studio.session import Session


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
            return {"findings": session.judge(piece, _pose(asked))}
        case "move":
            return {"changes": session.change(f"moved {piece}", move={piece: _pose(asked)})}
        case "swap":
            other = str(asked.get("other", ""))
            return {"changes": session.change(f"swapped {piece}, {other}", swap=[(piece, other)])}
        case "lock" | "unlock":
            return {"changes": session.change(f"{verb}ed {piece}", **{verb: [piece]})}
        case "again":
            space, seed = str(asked.get("space", "")), _whole(asked, "seed")
            done = f"arranged {space} again, seed {seed}"
            return {"changes": session.change(done, again=[space], seed=seed)}
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


def _pose(asked: Json) -> tuple[float, float, float]:
    pose = asked.get("pose")
    listed = pose if isinstance(pose, list) and len(pose) == 3 else [None]
    if not all(isinstance(number, int | float) and math.isfinite(number) for number in listed):
        raise InputError("pose: is no place", "give [x, y, heading] in metres and radians")
    x, y, heading = map(float, listed)
    return x, y, math.remainder(heading, math.tau)


def _sample(asked: Json) -> str:
    """The name of a sample: the page names no other file of this machine."""
    name = str(asked.get("source", ""))
    if name not in samples():
        raise InputError(f"there is no sample {name!r}", "choose one of the list")
    return name
