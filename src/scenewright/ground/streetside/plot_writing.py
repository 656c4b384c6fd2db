"""Plots in files: a feature of GeoJSON, an object of CityJSON."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from scenewright.core.projection import Projection
from scenewright.ground.buildings.city_objects import Vertices, flat_object, free_key
from scenewright.ground.maps.writing import write_feature, write_ring
from scenewright.ground.streetside.plots import Plot


def plot_features(plots: Iterable[Plot], map_: Projection) -> list[dict[str, Any]]:
    """A polygon for each plot, with ``place=plot`` of OpenStreetMap and in ``plot`` its house."""
    return [
        write_feature(
            f"{row.house}/plot",
            "Polygon",
            [write_ring(row.outline, map_)],
            {
                "place": "plot",
                "plot": row.house,
                "area": round(row.area, 2),
                "outbuildings": len(row.outbuildings),
            },
        )
        for row in plots
    ]


def add_plots(plots: Iterable[Plot], objects: dict[str, Any], vertices: Vertices) -> None:
    """Add a ``LandUse`` of class ``plot`` for each plot to the objects of a city model."""
    for row in plots:
        stated = {"name": row.house, "class": "plot", "area": round(row.area, 2)}
        flat = flat_object("LandUse", [(row.outline,)], stated, vertices)
        objects[free_key(f"{row.house}/plot", objects)] = flat
