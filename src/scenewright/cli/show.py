"""What people read and machines read of answers; nothing here decides anything."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.text import Text

from scenewright.cli.tables import bare, table

if TYPE_CHECKING:
    from scenewright.check import Report
    from scenewright.solution import Solution

MOST_FINDINGS = 20
MOST_BOTTLENECKS = 5
MEASURED = "widths are twice the way from the tour's line to what is nearest; plans tell whole gaps"
LEAST_COST = 0.005
"""What is less rounds to nothing."""


def arranged(
    console: Console, outputs: Sequence[Path], solution: Solution, report: Report,
    was_interrupted: bool = False,
) -> None:  # fmt: skip
    """The table of rooms, what was left out, the referee's verdict and the files."""
    title = solution.brief.name + " (interrupted: best so far)" * was_interrupted
    table = bare(_space_word(solution), "energy", "placed", title=title)
    table.columns[1].justify = "right"
    for space, name in _rooms(solution).items():
        energy = solution.energies.get(space)
        told = f"{energy:.1f}" if energy is not None else ""
        table.add_row(Text(name), told, Text(_placed(solution, space)))
    console.print(table)
    _left_out(console, solution)
    console.print(Text(_work(solution)))
    checked(console, report)
    for path in outputs:
        console.print(Text(f"wrote {path}", "dim"))


def adjusted(
    console: Console, outputs: Sequence[Path], solution: Solution, report: Report,
    changed: Mapping[str, Sequence[str]],
) -> None:  # fmt: skip
    """What moved, came and went, what is left out, the referee's verdict and the files."""
    for how, pieces in changed.items():
        if pieces:
            console.print(Text(f"{how}: {', '.join(pieces)}"))
    _left_out(console, solution)
    console.print(Text(_work(solution)))
    checked(console, report)
    for path in outputs:
        console.print(Text(f"wrote {path}", "dim"))


def interrupted(outputs: Sequence[Path]) -> str:
    """What Ctrl-C led to."""
    return "interrupted: best so far " + ("written" if outputs else "told, no -o to write")


def _left_out(console: Console, solution: Solution) -> None:
    """What is missing (essential or asked for), and what was welcome but not placed."""
    for entry, count in Counter(solution.left_out).items():
        mark = "left out" if entry.required else "welcome but not placed"
        what = f"{count} × {entry.what}" if count > 1 else entry.what
        told = f"{mark}: {_where(solution, entry.space)}{what}: {entry.reason}"
        console.print(Text(told, "yellow" if entry.required else "dim"))


def checked(console: Console, report: Report) -> None:
    """The verdict, then every finding on a line."""
    console.print(Text(str(report), "green" if report.valid else "red"))
    for found in report.findings[:MOST_FINDINGS]:
        told = f"  {found.kind.replace('_', ' ')}: {found.message}"
        console.print(Text(told + (" (given)" if found.given else "")))
    if len(report.findings) > MOST_FINDINGS:
        console.print(Text(f"  and {len(report.findings) - MOST_FINDINGS} more"))
    for note in report.notes:
        console.print(Text(f"  note: {note.message}", "dim"))
    _wishes(console, report)
    shares = report.figures.get("navigable_share", {})
    if isinstance(shares, Mapping) and shares:
        levels = [f" on level {level}" if len(shares) > 1 else "" for level in shares]
        told = ", ".join(
            f"{share:.0%}{level}" for level, share in zip(levels, shares.values(), strict=True)
        )
        console.print(Text(f"floor one can walk on: {told}", "dim"))
    _halls(console, report.figures.get("halls", {}))


def _wishes(console: Console, report: Report) -> None:
    """Which wishes of the household came true, and why the others did not."""
    for told in report.figures.get("wishes", []):
        mark = "fulfilled" if told["fulfilled"] else f"not fulfilled, {told['why']}"
        console.print(Text(f"wish: {told['space']}: {told['wish']}: {mark}"))


def _outlets(console: Console, report: Report) -> None:
    """How many pieces that need an outlet have one within reach, and which have not."""
    found = report.figures.get("outlets", [])
    if found:
        near = sum(told["within"] for told in found)
        console.print(
            Text(f"outlets: {near} of {len(found)} leads, hoses and pipes are long enough")
        )
    for told in (told for told in found if not told["within"]):
        much = f"{told['metres']:.2f} m, within {told['reach']:g} m"
        console.print(Text(f"  {told['piece']}: {told['outlet']} at {much} wanted"))


def _halls(console: Console, halls: Mapping[str, Mapping[str, Any]]) -> None:
    """The figures of halls as two tables, then where their tours are narrow."""
    if not halls:
        return
    first = dict(list(halls.items())[:MOST_FINDINGS])
    table(console, [_measured(name, figures) for name, figures in first.items()], "halls")
    table(console, [_used(name, figures) for name, figures in first.items()], "on foot")
    if len(halls) > len(first):
        console.print(Text(f"  and {len(halls) - len(first)} more halls", "dim"))
    places = [
        (place["width"], f"  the tour of {name} is {place['message']}")
        for name, figures in first.items()
        for place in figures["tour"].get("bottlenecks", [])
    ]
    if places:
        console.print(Text(f"  {MEASURED}", "dim"))
    for _, told in sorted(places)[:MOST_BOTTLENECKS]:
        console.print(Text(told, "dim"))


def _measured(name: str, figures: Mapping[str, Any]) -> dict[str, Any]:
    keys = ("objects", "aesthetic", "uniformity", "circulation")
    return {"hall": name} | {key: figures[key] for key in keys}


def _used(name: str, figures: Mapping[str, Any]) -> dict[str, Any]:
    tour, distance = figures["tour"], figures["escape"]["distance"]
    least = min((passage["clear"] for passage in figures["passages"]), default=None)
    return {
        "hall": name,
        "floor used": f"{figures['floor_used']:.0%}",
        "walkable": f"{figures['walkable_share']:.0%}",
        "passages": None if least is None else f"{least:.2f} m",
        "tour": f"{tour['length']:.0f} m" if tour else None,
        "its width": f"{tour['least_width']:.2f} m" if tour else None,
        "seen": f"{tour['seen']:.0%}" if tour else None,
        "way out": None if distance is None else f"{distance:.0f} m",
    }


def explained(console: Console, solution: Solution) -> None:
    """Costs by room, item and term, dearest first; what the terms mean; what was left out."""
    why = bare(_space_word(solution), "item", "term", "value", "weight", "cost", title="why")
    for column in why.columns[3:]:
        column.justify = "right"
    rooms = _rooms(solution)
    felt = [term for term in solution.terms if term.cost >= LEAST_COST]
    for term in sorted(felt, key=lambda t: -t.cost):
        why.add_row(Text(rooms.get(term.space, term.space)), Text(term.item), Text(term.term),
                      f"{term.value:.4g}", f"{term.weight:g}", f"{term.cost:.2f}")  # fmt: skip
    console.print(why)
    domain = solution.brief.domain
    figures = [t for t in solution.terms if t.weight == 0.0] if domain == "site" else []
    if figures:
        rows = [{"site": rooms.get(t.space, t.space), "figure": t.term, "value": t.value}
                for t in figures]  # fmt: skip
        table(console, rows, "figures")
    if any(room.wishes or room.outlets for room in solution.brief.rooms):
        from scenewright.check import check

        report = check(solution)
        _wishes(console, report)
        _outlets(console, report)
    for name, meaning in _meanings({term.term for term in (*felt, *figures)}, domain).items():
        console.print(Text(f"{name}: {meaning}", "dim"))
    _left_out(console, solution)


def _meanings(names: set[str], domain: str) -> dict[str, str]:
    """One line for each term; of two forms the repaired one."""
    from scenewright.terms.hall_terms import HALL_TERMS
    from scenewright.terms.site_terms import SITE_AIMS, SITE_FIGURES, SITE_TERMS
    from scenewright.terms.table import TERMS

    ordered = sorted(TERMS, key=lambda row: row.form != "printed")
    meanings = {row.name: row.doc for row in HALL_TERMS}
    meanings |= {row.name: row.doc for row in ordered}
    if domain == "site":
        meanings = {row.name: row.doc for row in (*SITE_TERMS, *SITE_AIMS)} | SITE_FIGURES
    return {name: meanings[name] for name in meanings if name in names}


def explained_document(solution: Solution) -> dict[str, Any]:
    """Energies, terms and what was left out, as plain values."""
    from scenewright.check import check

    wished = any(room.wishes or room.outlets for room in solution.brief.rooms)
    figures = check(solution).figures if wished else {}
    return {
        "energies": dict(solution.energies),
        "terms": [term._asdict() for term in solution.terms],
        "left_out": [entry._asdict() for entry in solution.left_out],
        "wishes": figures.get("wishes", []),
        "outlets": figures.get("outlets", []),
    }


def arranged_document(
    source: str, outputs: Sequence[Path], solution: Solution, report: Report, code: int
) -> dict[str, Any]:
    """Everything ``arrange`` tells, as plain values; ``exit`` is the exit code."""
    rooms = [
        {"id": space, "name": name, "energy": solution.energies.get(space),
         "pieces": dict(_counts(solution, space))}
        for space, name in _rooms(solution).items()
    ]  # fmt: skip
    return {
        "input": source,
        "outputs": [str(path) for path in outputs],
        "exit": code,
        "preset": solution.preset,
        "solver": solution.solver,
        "seed": solution.seed,
        "version": solution.version,
        "brief_hash": solution.brief_hash,
        "seconds": float(solution.seconds),
        "evaluations": int(solution.evaluations),
        "rooms": rooms,
        "left_out": [entry._asdict() for entry in solution.left_out],
        "check": report.to_dict(),
    }


def _rooms(solution: Solution) -> dict[str, str]:
    """Names of the rooms or sites by id."""
    from scenewright.plan import space_names

    return space_names(solution.brief)


def _where(solution: Solution, space: str) -> str:
    name = _rooms(solution).get(space, space)
    return f"{name}: " if name else ""


def _counts(solution: Solution, space: str) -> Counter[str]:
    """Pieces by category, buildings by their model; stairs belong to the building."""
    from scenewright.scene import STAIRS

    return Counter(
        piece.function if piece.category == "building" else piece.category
        for piece in solution.pieces if piece.space == space and piece.function != STAIRS
    )  # fmt: skip


def _space_word(solution: Solution) -> str:
    return "site" if solution.brief.domain == "site" else "room"


def _placed(solution: Solution, space: str) -> str:
    """``sofa, 2 × armchair``, in the order placed."""
    counts = _counts(solution, space)
    words = ((count, category.replace("_", " ")) for category, count in counts.items())
    return ", ".join(f"{count} × {word}" if count > 1 else word for count, word in words)


def _work(solution: Solution) -> str:
    pieces, rooms = len(solution.pieces), len(solution.brief.rooms or solution.brief.sites)
    space = _space_word(solution)
    return (
        f"{pieces} piece{'s' * (pieces != 1)} in {rooms} {space}{'s' * (rooms != 1)}, "
        f"{solution.seconds:.2f} s, {solution.evaluations:,} layouts looked at "
        f"({solution.solver}, preset {solution.preset}, seed {solution.seed})"
    )
