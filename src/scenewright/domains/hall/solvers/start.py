"""The first layout of a hall: units placed one by one, the largest first, without overlap.

Cao, Cheng, Zhang 2024, 3.1: patterns stand at random in their zones, wall objects along walls.
"""

from __future__ import annotations

from scenewright.domains.hall.solvers.moves import drawn_code, reseed, scatter
from scenewright.domains.hall.terms.measure import clear_of, write_row
from scenewright.domains.hall.terms.place import build, unfold
from scenewright.domains.hall.terms.state import Ints, PreparedHall, Scratch, State
from scenewright.domains.hall.terms.whole import forget, may_stand, place_all
from scenewright.engine.draws import Stream, uniform
from scenewright.geometry.boxes import Floats, make_frame, read_frame
from scenewright.geometry.buckets import remove
from scenewright.geometry.compiled import compiled, inlined


@inlined
def place_one(
    p: PreparedHall, s: State, work: Scratch, unit: int, tries: int, fresh: bool, stream: Stream
) -> bool:
    """Find a place for a unit among those that are filed: gaps shrink with every try, unless it
    keeps its form (not ``fresh``). Without any ``tries`` it stays where it is.

    True if found; the unit is filed then.
    """
    first, last = p.spans[unit, 0], p.spans[unit, 1]
    for count in range(max(tries, 1)):
        tight = 1.0 - 0.97 * max(2.0 * count / max(tries, 1) - 1.0, 0.0)
        if fresh:
            reseed(p, s, unit, drawn_code(p, unit, stream), uniform(stream), tight)
        if tries > 0:
            scatter(p, s, unit, stream)
        forget(work)
        if unfold(p, s, work, unit) and place_all(p, s, work, unit, True)[0] >= 0.0:
            return True
        for i in range(first, last):
            remove(s.buckets, i)
    return False


@compiled
def place_units(
    p: PreparedHall,
    s: State,
    work: Scratch,
    order: Ints,
    stay: int,
    tries: int,
    fresh: bool,
    stream: Stream,
    placed: Floats,
) -> None:
    """Place units in a given order: the first ``stay`` keep their places, the others get
    new forms where ``fresh``; ``placed`` (g,) tells which found room."""
    for i in range(s.frames.shape[0]):
        remove(s.buckets, i)
    for k in range(order.shape[0]):
        most, anew = (tries, fresh) if k >= stay else (0, False)
        placed[order[k]] = 1.0 if place_one(p, s, work, order[k], most, anew, stream) else 0.0


@compiled
def leave_refused_walls(p: PreparedHall, s: State) -> None:
    """Leave out every partition that may not stand where it does."""
    for host in range(s.walls.shape[0]):
        if s.walls[host, 4] > 0.0 and not may_stand(p, s, host):
            s.partitions[host, 1] = s.partitions[host, 0]
            build(p, s, host)


@compiled
def write_boxes(p: PreparedHall, s: State, boxes: Floats) -> None:
    """Make boxes (n, 5) the footprints, with the clearances that belong to them."""
    for i in range(boxes.shape[0]):
        frame = make_frame(boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3], boxes[i, 4])
        write_row(s.frames, i, frame)
        write_row(s.clears, i, clear_of(frame, p.clear, i))


@compiled
def copy_frames(s: State, out: Floats) -> None:
    """Boxes (n, 5) of the footprints."""
    for i in range(s.frames.shape[0]):
        frame = read_frame(s.frames, i)
        out[i, 0], out[i, 1], out[i, 2] = frame[0], frame[1], frame[7]
        out[i, 3], out[i, 4] = 2.0 * frame[4], 2.0 * frame[5]
