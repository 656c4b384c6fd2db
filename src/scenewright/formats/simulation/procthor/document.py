"""What is read of a house: the keys of its document, checked."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic.alias_generators import to_camel

from scenewright.core.document_faults import to_input_error
from scenewright.core.footprint import MOST_CORNERS
from scenewright.formats.json_document import check_size, parse_document

Metres = Annotated[float, Field(ge=-1e4, le=1e4, allow_inf_nan=False)]
DEEPEST = 8
"""How deep objects may stand on one another."""
CAMEL = ConfigDict(alias_generator=to_camel)


class Corner(BaseModel):
    """A point in their axes: x to the right, y up, z away."""

    x: Metres
    y: Metres = 0.0
    z: Metres


class OwnWords(BaseModel):
    """What our houses say beside the schema."""

    id: str = Field(default="", max_length=200)
    name: str = Field(default="", max_length=200)
    functions: list[str] = Field(default=[], max_length=20)
    category: str = Field(default="", max_length=80)
    asset: str = Field(default="", max_length=200)
    size: tuple[float, float, float] | None = None
    group: str = Field(default="", max_length=200)
    function: str = Field(default="", max_length=80)
    hinge: str = Field(default="left", pattern="^(left|right)$")
    swing: str = Field(default="in", pattern="^(in|out|slide|none)$")


class HouseRoom(BaseModel):
    """A room: its id, type and floor."""

    model_config = CAMEL

    id: str
    room_type: str = Field(default="", max_length=80)
    floor_polygon: list[Corner] = Field(min_length=3, max_length=MOST_CORNERS)
    own: OwnWords = Field(default=OwnWords(), alias="scenewright")


class HouseWall(BaseModel):
    """One side of a wall: four corners, the first two below; ``empty`` if there is only a gap."""

    model_config = CAMEL

    id: str
    room_id: str = ""
    polygon: list[Corner] = Field(min_length=2, max_length=64)
    empty: bool = False


class Box(BaseModel):
    """The corners of a hole, as houses before schema 1.0.0 give them."""

    min: Corner
    max: Corner


class HouseHole(BaseModel):
    """A door or window: the rooms and walls it joins, and its corners along the first wall."""

    model_config = CAMEL

    id: str
    asset_id: str = ""
    room0: str | None = None
    room1: str | None = None
    wall0: str | None = None
    wall1: str | None = None
    hole_polygon: list[Corner] = Field(default=[], max_length=64)
    bounding_box: Box | None = None
    own: OwnWords | None = Field(default=None, alias="scenewright")

    @property
    def corners(self) -> list[Corner]:
        """Two or more corners of the hole, along the wall and up; none if it has none."""
        box = self.bounding_box
        return [box.min, box.max] if box and not self.hole_polygon else self.hole_polygon


class Turn(BaseModel):
    """A turn in degrees about each axis."""

    x: float = 0.0
    y: float = Field(default=0.0, ge=-1e6, le=1e6)
    z: float = 0.0


class HouseObject(BaseModel):
    """An object: the middle of its box, its turn, and the objects on it."""

    model_config = CAMEL

    id: str = Field(max_length=200)
    asset_id: str = Field(default="", max_length=200)
    position: Corner
    rotation: Turn = Turn()
    children: list[Any] | None = []
    own: OwnWords | None = Field(default=None, alias="scenewright")


class House(BaseModel):
    """A house of schema 1.0.0."""

    rooms: list[HouseRoom] = Field(min_length=1, max_length=1000)
    walls: list[HouseWall] = Field(default=[], max_length=50_000)
    doors: list[HouseHole] = Field(default=[], max_length=5000)
    windows: list[HouseHole] = Field(default=[], max_length=5000)
    objects: list[HouseObject] = Field(default=[], max_length=50_000)


def load_house(path: Path) -> House:
    """The document of a file; InputError names the place of what is wrong in it."""
    check_size(path, "give one house a file")
    document = parse_document(path.read_bytes(), "a house")
    try:
        return House.model_validate(_without_nulls(document))
    except ValidationError as error:
        raise to_input_error(error) from None


def _without_nulls(document: Any) -> Any:
    """The keys that say something; a house may have null for an empty list."""
    if not isinstance(document, dict):
        return document
    return {key: value for key, value in document.items() if value is not None}


def children_of(one: HouseObject) -> list[HouseObject]:
    """What stands on an object; InputError for what is none."""
    try:
        return [HouseObject.model_validate(child) for child in one.children or []]
    except ValidationError as error:
        raise to_input_error(error) from None
