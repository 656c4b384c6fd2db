"""What the referee would say while something is moved: only the spaces it concerns are judged."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from scenewright.building.plan import room_ids
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import transfer_frame
from scenewright.core.plan import Plan
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains import check, plan_of

Told = tuple[str, str, str]


class MoveJudge:
    """Judges moves of a scene that stays as it is: of rooms and halls only those that something is
    moved in, and of halls no visitors' ways, which follow once it is put down.

    >>> import scenewright as sw
    >>> room = sw.solve(sw.read("sample:home-room"), steps=200)
    >>> judge = MoveJudge(room)
    >>> judge.find_new({})
    ()
    >>> found = judge.find_new({"room/desk/desk": (0.0, 0.0, 0.0)})
    >>> "out_of_bounds" in {one.kind for one in found}
    True
    """

    def __init__(self, solution: Solution, plan: Plan | None = None) -> None:
        self.solution, self.plan = solution, plan or plan_of(solution.brief)
        self._pieces = {piece.id: piece for piece in solution.pieces}
        self._before: dict[frozenset[str], frozenset[Told]] = {}

    def find_new(self, poses: Mapping[str, Sequence[float]]) -> tuple[Finding, ...]:
        """Findings that there would be if pieces, with all that lies on them, were put at (x, y,
        heading), and are not there now. InputError for a piece there is not."""
        moved: dict[str, Piece] = {}
        for name, pose in poses.items():
            moved |= self.carry_to(name, pose)
        if not moved:
            return ()
        spaces = frozenset(piece.space for piece in moved.values())
        part = narrow(self.solution, self.plan, spaces)
        if spaces not in self._before:
            self._before[spaces] = frozenset(map(_tell, part.judge()))
        pieces = tuple(moved.get(piece.id, piece) for piece in part.solution.pieces)
        found = part._replace(solution=replace(part.solution, pieces=pieces)).judge()
        return tuple(one for one in found if _tell(one) not in self._before[spaces])

    def carry_to(self, name: str, pose: Sequence[float]) -> dict[str, Piece]:
        """A piece at (x, y, heading) and all that lies on it, by id; InputError for none."""
        if name not in self._pieces:
            raise InputError(f"there is no piece '{name}'", "choose one of the scene")
        start, (x, y, heading) = self._pieces[name].pose, pose
        frame = start.x, start.y, start.heading
        carried = [name]
        for under in carried:
            carried += [p.id for p in self._pieces.values() if p.on == under]
        found = {}
        for one in (self._pieces[key] for key in carried):
            own = one.pose.x, one.pose.y, one.pose.heading
            there = transfer_frame(own, frame, (x, y, heading))
            placed = one.pose._replace(x=there[0], y=there[1], heading=there[2])
            found[one.id] = replace(one, pose=placed)
        return found


class Part(NamedTuple):
    """Some spaces of a scene."""

    solution: Solution
    plan: Plan

    def judge(self) -> tuple[Finding, ...]:
        """What the referee finds in them."""
        return check(self.solution, plan=self.plan, figures=False).findings


def narrow(solution: Solution, plan: Plan, spaces: frozenset[str]) -> Part:
    """The rooms or halls with some ids as a scene of their own; all of open ground, whose buildings
    have to do with one another."""
    brief = solution.brief
    if not brief.rooms:
        return Part(solution, plan)
    ids = room_ids(brief)
    rooms = [
        room.model_copy(update={"id": name})
        for room, name in zip(brief.rooms, ids, strict=True)
        if name in spaces
    ]
    part = replace(
        solution,
        brief=brief.model_copy(update={"rooms": rooms}),
        pieces=tuple(piece for piece in solution.pieces if piece.space in spaces),
        left_out=tuple(out for out in solution.left_out if out.space in spaces),
        detail=None,
    )
    return Part(part, plan._replace(spaces=tuple(s for s in plan.spaces if s.id in spaces)))


def _tell(found: Finding) -> Told:
    return found.kind, found.piece, found.other
