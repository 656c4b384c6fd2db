"""Reports for people and machines; nothing here decides anything."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from scenewright.cli.show_input import print_input, print_warnings
from scenewright.cli.tables import print_line, table
from scenewright.core.registry import domain_of
from scenewright.text import quantity
from scenewright.workflow.documents import appearance_of, count_pieces, floors_of

if TYPE_CHECKING:
    from scenewright.core.brief import Brief
    from scenewright.core.explanation import Advice
    from scenewright.core.plan import Plan
    from scenewright.core.report import Finding, Report
    from scenewright.core.solution import Solution

MOST_FINDINGS = 20
MOST_BOTTLENECKS = 5
MEASURED = (
    "widths are twice the distance from the tour to the nearest object; plans show whole gaps"
)
BETTER = "aesthetic: more is better; uniformity, circulation and excess: less is better"
SCALE = ("scale",)
"""What notes are about that stand on the standard error already."""
LEAST_COST = 0.005
"""Costs below this round to 0.00."""


def print_arranged(
    console: Console,
    outputs: Sequence[Path],
    solution: Solution,
    plan: Plan,
    report: Report,
    was_interrupted: bool = False,
) -> None:
    """The table of rooms, what was not placed, the referee's verdict and the files."""
    title = solution.brief.name + " (interrupted: best so far)" * was_interrupted
    rows = [
        {_space_word(solution): name, "placed": _format_pieces(solution, space)}
        for space, name in plan.names.items()
    ]
    table(console, rows, title, whole=(_space_word(solution),))
    _left_out(console, solution, plan.names)
    print_line(console, _work(solution, len(plan.names)))
    if appearance := appearance_of(solution):
        print_line(console, appearance, "dim")
    print_report(console, report, SCALE)
    print_warnings(console, solution.brief.input_report)
    for path in outputs:
        print_line(console, f"wrote {path}", "dim", whole=True)


def print_adjusted(
    console: Console,
    outputs: Sequence[Path],
    solution: Solution,
    plan: Plan,
    report: Report,
    changes: Sequence[str],
) -> None:
    """Changes with their reasons, what was not placed, the referee's verdict, the files."""
    for line in changes:
        print_line(console, line)
    _left_out(console, solution, plan.names)
    print_line(console, _work(solution, len(plan.names)))
    print_report(console, report)
    print_warnings(console, solution.brief.input_report)
    for path in outputs:
        print_line(console, f"wrote {path}", "dim", whole=True)


def describe_interruption(outputs: Sequence[Path]) -> str:
    """What Ctrl-C led to."""
    return "interrupted: best so far " + (
        "written" if outputs else "shown above (no -o, so nothing was written)"
    )


def _left_out(console: Console, solution: Solution, names: Mapping[str, str]) -> None:
    """What was not placed: what is essential or asked for with what helps, then what is optional
    with the reason alone."""
    from scenewright.domains import advise

    advice = advise(solution, names)
    _advice(console, [one if one.required else one._replace(remedy="") for one in advice])


def print_scale(console: Console, file: Path, brief: Brief, plan: Plan) -> None:
    """A line if the plan in a file seems drawn too small or too large."""
    from scenewright.workflow.request import note_scale

    for notice in note_scale(str(file), brief, plan, domain_of(brief.domain)):
        print_line(console, notice.text, "dim")


def print_report(console: Console, report: Report, known: Collection[str] = ()) -> None:
    """The verdict, then every finding on a line, and the notes but those on what is ``known``."""
    print_line(console, str(report), "green" if report.valid else "red")
    for found in report.findings[:MOST_FINDINGS]:
        text = f"  {found.kind.replace('_', ' ')}: {found.message}"
        print_line(console, text + _excuse(found))
    if len(report.findings) > MOST_FINDINGS:
        print_line(console, f"  and {len(report.findings) - MOST_FINDINGS} more")
    for note in (note for note in report.notes if note.missing not in known or note.space):
        print_line(console, f"  note: {note.message}", "dim")
    _wishes(console, report)
    shares = report.figures.get("navigable_share", {})
    if isinstance(shares, Mapping) and shares:
        levels = [f" on level {level}" if len(shares) > 1 else "" for level in shares]
        text = ", ".join(
            f"{share:.0%}{level}" for level, share in zip(levels, shares.values(), strict=True)
        )
        print_line(console, f"walkable floor: {text}", "dim")
    _usability(console, report.figures.get("usability", {}))
    _halls(console, report.figures.get("halls", {}))


def _excuse(found: Finding) -> str:
    """Why the answer is not to blame for a finding, if it is not."""
    if found.accepted:
        return f" (accepted: {found.accepted})"
    return " (given)" if found.given else " (locked by you)" if found.locked else ""


def _usability(console: Console, figures: Mapping[str, Any]) -> None:
    """The figures of the occupancy grid on a line, those there are."""
    words = {
        "wfr": "{:.0%} of the floor free",
        "nav": "{:.0%} of that in one part",
        "acc": "{:.0%} of sides to use clear",
        "mcw": "narrowest way {:.2f} m",
    }
    parts = [words[key].format(figures[key]) for key in words if figures.get(key) is not None]
    if parts:
        print_line(console, f"usability: {', '.join(parts)}", "dim")


def _wishes(console: Console, report: Report) -> None:
    """Which wishes are met, and why the others are not."""
    for wish in report.figures.get("wishes", []):
        mark = "met" if wish["fulfilled"] else f"not met: {wish['why']}"
        print_line(console, f"wish: {wish['space']}: {wish['wish']}: {mark}")


def _outlets(console: Console, report: Report) -> None:
    """How many pieces that need an outlet have one within reach, and which have not."""
    found = report.figures.get("outlets", [])
    if found:
        near = sum(lead["within"] for lead in found)
        text = f"outlets: {near} of {len(found)} leads, hoses and pipes reach"
        print_line(console, text)
    for lead in (lead for lead in found if not lead["within"]):
        much = f"{lead['metres']:.2f} m away, {lead['reach']:g} m at most"
        print_line(console, f"  {lead['piece']}: {lead['outlet']} outlet {much}")


def _halls(console: Console, halls: Mapping[str, Mapping[str, Any]]) -> None:
    """The figures of halls as two tables, then where their tours are narrow."""
    if not halls:
        return
    first = dict(list(halls.items())[:MOST_FINDINGS])
    table(console, [_format_measures(name, figures) for name, figures in first.items()], "halls")
    print_line(console, BETTER, "dim")
    table(console, [_format_usage(name, figures) for name, figures in first.items()], "on foot")
    if len(halls) > len(first):
        print_line(console, f"  and {len(halls) - len(first)} more halls", "dim")
    places = [
        (place["width"], f"  the tour of {name} is {place['message']}")
        for name, figures in first.items()
        for place in figures["tour"].get("bottlenecks", [])
    ]
    if places:
        print_line(console, f"  {MEASURED}", "dim")
    for _, line in sorted(places)[:MOST_BOTTLENECKS]:
        print_line(console, line, "dim")


def _format_measures(name: str, figures: Mapping[str, Any]) -> dict[str, Any]:
    keys = ("objects", "aesthetic", "uniformity", "circulation")
    return {"hall": name} | {key: figures[key] for key in keys} | {"excess": figures.get("excess")}


def _format_usage(name: str, figures: Mapping[str, Any]) -> dict[str, Any]:
    tour, distance = figures["tour"], figures["escape"]["distance"]
    least = min((passage["clear"] for passage in figures["passages"]), default=None)
    return {
        "hall": name,
        "floor used": f"{figures['floor_used']:.0%}",
        "walkable": f"{figures['walkable_share']:.0%}",
        "least passage": None if least is None else f"{least:.2f} m",
        "tour length": f"{tour['length']:.0f} m" if tour else None,
        "least on tour": f"{tour['least_width']:.2f} m" if tour else None,
        "seen on tour": f"{tour['seen']:.0%}" if tour else None,
        "farthest way out": None if distance is None else f"{distance:.0f} m",
    }


def print_explanation(
    console: Console, solution: Solution, plan: Plan | None = None, with_terms: bool = False
) -> None:
    """What was decided, what was not placed and what helps, compromises, wishes and outlets; with
    the costs of all terms only ``with_terms``."""
    from scenewright.core.explanation import describe_remarks
    from scenewright.domains import check, explain, plan_of

    plan = plan or plan_of(solution.brief)
    told = explain(solution, plan=plan)
    print_line(console, told.decided)
    if told.ledger:
        rows = [row.tell() for row in told.ledger]
        table(console, rows, "what the household needs", ("owed", "stands"), ("owed", "stands"))
    _advice(console, told.left_out)
    if told.remarks:
        print_line(console, "what the layout gives up, by what helps", "bold")
    for line in describe_remarks(told.remarks):
        print_line(console, line)
    if not (told.left_out or told.remarks):
        print_line(console, "everything is placed, and nothing is given up for it")
    if any(room.wishes or room.outlets for room in solution.brief.rooms):
        report = check(solution, plan=plan)
        _wishes(console, report)
        _outlets(console, report)
    if with_terms:
        print_terms(console, solution, plan.names)
    print_input(console, solution.brief.input_report)
    print_warnings(console, solution.brief.input_report)


def _advice(console: Console, left_out: Sequence[Advice]) -> None:
    from scenewright.core.explanation import describe_advice

    for advice in left_out:
        print_line(console, describe_advice(advice), "yellow" if advice.required else "dim")


def print_terms(console: Console, solution: Solution, rooms: Mapping[str, str]) -> None:
    """Costs by room, item and term, highest first, then figures and what the terms mean."""
    domain, word = domain_of(solution.brief.domain), _space_word(solution)
    labels = domain.table("labels")
    felt = [term for term in solution.terms if term.cost >= LEAST_COST]
    why = [
        {
            word: rooms.get(term.space, term.space),
            "item": " & ".join(labels.get(name, name) for name in term.item.split(" & ")),
            "term": term.term,
            "value": f"{term.value:.4g}",
            "weight": f"{term.weight:g}",
            "cost": f"{term.cost:.2f}",
        }
        for term in sorted(felt, key=lambda t: -t.cost)
    ]
    if why:
        table(console, why, "terms", right=("value", "weight", "cost"))
    else:
        print_line(console, "no term costs anything")
    _print_excess(console, solution, rooms)
    figures = [t for t in solution.terms if t.weight == 0.0]
    if figures:
        rows = [
            {word: rooms.get(t.space, t.space), "figure": t.term, "value": t.value} for t in figures
        ]
        table(console, rows, "figures")
    names = {term.term for term in (*felt, *figures)}
    for name, meaning in _meanings(names, domain.name).items():
        print_line(console, f"{name}: {meaning}", "dim")


def _print_excess(console: Console, solution: Solution, rooms: Mapping[str, str]) -> None:
    """The energy of each space beside the least it could be."""
    for space, floor in floors_of(solution).items():
        if space not in solution.energies:
            continue
        energy = solution.energies[space]
        text = f"{energy:.1f}, {energy - floor:.1f} above its floor of {floor:.1f}"
        print_line(console, f"energy of {rooms.get(space, space)}: {text}")


def _meanings(names: set[str], domain: str) -> dict[str, str]:
    """One line for each term."""
    meanings = domain_of(domain).table("meanings")
    return {name: meanings[name] for name in meanings if name in names}


def _space_word(solution: Solution) -> str:
    noun: str = domain_of(solution.brief.domain).noun
    return noun


def _format_pieces(solution: Solution, space: str) -> str:
    """``sofa, 2 × armchair``, in the order placed."""
    counts = count_pieces(solution, space)
    words = ((count, category.replace("_", " ")) for category, count in counts.items())
    return ", ".join(f"{count} × {word}" if count > 1 else word for count, word in words)


def _work(solution: Solution, rooms: int) -> str:
    pieces = len(solution.pieces)
    space = _space_word(solution)
    return (
        f"{quantity(pieces, 'piece')} in {quantity(rooms, space)}, "
        f"{solution.seconds:.2f} s, {solution.evaluations:,} layouts evaluated "
        f"({solution.solver}, preset {solution.preset}, seed {solution.seed})"
    )
