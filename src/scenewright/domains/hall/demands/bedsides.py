"""Nightstands asked for where beds stand are beside these: one at each bed, then at the other side.

A bed with its nightstands is laid out as one object, as a lounge is, and furnished
piece by piece.
"""

from __future__ import annotations

from scenewright.domains.hall.classes import BEDS
from scenewright.domains.hall.demands.holdings import HallDemand, LoungePart
from scenewright.domains.hall.seats.lounges import lay_as_one

STAND = "nightstand"
SIDES = 2
BEDSIDE_GAP = 0.05
"""Metres between a bed and its nightstand."""


def join_bedsides(wishes: list[HallDemand]) -> list[HallDemand]:
    """Demands in which beds have the nightstands of the same zones beside them, unless a brief
    says where those stand."""
    left = {wish.id: wish for wish in wishes}
    for beds in (wish for wish in wishes if wish.category in BEDS and not wish.facing):
        near = [w for w in left.values() if w.category == STAND and w.zones == beds.zones]
        stands = next((w for w in near if w.unstated and w.sizes), None)
        if stands:
            many = min(len(stands.sizes), SIDES * len(beds.sizes))
            left[beds.id] = _join(beds, stands._replace(sizes=stands.sizes[:many]))
            left[stands.id] = stands._replace(sizes=stands.sizes[many:])
    return [wish for wish in left.values() if wish.sizes]


def _join(beds: HallDemand, stands: HallDemand) -> HallDemand:
    """Beds as one with the nightstands beside them, which stand on the free floor at their right;
    where some have two, one gets to both sides beyond these."""
    number = len(beds.sizes)
    own = [[LoungePart(stands, size) for size in stands.sizes[k::number]] for k in range(number)]
    groups = [
        _set_beside(LoungePart(beds, size), two) for size, two in zip(beds.sizes, own, strict=True)
    ]
    front, left, back, right = beds.clearance
    if not any(two[1:] for two in own):
        right = max(right - BEDSIDE_GAP - max(size.width for size in stands.sizes), 0.0)
    return lay_as_one(beds, groups)._replace(
        clearance=(front, left, back, right), required=beds.required or stands.required
    )


def _set_beside(bed: LoungePart, stands: list[LoungePart]) -> tuple[LoungePart, ...]:
    """A bed with up to two nightstands at its head, backs in line."""
    found = [bed]
    for stand, side in zip(stands, (1.0, -1.0), strict=False):
        along = side * (0.5 * (bed.size.width + stand.size.width) + BEDSIDE_GAP)
        back = -0.5 * (bed.size.depth - stand.size.depth)
        found.append(stand._replace(along=along, ahead=back))
    return tuple(found)
