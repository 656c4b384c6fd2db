"""How tests speak to a session of the studio, and outlines they draw."""

from __future__ import annotations

import json

from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.verbs import do_verb


def ask(session: Session, **keys: object) -> Json:
    return do_verb(session, json.dumps(keys).encode())


def box(left: float, low: float, right: float, high: float) -> list[list[float]]:
    return [[left, low], [right, low], [right, high], [left, high]]
