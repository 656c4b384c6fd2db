"""The one door to files: whatever a brief names lies under one root, or is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.core.workspace import check_inside, confined
from scenewright.formats import SAMPLE, read_planned, solution_json, write


class Workspace(NamedTuple):
    """The files of one user, or of one folder of a server.

    With a ``root`` every name is taken from it, and what leads out of it, by ``..``, an absolute
    path or a link, be it named by a brief (catalogs, groups, styles, sources, references), is
    refused with an :class:`InputError` that does not tell whether it is there. Without, names are
    the user's own, as on the command line.

    >>> Workspace(Path("/srv/plans")).read("../../etc/passwd.json")
    Traceback (most recent call last):
    scenewright.core.errors.InputError: ../../etc/passwd.json: lies outside the workspace; use \
names below its folder
    """

    root: Path | None = None

    def path(self, name: str) -> Path:
        """The file of a name, there or not; samples have none."""
        whole = Path(name) if self.root is None else Path(self.root) / name
        try:
            with confined(self.root):
                check_inside(whole)
        except InputError as error:
            raise error.located(file=name) from None
        return whole

    def read(self, name: str, **options: Any) -> Brief:
        """The brief in a file, as :func:`scenewright.read` has it."""
        return self.read_planned(name, **options)[0]

    def read_planned(self, name: str, **options: Any) -> tuple[Brief, Plan]:
        """The brief in a file or a sample, and its plan."""
        source = name if name.startswith(SAMPLE) else str(self.path(name))
        try:
            with confined(self.root):
                return read_planned(source, **options)
        except InputError as error:
            raise self._hide(error) from None

    def read_solution(self, name: str) -> tuple[Solution, Plan]:
        """A saved solution and its plan."""
        path = self.path(name)
        try:
            with confined(self.root):
                return solution_json.read_planned(path)
        except InputError as error:
            raise self._hide(error) from None

    def write(self, solution: Solution, name: str, plan: Plan | None = None) -> Path:
        """Write a solution in the format of the suffix of a name; where it lies now."""
        path = self.path(name)
        with confined(self.root):
            write(solution, path, plan)
        return path

    def _hide(self, error: InputError) -> InputError:
        """An error with names as the user gave them: below the root, not of the machine."""
        if self.root is None:
            return error
        words = [f"{Path(self.root)}/", f"{Path(self.root).resolve()}/"]
        texts = [error.fault, error.remedy, error.file or "", error.place or ""]
        for word in words:
            texts = [text.replace(word, "") for text in texts]
        return InputError(texts[0], texts[1], file=texts[2], place=texts[3])
