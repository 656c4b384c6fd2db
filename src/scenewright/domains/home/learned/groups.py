"""Learned groups as a file: JSON, versioned, one member a line, used by a brief as it is."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import isfinite
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field

from scenewright.catalog.assets import shipped
from scenewright.catalog.models.files import check_json
from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief.fields import (
    Coordinate,
    Heading,
    Height,
    Length,
    Number,
    Side,
    StrictModel,
    Whole,
)
from scenewright.core.catalog import Catalog, Group, Member
from scenewright.core.errors import InputError
from scenewright.core.scene import Size
from scenewright.core.stored_file import check_plain, read_plain, report_damage
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.cases import LearnedCase, merge_similar_cases
from scenewright.domains.home.learned.learning import FurnishedSpace, found_in
from scenewright.domains.home.learned.rows import Clearance, Distance, Share, Targets
from scenewright.domains.home.learned.targets import targets_of

FORMAT = "scenewright/groups"
MOST_BYTES = 32 * 2**20

Sides = tuple[Side, Side, Side]
Text = Annotated[str, Field(max_length=200)]


class MemberRecord(StrictModel):
    """A member of a case as in the file; ``smallest`` and ``largest`` are the sizes seen."""

    category: Text
    x: Coordinate
    y: Coordinate
    z: Height = 0.0
    heading: Heading = 0.0
    size: Sides
    smallest: Sides | None = None
    largest: Sides | None = None
    on: Annotated[Whole, Field(ge=-1, le=200)] = -1


class CaseRecord(StrictModel):
    """A case as in the file; ``rooms`` is the range of areas it was seen in."""

    function: Text
    name: Text
    width: Length
    depth: Length
    members: Annotated[list[MemberRecord], Field(min_length=1, max_length=200)]
    rooms: tuple[Length, Length] | None = None
    wall: Number | None = None
    door: Number | None = None
    seen: Annotated[Whole, Field(ge=1)] = 1
    homes: Annotated[list[Text], Field(max_length=1000)] = []


class GroupsRecord(StrictModel):
    """The file."""

    format: Literal["scenewright/groups"] = "scenewright/groups"
    version: Literal[1] = 1
    rooms: Annotated[Whole, Field(ge=0)] = 0
    cases: Annotated[list[CaseRecord], Field(max_length=5000)]
    distances: Annotated[list[Distance], Field(max_length=5000)] = []
    clearances: Annotated[list[Clearance], Field(max_length=500)] = []
    shares: Annotated[list[Share], Field(max_length=20_000)] = []


class Learned(NamedTuple):
    """What was learned: cases, and statistics of the rooms."""

    rooms: int
    cases: tuple[LearnedCase, ...]
    targets: Targets


@dataclass(frozen=True, eq=False)
class Known:
    """What a brief uses of a file: cases by function, the middle of the room areas each was seen
    in (NaN: not known), and statistics of the rooms."""

    cases: dict[str, tuple[Group, ...]]
    areas: dict[str, tuple[float, ...]]
    targets: Targets


def learn(rooms: Sequence[FurnishedSpace], catalog: Catalog) -> Learned:
    """Groups and statistics of furnished rooms."""
    furnished = [room for room in rooms if room.pieces]
    found = [one for room in furnished for one in found_in(room, catalog)]
    return Learned(
        len(furnished), merge_similar_cases(found), targets_of(furnished, found, catalog)
    )


def document(learned: Learned) -> dict[str, Any]:
    """The file's content."""
    return {
        "format": FORMAT,
        "version": 1,
        "rooms": learned.rooms,
        "cases": [_case(case) for case in learned.cases],
        **{
            key: [_round_row(row._asdict()) for row in rows]
            for key, rows in learned.targets._asdict().items()
        },
    }


def write(learned: Learned, path: Path) -> None:
    """Write the file; it appears whole or not at all."""
    content = document(learned)
    head = {key: value for key, value in content.items() if not isinstance(value, list)}
    lists = [
        f' "{key}": [\n' + ",\n".join("  " + _line(row) for row in rows) + "\n ]"
        for key, rows in content.items()
        if isinstance(rows, list)
    ]
    start = ",\n".join(f' "{key}": {json.dumps(value)}' for key, value in head.items())
    try:
        write_atomically(path, "{\n" + ",\n".join([start, *lists]) + "\n}\n")
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror}", "choose another place", file=str(path)
        ) from None


def read(path: Path) -> Known:
    """What a brief uses of a file; InputError where it cannot be used."""
    with report_damage(path, "a file of learned groups", "make it with scenewright catalog learn"):
        check_plain(path, MOST_BYTES)
        status = path.stat()
        return _read(path, status.st_mtime_ns, status.st_size)


@lru_cache(maxsize=16)
def _read(path: Path, changed: int, size: int) -> Known:
    del changed, size
    content = read_plain(path, MOST_BYTES)
    check_json(content)
    record = GroupsRecord.model_validate_json(content)
    for number, case in enumerate(record.cases):
        _check(case, f"cases[{number}]", str(path))
    return _known(record)


def _check(case: CaseRecord, place: str, file: str) -> None:
    """Raise unless a case is of a known function and its members of known kinds, in its box."""
    if case.function not in GROUPS:
        raise InputError(
            f"unknown group '{case.function}'",
            "see scenewright list groups",
            file=file,
            place=place,
        )
    for number, member in enumerate(case.members):
        at = f"{place}.members[{number}]"
        if member.category not in shipped().kinds:
            raise InputError(
                f"unknown category '{member.category}'",
                "see scenewright list assets",
                file=file,
                place=at,
            )
        if member.on >= number:
            raise InputError(
                "stands on a member that comes later", "list that one first", file=file, place=at
            )
        if max(abs(member.x) - case.width, abs(member.y) - case.depth) > 0:
            raise InputError("is outside its group", "correct its place", file=file, place=at)


def _known(record: GroupsRecord) -> Known:
    cases: dict[str, list[Group]] = {}
    areas: dict[str, list[float]] = {}
    for case in record.cases:
        members = tuple(
            Member(m.category, m.x, m.y, m.z, m.heading, Size(*m.size), m.on) for m in case.members
        )
        group = Group(case.function, case.name, case.width, case.depth, members)
        cases.setdefault(case.function, []).append(group)
        middle = float(np.mean(case.rooms)) if case.rooms else float("nan")
        areas.setdefault(case.function, []).append(middle)
    targets = Targets(tuple(record.distances), tuple(record.clearances), tuple(record.shares))
    return Known(
        {name: tuple(own) for name, own in cases.items()},
        {name: tuple(own) for name, own in areas.items()},
        targets,
    )


def _case(learned: LearnedCase) -> dict[str, Any]:
    case = learned.case
    members = [
        {
            "category": m.category,
            "x": round(m.x, 4),
            "y": round(m.y, 4),
            "z": round(m.z, 4),
            "heading": round(m.heading, 4),
            "size": _sides(m.size),
            "smallest": _sides(low),
            "largest": _sides(high),
            "on": m.on,
        }
        for m, low, high in zip(case.members, learned.smallest, learned.largest, strict=True)
    ]
    return {
        "function": case.function,
        "name": case.name,
        "width": round(case.width, 4),
        "depth": round(case.depth, 4),
        "rooms": [round(a, 2) for a in learned.areas],
        "wall": round(learned.wall, 3),
        "door": round(learned.door, 3) if isfinite(learned.door) else None,
        "seen": learned.seen,
        "homes": list(learned.homes),
        "members": members,
    }


def _sides(size: Sequence[float]) -> list[float]:
    return [round(side, 4) for side in size]


def _round_row(row: dict[str, Any]) -> dict[str, Any]:
    return {
        key: round(value, 3) if isinstance(value, float) else value for key, value in row.items()
    }


def _line(row: dict[str, Any]) -> str:
    """A row in one line; a case with a line for each member."""
    if "members" not in row:
        return json.dumps(row, ensure_ascii=False)
    head = json.dumps({k: v for k, v in row.items() if k != "members"}, ensure_ascii=False)
    lines = ",\n    ".join(json.dumps(m, ensure_ascii=False) for m in row["members"])
    return head[:-1] + ', "members": [\n    ' + lines + "]}"
