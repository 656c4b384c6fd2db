"""Furniture in the user's own model: theirs stays, what is new stands where it was placed."""

from __future__ import annotations

import dataclasses
import re
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flat import flat_solution
from scenewright import formats
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.workflow.arrange import arrange
from thoroughness import few_or_many

ifcopenshell = pytest.importorskip("ifcopenshell")
ifc_models = pytest.importorskip("ifc_models")

SCHEMAS = ("IFC2X3", "IFC4")


@pytest.fixture(scope="module", params=SCHEMAS)
def own(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("own") / "own.ifc"
    ifc_models.write_model(path, request.param)
    return path


@pytest.fixture(scope="module")
def furnished(own: Path) -> tuple[Solution, Path]:
    """The pieces of the flat's living room in the room of the model, and the file written."""
    return furnish(own, own.with_name("furnished.ifc"))


def furnish(own: Path, path: Path, keep: bool = True) -> tuple[Solution, Path]:
    brief = formats.read(own, keep=keep)
    assert brief.source_file is not None
    (room,) = brief.source_file.rooms
    pieces = tuple(
        dataclasses.replace(piece, space=room)
        for piece in flat_solution().pieces
        if piece.id in ("rug", "table")
    )
    low = np.min(brief.rooms[0].outline, axis=0)
    moved = (p.pose._replace(x=p.pose.x + low[0], y=p.pose.y + low[1]) for p in pieces)
    pieces = tuple(dataclasses.replace(p, pose=at) for p, at in zip(pieces, moved, strict=True))
    solution = dataclasses.replace(flat_solution(), brief=brief, pieces=pieces)
    formats.write(solution, path)
    return solution, path


def new_products(own: Path, file: Any) -> list[Any]:
    last = max(entity.id() for entity in ifcopenshell.open(str(own)))
    return [product for product in file.by_type("IfcElement") if product.id() > last]


def test_every_entity_of_theirs_is_as_it_was(own: Path, furnished: tuple[Solution, Path]) -> None:
    before, after = (ifcopenshell.open(str(path)) for path in (own, furnished[1]))
    assert before.schema == after.schema
    assert [str(entity) for entity in before] == [str(after.by_id(e.id())) for e in before]
    head, _, tail = own.read_bytes().partition(b"ENDSEC;\nEND-ISO")
    whole = furnished[1].read_bytes()
    assert whole.startswith(head)
    assert whole.endswith(b"ENDSEC;\nEND-ISO" + tail)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
@pytest.mark.parametrize("own", SCHEMAS[: few_or_many(1, 2)], indirect=True, scope="module")
def test_the_checker_finds_nothing_new(own: Path, furnished: tuple[Solution, Path]) -> None:
    import ifcopenshell.validate

    found = []
    for path in (own, furnished[1]):
        log = ifcopenshell.validate.json_logger()
        ifcopenshell.validate.validate(ifcopenshell.open(str(path)), log, express_rules=True)
        words = (re.sub("0x[0-9a-f]+", "", str(row["message"])) for row in log.statements)
        found.append(Counter(words))
    assert found[1] - found[0] == Counter()


def test_pieces_stand_in_their_room_where_they_were_placed(
    own: Path, furnished: tuple[Solution, Path]
) -> None:
    import ifcopenshell.geom

    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    solution, path = furnished
    wanted = {piece.id: piece for piece in solution.pieces}
    file = ifcopenshell.open(str(path))
    found = new_products(own, file)
    assert {product.Name for product in found} == set(wanted)
    for product in found:
        (held,) = product.ContainedInStructure
        assert held.RelatingStructure.is_a("IfcSpace")
        made = ifcopenshell.geom.create_shape(settings, product)
        points = np.asarray(made.geometry.verts).reshape(-1, 3)
        x, y, z, heading = wanted[product.Name].pose
        source = solution.brief.source_file
        assert source is not None
        middle = (points.min(axis=0) + points.max(axis=0))[:2] / 2 - source.offset
        assert middle == pytest.approx((x, y), abs=0.05)
        assert points[:, 2].min() == pytest.approx(3.1 + z, abs=0.01)
        wide, deep, _ = wanted[product.Name].size
        across, along = (deep, wide) if abs(np.cos(heading)) > 0.5 else (wide, deep)
        assert np.ptp(points[:, 0]) == pytest.approx(across, abs=0.05)
        assert np.ptp(points[:, 1]) == pytest.approx(along, abs=0.05)


def test_like_pieces_share_a_type_with_a_mesh(own: Path, furnished: tuple[Solution, Path]) -> None:
    file = ifcopenshell.open(str(furnished[1]))
    for product in new_products(own, file):
        (shape,) = product.Representation.Representations
        assert shape.RepresentationType == "MappedRepresentation"
        (typed,) = getattr(product, "IsTypedBy", ()) or [
            one for one in product.IsDefinedBy if one.is_a("IfcRelDefinesByType")
        ]
        assert shape.Items[0].MappingSource in typed.RelatingType.RepresentationMaps


def test_read_again_all_furniture_is_kept(furnished: tuple[Solution, Path]) -> None:
    solution, path = furnished
    brief = formats.read(path, keep=True)
    assert [item.id for item in brief.rooms[0].fixed] == [piece.id for piece in solution.pieces]
    twice = dataclasses.replace(solution, brief=brief, pieces=())
    formats.write(twice, path.with_name("twice.ifc"))
    assert path.with_name("twice.ifc").read_bytes() == path.read_bytes()


def test_corners_are_those_of_the_kernel(furnished: tuple[Solution, Path]) -> None:
    """Faces as the file states them reach as far as what the kernel of solids makes of them."""
    import ifcopenshell.geom

    from scenewright.formats.ifc.corners import corners_of

    file = ifcopenshell.open(str(furnished[1]))
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    unit, known, checked = ifcopenshell.util.unit.calculate_unit_scale(file), {}, 0
    for product in file.by_type("IfcFurnishingElement"):
        points = corners_of(product, known)
        assert points is not None
        made = ifcopenshell.geom.create_shape(settings, product).geometry.verts
        drawn = np.asarray(made, float).reshape(-1, 3)
        for end in (np.min, np.max):
            assert end(points * unit, axis=0) == pytest.approx(end(drawn, axis=0), abs=1e-5)
        checked += 1
    assert checked
    (space, *_) = file.by_type("IfcSpace")
    assert corners_of(space, known) is None, "a solid is left to the kernel"


def test_the_same_solution_gives_the_same_bytes(furnished: tuple[Solution, Path]) -> None:
    solution, path = furnished
    formats.write(solution, path.with_name("again.ifc"))
    assert path.with_name("again.ifc").read_bytes() == path.read_bytes()


def test_a_file_that_changed_is_not_furnished(tmp_path: Path) -> None:
    own = tmp_path / "own.ifc"
    ifc_models.write_model(own, "IFC4")
    solution, _ = furnish(own, tmp_path / "out.ifc")
    with pytest.raises(InputError, match="is the model that was read"):
        formats.write(solution, own)
    own.write_bytes(own.read_bytes().replace(b"Upper", b"Lower"))
    for fault in ("has changed since", "is gone"):
        with pytest.raises(InputError, match=fault):
            formats.check_output(tmp_path / "new.ifc", solution.brief)
        with pytest.raises(InputError, match=fault):
            formats.write(solution, tmp_path / "new.ifc")
        own.unlink(missing_ok=True)
    assert not (tmp_path / "new.ifc").exists()


def test_furniture_that_is_there_stays_or_is_in_the_way(tmp_path: Path) -> None:
    own = tmp_path / "own.ifc"
    ifc_models.write_model(own, "IFC2X3", furniture=True)
    with pytest.raises(InputError, match=r"1 piece of furniture .* --keep"):
        furnish(own, tmp_path / "new.ifc", keep=False)


def test_arranged_it_is_their_file_with_more(own: Path, tmp_path: Path) -> None:
    arranged = arrange(own, [tmp_path / "new.ifc"], steps=20)
    file = ifcopenshell.open(str(tmp_path / "new.ifc"))
    found = new_products(own, file)
    assert {product.Name for product in found} == {p.id for p in arranged.solution.pieces}
    assert len(found) > 3
