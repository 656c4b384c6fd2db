"""What a site's explanation says: what helps where something was left out, and compromises."""

from __future__ import annotations

from scenewright.core.explanation import Compromise, Remedy

REMEDIES: tuple[Remedy, ...] = (
    Remedy(
        r"no way ([\d.]+) m wide",
        "lead a street there, or state a narrower way for the fire brigade (fire_access)",
    ),
    Remedy(
        r"no place left for ([\d.]+ x [\d.]+) m",
        "ask for fewer or smaller buildings, or state less spacing or setback",
    ),
    Remedy(r"found a place", "ask for more buildings, or for less ground to be covered"),
    Remedy(r"no room left (beside a street|along the border)", "keep ground free {0}"),
)
"""By what a reason says; the first that matches counts."""

COMPROMISES: dict[str, Compromise] = {
    "facing": Compromise(
        0.3,
        "some fronts are turned away from the street or the preferred heading",
        "leave more ground before buildings, or state another heading (facing)",
    ),
    "road": Compromise(
        0.1,
        "ways round some buildings are narrow",
        "ask for fewer buildings, or state less spacing",
    ),
    "even": Compromise(0.2, "buildings are at one side of a block", "ask for more buildings"),
}
"""By the name of a term; the value from which it is said is in the term's unit."""
