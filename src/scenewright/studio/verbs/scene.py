"""Verbs of the scene as a whole: begin with it, arrange it, step through its versions."""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.render.daylight import HOURS
from scenewright.render.photo.photograph import SIZE as PHOTO_SIZE
from scenewright.studio.asked import read_list, read_pose, read_sample, read_text, read_whole
from scenewright.studio.photos import View
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.verbs.rows import AT, POSE, SEED, TEXT, Verb


def _photo(session: Session, asked: Json) -> None:
    x, y, heading = read_pose([*read_list(asked.get("eye"))[:2], asked.get("heading")])
    z, _, _ = read_pose([*read_list(asked.get("eye"))[2:], 0.0, 0.0])
    wide, tall, _ = read_pose([*(read_list(asked.get("size")) or PHOTO_SIZE), 0.0])
    hour = read_text(asked, "hour") or "day"
    session.photograph(View((x, y, z), heading, hour, (int(wide), int(tall))))


SCENE_VERBS: Mapping[str, Verb] = {
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
}
