"""What halls are held to once they stand, as tables of rows by theme.

No rows, as each needs more than the objects and the floor between them: audiences and banquets
(where all of them sit to the axis of their stage, which moves with them); columns among rows (their
pitch); gates with their rails (what these run into); ropes (the best of what they may guard); the
main exhibit (a place that depends on its zone); desks off their wall (which of several lines is
theirs); tills along the way out (either way round); seats to wait on (the side of staff, or near a
desk); the queue before lanes (a side that depends on the way out); empty floor and strips (found by
walking over all of it). Each of them is one function of :mod:`..retouch`.
"""

from __future__ import annotations

from scenewright.arranging.rows import Row
from scenewright.domains.hall.rules.exhibits import EXHIBITS
from scenewright.domains.hall.rules.seating import SEATING
from scenewright.domains.hall.rules.serving import SERVING

ROWS: tuple[Row, ...] = (*EXHIBITS, *SEATING, *SERVING)
"""All rows of halls."""
