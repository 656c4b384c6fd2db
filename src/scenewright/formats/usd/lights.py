"""Lamps, sun and sky in photometric units.

Luminance is in nits. A ball of flux F and surface A has the luminance F / (pi A); a light that is
normalised divides its intensity by A, so that its intensity is F / pi. The sun's, normalised, is
the illuminance in lux of what it strikes squarely (OpenUSD, *UsdLux quantities and units*, 2024).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux

from scenewright.core.catalog import Catalog
from scenewright.render.daylight import HOURS, sun_at
from scenewright.render.items import RenderItem
from scenewright.render.lamps import lamps_of
from scenewright.render.observations.views import SUN

KILO = 1000.0
SUN_DISC = 0.53
"""Angular diameter of the sun in degrees."""


def define_lamps(
    stage: Usd.Stage, items: Sequence[RenderItem], places: dict[str, Sdf.Path], catalog: Catalog
) -> None:
    """A ball of light in every lamp, below its piece."""
    for lamp in lamps_of(items, catalog):
        path = places[lamp.item.name].AppendChild("Light")
        light = UsdLux.SphereLight.Define(stage, path)
        light.AddTranslateOp().Set(Gf.Vec3d(*lamp.at))
        light.CreateRadiusAttr(round(lamp.radius, 5))
        light.CreateNormalizeAttr(True)
        light.CreateIntensityAttr(round(lamp.lumens / float(np.pi), 3))
        light.CreateEnableColorTemperatureAttr(True)
        kind = catalog.kinds[str(lamp.item.extras["category"])]
        light.CreateColorTemperatureAttr(float(kind.kelvin))


def define_daylight(stage: Usd.Stage, parent: Sdf.Path, hour: str = "") -> None:
    """The sun, where it has risen at an hour, and the light of the sky; those of a clear afternoon
    where none is said."""
    day, risen = HOURS[hour or "day"], sun_at(hour)
    if risen is not None or not hour:
        sun = UsdLux.DistantLight.Define(stage, parent.AppendChild("Sun"))
        sun.CreateAngleAttr(SUN_DISC)
        sun.CreateNormalizeAttr(True)
        _shine(sun, np.array(day.sun))
        to = SUN if risen is None else risen.towards
        turn = Gf.Rotation(Gf.Vec3d(0, 0, 1), Gf.Vec3d(*to)).GetQuat()
        UsdGeom.Xformable(sun).AddOrientOp().Set(Gf.Quatf(turn))
    sky = UsdLux.DomeLight.Define(stage, parent.AppendChild("Sky"))
    _shine(sky, (np.array(day.horizon) + np.array(day.zenith)) / 2)


def _shine(light: UsdLux.DistantLight | UsdLux.DomeLight, rows: np.ndarray) -> None:
    """Intensity and colour from kilolux or kilonits in linear red, green and blue."""
    top = float(rows.max())
    light.CreateIntensityAttr(round(KILO * top, 3))
    light.CreateColorAttr(Gf.Vec3f(*(round(float(share) / top, 5) for share in rows)))
