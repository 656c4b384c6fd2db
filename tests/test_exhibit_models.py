"""What large exhibits are drawn as: by what they are called."""

from __future__ import annotations

import pytest

from hall_briefs import answer, hall
from scenewright.catalog.assets import shipped
from scenewright.core.scene import Size


def _drawn(**demand: object) -> list[str]:
    pieces = answer(hall(demands=[{"category": "exhibit_island"} | demand])).pieces
    return [piece.asset for piece in pieces]


@pytest.mark.parametrize(
    ("name", "asset"),
    [
        ("the boat", "exhibit_island_boat"),
        ("Segelboot", "exhibit_island_boat"),
        ("two aeroplanes", "exhibit_island_aeroplane"),
        ("old tram", "exhibit_island_locomotive"),
        ("stands of publishers", "exhibit_island_stand"),
        ("model of the town", "exhibit_island_scale_model"),
        ("a boat model", "exhibit_island_scale_model"),
        ("the skeleton", "exhibit_island_skeleton"),
        ("skeleton of a fin whale", "exhibit_island_whale"),
        ("carpets", "exhibit_island"),
        ("a large exhibit", "exhibit_island"),
    ],
)
def test_an_island_is_drawn_as_what_it_is_called(name: str, asset: str) -> None:
    size = Size(4.0, 2.0, 1.5)
    catalog = shipped()
    found = catalog.choose_called("exhibit_island", name) or catalog.choose("exhibit_island", size)
    assert found is not None
    assert found.id == asset


def test_cars_beside_one_another_differ_in_colour() -> None:
    drawn = _drawn(id="new-cars", count=2, size=[3.2, 1.4, 1.3])
    assert len(set(drawn)) == 2
    assert all(name.startswith("exhibit_island_car_") for name in drawn)


@pytest.mark.parametrize("size", [(4.5, 1.9, 1.5), (8.0, 3.0, 3.5), (5.0, 2.4, 2.6)])
def test_no_size_makes_a_car_or_a_skeleton_of_an_island(size: tuple[float, ...]) -> None:
    found = shipped().choose("exhibit_island", Size(*size))
    assert found is not None
    assert not found.called


def test_a_car_lies_along_the_longer_side_of_its_box() -> None:
    car = shipped().assets["exhibit_island_car_1"]
    along, across = car.symbol(Size(4.6, 1.9, 1.5)), car.symbol(Size(1.9, 4.6, 1.5))
    for one, other in zip(along, across, strict=True):
        assert abs(abs(one[:, 0]).max() - abs(other[:, 1]).max()) < 1e-9
