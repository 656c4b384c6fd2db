"""Hours of sun as a rule: a site is laid out wider behind buildings until all have them.

What still stands in the dark then is left out, the darkest first.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from scenewright.domains.site.problem import Floats, Ints, SiteProblem
from scenewright.domains.site.solvers.blocks.distances import noon
from scenewright.domains.site.solvers.outcome import SiteFound, SiteLayout
from scenewright.geometry.sun import sun_hours, sun_path

WIDER = (0.6, 0.9, 1.2, 1.5, 1.8, 2.2)
"""Heights of a building kept free behind it, tried one after another."""
PLACES, SLACK = 12, 0.15
"""Places looked at along a side, and hours by which they may be off."""


def solve_in_sun(
    run: Callable[[SiteProblem], SiteFound], problem: SiteProblem, hours: float
) -> tuple[SiteFound, dict[int, str]]:
    """The answer of ``run`` in which most buildings have ``hours`` hours of sun, without the
    others; and by the number of each of these why it is left out."""
    tried = [problem.sun_spacing, *(t for t in WIDER if t > problem.sun_spacing)]
    best: SiteFound | None = None
    most, done = -1, 0
    for times in tried:
        found = run(problem._replace(sun_spacing=times))
        layout, done = found.layouts[0], done + found.evaluations
        sunny = int(layout.present.sum()) - len(find_dark(problem, layout, hours))
        if sunny > most:
            best, most = found, sunny
        if sunny == len(layout.present):
            break
    assert best is not None
    layout, lost = remove_dark(problem, best.layouts[0], hours)
    return best._replace(layouts=(layout,), evaluations=done), lost


def find_dark(problem: SiteProblem, found: SiteLayout, hours: float) -> Ints:
    """Numbers of the buildings with fewer hours of sun, the darkest first."""
    here = np.flatnonzero(found.present)
    got = measure_sun(problem, found.boxes[here], problem.buildings.sizes[here, 2])
    order = np.argsort(got, kind="stable")
    dark: Ints = here[order[got[order] < hours + SLACK]]
    return dark


def measure_sun(problem: SiteProblem, boxes: Floats, heights: Floats) -> Floats:
    """Hours of sun (n,) on the side of each box (n, 5) that looks most towards the noon sun."""
    path = sun_path(problem.latitude, problem.day)
    marks = problem.ground.landmarks, problem.ground.landmark_heights
    every = sun_hours(boxes, heights, path, marks, places=PLACES)
    turns = boxes[:, 2:3] + math.pi / 2 * np.arange(4)
    sunny = np.argmax(np.round(np.cos(turns - noon(problem)), 6), axis=1)
    return every[np.arange(len(boxes)), sunny]


def remove_dark(
    problem: SiteProblem, found: SiteLayout, hours: float
) -> tuple[SiteLayout, dict[int, str]]:
    """A layout without buildings that lack sun: the darkest goes, and the others are looked at
    again."""
    lost: dict[int, str] = {}
    while len(dark := find_dark(problem, found, hours)):
        present = found.present.copy()
        present[dark[0]] = False
        lost[int(dark[0])] = f"less than {hours:g} h of sun wherever there is room for it"
        found = found._replace(present=present, score={})
    return found, lost
