"""Which tills are small desks to pay at: belts are for groceries."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import DESKS, TABLES
from scenewright.core.brief import Room
from scenewright.core.brief.zones import Demand
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Size

TILL, DESK = "checkout", "checkout_desk"
"""The kind, and its model without a belt."""
GROCERIES = ("fridge_shelf",)
"""Several tills beside one of these have belts."""
OTHERS = (
    *("clothes_rail", "round_rack", "mannequin", "fitting_room", "book_stack"),
    *("display_table", "display_cabinet", "showcase", "interactive_table", *TABLES, *DESKS),
)
"""Several tills beside one of these, and no groceries, have none."""
NAMED = (
    *(
        "supermarket",
        "hypermarket",
        "grocer",
        "food hall",
        "belt",
        "lane",
        "supermarch",
        "épicerie",
    ),
    *("lebensmittel", "supermarkt", "supermercado", "超市", "スーパー"),
)
"""Parts of the names of halls and tills with belts."""


def is_cash_desk(demand: Demand, room: Room) -> bool:
    """Whether the tills of a demand are desks without belts: of no stated size, and a single one
    or several in a shop that sells no groceries; the name of the hall or the tills may say
    otherwise.

    >>> till, rails = Demand(category="checkout"), Demand(category="clothes_rail", count=9)
    >>> hall = {"outline": [(0, 0), (9, 0), (9, 9)], "demands": [till, rails]}
    >>> is_cash_desk(till, Room(name="Boutique", **hall))
    True
    >>> is_cash_desk(till, Room(name="Supermarket", **hall))
    False
    """
    if demand.category != TILL or demand.size is not None or demand.sizes:
        return False
    said = f"{room.name} {demand.id} {demand.name}".casefold()
    if any(word in said for word in NAMED):
        return False
    beside = {other.category for other in room.demands}
    return (demand.count or 1) == 1 or (
        not beside & set(GROCERIES) and not beside.isdisjoint(OTHERS)
    )


def measure_cash_desk(catalog: Catalog) -> Size:
    """The usual size of a desk to pay at."""
    return Size(*catalog.assets[DESK].usual)
