"""What a hall's explanation says: what helps where something was left out, and compromises."""

from __future__ import annotations

from scenewright.core.explanation import Compromise, Remedy

FEWER = "enlarge the zone, ask for fewer of them, or allow another zone"

REMEDIES: tuple[Remedy, ...] = (
    Remedy(r"([\d.]+ m) are missing", "make the zone {0} larger, or ask for a smaller one"),
    Remedy(
        r"([\d.]+ m) more wall needed",
        "give the zone {0} more wall, ask for fewer, or allow another zone",
    ),
    Remedy(
        r"([\d.]+ m²) more needed",
        "enlarge the zone by {0}, ask for fewer, allow another zone, or state less clearance",
    ),
    Remedy(
        r"a route ([\d.]+) m wide", "ask for fewer objects, or allow narrower routes (route_width)"
    ),
    Remedy(
        r"passages are as wide",
        "ask for fewer objects, or allow narrower passages (passage_width, or width of the link)",
    ),
    Remedy(r": ask for", ""),
    Remedy(r"before what they are to look at", "leave more floor before the stage or screen"),
    Remedy(r"low table|seats are left", "ask for more seats, or for fewer tables"),
    Remedy(r"stage found no room", "enlarge the zone of the stage, or ask for a smaller one"),
    Remedy(r"desk or table", "ask for more desks or tables, or for fewer chairs"),
    Remedy(
        r"guide people|two lines of them|bar the way",
        "leave more floor before the counter, or ask for fewer ropes",
    ),
    Remedy(r"the layout has no place", "add it to the layout that was handed in"),
    Remedy(r"no room left|no place|no layout|found no room", FEWER),
)
"""By what a reason says; the first that matches counts."""

COMPROMISES: dict[str, Compromise] = {
    "access": Compromise(
        0.05, "the passage between them is narrow", "ask for fewer objects along the border"
    ),
    "facing": Compromise(
        0.3, "turned away from what it looks at", "leave floor free between the two"
    ),
    "aisles": Compromise(
        0.3, "gaps lack {value:.1f} m to pass", "ask for fewer objects, or enlarge the zone"
    ),
    "balance": Compromise(
        0.3, "objects are at one side", "ask for more objects, or a smaller zone"
    ),
    "evenness": Compromise(
        0.15, "some zones are fuller than others", "let objects stand in more zones (zones)"
    ),
    "sight": Compromise(
        0.2, "the main exhibit is hidden from the entrance", "keep the way from the entrance free"
    ),
    "order": Compromise(
        1.0, "desk or tills lie behind other objects", "name zones near the doors for them (zones)"
    ),
    "queues": Compromise(0.3, "little floor to queue on", "leave more floor before the tills"),
    "egress": Compromise(0.1, "more than 15 m from every way out", "add a door, or an exit (use)"),
}
"""By the name of a term; the value from which it is said is in the term's unit."""
