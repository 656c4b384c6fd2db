"""Verbs that draw a plan."""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.studio.drafting import ACTS, NOUNS
from scenewright.studio.verbs.rows import AT, Verb

DRAWING_VERBS: Mapping[str, Verb] = {
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
            "copy": {
                "type": "boolean",
                "description": "a storey with the rooms of that below; shift another one",
            },
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
}
