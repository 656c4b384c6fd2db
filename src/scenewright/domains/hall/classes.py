"""Classes of kinds as halls use them, each stated here and nowhere else."""

from __future__ import annotations

AUDIENCE_SEATS = ("auditorium_seat",)
"""Seats that always look at what is shown."""
LONGEST_BENCH, PEW_PITCH = 2.5, 0.95
"""Benches longer than this are pews, which stand in rows and look at what is shown, and metres from
one to the next (Neufert 2012: 0.9 to 1.0 m)."""
TABLE_CHAIRS = ("dining_chair", "reading_chair", "office_chair")
"""Chairs that look at what is shown where no table is in their zone."""
LOUNGE_CHAIRS = ("armchair", "lounge_seat")
"""Kinds that join the sofa of a lounge."""
LOUNGE_SEATS = frozenset(("lounge_seat", "armchair", "sofa", "pouf"))
"""Soft seats that look into their hall."""
CARPETED_SEATS = frozenset(("lounge_seat", "bench", "pew", "auditorium_seat", "reading_table"))
"""Seats and tables under which a carpet may lie."""
SITTING_TABLES = frozenset(("reading_table", "dining_table", "round_table", "outdoor_table"))
"""Tables at which one sits."""
BEDS = ("double_bed", "single_bed")
"""Beside which nightstands stand."""
SHOWS = ("stage", "screen", "lectern")
"""Kinds an audience looks at."""
ALTARS = ("altar", "autel", "communion", "abendmahl", "bimah", "祭壇", "祭坛")
"""Parts of the names of what a congregation looks at."""
FRAMED = ("stage", "screen")
"""Kinds with planters at both sides."""
MAIN_EXHIBITS = ("exhibit_island", "showcase", "plinth", "interactive_table", "stage", "screen")
"""Kinds that may be the main exhibit, the likeliest first."""
ON_SHOW = frozenset((*MAIN_EXHIBITS[:4], "exhibit_panel", "display_table", "mannequin"))
"""Kinds that visitors walk round or along to look at."""
SHOWN_SINGLY = ("mannequin", "plinth")
"""What stands in companies where there are many."""
ANYWHERE = frozenset(
    (
        "bench",
        "lounge_seat",
        "auditorium_seat",
        "dining_chair",
        "round_table",
        "dining_table",
        "desk",
    )
)
"""Seats and tables common to most themes, which therefore suggest none."""
CARPETED_EXHIBITS = frozenset(
    ("showcase", "plinth", "exhibit_island", "exhibit_panel", "interactive_table")
)
"""Exhibits under which a carpet may lie."""
FRONTED = ("exhibit_island", "exhibit_panel")
"""Kinds with a front and a back as drawn, though used from all sides or from both."""
SERVING = ("info_desk", "counter", "checkout")
"""Desks at which somebody serves."""
QUEUED_AT = ("counter", "checkout")
"""Ropes in a zone where these may stand lead to them."""
GOODS = ("gondola", "wall_shelving", "ring_shelf", "fridge_shelf", "clothes_rail", "round_rack")
"""Where one of these is, counters are tills; elsewhere visitors come to them first."""
EATEN_AT = ("vending_machine", "dining_table", "round_table", "counter", "bench")
"""Where litter comes from."""
DECOR = ("plant", "potted_tree", "planter", "litter_bin", "rope_barrier")
"""Kinds nobody comes to see."""


def is_pew(category: str, width: float) -> bool:
    """Whether something is a bench of a congregation.

    >>> is_pew("bench", 3.0), is_pew("bench", 1.2)
    (True, False)
    """
    return category == "pew" or (category == "bench" and width > LONGEST_BENCH)


def is_altar(category: str, name: str) -> bool:
    """Whether a stage, or a box of one's own, is an altar by its name; a stage always is.

    >>> is_altar("box", "High altar"), is_altar("box", "font"), is_altar("stage", "")
    (True, False, True)
    """
    return category == "stage" or (
        category == "box" and any(word in name.casefold() for word in ALTARS)
    )


def is_audience_seat(category: str, width: float) -> bool:
    """Whether an object is a seat, or a row of them, that always looks at what is shown."""
    return category in AUDIENCE_SEATS or is_pew(category, width)
