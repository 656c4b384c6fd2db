"""What changed from one state of the page to the next: an edit is a few rows, not the scene."""

from __future__ import annotations

from collections import OrderedDict
from typing import Any

Json = dict[str, Any]
KEPT = 8
"""States that a change can be told from."""


def tell_change(before: Json, after: Json) -> Json:
    """Values to ``set`` by key, keys that are ``gone``, entries to ``add`` to objects, and of lists
    of rows with an id those ``gone`` and those ``put``, each at its index. What a page has makes
    ``after`` by :func:`follow_change`, but for entries of objects, which it may keep.

    >>> one = {"version": 1, "pieces": [{"id": "bed", "x": 1}, {"id": "desk", "x": 2}]}
    >>> two = {"version": 2, "pieces": [{"id": "bed", "x": 5}]}
    >>> told = tell_change(one, two)
    >>> told["set"], told["rows"]
    ({'version': 2}, {'pieces': {'gone': ['desk'], 'put': [[0, {'id': 'bed', 'x': 5}]]}})
    >>> follow_change(one, told) == two
    True
    """
    told: Json = {"set": {}, "gone": [key for key in before if key not in after]}
    told |= {"add": {}, "rows": {}}
    for key, value in after.items():
        was = before.get(key)
        if was == value and key in before:
            continue
        if isinstance(was, dict) and isinstance(value, dict):
            told["add"][key] = {name: v for name, v in value.items() if was.get(name) != v}
        elif (rows := _tell_rows(was, value)) is not None:
            told["rows"][key] = rows
        else:
            told["set"][key] = value
    return told


def follow_change(before: Json, told: Json) -> Json:
    """The state after a change, as the page works it out."""
    after = {key: value for key, value in before.items() if key not in told["gone"]} | told["set"]
    for key, more in told["add"].items():
        after[key] = before[key] | more
    for key, rows in told["rows"].items():
        after[key] = _follow_rows(before[key], rows)
    return after


def _tell_rows(was: Any, now: Any) -> Json | None:
    """How a list of rows with ids changed; nothing where it has no such rows, or they changed
    places."""
    if not (_has_ids(was) and _has_ids(now)):
        return None
    known, there = {row["id"]: row for row in was}, {row["id"] for row in now}
    put = [[k, row] for k, row in enumerate(now) if known.get(row["id"]) != row]
    rows = {"gone": [name for name in known if name not in there], "put": put}
    return rows if _follow_rows(was, rows) == now else None


def _follow_rows(was: list[Json], rows: Json) -> list[Json]:
    gone = {*rows["gone"], *(row["id"] for _, row in rows["put"])}
    found = [row for row in was if row["id"] not in gone]
    for at, row in rows["put"]:
        found.insert(at, row)
    return found


def _has_ids(rows: Any) -> bool:
    if not isinstance(rows, list) or not all(isinstance(row, dict) and "id" in row for row in rows):
        return False
    return len({row["id"] for row in rows}) == len(rows)


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
