"""Screens that nobody sees from the sofa: the last resort where the two face nowhere, or where
there is neither sofa, armchair nor bed to watch one from; and those that hang in a doorway."""

from __future__ import annotations

from scenewright.catalog.classes import SOFAS
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.composing.case_faults import is_hung
from scenewright.domains.home.composing.filling.amid_walls import list_amid_walls
from scenewright.domains.home.composing.filling.widths import BOOKS
from scenewright.domains.home.composing.judging import Placed, count_unmet
from scenewright.domains.home.composing.placed_faults import (
    measure_before_doors,
    measure_before_windows,
    measure_hung_over_doors,
)
from scenewright.domains.home.composing.places.moving import dress_group, with_margin
from scenewright.domains.home.composing.views import RESTING, is_unseen
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.living import low_board
from scenewright.domains.home.programme import WELCOME, Wish
from scenewright.domains.home.rules.every import SEEN
from scenewright.domains.home.shortfall import list_lacking

FOCAL = "screen or focal point"
"""What kinds that a living room may be furnished towards are essential for."""
SEATS = frozenset((*SOFAS, *RESTING))
"""What one watches a screen from."""
BEFORE = 0.6
"""Metres left free before books."""
REASON = "no place for it is seen from the sofa"
WALL_LESS = "no wall that is seen from the sofa is wide enough for it"
OVER_DOOR = 0.1
"""Metres of the shelf below a screen on the wall that may be over a door."""
SEATLESS = "the room has no seat to watch it from"


def leave_out_unseen_screen(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer without a screen that no seat looks at or no wall holds, unless somebody asked for
    it; where it was on a stand, a low cabinet takes the same floor. Where the room would keep
    nothing to look at, books stand at a wall; where they find no place, the screen stays."""
    media = next((p for p in answer.placed if p.wish.group == "media"), None)
    if media is None or media.wish.required or "media" in task.library.own:
        return answer
    wall_less = hangs_in_doorway(task, media)
    if not wall_less and not is_screen_unseen(task, answer.placed):
        return answer
    rest = tuple(p for p in answer.placed if p is not media)
    board = () if is_hung(media.dressed.case) else _put_board(task, rest, media)
    placed = (*rest, *board)
    if _lacks_focus(task, placed):
        shelf = _put_books(task, rest)
        placed = (*rest, *shelf) if shelf else answer.placed
    if count_unmet(task, placed) > count_unmet(task, answer.placed):
        return answer
    if media in placed:
        return answer
    welcome = media.wish._replace(rank=WELCOME, core=False)
    seated = any(p.category in SOFAS for g in placed for p in g.pieces)
    unseen = REASON if seated else SEATLESS
    lost = Missing(welcome, WALL_LESS if wall_less else unseen)
    return answer._replace(placed=placed, missing=(*answer.missing, lost))


def hangs_in_doorway(task: RoomTask, media: FurnishedGroup) -> bool:
    """Whether a screen on the wall reaches over a door by more than :data:`OVER_DOOR`."""
    return measure_hung_over_doors(media, task.ground) > OVER_DOOR


def is_screen_unseen(task: RoomTask, placed: Placed) -> bool:
    """Whether no seat of a room looks at its screen, nor one that stands already or elsewhere in
    its open space."""
    seated = any(p.category in SOFAS for g in placed for p in g.pieces)
    others = "seating" in task.elsewhere or any(p.category in SEATS for p in task.fixed)
    return (seated or not others) and is_unseen(placed, task.ground.edges)


def _lacks_focus(task: RoomTask, placed: Placed) -> bool:
    """Whether a room needs something to look at and has nothing of the kind."""
    pieces = (*task.fixed, *task.beside, *(piece for group in placed for piece in group.pieces))
    return any(need.name == FOCAL for need in list_lacking(task.space, pieces, task.catalog))


def _put_books(task: RoomTask, rest: Placed) -> Placed:
    """Bookcases at the middle of the longest free stretch of wall where they bar nothing."""
    if "bookcase" in task.forbidden:
        return ()
    margin, wish = with_margin(task), Wish("shelf", WELCOME)
    barred = frozenset(find_blocked(margin, rest))
    found = (g for g in list_amid_walls(task, rest, wish, BOOKS, BEFORE) if _lets_in(task, g))
    return next(((g,) for g in found if bars_no_more(margin, (*rest, g), barred)), ())


def _lets_in(task: RoomTask, group: FurnishedGroup) -> bool:
    """Whether a group stands before no wide door and no window."""
    panes = measure_before_windows(group, task.ground)
    return measure_before_doors(group, task.ground) == 0.0 and float(panes.sum()) <= SEEN


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
