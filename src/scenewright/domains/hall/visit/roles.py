"""The part a group plays in a visit: seen first, passed last, or neither."""

from __future__ import annotations

from collections.abc import Collection

from scenewright.domains.hall.classes import GOODS

GATE = "ticket_gate"
"""Objects that all visitors of their zone pass."""
MACHINES = ("ticket_machine",)
"""Where one gets a ticket or a number without being served."""
FRONT = 16384
"""The role of groups that have a front and a back as drawn (those before it:
:mod:`..terms.visitors`)."""
DESKS = ("info_desk", GATE, *MACHINES)


def is_till(category: str, beside: Collection[str]) -> bool:
    """Whether visitors pay there on their way out; ``beside`` are the categories of the hall.

    >>> is_till("counter", ["gondola"]), is_till("counter", ["auditorium_seat"])
    (True, False)
    """
    return category == "checkout" or (category == "counter" and any(g in beside for g in GOODS))


def is_first(category: str, beside: Collection[str]) -> bool:
    """Whether visitors go there before all else: to ask, or for a ticket.

    >>> is_first("counter", ["auditorium_seat"]), is_first("showcase", [])
    (True, False)
    """
    return category in (*DESKS, "counter") and not is_till(category, beside)


def turn_of(category: str, beside: Collection[str]) -> int:
    """When a tour comes to a group: 0 first of all, 1 whenever it is near, 2 last of all."""
    if is_till(category, beside):
        return 2
    return 0 if is_first(category, beside) else 1
