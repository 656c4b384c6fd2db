"""What changed from one state of the page to the next: an edit is a few numbers, not the scene."""

from __future__ import annotations

import json
from collections import OrderedDict
from difflib import SequenceMatcher
from typing import Any

Json = dict[str, Any]
KEPT = 8
"""States that a change can be told from."""


def tell_change(before: Any, after: Any) -> Json:
    """What makes ``after`` of ``before`` by :func:`follow_change`: another ``value``; of an object
    the ``keys`` that changed, each with its change, and those that are ``gone``; of a list the
    ``items`` that changed, by their index, and what is ``cut`` at an index, with what comes there.

    >>> one = {"version": 1, "pieces": [{"id": "bed", "at": [1, 2]}, {"id": "desk", "x": 3}]}
    >>> two = {"version": 2, "pieces": [{"id": "bed", "at": [5, 2]}]}
    >>> told = tell_change(one, two)
    >>> told["keys"]["version"]
    {'value': 2}
    >>> follow_change(one, told) == two
    True
    """
    if isinstance(before, dict) and isinstance(after, dict):
        gone = [key for key in before if key not in after]
        keys = {
            key: tell_change(before[key], value) if key in before else {"value": value}
            for key, value in after.items()
            if key not in before or before[key] != value
        }
        return {"keys": keys} | ({"gone": gone} if gone else {})
    if _holds_more(before) and _holds_more(after):
        return _tell_list(before, after)
    return {"value": after}


def follow_change(before: Any, told: Json) -> Any:
    """The state after a change, as the page works it out."""
    if "value" in told:
        return told["value"]
    if "keys" in told:
        after = {key: value for key, value in before.items() if key not in told.get("gone", ())}
        return after | {k: follow_change(before.get(k), one) for k, one in told["keys"].items()}
    items = list(before)
    for index, one in told.get("items", {}).items():
        items[int(index)] = follow_change(items[int(index)], one)
    for at, count, more in reversed(told.get("cut", ())):
        items[at : at + count] = more
    return items


def _tell_list(before: list[Any], after: list[Any]) -> Json:
    """Items are told apart by their id, or else by their text; of those that stand for one another
    the change is told."""
    items, cut = dict[str, Json](), list[list[Any]]()
    one, other = ([_name(item) for item in rows] for rows in (before, after))
    for tag, a, b, c, d in SequenceMatcher(None, one, other, autojunk=False).get_opcodes():
        pairs = [*zip(range(a, b), range(c, d), strict=False)]
        if tag == "equal" or (b - a == d - c and all(_has_parts(after[n]) for _, n in pairs)):
            changed = ((k, n) for k, n in pairs if before[k] != after[n])
            items |= {str(k): tell_change(before[k], after[n]) for k, n in changed}
        else:
            cut.append([a, b - a, after[c:d]])
    told: Json = ({"items": items} if items else {}) | ({"cut": cut} if cut else {})
    return told if len(json.dumps(told)) < len(json.dumps(after)) else {"value": after}


def _name(item: Any) -> str:
    named = isinstance(item, dict) and "id" in item
    return f"id {item['id']}" if named else json.dumps(item)


def _has_parts(value: Any) -> bool:
    """Whether the change of something may be told by its parts."""
    return isinstance(value, dict) or _holds_more(value)


def _holds_more(value: Any) -> bool:
    """Whether something is a list of lists or objects; points are told whole."""
    return isinstance(value, list) and any(isinstance(one, list | dict) for one in value)


class States:
    """The last states, each by its number, so that a page may ask what changed since."""

    def __init__(self) -> None:
        self._kept: OrderedDict[int, Json] = OrderedDict()
        self._number = 0

    def tell(self, state: Json, since: int = 0) -> Json:
        """A state with its number as ``stamp``, or how it changed ``since`` one that is kept."""
        last = self._kept.get(self._number)
        if last is None or last != state | {"stamp": self._number}:
            self._number += 1
            self._kept[self._number] = state | {"stamp": self._number}
            while len(self._kept) > KEPT:
                self._kept.popitem(last=False)
        now = self._kept[self._number]
        if since not in self._kept:
            return now
        return {"since": since, **tell_change(self._kept[since], now)}
