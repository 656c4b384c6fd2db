"""Building models: written so that the official checker finds nothing, and read back as drawn."""

from __future__ import annotations

import zipfile
from contextlib import suppress
from pathlib import Path

import pytest
import shapely

from scenewright import formats
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import scene_of

ifcopenshell = pytest.importorskip("ifcopenshell")

SPACE = "IfcSpace"


@pytest.fixture
def model(solution: Solution, tmp_path: Path) -> Path:
    path = tmp_path / "flat.ifc"
    formats.write(solution, path)
    return path


def areas(brief: Brief) -> dict[str, float]:
    return {room.name: shapely.Polygon(room.outline, room.holes).area for room in brief.rooms}


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
def test_the_official_checker_finds_nothing(model: Path) -> None:
    import ifcopenshell.validate

    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(ifcopenshell.open(str(model)), log, express_rules=True)
    assert [row["message"] for row in log.statements] == []


def test_rooms_openings_and_pieces_are_all_there(model: Path, solution: Solution) -> None:
    file, scene = ifcopenshell.open(str(model)), scene_of(solution)
    assert len(file.by_type(SPACE)) == len(scene.spaces)
    doors = [opening for opening in scene.openings if opening.kind == "door"]
    assert len(file.by_type("IfcDoor")) == len(doors)
    assert all(door.FillsVoids for door in file.by_type("IfcDoor"))
    assert len(file.by_type("IfcWindow")) == sum(o.kind == "window" for o in scene.openings)
    names = {product.Name for product in file.by_type("IfcElement")}
    assert {piece.id for piece in scene.pieces} <= names
    stated = {
        round(quantity.AreaValue, 3)
        for quantity in file.by_type("IfcQuantityArea")
        if quantity.Name == "NetFloorArea"
    }
    floors = {round(shapely.Polygon(s.outline, s.holes).area, 3) for s in scene.spaces}
    assert stated == floors


def test_like_pieces_share_one_type(model: Path) -> None:
    file = ifcopenshell.open(str(model))
    for kind in file.by_type("IfcFurnitureType"):
        assert kind.Types
        assert kind.RepresentationMaps


def test_the_same_solution_gives_the_same_bytes(
    model: Path, solution: Solution, tmp_path: Path
) -> None:
    formats.write(solution, tmp_path / "again.ifc")
    assert (tmp_path / "again.ifc").read_bytes() == model.read_bytes()


def test_read_back_rooms_and_doors_are_as_drawn(model: Path, solution: Solution) -> None:
    brief = formats.read(model)
    drawn = areas(solution.brief)
    assert areas(brief) == pytest.approx(drawn, abs=0.01)
    assert sum(len(room.doors) for room in brief.rooms) == sum(
        len(room.doors) for room in solution.brief.rooms
    )
    report = brief.input_report
    assert report is not None
    assert report.floor_share == 1.0
    file = ifcopenshell.open(str(model))
    unfilled = [o for o in file.by_type("IfcOpeningElement") if not o.HasFillings]
    elements = [e for e in file.by_type("IfcElement") if not e.is_a("IfcFeatureElement")]
    assert report.features == len(file.by_type(SPACE)) + len(elements) + len(unfilled)


def test_furniture_stays_where_it_is_to_be_kept(model: Path, solution: Solution) -> None:
    kept = formats.read(model, keep=True)
    fixed = [item for room in kept.rooms for item in room.fixed]
    standing = {piece.id: piece for piece in solution.pieces}
    assert len(fixed) >= 0.9 * len(standing)
    for item in fixed:
        piece = standing[item.name]
        assert item.at == pytest.approx(piece.pose[:2], abs=0.03)
        assert item.category == piece.category
        assert item.size[:2] == pytest.approx(piece.size[:2], abs=0.03)


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        (b"", "is empty"),
        (b"\xef\xbb\xbf<ifcXML>", "an IFC building model as XML"),
        (b"PK\x03\x04" + bytes(100), "is an archive"),
        (b"ISO-10303-21;\nHEADER;/* IFC4 */\n" + b"\xff" * 300, "cannot be read as IFC"),
        (b"ISO-10303-21;HEADER;FILE_SCHEMA(('IFC9'));ENDSEC;DATA;ENDSEC;", "cannot be read as IFC"),
    ],
)
def test_what_is_no_model_is_one_line(content: bytes, fault: str, tmp_path: Path) -> None:
    path = tmp_path / "broken.ifc"
    path.write_bytes(content)
    with pytest.raises(InputError, match=fault) as caught:
        formats.read(path)
    assert "\n" not in str(caught.value)


def test_a_zipped_model_is_read(model: Path, tmp_path: Path) -> None:
    path = tmp_path / "flat.ifczip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.write(model, "flat.ifc")
    brief = formats.read(path)
    assert areas(brief) == areas(formats.read(model))
    assert brief.source_file is None
    with zipfile.ZipFile(path, "a") as archive:
        archive.write(model, "other.IFC")
    with pytest.raises(InputError, match="is an archive of 2 models"):
        formats.read(path)


def test_a_model_cut_short_is_read_or_refused(model: Path, tmp_path: Path) -> None:
    text = model.read_bytes()
    for share in (0.2, 0.6):
        path = tmp_path / "cut.ifc"
        path.write_bytes(text[: int(len(text) * share)])
        with suppress(InputError):
            assert formats.read(path).rooms


@pytest.mark.realdata
@pytest.mark.parametrize(
    ("name", "rooms", "doors"),
    [
        ("duplex_revit_ifc2x3", 20, 14),
        ("fzk_haus_adt_ifc2x", 7, 5),
        ("largebuilding_revit2021_ifc2x3", 8, 18),
        ("tallbuilding_revit2021_ifc2x3", 3, 5),
        ("revit2013_japanese_ifc2x3", 2, 1),
        ("sample_project_revit_es_ifc2x3", 1, 1),
    ],
)
def test_every_room_of_a_real_model_is_found(
    name: str, rooms: int, doors: int, real_data: Path
) -> None:
    brief = formats.read(real_data / f"professional_files/ifc/{name}.ifc")
    assert len(brief.rooms) == rooms
    report = brief.input_report
    assert report is not None
    assert report.complete
    assert sum(row.count for row in report.rows if (row.kind, row.outcome) == ("door", "used")) == (
        doors
    )
    lost = [row.reason for row in report.rows if row.kind == "room (IfcSpace)" and row.reason]
    assert lost == ["by its name it is no room"] * name.startswith("duplex")
