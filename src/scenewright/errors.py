"""The one error a user's input can cause."""

from __future__ import annotations


class InputError(ValueError):
    """Input that cannot be used: one line naming file, place, fault and remedy.

    >>> str(InputError("the outline crosses itself", "list the corners in order",
    ...                file="flat.json", place="rooms[2] 'Kitchen'"))
    "flat.json: rooms[2] 'Kitchen': the outline crosses itself; list the corners in order"
    """

    def __init__(self, fault: str, remedy: str = "", *, file: str = "", place: str = "") -> None:
        self.fault, self.remedy, self.file, self.place = fault, remedy, file, place
        told = ": ".join(part for part in (file, place, fault) if part)
        super().__init__(" ".join((f"{told}; {remedy}" if remedy else told).split()))

    def located(self, *, file: str = "", place: str = "") -> InputError:
        """The same error with file or place filled in where they were unknown."""
        return InputError(
            self.fault, self.remedy, file=self.file or file, place=self.place or place
        )
