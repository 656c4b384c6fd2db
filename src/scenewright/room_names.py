"""What a room is for, read from its name."""

from __future__ import annotations

from collections.abc import Iterable


def functions_from_name(name: str) -> tuple[str, ...]:
    """Functions of a room by its name; ``('other',)`` if the name says nothing."""
    text = name.casefold()
    words = {"bedroom": "bedroom", "kitchen": "kitchen", "living": "living", "bath": "bathroom"}
    return sort_functions(f for w, f in words.items() if w in text)


def sort_functions(functions: Iterable[str]) -> tuple[str, ...]:
    """Without doubles, and without the vague ones beside something more exact."""
    found = list(dict.fromkeys(functions))
    if any(f.endswith("_bedroom") for f in found):
        found = [f for f in found if f != "bedroom"]
    exact = [f for f in found if f != "other"]
    return tuple(exact) or ("other",)
