"""What strikes the eye on a site and breaks no rule: models that are hardly of such a size, streets
that lie too far off to serve it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

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


def find_far_streets(sites: Sequence[Site], plans: Sequence[SitePlan]) -> Iterator[Note]:
    """Streets of the brief farther from a site than the verge over which they would serve it."""
    for site, plan in zip(sites, plans, strict=True):
        floor = shapely.Polygon(plan.outline)
        for row, way in zip(site.roads, plan.roads, strict=True):
            surface = shapely.buffer(
                shapely.LineString(row.line), row.width / 2, cap_style="flat", join_style="mitre"
            )
            away = float(surface.distance(floor))
            if away > site.verge:
                message = f"{way.name or way.id} lies {away:.1f} m from the border and gives no "
                message += f"access: raise verge ({site.verge:g} m) if it does"
                yield Note(plan.id, "street", "", message)
