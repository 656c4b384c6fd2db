"""A kind of furniture of another package: one row, and the function that draws it."""

from __future__ import annotations

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import NAVY, STEEL
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import round_plain
from scenewright.core.kind import Kind, OwnGroup, free, size_range, words
from scenewright.core.scene import Size
from scenewright.geometry.solids import disc, pipe


def trampoline(size: Size) -> Parts:
    """A mat in a ring, from which the legs reach down."""
    mat, rim = disc(0.8, (0.7, 0.75), sides=16), pipe(1, 0.8, (0.0, 1.0), sides=16)
    return parts(size, {NAVY: [mat], STEEL: [rim]})


ASSETS = (Drawing("trampoline", trampoline, round_plain),)

KINDS = (
    Kind(
        "trampoline",
        access=("front", "back", "left", "right"),
        sizes=size_range("90 110 130", "90 110 130", "20 25 35"),
        hall=free("grid single", 0.75),
        words=(
            words(
                en="trampoline, rebounder",
                fr="trampoline",
                de="Trampolin",
                es="cama elástica",
                zh="蹦床",
                ja="トランポリン",
            ),
        ),
        forms="bouncing",
        alone=OwnGroup("bouncing", back=0.0, rooms=(("child_bedroom", 16.0),)),
        drawn_by=("gym",),
    ),
)
