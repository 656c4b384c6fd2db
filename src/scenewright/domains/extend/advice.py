"""What an extension's explanation says: what helps where something was left out."""

from __future__ import annotations

from scenewright.core.explanation import Compromise, Remedy

REMEDIES: tuple[Remedy, ...] = (
    Remedy(r"stopped before", "let it run longer (--layouts)"),
    Remedy(r"not followed", "draw the source without it if the rest is to be followed closer"),
    Remedy(r"look at a square or main street", "ask for fewer shops (uses)"),
    Remedy(r"houses to choose from|no more place for one", "ask for fewer (uses)"),
    Remedy(r"distances of the source", "ask for fewer buildings (count), or enlarge the area"),
)
"""By what a reason says; the first that matches counts."""

COMPROMISES: dict[str, Compromise] = {
    "coverage": Compromise(
        0.15,
        "the ground covered is {value:.0%} off that of the sources",
        "state the number of buildings (count)",
    ),
    "what": Compromise(
        0.5, "sizes or shapes differ from those of the sources", "name more source areas"
    ),
    "how": Compromise(
        0.5, "gaps or rows differ from those of the sources", "draw an area shaped more like them"
    ),
}
"""By the name of a term."""
