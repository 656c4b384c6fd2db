"""What a hostile client puts into the keys of verbs."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

WHOLE: dict[str, Any] = {
    "piece": "desk",
    "other": "wardrobe",
    "pieces": ["desk"],
    "pose": [1.0, 1.0, 0.0],
    "size": [1.0, 0.6, 0.75],
    "asset": "armchair",
    "at": [1.0, 1.0],
    "space": "room",
    "style": "nordic",
    "act": "name",
    "kind": "collision",
    "reason": "meant",
    "wishes": [],
    "version": 1,
    "number": 0,
    "line": "3",
    "eye": [1.0, 1.0, 1.6],
    "heading": 0.0,
}
"""What a key may hold, so that only another one is hostile."""


def nest(depth: int) -> Any:
    """Lists in lists."""
    value: Any = []
    for _ in range(depth):
        value = [value]
    return value


VALUES: Mapping[str, Any] = {
    "nothing": None,
    "yes": True,
    "negative": -1,
    "huge": 10**400,
    "large": 1e308,
    "not a number": float("nan"),
    "endless": float("inf"),
    "empty": "",
    "long": "x" * 100_000,
    "zero byte": "desk\x00",
    "lines": "desk\nroom: all is well",
    "outside": "../../../../etc/passwd",
    "no text": "\ud800",
    "list": [[]],
    "object": {"desk": {}},
    "deep": nest(400),
    "numbers": [1e308, -1e308, 1e308],
    "huge numbers": [10**400, 0, 0],
    "not numbers": [float("nan")] * 3,
    "many": ["desk"] * 5000,
}
"""Values that no key is meant to hold, or hardly."""


def list_hostile(verb: str, keys: Mapping[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Requests of one verb: one key hostile, the others as they may be; and keys left out, more
    than there are, and one of another version."""
    usual = {key: WHOLE[key] for key in keys if key in WHOLE}
    for key in keys:
        for name, value in VALUES.items():
            yield f"{verb} {key} {name}", {"verb": verb, **usual, key: value}
    yield f"{verb} of nothing", {"verb": verb}
    yield f"{verb} and more", {"verb": verb, **usual, "colour": "red", "__class__": "Session"}


def write(asked: Mapping[str, Any]) -> bytes:
    """A request as it is sent; lone surrogates and numbers that are none as they are."""
    return json.dumps(asked).encode()
