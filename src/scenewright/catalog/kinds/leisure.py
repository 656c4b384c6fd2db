"""Large things for pastimes and housework."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FLANKS, FRONT
from scenewright.core.kind import Kind, OwnGroup, free, size_range

KINDS = (
    Kind(
        "piano",
        access=FRONT,
        reach=0.75,
        sizes=size_range("135 148 160", "50 62 75", "98 120 136"),
        hall=free("single", 0.9, 0.3, 0.0, 0.3),
        essential=("screen or focal point",),
        alone=OwnGroup("piano"),
        drawn_by=(".furniture.leisure",),
    ),
    Kind(
        "exercise_bike",
        access=FLANKS,
        sizes=size_range("45 55 72", "85 105 135", "100 125 150"),
        forms="exercise",
        alone=OwnGroup("exercise", rooms=(("study", 18.0),)),
        drawn_by=(".furniture.leisure",),
    ),
    Kind(
        "ironing_board",
        access=FLANKS,
        airy=True,
        sizes=size_range("30 38 50", "100 130 165", "70 88 100"),
        alone=OwnGroup("ironing", back=0.5),
        drawn_by=(".furniture.leisure",),
    ),
)
