"""The table of kinds: which sides of a piece a person reaches, what holds it, what it goes under.

Reach depths follow usual dimensioning guides (Neufert; Panero & Zelnik): about 0.5 m to sit or to
pass, 0.75 m before doors and drawers, 0.9 m before cooking units.
"""

from __future__ import annotations

from scenewright.catalog import Kind, Side, Support

_FRONT: tuple[Side, ...] = ("front",)
_ANY: tuple[Side, ...] = ("front", "back", "left", "right")
_SEAT: tuple[Side, ...] = ("back", "left", "right")
_FLANKS: tuple[Side, ...] = ("left", "right")
_THREE: tuple[Side, ...] = ("front", "left", "right")
_BOTH: tuple[Side, ...] = ("front", "back")
_TABLES = ("dining_table", "round_table", "outdoor_table")
_DESKS = ("desk", "kids_desk", "vanity")


def _kinds(
    names: str,
    access: tuple[Side, ...] = (),
    reach: float = 0.5,
    *,
    flat: bool = False,
    support: Support = "floor",
    under: tuple[str, ...] = (),
) -> tuple[Kind, ...]:
    return tuple(Kind(name, access, reach, flat, support, under) for name in names.split())


_ROWS = (
    _kinds("sofa loveseat corner_sofa armchair deck_chair", _FRONT),
    _kinds("bench pouf", _ANY),
    _kinds("dining_chair", _SEAT, under=(*_TABLES, *_DESKS)),
    _kinds("office_chair", _SEAT, under=(*_DESKS, *_TABLES)),
    _kinds("stool", _ANY, under=(*_TABLES, *_DESKS)),
    _kinds("bar_stool", _SEAT, under=("kitchen_island", "dining_table")),
    _kinds("outdoor_chair", _THREE, under=("outdoor_table",)),
    _kinds("dining_table round_table outdoor_table coffee_table", _ANY),
    _kinds("side_table"),
    _kinds("desk kids_desk vanity", _FRONT),
    _kinds("console_table", _FRONT),
    _kinds("double_bed", _FLANKS),
    _kinds("single_bed bunk_bed cot", _THREE),
    _kinds("nightstand"),
    _kinds("wardrobe chest_of_drawers storage_shelf shoe_cabinet", _FRONT, 0.75),
    _kinds("bookcase shelf_unit sideboard display_cabinet coat_rack toy_box", _FRONT),
    _kinds("tv_stand"),
    _kinds("wall_shelf wall_cabinet hood mirror towel_rail radiator", support="wall"),
    _kinds("base_cabinet drawer_cabinet sink_cabinet hob_cabinet oven_cabinet", _FRONT, 0.9),
    _kinds("dishwasher fridge tall_cabinet corner_cabinet", _FRONT, 0.9),
    _kinds("kitchen_island", _ANY, 0.9),
    _kinds("toilet basin pedestal_basin bathtub shower", _FRONT),
    _kinds("washing_machine dryer", _FRONT, 0.6),
    _kinds("bathroom_cabinet", _FRONT),
    _kinds("laundry_basket"),
    _kinds("tv monitor laptop", support="top"),
    _kinds("speaker floor_lamp potted_tree planter column obstacle box"),
    _kinds("table_lamp desk_lamp plant books vase bowl", support="top"),
    _kinds("pendant_lamp ceiling_lamp", support="ceiling"),
    _kinds("rug road", flat=True),
    _kinds("picture curtain wall_clock", support="wall"),
    _kinds("drying_rack", _ANY),
    _kinds("staircase", _FRONT, 0.9),
    _kinds("fireplace", _FRONT),
    _kinds("piano", _FRONT, 0.75),
    _kinds("exercise_bike", _FLANKS),
    _kinds("ironing_board", _FLANKS),
    _kinds("showcase plinth interactive_table", _ANY, 0.6),
    _kinds("exhibit_panel", _BOTH, 0.6),
    _kinds("wall_exhibit", _FRONT, 0.6),
    _kinds("exhibit_island", _ANY, 0.75),
    _kinds("rope_barrier partition screen mannequin sign_totem"),
    _kinds("info_desk counter checkout", _FRONT, 0.9),
    _kinds("ticket_gate", _BOTH, 0.9),
    _kinds("gondola book_stack clothes_rail", _BOTH, 0.6),
    _kinds("wall_shelving ring_shelf", _FRONT, 0.6),
    _kinds("round_rack display_table", _ANY, 0.6),
    _kinds("basket_stack litter_bin", _ANY, 0.45),
    _kinds("fitting_room", _FRONT, 0.9),
    _kinds("fridge_shelf lockers vending_machine", _FRONT, 0.75),
    _kinds("reading_table", _BOTH, 0.6),
    _kinds("reading_chair", _SEAT, under=("reading_table", "carrel", *_TABLES, *_DESKS)),
    _kinds("carrel", _FRONT, 0.75),
    _kinds("lounge_seat", _FRONT),
    _kinds("catalogue_terminal", _FRONT, 0.6),
    _kinds("auditorium_seat", _BOTH, 0.45),
    _kinds("lectern", ("back",), 0.6),
    _kinds("stage", _THREE, 0.9),
    _kinds("building", _FRONT, 1.5),
    _kinds("tree lamp_post"),
    _kinds("site_bench", _FRONT),
)

KINDS: dict[str, Kind] = {kind.category: kind for row in _ROWS for kind in row}
