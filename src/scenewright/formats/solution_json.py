"""A solution as JSON: everything needed to read it back exactly and to solve it again.

The document is ``{"format": "scenewright/solution", "version": 1, ...}`` with the brief inside;
lengths in metres, angles in radians. One piece, patch or term a line, so that two solutions can
be compared line by line. A piece with ``"fixed": true`` is *locked*: when the file is given to
``scenewright arrange`` it stays where it is and everything else is placed anew.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from scenewright import authorship
from scenewright.brief import Brief, Room
from scenewright.domains.standing import is_item, is_radiator, item_of
from scenewright.errors import InputError
from scenewright.formats.catalog_paths import resolved
from scenewright.formats.graph_record import graph_document, graph_of, tour_document, tour_of
from scenewright.formats.solution_record import FORMAT, PieceRecord, checked
from scenewright.plan import room_ids
from scenewright.scene import STAIRS, Piece, Pose, Size
from scenewright.solution import LeftOut, Patch, Solution, TermValue
from scenewright.stock import catalog_of
from scenewright.whole_file import write_whole


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write a solution to ``path``; the file appears whole or not at all."""
    write_whole(path, dumps(solution))


def read(path: str | os.PathLike[str]) -> Solution:
    """Read a solution; raises :class:`InputError` naming file, place and fault."""
    if Path(path).suffix.lower() != ".json":
        raise InputError("is no solution", "give a solution .json", file=str(path))
    try:
        return loads(Path(path).read_bytes(), Path(path).parent)
    except FileNotFoundError:
        raise InputError("there is no such file", "check the path", file=str(path)) from None
    except InputError as error:
        raise error.located(file=str(path)) from None
    except OSError as error:
        raise InputError(error.strerror or "cannot be read", file=str(path)) from None


def dumps(solution: Solution) -> str:
    """The JSON text of a solution, ending in a newline."""
    entries = ((key, _lines(value)) for key, value in to_document(solution).items())
    return "{\n" + ",\n".join(f'"{key}": {text}' for key, text in entries) + "\n}\n"


def loads(text: str | bytes, folder: Path | None = None) -> Solution:
    """The solution written in ``text`` (UTF-8 if bytes); its catalogues are below ``folder``."""
    try:
        plain = text.decode("utf-8") if isinstance(text, bytes) else text
        document = json.loads(plain, parse_constant=_no_constant)
    except UnicodeDecodeError:
        raise InputError("is not UTF-8 text", "save it as UTF-8") from None
    except RecursionError:
        raise InputError("is nested too deeply", "give a solution file") from None
    except ValueError as error:
        raise InputError(f"is not valid JSON ({error})", "give a solution file") from None
    plain_object = isinstance(document, dict)
    return of_document(resolved(document, folder or Path()) if plain_object else document)


def to_document(solution: Solution) -> dict[str, Any]:
    """A solution as a plain document of dicts, lists, text and numbers."""
    return {
        "format": FORMAT,
        "version": 1,
        "made_by": solution.version,
        "preset": solution.preset,
        "solver": solution.solver,
        "seed": solution.seed,
        "brief_hash": solution.brief_hash,
        "seconds": solution.seconds,
        "evaluations": solution.evaluations,
        "energies": dict(solution.energies),
        "pieces": [_piece_document(piece) for piece in solution.pieces],
        "patches": [patch._asdict() for patch in solution.patches],
        "left_out": [entry._asdict() for entry in solution.left_out],
        "terms": [value._asdict() for value in solution.terms],
        **_hall_document(solution),
        "credits": authorship.document(
            authorship.credits_of(solution.pieces, catalog_of(solution.brief.catalogs))
        ),
        "brief": solution.brief.model_dump(mode="json"),
    }


def _hall_document(solution: Solution) -> dict[str, Any]:
    """What only halls have."""
    if solution.graph is None:
        return {}
    tours = [tour_document(tour) for tour in solution.tours]
    return {"graph": graph_document(solution.graph), "tours": tours}


def of_document(document: object) -> Solution:
    """The solution a document tells; raises :class:`InputError` if it tells none."""
    record = checked(document)
    return Solution(
        brief=record.brief,
        pieces=tuple(_piece(piece) for piece in record.pieces),
        patches=tuple(Patch(p.id, p.space, p.function, p.box) for p in record.patches),
        terms=tuple(TermValue(**dict(value)) for value in record.terms),
        left_out=tuple(LeftOut(**dict(entry)) for entry in record.left_out),
        energies=dict(record.energies),
        preset=record.preset,
        solver=record.solver,
        seed=record.seed,
        version=record.made_by,
        brief_hash=record.brief_hash,
        seconds=record.seconds,
        evaluations=record.evaluations,
        graph=None if record.graph is None else graph_of(record.graph),
        tours=tuple(tour_of(tour) for tour in record.tours),
    )


def brief_of(document: object) -> Brief:
    """The brief to solve again: locked pieces are its fixed items, everything else is free.

    A locked piece keeps its whole furniture group: a locked table its chairs. Fixed items of the
    brief inside stand among the pieces; one that was unlocked in the file is free too. Id,
    category, asset, pose and size are kept.
    """
    solution = of_document(document)
    ids = room_ids(solution.brief)
    rooms = [
        _room_with_locked(room, [piece for piece in solution.pieces if piece.space == space])
        for room, space in zip(solution.brief.rooms, ids, strict=True)
    ]
    return solution.brief.model_copy(update={"rooms": [*map(_zoned(solution), rooms, ids)]})


def _room_with_locked(room: Room, here: list[Piece]) -> Room:
    here = [piece for piece in here if not is_radiator(piece)]
    names = {item.id: item.name for item in room.fixed if item.id}
    groups = {p.group for p in here if p.fixed and p.function not in ("", "fixed", "light")}
    kept = [p for p in here if (p.fixed or p.group in groups) and p.function != STAIRS]
    locked = [item_of(piece, names.get(piece.id, "")) for piece in kept]
    unplaced = [item for item in room.fixed if not any(is_item(item, piece) for piece in here)]
    return room.model_copy(update={"fixed": [*locked, *unplaced]})


def _zoned(solution: Solution) -> Callable[[Room, str], Room]:
    """Gives a room the zones of the solution where its brief leaves them open."""
    zones = () if solution.graph is None else solution.graph.zones
    outlines = {(zone.space, zone.id): zone.outline.tolist() for zone in zones}

    def zoned(room: Room, space: str) -> Room:
        drawn = [
            zone
            if zone.outline is not None or (space, zone.id) not in outlines
            else zone.model_copy(update={"outline": [tuple(p) for p in outlines[space, zone.id]]})
            for zone in room.zones
        ]
        return room.model_copy(update={"zones": drawn})

    return zoned


def _piece_document(piece: Piece) -> dict[str, Any]:
    return {
        "id": piece.id,
        "category": piece.category,
        "asset": piece.asset,
        "space": piece.space,
        "pose": [float(v) for v in piece.pose],
        "size": [float(v) for v in piece.size],
        "group": piece.group,
        "function": piece.function,
        "on": piece.on,
        "fixed": piece.fixed,
    }


def _piece(record: PieceRecord) -> Piece:
    values = dict(record)
    return Piece(**values | {"pose": Pose(*record.pose), "size": Size(*record.size)})


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not a number")


def _lines(value: object) -> str:
    """JSON with one entry of a list a line."""
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(_compact(entry) for entry in value) + "\n]"
    return _compact(value)


def _compact(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, default=_plain)


def _plain(value: Any) -> Any:
    """A NumPy number as a plain one."""
    return value.item()
