"""The measures of Cao, Cheng and Zhang (2024) for halls: aesthetic, uniformity, circulation.

The paper gives the sums, not how they are measured; what was chosen is stated at each. All are
the same however the hall is turned: alignment is looked at along the hall's own walls.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import WALL_GAP, Bodies, Floats, Indices, Shape, Shapes
from scenewright.core.space import Opening
from scenewright.domains.hall.check.halls import JudgedHall

SAME_LINE = 0.01
"""How far apart two alignment lines are at least, in metres."""

PERSON = 0.6
"""Width one person needs to move (ML of the paper), in metres."""

ABUT = 0.02
"""Objects at most this far apart are meant to stand side by side, in metres."""

_FACE = 0.03  # the face of a wall may be written a hair off the border of its zone
_SAME_WAY = np.deg2rad(1.0)


def measures_of(bodies: Bodies, hall: JudgedHall) -> dict[str, float]:
    """All measures of a hall, both readings of those the paper leaves open."""
    centres, edges = aesthetic(bodies.corners[hall.objects], principal_direction(hall.shape))
    apart, all_pairs = circulation(bodies.footprints[hall.objects])
    return {
        "aesthetic": round(centres, 5),
        "aesthetic_edges": round(edges, 5),
        "uniformity": round(uniformity(bodies, hall), 4),
        "circulation": round(apart, 3),
        "circulation_all": round(all_pairs, 3),
    }


def principal_direction(shape: Shape) -> float:
    """The direction most of the length of the walls runs along, in [0, pi/2), in radians.

    >>> round(principal_direction(shapely.box(0, 0, 5, 3)), 6)
    0.0
    """
    lengths, angles = np.empty(0), np.empty(0)
    for ring in _rings(shape):
        along = np.diff(shapely.get_coordinates(ring), axis=0)
        lengths = np.append(lengths, np.hypot(*along.T))
        angles = np.append(angles, np.arctan2(along[:, 1], along[:, 0]))
    if not len(angles):
        return 0.0
    quarter = np.pi / 2
    turned = np.abs((angles[:, None] - angles + quarter / 2) % quarter - quarter / 2)
    same = (turned < _SAME_WAY) @ lengths
    return float(angles[int(np.argmax(np.round(same, 3)))] % quarter)


def aesthetic(corners: Floats, direction: float) -> tuple[float, float]:
    """Simplicity 3 / (n_vap + n_hap + n) of Ngo, Teo and Byrne (2003) for rectangles (n, 4, 2).

    n_vap and n_hap are the numbers of distinct alignment lines along and across ``direction``;
    lines within 1 cm are one. Of two readings the first draws lines through the middles of the
    objects (for like objects the same as through their left and upper edges), the second
    through all edges of the boxes that bound them. 0 without objects.
    """
    if not len(corners):
        return 0.0, 0.0
    cos, sin = np.cos(direction), np.sin(direction)
    local = corners @ np.array([[cos, -sin], [sin, cos]])
    middles, low, high = local.mean(1), local.min(1), local.max(1)
    edges = np.concatenate([low, high])
    counts = [_lines(lines[:, 0]) + _lines(lines[:, 1]) for lines in (middles, edges)]
    return 3 / (counts[0] + len(corners)), 3 / (counts[1] + len(corners))


def _lines(values: Floats) -> int:
    return 1 + int((np.diff(np.sort(values)) > SAME_LINE).sum())


def circulation(footprints: Shapes) -> tuple[float, float]:
    """Sum over pairs of objects of max(0, 0.6 m - gap), in metres: what people cannot get past.

    The paper takes all pairs, so shelves side by side count most; that is the second value. The
    first leaves out pairs at most 2 cm apart, which are meant to stand so.
    """
    if len(footprints) < 2:
        return 0.0, 0.0
    tree = shapely.STRtree(footprints)
    i, j = tree.query(footprints, predicate="dwithin", distance=PERSON)
    i, j = i[i < j], j[i < j]
    gaps = np.asarray(shapely.distance(footprints[i], footprints[j]))
    missing = np.maximum(PERSON - gaps, 0.0)
    return float(missing[gaps > ABUT].sum()), float(missing.sum())


def uniformity(bodies: Bodies, hall: JudgedHall) -> float:
    """Mean over zones of abs(U_a of the zone - U_a) + abs(U_w of the zone - U_w); less is better.

    U_a is the area of the objects' footprints over the floor, of the zone or the hall. U_w is
    the length of the fronts of objects whose back stands at a wall, over the length of walls
    without their doors and of both sides of partitions. An object belongs to the zone of its
    middle. Zones without walls have no U_w to compare.
    """
    if not len(hall.areas):
        return 0.0
    walls, backed = walls_of(bodies, hall), at_walls(bodies, hall)
    middles = shapely.centroid(bodies.footprints[hall.objects])
    areas = np.asarray(shapely.area(bodies.footprints[hall.objects]))
    widths = np.array([bodies.pieces[row].size.width for row in hall.objects]) * backed
    floor = max(float(hall.shape.area), 1e-9)
    base = areas.sum() / floor, _share(float(widths.sum()), float(walls.length))
    total = 0.0
    for zone in hall.areas:
        inside = shapely.intersects(zone, middles)
        total += abs(float(areas[inside].sum()) / float(zone.area) - base[0])
        length = float(shapely.intersection(walls, zone.buffer(_FACE)).length)
        length = min(length, float(walls.length))
        if length > PERSON:
            total += abs(_share(float(widths[inside].sum()), length) - base[1])
    return total / len(hall.areas)


def _share(part: float, whole: float) -> float:
    return part / whole if whole > 0 else 0.0


def walls_of(bodies: Bodies, hall: JudgedHall) -> Shape:
    """Faces of the walls of a hall without its doors, and both long sides of its partitions."""
    doors = [_doorway(o) for o in hall.space.openings if o.kind != "window"]
    rings = shapely.multilinestrings(_rings(hall.shape))
    walls = shapely.difference(rings, shapely.union_all(doors))
    sides = bodies.corners[hall.partitions]
    return shapely.union_all(
        [walls, *shapely.linestrings(sides[:, [1, 2]]), *shapely.linestrings(sides[:, [3, 0]])]
    )


def at_walls(bodies: Bodies, hall: JudgedHall) -> Indices:
    """1 for each object of a hall the middle of whose back edge is within 5 cm of a wall or
    partition, else 0."""
    return (wall_gaps(bodies, hall) <= WALL_GAP).astype(np.int64)


def wall_gaps(bodies: Bodies, hall: JudgedHall) -> Floats:
    """Metres from the middle of the back edge of each object of a hall to the nearest wall or
    partition."""
    backs = bodies.corners[hall.objects][:, [0, 3]].mean(1)
    solid = shapely.union_all([shapely.boundary(hall.shape), *bodies.footprints[hall.partitions]])
    gaps: Floats = np.asarray(shapely.distance(shapely.points(backs), solid), np.float64)
    return gaps


def _rings(shape: Shape) -> Shapes:
    """Outline and holes of an area as lines."""
    return shapely.get_parts(shapely.get_rings(shapely.get_parts(shape)))


def _doorway(opening: Opening) -> Shape:
    along = np.array([opening.ux, opening.uy]) * opening.width / 2
    out = np.array([-opening.uy, opening.ux]) * (opening.thickness / 2 + WALL_GAP)
    centre = np.array([opening.x, opening.y])
    sides = np.stack([-along - out, along - out, along + out, -along + out])
    return shapely.polygons(centre + sides)
