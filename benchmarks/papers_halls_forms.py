"""E_s and E_u of Cao, Cheng and Zhang (2024, eqs. 1 and 3) as printed beside the repaired forms."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.hall_measure import posed
from benchmarks.papers_halls_measures import compared, make_record
from scenewright.domains.hall.patterns import CHAIN, GRID
from scenewright.domains.hall.settings import HallSettings
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.terms.place import unfold
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.table import FILL, SPACE
from scenewright.domains.hall.terms.whole import measure_frames
from scenewright.engine.draws import streams

Row = dict[str, Any]
SPREADS = (0.0, 0.3, 0.6, 0.9, 1.2)
"""Metres by which the gaps of all rows are widened."""


def printed_forms(case: str) -> list[Row]:
    """E_s and E_u, repaired (ours) and as printed (baseline), of one first layout as the gaps of
    all its rows are spread out: the printed E_u stays the same; E_s is divided by β in both."""
    ready, found = posed(compared(case), 0, printed=True).fitted, []
    for metres in SPREADS:
        kept = spread_rows(ready.start, metres)
        for term, name in ((SPACE, "E_s"), (FILL, "E_u")):
            costs = []
            for printed in (False, True):
                problem = ready.problem._replace(settings=HallSettings(printed=printed))
                chain = begin_chain(problem, ready.start, streams(0, 1)[0])
                chain.s.layers[:] = kept.layers
                for unit in range(len(chain.p.spans)):
                    unfold(chain.p, chain.s, chain.work, unit)
                measure_frames(chain.p, chain.s, chain.work, False)
                costs.append(float(chain.s.costs[term].sum()))
            record = make_record(case, f"{name}, gaps {metres:+.1f} m", "1", *costs)
            found.append(record | {"baseline_name": "as printed", "runs": 1})
    return found


def spread_rows(start: Kept, metres: float) -> Kept:
    """A layout whose rows have wider gaps, along and across."""
    layers = start.layers.copy()
    rows = np.isin(layers[:, 3], (CHAIN, GRID))
    layers[rows, 1:3] += metres
    return start._replace(layers=layers)
