"""Verbs of the owner: who is let in, and what they liked."""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.studio.asked import read_text, read_whole
from scenewright.studio.people import OWN
from scenewright.studio.verbs.rows import NUMBER, TEXT, Verb

GUEST_VERBS: Mapping[str, Verb] = {
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
