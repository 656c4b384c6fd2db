"""Rows of the table for terms of the picture a room makes: symmetry, void, what one sees first."""

from __future__ import annotations

from scenewright.engine.rows import TermRow

THEMES = "scenewright.domains.home.terms"

PICTURE_ROWS = (
    TermRow(
        "bed_symmetry",
        -1,
        "layout",
        60,
        "axis of a double bed off the middle of the floor beside it, and off any window's",
        "Merrell et al. 2011, symmetry, about the axis of a bed",
        form="repaired",
        function=f"{THEMES}.bed_symmetry:measure_asymmetry",
        data=f"{THEMES}.bed_symmetry:list_axes",
    ),
    TermRow(
        "largest_void",
        -1,
        "layout",
        60,
        "radius of the largest empty circle, of that of the empty room",
        "Toussaint 1983, on a grid, as a share",
        form="repaired",
        function=f"{THEMES}.emptiness:largest_void",
        data=f"{THEMES}.emptiness:find_floor",
    ),
    TermRow(
        "focal_sight",
        -1,
        "layout",
        60,
        "doors from which tall furniture hides every window, fireplace, the seats and the screen",
        "after Merrell et al. 2011, emphasis",
        form="repaired",
        function=f"{THEMES}.focus:focal_sight",
        data=f"{THEMES}.focus:find_sights",
    ),
    TermRow(
        "axis_symmetry",
        -1,
        "layout",
        60,
        "furniture without a counterpart across the axis of the fireplace, screen or bed",
        "Merrell et al. 2011, symmetry, capped, as a share",
        form="repaired",
        function=f"{THEMES}.focus:axis_symmetry",
        data=f"{THEMES}.focus:find_axis",
    ),
    TermRow(
        "shared_lines",
        -1,
        "layout",
        60,
        "edges and axes off those of other items and of windows",
        "after O'Donovan et al. 2014, alignment",
        form="repaired",
        function=f"{THEMES}.lines:shared_lines",
        data=f"{THEMES}.lines:find_window_axes",
    ),
    TermRow(
        "conversation",
        -1,
        "layout",
        60,
        "seats out of speaking distance of all others, or not turned to them",
        "Merrell et al. 2011, conversation, of groups",
        form="repaired",
        function=f"{THEMES}.conversation:conversation",
        data=f"{THEMES}.conversation:find_seats",
    ),
    TermRow(
        "wall_proportion",
        -1,
        "layout",
        60,
        "seats, screen or bed under half or over five sixths of their wall",
        "ours, after the rule of two thirds",
        form="repaired",
        function=f"{THEMES}.proportion:wall_proportion",
        data=f"{THEMES}.proportion:find_walls",
    ),
)
"""Weighed by those who ask for them; of the shipped presets only what their weights name."""
