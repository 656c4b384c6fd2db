"""A small furnished flat of two rooms, built by hand."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut, Patch, Solution, TermValue


def flat_brief(name: str = "Two rooms") -> Brief:
    """A living room with a door outside and a window, and a bedroom beside it."""
    return Brief.model_validate(
        {
            "name": name,
            "levels": [{"id": "ground", "name": "Ground floor"}],
            "rooms": [
                {
                    "id": "living",
                    "name": "Living room",
                    "function": "living",
                    "level": "ground",
                    "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
                    "doors": [
                        {"id": "entry", "at": [1, 0], "width": 0.9},
                        {"id": "inner", "at": [5, 3], "to": "bedroom"},
                    ],
                    "windows": [{"id": "glass", "at": [2.5, 4], "width": 1.8}],
                },
                {
                    "id": "bedroom",
                    "name": "Bedroom",
                    "function": "bedroom",
                    "level": "ground",
                    "outline": [[5.12, 0], [8.2, 0], [8.2, 4], [5.12, 4]],
                    "windows": [{"id": "south", "at": [6.6, 0]}],
                    "fixed": [
                        {
                            "id": "old-chest",
                            "name": "Grandmother's chest",
                            "category": "chest_of_drawers",
                            "at": [7.9, 1.0],
                            "heading": 3.141592653589793,
                            "size": [0.9, 0.45, 0.8],
                        }
                    ],
                },
            ],
        }
    )


def flat_solution(name: str = "Two rooms") -> Solution:
    """A furnished answer to :func:`flat_brief`; the headings are exact quarter turns."""
    east, north, west = 0.0, 1.5707963267948966, 3.141592653589793
    pieces = (
        Piece(
            "sofa",
            "sofa",
            "sofa",
            "living",
            Pose(0.5, 2.4, 0, east),
            Size(2.0, 0.9, 0.8),
            "living/seating",
            "seating",
        ),
        Piece(
            "rug",
            "rug",
            "rug",
            "living",
            Pose(1.9, 2.4, 0, east),
            Size(2.4, 1.7, 0.01),
            "living/seating",
            "seating",
        ),
        Piece(
            "table",
            "coffee_table",
            "coffee_table",
            "living",
            Pose(1.8, 2.4, 0, east),
            Size(1.0, 0.6, 0.4),
            "living/seating",
            "seating",
        ),
        Piece(
            "bed",
            "double_bed",
            "double_bed",
            "bedroom",
            Pose(6.66, 2.95, 0, -north),
            Size(1.6, 2.05, 0.5),
            "bedroom/sleeping",
            "sleeping",
        ),
        Piece(
            "old-chest",
            "chest_of_drawers",
            "chest_of_drawers",
            "bedroom",
            Pose(7.9, 1.0, 0, west),
            Size(0.9, 0.45, 0.8),
            fixed=True,
        ),
        Piece(
            "lamp",
            "table_lamp",
            "table_lamp",
            "bedroom",
            Pose(7.9, 1.0, 0.8, west),
            Size(0.25, 0.25, 0.45),
            on="old-chest",
        ),
    )
    return Solution(
        brief=flat_brief(name),
        pieces=pieces,
        patches=(Patch("living/seating", "living", "seating", (1.2, 2.4, 0.0, 2.6, 2.4)),),
        terms=(TermValue("living", "living/seating", "overlap", 0.125, 600.0, 75.0),),
        left_out=(LeftOut("bedroom", "wardrobe", "no wall is long enough", True),),
        energies={"living": 75.0, "bedroom": 0.1},
        preset="default",
        solver="anneal",
        seed=7,
        version="0.1.0",
        brief_hash="0f" * 8,
        seconds=0.25,
        evaluations=12_345,
    )
