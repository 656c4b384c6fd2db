"""Classes of groups of halls that rows are about, by the names of :mod:`..retouch.row_groups`."""

from __future__ import annotations

from scenewright.arranging.rows import COLUMNS, ENTRANCES, WALLS, Class

EXHIBIT = Class("an exhibit or table", frozenset(("exhibit",)))
LOUNGE_SEAT = Class("a lounge seat", frozenset(("lounge seat",)))
LOUNGE_ROW = Class("a row of lounge seats", frozenset(("row of lounge seats",)), floor=True)
STAND = Class("a stand", frozenset(("stand",)), floor=True)
TWO_FACED = Class("a row with two faces", frozenset(("rows with two faces",)), floor=True)
OTHERS = Class("something", but=frozenset(("low table",)))
AT_COLUMNS = Class("a column", parts=COLUMNS)
AT_ENTRANCES = Class("the entrance", parts=ENTRANCES)
BY_WALLS = Class("the wall", parts=WALLS)
