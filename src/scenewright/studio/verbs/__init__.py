"""The verbs of the studio: one row each, for the page and for agents.

A verb is a JSON object, ``{"verb": "move", "piece": "sofa", "pose": [x, y, heading]}``. Its row
says in a sentence what it does, its keys as JSON Schema, and who may use it.
"""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.core.errors import InputError
from scenewright.studio.asked import read_request
from scenewright.studio.people import AUTHOR, EDIT, OWNER, Person, may
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.verbs.drawing import DRAWING_VERBS
from scenewright.studio.verbs.editing import EDITING_VERBS
from scenewright.studio.verbs.guests import GUEST_VERBS
from scenewright.studio.verbs.rows import Verb
from scenewright.studio.verbs.scene import SCENE_VERBS
from scenewright.studio.verbs.sheets import SHEET_VERBS

__all__ = ["VERBS", "Verb", "do_verb"]

VERBS: Mapping[str, Verb] = {
    **SCENE_VERBS,
    **EDITING_VERBS,
    **DRAWING_VERBS,
    **SHEET_VERBS,
    **GUEST_VERBS,
}


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
