"""The one error a user's input can cause, and the end of what was cancelled."""

from __future__ import annotations

from scenewright.text import printable

MOST = 400
"""Letters of a place or a fault that are shown."""


class CancelledError(Exception):
    """A run was cancelled before anything was found; nothing was written."""


class InputError(ValueError):
    """Input that cannot be used: one line naming file, place, fault and remedy.

    >>> str(InputError("the outline crosses itself", "list the corners in order",
    ...                file="flat.json", place="rooms[2] 'Kitchen'"))
    "flat.json: rooms[2] 'Kitchen': the outline crosses itself; list the corners in order"
    """

    def __init__(self, fault: str, remedy: str = "", *, file: str = "", place: str = "") -> None:
        self.fault, self.remedy, self.file, self.place = fault, remedy, file, place
        parts = (file, _short(place), _short(fault))
        text = ": ".join(part for part in parts if part)
        super().__init__(printable(f"{text}; {remedy}" if remedy else text))

    def located(self, *, file: str = "", place: str = "") -> InputError:
        """The same error with file or place filled in where they were unknown."""
        return InputError(
            self.fault, self.remedy, file=self.file or file, place=self.place or place
        )


def _short(text: str) -> str:
    """A text that quotes a long one of the user's, with its middle left out.

    >>> _short("a" * 999) == "a" * 200 + " … " + "a" * 100
    True
    """
    return text if len(text) <= MOST else f"{text[:200]} … {text[-100:]}"
