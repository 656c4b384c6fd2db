"""Screens that nobody sees from the sofa: the last resort where the two face nowhere."""

from __future__ import annotations

from scenewright.domains.home.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    find_blocked,
)
from scenewright.domains.home.composing.case_faults import is_hung
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.moving import dress_group, with_margin
from scenewright.domains.home.composing.views import is_unseen
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.living import low_board

REASON = "no place for it is seen from the sofa"


def leave_out_unseen_screen(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer without a screen that no sofa looks at, unless somebody asked for it; where it was
    on a stand, a low cabinet takes the same floor."""
    media = next((p for p in answer.placed if p.wish.group == "media"), None)
    if media is None or media.wish.required or "media" in task.library.own:
        return answer
    if not is_unseen(answer.placed):
        return answer
    rest = tuple(p for p in answer.placed if p is not media)
    board = () if is_hung(media.dressed.case) else _put_board(task, rest, media)
    missing = (*answer.missing, Missing(media.wish, REASON))
    return answer._replace(placed=(*rest, *board), missing=missing)


def _put_board(task: RoomTask, rest: Placed, media: FurnishedGroup) -> Placed:
    """A low cabinet on the box of a stand, under its name, if it fits there and one can come to
    it."""
    if "sideboard" in task.forbidden:
        return ()
    case = low_board(media.dressed.case.width)
    pieces = (*task.fixed, *task.beside, *(piece for group in rest for piece in group.pieces))
    group = media._replace(dressed=media.dressed._replace(lost=0))
    standing = standing_of(pieces, flat_kinds(task.catalog))
    board = dress_group(task, group, case, media.dressed.box, standing)
    if board is None:
        return ()
    margin = with_margin(task)
    blocked = set(find_blocked(margin, (*rest, board))) - set(find_blocked(margin, rest))
    return () if blocked else (board,)
