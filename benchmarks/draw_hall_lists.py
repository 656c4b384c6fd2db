"""Draws ``docs/hall-lists.png``: one outline laid out for several requirement lists.

``python -m benchmarks.draw_hall_lists [file]`` (Cao, Cheng and Zhang 2024, Fig. 5). Above one list
laid out with three seeds, below the other lists (:mod:`.papers_halls_lists`), seed 0 each.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from PIL import Image, ImageDraw, ImageFont

from benchmarks.papers_halls_lists import OWN, lay_out, lists
from scenewright.building.plan import spaces
from scenewright.core.layout import corners
from scenewright.core.solution import Solution

Frame = tuple[float, float, float]
SEEDS = 3
FINE, PANEL, TOP, GAP = 3, 560, 44, 18
"""Drawn so many times larger, then reduced; dots of a panel, of its heading, between two."""
INK, GREY, WALL, COLUMN = (38, 44, 52), (110, 118, 128), (44, 50, 58), (70, 78, 88)
DOOR = (214, 140, 40)
ZONES = ((233, 240, 246), (246, 241, 230), (235, 243, 234), (244, 236, 242))
GROUPS = (
    (62, 98, 138),
    (196, 112, 52),
    (74, 128, 88),
    (150, 72, 100),
    (112, 96, 164),
    (128, 118, 62),
    (54, 130, 138),
    (178, 82, 70),
    (96, 104, 116),
)


def main(path: Path) -> None:
    """Lay out, draw and write the picture."""
    others = [name for name in lists() if name != OWN]
    first = [panel(lay_out(OWN, seed), f"{OWN}, seed {seed}") for seed in range(SEEDS)]
    rows = [first, [panel(lay_out(name, 0), name) for name in others]]
    height = first[0].height + GAP
    width = max(len(row) for row in rows) * (PANEL + GAP) + GAP
    sheet = Image.new("RGB", (width, len(rows) * height + GAP), "white")
    for number, row in enumerate(rows):
        for k, image in enumerate(row):
            sheet.paste(image, (GAP + k * (PANEL + GAP), GAP + number * height))
    sheet.save(path, optimize=True)


def panel(solution: Solution, title: str) -> Image.Image:
    """One plan with its heading: zones, columns, objects by group, walls."""
    (space,) = spaces(solution.brief)
    x0, y0, x1, y1 = shapely.Polygon(space.outline).bounds
    scale = (PANEL - 8) / (x1 - x0)
    height = round((y1 - y0) * scale) + TOP + 8
    image = Image.new("RGB", (PANEL * FINE, height * FINE), "white")
    draw, frame = ImageDraw.Draw(image), (x0, y1, scale)
    draw.text((4 * FINE, 4 * FINE), title, INK, ImageFont.load_default(20 * FINE))
    held = f"{sum(p.category != 'partition' for p in solution.pieces)} objects"
    place = (PANEL - 6) * FINE, 8 * FINE
    draw.text(place, held, GREY, ImageFont.load_default(16 * FINE), anchor="ra")
    _floor(draw, frame, solution, space)
    _objects(draw, frame, solution)
    return image.resize((PANEL, height), Image.Resampling.LANCZOS)


def _floor(draw: Any, frame: Frame, solution: Solution, space: Any) -> None:
    assert solution.detail is not None
    for k, zone in enumerate(solution.detail.layout.zones):
        draw.polygon(_at(frame, zone.outline), fill=ZONES[k % len(ZONES)])
    for hole in space.holes:
        draw.polygon(_at(frame, hole), fill=COLUMN)
    ring = _at(frame, [*space.outline, space.outline[0]])
    draw.line(ring, fill=WALL, width=3 * FINE, joint="curve")
    for door in space.openings:
        if door.kind != "window":
            x, y, u, v = door.x, door.y, door.ux * door.width / 2, door.uy * door.width / 2
            draw.line(_at(frame, [(x - u, y - v), (x + u, y + v)]), fill=DOOR, width=5 * FINE)


def _objects(draw: Any, frame: Frame, solution: Solution) -> None:
    assert solution.detail is not None
    groups = solution.detail.layout.groups
    demands = list(dict.fromkeys(group.demand for group in groups))
    colours = {
        name: GROUPS[demands.index(group.demand) % len(GROUPS)]
        for group in groups
        for name in group.objects
    }
    for piece in solution.pieces:
        x, y, _, heading = piece.pose
        box = corners(np.array([[x, y, heading, piece.size.width, piece.size.depth]]))[0]
        colour = WALL if piece.category == "partition" else colours.get(piece.id, GREY)
        draw.polygon(_at(frame, box), fill=colour)


def _at(frame: Frame, points: Any) -> list[tuple[float, float]]:
    """Metres to dots: y goes down, the hall stands below its heading."""
    x0, y1, scale = frame
    return [
        (FINE * (4 + scale * (float(x) - x0)), FINE * (TOP + scale * (y1 - float(y))))
        for x, y in points
    ]


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/hall-lists.png"))
