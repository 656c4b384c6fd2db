"""Two plans of one home side by side on one sheet: the designer's and ours."""

from __future__ import annotations

import re
from dataclasses import replace

from benchmarks.designer_rooms import Home
from scenewright.catalog.assets import shipped
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.drawing import rooms
from scenewright.drawing.svg import write_svg

_HEAD = re.compile(r'<svg [^>]*?width="([\d.]+)mm" height="([\d.]+)mm"', re.DOTALL)
_NAMES = re.compile(r'(\bid="|href="#|url\(#)')


def sheet(home: Home) -> str:
    """The SVG text of a home's two plans."""
    plans = [
        draw_plan(home.designer, f"{home.name} · designer", "a-"),
        draw_plan(home.ours, f"{home.name} · Scenewright", "b-"),
    ]
    return place_side_by_side(plans, 2)


def place_side_by_side(plans: list[tuple[str, float, float]], columns: int) -> str:
    """One SVG text of plans with their widths and heights in millimetres, row by row."""
    rows = [plans[k : k + columns] for k in range(0, len(plans), columns)]
    wide = max(sum(w for _, w, _ in row) for row in rows)
    body, high = [], 0.0
    for row in rows:
        left, tall = 0.0, max(h for _, _, h in row)
        for text, width, height in row:
            down = high + (tall - height) / 2
            body.append(f'<g transform="translate({left:g} {down:g})">{text}</g>')
            left += width
        high += tall
    inside = "\n".join(body)
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" '
        'xmlns:xlink="http://www.w3.org/1999/xlink" version="1.1" '
        f'width="{wide:g}mm" height="{high:g}mm" viewBox="0 0 {wide:g} {high:g}">\n'
        f"{inside}\n</svg>\n"
    )


def draw_plan(solution: Solution, name: str, prefix: str) -> tuple[str, float, float]:
    """A plan to stand within another, names of its own, and its width and height in millimetres."""
    text = write_svg(rooms.plan(replace(scene_of(solution), name=name), shipped()))
    text = text[text.index("<svg ") :]
    found = _HEAD.search(text)
    if found is None:
        raise AssertionError("a plan tells its size in millimetres")
    width, height = found.groups()
    text = text.replace(
        f'width="{width}mm" height="{height}mm"', f'width="{width}" height="{height}"', 1
    )
    return _NAMES.sub(rf"\g<1>{prefix}", text), float(width), float(height)
