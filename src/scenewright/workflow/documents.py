"""Results as plain values: what was arranged, what is explained, what became of a file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from scenewright.core.registry import domain_of

if TYPE_CHECKING:
    from scenewright.core.brief import Brief
    from scenewright.core.brief.input_report import InputReport
    from scenewright.core.plan import Plan
    from scenewright.core.report import Report
    from scenewright.core.solution import Solution


def explained_document(solution: Solution, plan: Plan | None = None) -> dict[str, Any]:
    """Energies, terms and what was not placed, as plain values."""
    from scenewright.domains import check, explain

    wished = any(room.wishes or room.outlets for room in solution.brief.rooms)
    figures = check(solution, plan=plan).figures if wished else {}
    told = explain(solution, plan=plan)
    return {
        "energies": dict(solution.energies),
        **({"floors": floors} if (floors := floors_of(solution)) else {}),
        **({"programme": told.decided} if told.decided else {}),
        **({"ledger": [row._asdict() for row in told.ledger]} if told.ledger else {}),
        "terms": [term._asdict() for term in solution.terms],
        "left_out": [entry._asdict() for entry in solution.left_out],
        "advice": [advice._asdict() for advice in told.left_out],
        "remarks": [remark._asdict() for remark in told.remarks],
        "wishes": figures.get("wishes", []),
        "outlets": figures.get("outlets", []),
        **input_document(solution.brief),
    }


def arranged_document(
    source: str, outputs: Sequence[Path], solution: Solution, plan: Plan, report: Report, code: int
) -> dict[str, Any]:
    """Everything ``arrange`` reports, as plain values; ``exit`` is the exit code."""
    rooms = [
        {
            "id": space,
            "name": name,
            "energy": solution.energies.get(space),
            "pieces": dict(count_pieces(solution, space)),
        }
        for space, name in plan.names.items()
    ]
    return {
        "input": source,
        "outputs": [str(path) for path in outputs],
        "losses": {str(path): _losses(solution, path) for path in outputs},
        "exit": code,
        "preset": solution.preset,
        "solver": solution.solver,
        "seed": solution.seed,
        "version": solution.version,
        "brief_hash": solution.brief_hash,
        "seconds": float(solution.seconds),
        "evaluations": int(solution.evaluations),
        **({"appearance": appearance} if (appearance := appearance_of(solution)) else {}),
        "rooms": rooms,
        "left_out": [entry._asdict() for entry in solution.left_out],
        "check": report.to_dict(),
        **input_document(solution.brief),
    }


def input_document(brief: Brief) -> dict[str, Any]:
    """The report of a brief's file under its key, as plain values."""
    from scenewright.core.brief.own_report import input_report_of

    return report_document(input_report_of(brief))


def report_document(report: InputReport) -> dict[str, Any]:
    """A report under its key, as plain values."""
    return {"input_report": report.model_dump(mode="json") | {"complete": report.complete}}


def appearance_of(solution: Solution) -> str:
    """How the scene looks, where its domain tells it."""
    domain = domain_of(solution.brief.domain)
    return str(domain.verb("appearance")(solution)) if domain.has("appearance") else ""


def floors_of(solution: Solution) -> dict[str, float]:
    """The least the energy of each space could be, where the domain knows it."""
    domain = domain_of(solution.brief.domain)
    return dict(domain.verb("floors")(solution)) if domain.has("floors") else {}


def count_pieces(solution: Solution, space: str) -> Counter[str]:
    """Pieces by category, buildings by their model; stairs belong to the building."""
    from scenewright.core.scene import STAIRS

    return Counter(
        piece.function if piece.category == "building" else piece.category
        for piece in solution.pieces
        if piece.space == space and piece.function != STAIRS
    )


def _losses(solution: Solution, path: Path) -> list[dict[str, Any]]:
    from scenewright.formats import losses

    return [loss._asdict() for loss in losses(solution, path)]
