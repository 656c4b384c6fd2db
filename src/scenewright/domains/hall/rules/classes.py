"""Classes of groups of halls that rows are about, by the names of :mod:`..retouch.row_groups`."""

from __future__ import annotations

from scenewright.arranging.rows import COLUMNS, DOORS, ENTRANCES, EXITS, WALLS, WAY_IN, Class

EXHIBIT = Class("an exhibit or table", frozenset(("exhibit",)))
LOUNGE_SEAT = Class("a lounge seat", frozenset(("lounge seat",)))
LOUNGE_ROW = Class("a row of lounge seats", frozenset(("row of lounge seats",)), floor=True)
STAND = Class("a stand", frozenset(("stand",)), floor=True)
TWO_FACED = Class("a row with two faces", frozenset(("rows with two faces",)), floor=True)
OTHERS = Class("something", but=frozenset(("low table",)))
AT_COLUMNS = Class("a column", parts=COLUMNS)
AT_DOORS = Class("a door one comes in by", parts=DOORS)
AT_ENTRANCES = Class("the entrance", parts=ENTRANCES)
BY_WALLS = Class("the wall", parts=WALLS)

FIRST_DESK = Class("a desk one comes to first", frozenset(("first desk",)), floor=True)
PAY_DESK = Class("a desk to pay at", frozenset(("desk to pay at",)), floor=True)
OTHER_DESK = Class("a desk", frozenset(("other desk",)), floor=True)
ANY_DESK = Class("a desk", FIRST_DESK.kinds | PAY_DESK.kinds | OTHER_DESK.kinds, floor=True)
TILLS = Class("a row of tills", frozenset(("tills with lanes",)), floor=True)
AT_EXITS = Class("the way out", parts=EXITS)
ON_WAY_IN = Class("the way in", parts=WAY_IN)
