"""What a home's explanation says: what helps where something was left out, and compromises.

The terms of rules that the referee judges exactly (collisions, doors, routes) have no row: they
are measured on whole groups, and what breaks a rule is a finding.
"""

from __future__ import annotations

from scenewright.core.explanation import Compromise, Remedy

LARGER = "give the room more floor, or forbid something else in it (wishes: forbid)"

REMEDIES: tuple[Remedy, ...] = (
    Remedy(r"large enough for (.+?)(?: \(|$)", "make 1.2 x 1.4 m of floor free for {0}"),
    Remedy(
        r"^(?:places to eat.*: )?tried (.+?) \(([\d.]+ x [\d.]+) m of floor\)",
        "make {1} m of floor free for {0} in one of these rooms",
    ),
    Remedy(
        r"no free wall of ([\d.]+) m",
        "keep {0} m of wall free of doors, windows and tall furniture, or forbid something else "
        "that stands at the walls",
    ),
    Remedy(r"closed end would face", "leave a corner free for it, or ask for a smaller one"),
    Remedy(
        r"before a (wide )?door",
        "move the door or let it slide or open outwards (swing), or forbid something else",
    ),
    Remedy(r"before a window", "raise the sill, or keep more wall without windows"),
    Remedy(r"before a radiator", "move the radiator, or keep more wall free of radiators"),
    Remedy(r"too tall for the slope", "raise the ceiling there, or ask for it in another room"),
    Remedy(r"of ([\d.]+ x [\d.]+) m would stick out", "make {0} m of floor free in one piece"),
    Remedy(r"run into the (.+?)(?: \(|$)", "forbid or move the {0}, or give the room more floor"),
    Remedy(r"wheelchair", "widen the room, or forbid something else in it"),
    Remedy(
        r"walking route|bar ",
        "widen the room, forbid the furniture in the way, or allow a narrower route (route_width)",
    ),
    Remedy(r"^beds for", "state fewer residents, or add or enlarge a bedroom"),
    Remedy(r"seen from the sofa", "leave a wall opposite the seats free of openings"),
    Remedy(r"no seat to watch", "ask for seats too, or give the room more floor"),
    Remedy(r"hang in the closet", "none is needed; ask for a wardrobe to have one"),
    Remedy(r"away from the kitchen", "keep more wall beside the kitchen free"),
    Remedy(r"the home cooks in", "ask for a kitchen in this room to have a second one"),
    Remedy(r"something smaller", "give the room more floor, or ask for the smaller one"),
    Remedy(r"the layout has no place", "add it to the layout that was handed in"),
    Remedy(
        r"makes? room for|takes? its place|comes before it", "give the room more floor to have both"
    ),
    Remedy(r"no room is left|no place|small enough|without it|too near|drawn back", LARGER),
)
"""By what a reason says; the first that matches counts."""

COMPROMISES: dict[str, Compromise] = {
    "wish": Compromise(
        0.4, "not of the preferred size", "give the room more floor, or forbid something in it"
    ),
    "corridors": Compromise(
        0.15, "on the way from door to door", "move a door, or forbid something in the room"
    ),
    "against_wall": Compromise(0.96, "off the wall", "move it to a wall by hand (adjust --move)"),
    "alignment": Compromise(
        0.1, "askew to the walls", "turn it by hand (adjust --move, with a heading)"
    ),
    "daylight": Compromise(0.5, "far from the window", "wish for it by the window (wishes: by)"),
    "pairs": Compromise(
        0.6,
        "not at the distance or angle at which the two are used best",
        "make floor free between them, or move one by hand (adjust --move)",
    ),
    "balance": Compromise(
        0.3, "furniture is at one side", "ask for something for the empty side (ask)"
    ),
    "places": Compromise(
        0.5, "too near to or too far from what it belongs to", "move it by hand (adjust --move)"
    ),
    "daylight_kept": Compromise(
        0.3, "before {value:.1f} m of a window", "keep more wall free of windows"
    ),
    "openings_kept": Compromise(
        0.3, "before a wide door or passage", "forbid it, or narrow the opening"
    ),
}
"""By the name of a term; the value from which it is said is in the term's unit."""
