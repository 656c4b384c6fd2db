"""What strikes the eye on a site and breaks no rule: models that are hardly of such a size."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from scenewright.core.catalog import OWN
from scenewright.core.report import Note
from scenewright.domains.site.brief import Site
from scenewright.ground.plan import SitePlan

SMALL = 2.0
"""Greatest side, in metres, of a landmark that is reported as small."""


def find_small(sites: Sequence[Site], plans: Sequence[SitePlan]) -> Iterator[Note]:
    """Landmarks of a user's own models that are small by their files, not by the brief."""
    for site, plan in zip(sites, plans, strict=True):
        for asked, row in zip(site.landmarks, plan.landmarks, strict=True):
            sides = (row.box[3], row.box[4], row.height)
            if row.model.startswith(OWN) and asked.size is None and max(sides) < SMALL:
                width, depth, height = sides
                message = (
                    f"{row.id} is only {width:.3g} x {depth:.3g} m, {height:.3g} m high by its "
                )
                message += "file: give its size, or its catalogue a scale"
                yield Note(plan.id, "landmark", "", message)
