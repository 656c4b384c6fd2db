"""What a verb is asked with, read: numbers, places, names. InputError for what cannot be."""

from __future__ import annotations

import json
import math
from collections.abc import Collection
from typing import Any

from scenewright.core.errors import InputError
from scenewright.formats import samples
from scenewright.studio.shapes import Json

MOST = 500
"""Pieces that one verb may name."""
FARTHEST = 1e9
"""Metres that a place is away from the origin, at most; what is no number is not within it."""


def read_request(body: bytes) -> Json:
    """The JSON object that a request brings; InputError for anything else."""
    try:
        asked = json.loads(body)
    except (ValueError, RecursionError):
        asked = None
    if not isinstance(asked, dict):
        raise InputError("the request is no JSON object", "send one verb with its keys")
    return asked


def read_whole(asked: Json, key: str) -> int:
    """A whole number from 0 on; 0 if left out."""
    number = asked.get(key, 0)
    if not isinstance(number, int) or not 0 <= number < 1 << 53:
        raise InputError(f"{key}: {number!r} is no whole number", "give one from 0 on")
    return number


def read_text(asked: Json, key: str) -> str:
    """A text; empty if left out."""
    return str(asked.get(key, ""))


def read_pose(value: Any) -> tuple[float, float, float]:
    """x, y and a heading."""
    listed = value if isinstance(value, list) and len(value) == 3 else [None]
    if not all(isinstance(number, int | float) and abs(number) <= FARTHEST for number in listed):
        raise InputError("pose: is no place", "give [x, y, heading] in metres and radians")
    x, y, heading = map(float, listed)
    return x, y, math.remainder(heading, math.tau)


def read_poses(asked: Json) -> dict[str, tuple[float, float, float]]:
    """Where each piece is to stand: ``poses`` by id, or one ``piece`` and its ``pose``."""
    given = asked.get("poses") or {read_text(asked, "piece"): asked.get("pose")}
    if not isinstance(given, dict) or len(given) > MOST:
        raise InputError("poses: are no places", f"give at most {MOST} by id")
    return {str(name): read_pose(pose) for name, pose in given.items()}


def read_names(asked: Json) -> list[str]:
    """Ids of ``pieces``, or of one ``piece``."""
    return [str(name) for name in read_list(asked.get("pieces")) or [asked.get("piece", "")]][:MOST]


def read_list(value: Any) -> list[Any]:
    """A list; empty for what is none."""
    return value if isinstance(value, list) else []


def word_of(name: str) -> str:
    """What is named, without where it is."""
    return name.rpartition("/")[2].replace("_", " ")


def list_words(names: Collection[str]) -> str:
    """Names for the history: not more than a few."""
    first = ", ".join(map(word_of, [*names][:3]))
    return first if len(names) <= 3 else f"{first} and {len(names) - 3} more"


def read_sample(asked: Json) -> str:
    """The name of a sample: the page names no other file of this machine."""
    name = read_text(asked, "source")
    if name not in samples():
        raise InputError(f"there is no sample {name!r}", "choose one of the list")
    return name
