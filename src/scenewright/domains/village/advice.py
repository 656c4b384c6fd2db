"""What a village's explanation says: what helps where something was left out, and compromises."""

from __future__ import annotations

from scenewright.core.explanation import Compromise, Remedy

REMEDIES: tuple[Remedy, ...] = (
    Remedy(r"stopped before", "let it run longer (--layouts)"),
    Remedy(
        r"no place left on", "ask for fewer houses (count), or lead a lane into the block (lanes)"
    ),
    Remedy(r"look at a square or main street", "ask for fewer shops, or draw a wider street by it"),
    Remedy(r"houses to choose from", "add one to the library (houses) and say its use"),
    Remedy(r"no more place for one", "ask for fewer, or for smaller houses beside it"),
    Remedy(r"([\d.]+ x [\d.]+) m free", "ask for a smaller square, or keep {0} m at a street free"),
)
"""By what a reason says; the first that matches counts."""

COMPROMISES: dict[str, Compromise] = {
    "void": Compromise(
        0.5,
        "the empty middle is {value:.1f} plots wider than in most real blocks",
        "lead a lane into the block, or ask for more houses (count)",
    )
}
"""By the name of a term."""
