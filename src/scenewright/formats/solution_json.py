"""A solution as JSON: everything needed to read it back exactly and to solve it again.

The document is ``{"format": "scenewright/solution", "version": 1, ...}`` with the brief inside;
lengths in metres, angles in radians. The time that solving took is not in it, so that the same
seed and steps give the same bytes. One piece, patch or term a line, so that two solutions can
be compared line by line. A piece with ``"fixed": true`` is *locked*: when the file is given to
``scenewright arrange`` it stays where it is and everything else is placed anew.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import note_read, write_atomically
from scenewright.core.brief import Brief
from scenewright.core.brief.own_report import report_pieces
from scenewright.core.errors import InputError
from scenewright.core.footprint import read_footprint
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut, Patch, Solution, TermValue
from scenewright.formats.catalog_paths import resolve_paths
from scenewright.formats.json_document import check_size, parse_document
from scenewright.formats.solution_record import FORMAT, PieceRecord, SolutionRecord, check_document


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write a solution to ``path``; the file appears whole or not at all."""
    write_atomically(path, dumps(solution))


def read(path: str | os.PathLike[str]) -> Solution:
    """Read a saved solution, which can be judged, explained, changed, written in other formats or
    solved again. Raises :class:`InputError`, one line that names file, place, fault and remedy."""
    return read_planned(path)[0]


def read_planned(
    path: str | os.PathLike[str], known: tuple[Brief, Plan] | None = None
) -> tuple[Solution, Plan]:
    """Read a solution and the plan of its brief; a brief equal to the ``known`` one is not planned
    again. Raises :class:`InputError` naming file, place and fault."""
    if not Path(path).suffix and not Path(path).exists():
        raise InputError(
            "there is no such file", "check the path; solutions are .json files", file=str(path)
        )
    if Path(path).suffix.lower() != ".json":
        raise InputError("is not a Scenewright solution", "give a solution .json", file=str(path))
    if Path(path).exists() and not Path(path).is_file():
        what = "is a folder" if Path(path).is_dir() else "is not a file"
        raise InputError(what, "give the file itself", file=str(path))
    note_read(path)
    try:
        check_size(Path(path), "split its brief")
        return _parse(Path(path).read_bytes(), Path(path).parent, known)
    except FileNotFoundError:
        raise InputError("there is no such file", "check the path", file=str(path)) from None
    except InputError as error:
        raise error.located(file=str(path)) from None
    except OSError as error:
        fault = f"cannot be read: {error.strerror or error}"
        raise InputError(fault, "check file permissions", file=str(path)) from None


def dumps(solution: Solution) -> str:
    """The JSON text of a solution, ending in a newline."""
    entries = ((key, _lines(value)) for key, value in to_document(solution).items())
    return "{\n" + ",\n".join(f'"{key}": {text}' for key, text in entries) + "\n}\n"


def loads(text: str | bytes, folder: Path | None = None) -> Solution:
    """The solution written in ``text`` (UTF-8 if bytes); its catalogues are below ``folder``."""
    return _parse(text, folder)[0]


def _parse(
    text: str | bytes, folder: Path | None = None, known: tuple[Brief, Plan] | None = None
) -> tuple[Solution, Plan]:
    document = parse_document(text, "a solution file")
    plain_object = isinstance(document, dict)
    whole = resolve_paths(document, folder or Path()) if plain_object else document
    record, plan = check_document(whole, known)
    return _solution(record), plan


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
        "evaluations": solution.evaluations,
        "energies": dict(solution.energies),
        "pieces": [_piece_document(piece) for piece in solution.pieces],
        "patches": [patch._asdict() for patch in solution.patches],
        "left_out": [entry._asdict() for entry in solution.left_out],
        "terms": [value._asdict() for value in solution.terms],
        **_detail_document(solution),
        **({"clutter": solution.clutter} if solution.clutter != "none" else {}),
        "credits": authorship.document(
            authorship.credits_of_solution(solution, catalog_of(solution.brief.catalogs))
        ),
        "brief": solution.brief.model_dump(mode="json"),
    }


def _detail_document(solution: Solution) -> dict[str, Any]:
    """What only the brief's domain knows of its solutions."""
    domain = domain_of(solution.brief.domain)
    if solution.detail is None or not domain.has("detail_document"):
        return {}
    document: dict[str, Any] = domain.verb("detail_document")(solution.detail)
    return document


def of_document(document: object) -> Solution:
    """The solution a document tells; raises :class:`InputError` if it tells none."""
    return _solution(check_document(document)[0])


def _solution(record: SolutionRecord) -> Solution:
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
        detail=_detail(record),
        clutter=record.clutter,
    )


def _detail(record: SolutionRecord) -> Any:
    domain = domain_of(record.brief.domain)
    return domain.verb("detail_of")(record.detail) if domain.has("detail_of") else None


def brief_of(document: object) -> Brief:
    """The brief to solve again, with what is locked in the document as its domain keeps it."""
    solution = of_document(document)
    domain = domain_of(solution.brief.domain)
    keeps = domain.has("locked")
    brief: Brief = domain.verb("locked")(solution) if keeps else solution.brief
    return report_pieces(brief, [keeps and piece.fixed for piece in solution.pieces])


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
        **({"footprint": [list(corner) for corner in piece.footprint]} if piece.footprint else {}),
    }


def _piece(record: PieceRecord) -> Piece:
    footprint = read_footprint(record.footprint, *record.size[:2]) if record.footprint else ()
    made = {"pose": Pose(*record.pose), "size": Size(*record.size), "footprint": footprint}
    return Piece(**dict(record) | made)


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
