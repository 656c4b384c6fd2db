"""The manifest of a set of generated plans: a JSON line a plan, and splits that share no plan."""

from __future__ import annotations

import json
import re
from hashlib import blake2b
from typing import Any

from scenewright._version import __version__
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.formats import brief_json

RANGE = re.compile(r"[0-9]{1,15}:[0-9]{1,15}")
SHARES = (("train", 0.8), ("val", 0.9), ("test", 1.0))
"""The splits, and up to what share of all hashes each reaches."""


def seeds_of(text: str, most: int) -> range:
    """The seeds of ``FIRST:END``, the end left out; ``most`` at once.

    >>> seeds_of("3:6", 10)
    range(3, 6)
    """
    first, _, end = text.partition(":")
    if not RANGE.fullmatch(text):
        raise InputError(f"--seeds '{text[:40]}' is no range", "give FIRST:END, such as 0:1000")
    seeds = range(int(first), int(end))
    if not seeds:
        fault = f"--seeds {text} holds no seed: the end is left out"
        raise InputError(fault, f"give FIRST:END with END above {first}")
    if len(seeds) > most:
        raise InputError(f"--seeds {text} is {len(seeds)} plans", f"ask for {most} at once")
    return seeds


OF_LOOKS = ("name", "style", "colour", "hour", "residents")
"""Keys of a brief that say nothing of its plan."""


def plan_hash(brief: Brief) -> str:
    """A digest of the plan a brief draws: equal for equal plans, whatever their name, who lives
    there and how they look."""
    said = json.loads(brief_json.dumps(brief))
    for key in OF_LOOKS:
        said.pop(key, None)
    for door in (door for room in said.get("rooms", ()) for door in room.get("doors", ())):
        door.pop("ajar", None)
    return blake2b(json.dumps(said, sort_keys=True).encode(), digest_size=16).hexdigest()


def split_of(digest: str) -> str:
    """The split of a plan by its hash alone, so that one plan is never in two.

    >>> split_of("00ff00ff"), split_of("ffffffff")
    ('train', 'test')
    """
    share = int(digest[:8], 16) / 16**8
    return next(name for name, end in SHARES if share < end)


def manifest_line(file: str, kind: str, seed: int, asked: dict[str, Any], brief: Brief) -> str:
    """A plan's line of the manifest: file, kind, seed, what was asked, version, hash and split."""
    digest = plan_hash(brief)
    given = {key: value for key, value in asked.items() if value is not None}
    line = {"file": file, "kind": kind, "seed": seed, "asked": given, "version": __version__}
    return json.dumps({**line, "plan": digest, "split": split_of(digest)}) + "\n"
