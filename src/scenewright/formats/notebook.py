"""How values look in a notebook: words and tables as HTML, plans as SVG, pictures as PNG.

Drawings are embedded as images, so that their marks and styles touch nothing else on the page.
All names are escaped. A brief that cannot be planned shows the fault instead of a drawing.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Sequence
from html import escape
from io import BytesIO
from typing import TYPE_CHECKING

from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import InputReport
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution, unfurnished
from scenewright.domains import check, draw_plan, explain, plan_of
from scenewright.drawing.svg import write_svg

if TYPE_CHECKING:
    from scenewright.core.explanation import Explanation

WIDTH = 960
"""Pixels of a picture."""
MOST_ROWS = 40
"""Rows of a table; the rest is counted."""


def brief_html(brief: Brief) -> str:
    """The plan without furniture and its rooms with their areas in m²."""
    try:
        plan = plan_of(brief)
        drawn = write_svg(draw_plan(unfurnished(brief), plan))
    except InputError as error:
        return paragraph(repr(brief)) + paragraph(f"cannot be laid out: {error}")
    return paragraph(repr(brief)) + embed(drawn) + _spaces(brief, plan)


def brief_svg(brief: Brief) -> str | None:
    """The plan without furniture; ``None`` for a brief that cannot be planned."""
    try:
        return write_svg(draw_plan(unfurnished(brief)))
    except InputError:
        return None


def solution_html(solution: Solution) -> str:
    """The verdict, the plan, what breaks a rule, and what was not placed with its remedy."""
    plan = plan_of(solution.brief)
    report = check(solution, plan=plan)
    return "".join(
        [
            paragraph(repr(solution)),
            report_html(report),
            embed(write_svg(draw_plan(solution, plan))),
            _left_out(explain(solution, plan=plan)),
        ]
    )


def solution_svg(solution: Solution) -> str:
    """The plan to print."""
    return write_svg(draw_plan(solution))


def scene_png(scene: Scene) -> bytes:
    """The picture from above at an angle, with the models shipped; a model of the user's own is
    drawn as its box."""
    from PIL import Image

    from scenewright.catalog.assets import shipped
    from scenewright.formats.png import picture

    stream = BytesIO()
    Image.fromarray(picture(scene, shipped(), WIDTH)).save(stream, format="png")
    return stream.getvalue()


def report_html(report: Report) -> str:
    """The verdict and a table of findings and notes."""
    found = [(one.kind.replace("_", " "), one.message) for one in report.findings]
    found += [("note", note.message) for note in report.notes]
    return paragraph(str(report)) + table(("finding", ""), found)


def input_report_html(report: InputReport) -> str:
    """What became of the features of a file, by kind."""
    head = ", ".join(filter(None, [report.format, report.system, report.unit]))
    words = f"{head}{': ' if head else ''}{report.features:,} features"
    rows = [(row.kind, row.describe()) for row in report.rows]
    rows += [("floor", text) for text in [report.describe_floor()] if text]
    return paragraph(words) + table(("feature", "what became of it"), rows)


LEDGER = ("need", "owed", "stands", "where", "why not")
"""The heads of the table of what is needed."""


def explanation_html(explanation: Explanation) -> str:
    """What was decided, what was not placed, and what the layout gives up for it."""
    given_up = [
        (remark.space, ", ".join(remark.items), remark.text, remark.remedy)
        for remark in explanation.remarks
    ]
    return "".join(
        [
            paragraph(explanation.decided) if explanation.decided else "",
            table(LEDGER, (tuple(row.tell().values()) for row in explanation.ledger)),
            _left_out(explanation),
            table(("where", "what", "compromise", "what helps"), given_up),
        ]
    )


def paragraph(text: str) -> str:
    """A paragraph of plain text.

    >>> paragraph("A & B")
    '<p>A &amp; B</p>'
    """
    return f"<p>{escape(text)}</p>"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table of plain texts, empty without rows; what exceeds :data:`MOST_ROWS` is counted.

    >>> table(("room",), [("Bath",)])
    '<table><tr><th>room</th></tr><tr><td>Bath</td></tr></table>'
    """
    listed = list(rows)
    if not listed:
        return ""
    lines = [_row("th", head), *(_row("td", row) for row in listed[:MOST_ROWS])]
    spare = len(listed) - MOST_ROWS
    return f"<table>{''.join(lines)}</table>" + paragraph(f"and {spare} more") * (spare > 0)


def embed(svg: str) -> str:
    """A drawing as an image that is as wide as the page at most."""
    data = b64encode(svg.encode()).decode()
    style = "max-width:100%;height:auto;background:#fff"
    return f'<img alt="plan" style="{style}" src="data:image/svg+xml;base64,{data}">'


def _row(cell: str, texts: Sequence[str]) -> str:
    return f"<tr>{''.join(f'<{cell}>{escape(text)}</{cell}>' for text in texts)}</tr>"


def _spaces(brief: Brief, plan: Plan) -> str:
    """The rooms or halls of a plan with their areas."""
    from shapely import Polygon

    if not brief.rooms:
        return ""
    areas = [Polygon(space.outline, space.holes).area for space in plan.spaces]
    rows = [
        (plan.names[space.id], ", ".join(space.functions).replace("_", " "), f"{area:.1f} m²")
        for space, area in zip(plan.spaces, areas, strict=True)
    ]
    return table(("room", "use", "floor"), [*rows, ("together", "", f"{sum(areas):.1f} m²")])


def _left_out(explanation: Explanation) -> str:
    """The things not placed: why, and what helps."""
    rows = [
        (advice.space, advice.what, advice.reason, advice.remedy) for advice in explanation.left_out
    ]
    return table(("where", "not placed", "why", "what helps"), rows)
