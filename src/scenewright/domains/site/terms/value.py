"""How good a site looks by the paper's own measure, F_eva = ω1 R + ω2 M + ω3 C + ω4 H, (22).

Zhang, Yang 2023 name R use of space, M mesh visual quality, C texture of facades (tone, symmetry,
preference) and H height, without formulas. Here each is a share in [0, 1], higher is better, and
what is left out never pays:

* R = Σ (w + s)(d + s) / area of the blocks, s the spacing, at most 1: (1) without heights;
* M = Σ τ a / Σ a, a = 2 (w + d) h the facades; the sum below runs over all asked for;
* C = mean of symmetry, of 1 - tone difference to each neighbour, and of preference if known,
  times the share of buildings that stand;
* H = Σ w d h / Σ w d h, the volume that stands of all asked for.

R and H of a layout that holds all that is asked for are constants, and so is M as a sum over all
facades: it counts those nobody sees. In the repaired form M is what walkers on the ways see, the
mean of V over eyes as a share of :data:`FULL` (:mod:`scenewright.geometry.walker`). Where the brief
gives a library and a target, models are chosen while solving, and R = 1 - abs(covered / target - 1)
of the ground, H the same of floor area.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.terms.measure import SiteState
from scenewright.geometry.boxes import read_frame
from scenewright.geometry.buckets import column_of, row_of
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]

OMEGA = (0.2, 0.5, 0.1, 0.2)
"""ω1 to ω4: visual quality leads, texture counts little, as the paper found best."""
FULL = 0.3
"""Visual quality V of a rich street, at which M is 1."""
NEAR = 20.0
"""How far apart the circles round neighbours may be, in metres."""


class Worth(NamedTuple):
    """What :func:`value_parts` reads: ``facts`` (n, 8) facade area, volume, quality, tone,
    symmetry, preference (-1: unknown), ground covered and floor area; ``whole`` (6,) area of the
    blocks, all facades, all volume, half the spacing, and the targets of ground covered and floor
    area (0: all that is asked for is to stand)."""

    facts: Floats
    whole: Floats


def make_worth(problem: SiteProblem, liked: Floats | None = None) -> Worth:
    """The facts of a problem's buildings; ``liked`` (n,) in [0, 1] is a person's preference."""
    made = problem.buildings
    w, d, h = made.sizes.T
    facades, volume = 2.0 * (w + d) * h, w * d * h
    preference = np.full(len(w), -1.0) if liked is None else np.asarray(liked, float)
    looks = (made.quality, made.tone, made.symmetry, preference)
    facts = np.column_stack([facades, volume, *looks, w * d, w * d * made.floors])
    area = float(problem.ground.block_areas.sum())
    whole = np.array(
        [area, facades.sum(), volume.sum(), 0.5 * problem.spacing, *problem.target], float
    )
    return Worth(np.ascontiguousarray(facts), np.maximum(whole, [1e-9, 1e-9, 1e-9, 0, 0, 0]))


@inlined
def tone_difference(s: SiteState, facts: Floats, i: int) -> float:
    """Mean difference of tone, column 3 of ``facts`` (n, 8), between building ``i`` and its
    neighbours; 0 without any."""
    b, a = s.buckets, read_frame(s.frames, i)
    far = a[6] + NEAR + b.reach
    left, right = column_of(b, a[0] - far), column_of(b, a[0] + far)
    low, high = row_of(b, a[1] - far), row_of(b, a[1] + far)
    across, total, count = right - left + 1, 0.0, 0
    for k in range(across * (high - low + 1) + 1):
        place = (low + k // across) * b.columns + left + k % across
        if k == across * (high - low + 1):
            place = b.columns * b.rows
        j = b.heads[place]
        while j >= 0:
            dx, dy = s.frames[j, 0] - a[0], s.frames[j, 1] - a[1]
            reach = a[6] + s.frames[j, 6] + NEAR
            if j != i and dx * dx + dy * dy <= reach * reach:
                total, count = total + abs(facts[i, 3] - facts[j, 3]), count + 1
            j = b.after[j]
    return total / count if count > 0 else 0.0


@compiled
def value_parts(s: SiteState, worth: Worth, out: Floats) -> None:
    """Write R, M, C and H of the layout a state holds to ``out`` (4,)."""
    facts, whole, n = worth.facts, worth.whole, s.frames.shape[0]
    used, shown, texture, volume, stand = 0.0, 0.0, 0.0, 0.0, 0
    covered, floors, facades = 0.0, 0.0, 0.0
    for i in range(n):
        frame = read_frame(s.frames, i)
        if frame[4] > 0.0:
            used += 4.0 * (frame[4] + whole[3]) * (frame[5] + whole[3])
            shown += facts[i, 0] * facts[i, 2]
            volume += facts[i, 1]
            covered, floors = covered + facts[i, 6], floors + facts[i, 7]
            facades, stand = facades + facts[i, 0], stand + 1
            own = facts[i, 4] + 1.0 - tone_difference(s, facts, i)
            texture += (own + facts[i, 5]) / 3.0 if facts[i, 5] >= 0.0 else 0.5 * own
    out[0], out[1] = min(used / whole[0], 1.0), min(shown / whole[1], 1.0)
    out[2], out[3] = texture / max(n, 1), min(volume / whole[2], 1.0)
    if whole[4] > 0.0:
        out[0] = max(1.0 - abs(covered / whole[4] - 1.0), 0.0)
        out[1] = shown / max(facades, 1e-9) * min(covered / whole[4], 1.0)
        out[2] = texture / max(stand, 1) * min(covered / whole[4], 1.0)
        out[3] = max(1.0 - abs(floors / whole[5] - 1.0), 0.0)
