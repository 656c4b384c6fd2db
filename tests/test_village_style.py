"""The learned style: what the net is told, its file, and hostile ones."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import shapely

from scenewright.cli.commands import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import problems
from scenewright.domains.village.choosing import choose_houses
from scenewright.domains.village.house import House, to_own_frame
from scenewright.domains.village.learned.fullness import odds_of_more
from scenewright.domains.village.learned.pose_net import score_poses, shapes_of_net
from scenewright.domains.village.learned.style import (
    FORMAT,
    SHIPPED,
    arrays_of,
    read_style,
    shipped_style,
    write_style,
)
from scenewright.domains.village.learned.surroundings import (
    Surroundings,
    survey,
    with_house,
    without_houses,
)
from scenewright.domains.village.learned.tokens import tokens_of
from scenewright.domains.village.learning.examples import problem_of_block
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.library import classify_house
from scenewright.domains.village.proposals import is_legal, propose, shapes_at, shrink
from scenewright.domains.village.relations import fold
from scenewright.domains.village.settings import GrowSettings, VillageSettings
from scenewright.domains.village.standing import place, stand

RINGS = [
    np.array([[5.0, 6.0], [17, 6], [17, 14], [5, 14]]),
    np.array([[30.0, 5.0], [40, 7], [38.5, 14.5], [28.5, 12.5]]),
    np.array([[8.0, 30.0], [20, 30], [20, 36], [14, 36], [14, 40], [8, 40]]),
]
FLOOR = np.array([[0.0, 0.0], [60, 0], [62, 45], [-3, 50]])
POSES = np.array([[23.0, 10.0, 0.1], [45.0, 30.0, 1.2], [30.0, 40.0, 0.0]])


def house() -> House:
    ring = np.array([[0.0, 0.0], [9, 0], [9, 6], [0, 6]])
    return classify_house("h", to_own_frame(ring)[0], 2, 7.0, "", 1.0)


def scene_of(moved: Callable[[np.ndarray], np.ndarray], mirrored: bool = False) -> Surroundings:
    """The block with everything moved; the grid of voids moves with it."""
    rings = [moved(ring)[::-1] if mirrored else moved(ring) for ring in RINGS]
    street = moved(FLOOR[:2])[None]
    seen = survey(shapely.Polygon(moved(FLOOR)), street, 0.27, 6, stand(rings, [1, 1, 2]))
    plain = survey(shapely.Polygon(FLOOR), FLOOR[None, :2], 0.27, 6, stand(RINGS, [1, 1, 2]))
    return seen._replace(points=moved(plain.points), away=plain.away)


def told(seen: Surroundings, poses: np.ndarray) -> np.ndarray:
    one = house()
    tokens = tokens_of(seen, one, poses, np.asarray(shapely.polygons(place(one.outline, poses))))
    return np.concatenate([part.reshape(len(poses), -1) for part in tokens], 1)


def test_turning_moving_and_mirroring_a_block_changes_nothing() -> None:
    plain = told(scene_of(lambda points: points), POSES)
    turn, shift = 0.7, np.array([400.0, -90.0])
    spin = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    moved = np.column_stack([POSES[:, :2] @ spin + shift, POSES[:, 2] + turn])
    assert told(scene_of(lambda p: p @ spin + shift), moved) == pytest.approx(plain, abs=1e-6)
    flip = np.array([-1.0, 1.0])
    mirror = np.column_stack([POSES[:, :2] * flip, np.pi - POSES[:, 2]])
    assert told(scene_of(lambda p: p * flip, True), mirror) == pytest.approx(plain, abs=1e-6)


def test_a_house_may_be_turned_by_half_a_turn() -> None:
    seen = scene_of(lambda points: points)
    assert told(seen, POSES + np.array([0.0, 0.0, np.pi])) == pytest.approx(
        told(seen, POSES), abs=1e-6
    )


def test_what_is_told_differs_between_poses() -> None:
    plain = told(scene_of(lambda points: points), POSES)
    assert np.abs(plain[0] - plain[1]).max() > 0.1


def test_surroundings_grow_and_shrink_as_if_made_anew() -> None:
    floor, street = shapely.Polygon(FLOOR), FLOOR[None, :2]
    whole = stand(RINGS, [1, 1, 2])
    anew = survey(floor, street, 0.27, 6, whole)
    grown = with_house(survey(floor, street, 0.27, 6, whole.take([0, 1])), whole)
    more = stand([*RINGS, RINGS[0] + np.array([30.0, 22.0])], [1, 1, 2, 1])
    shrunk = without_houses(survey(floor, street, 0.27, 6, more), whole)
    for other in (grown, shrunk):
        assert other.away == pytest.approx(anew.away)
        assert other.setbacks == pytest.approx(anew.setbacks)
        assert other.planned == anew.planned


def test_the_shipped_net_asks_the_neighbour() -> None:
    """Poses drawn by the net beside one house: most within 4° of it, and each degree below 4° is
    likelier than one beyond. (Scores alone are against proposals, most of them parallel.)"""
    problem = problem_of_block(
        RealBlock("b", "", shapely.box(0, 0, 60, 45), FLOOR[None, :2], (RINGS[1],)),
        (),
        shipped_style(),
        VillageSettings(GrowSettings(proposed=6000)),
    )
    seen = survey(problem.floor, problem.streets, 0.28, 4, stand(RINGS[1:2], [1]))
    one = house()
    poses = propose(problem, seen.standing, one, np.random.default_rng(0))
    shapes, rings = shapes_at(one, poses)
    legal = is_legal(problem.floor, shrink(seen.standing.shapes), shapes, rings)
    scores = score_poses(shipped_style().poses, tokens_of(seen, one, poses[legal], shapes[legal]))
    odds = np.exp(scores - scores.max())
    turn = np.rad2deg(fold(poses[legal, 2] - seen.standing.frames[0, 2]))
    near, beyond = (odds[(turn >= a) & (turn < b)].sum() for a, b in ((0, 4), (4, 46)))
    assert near > beyond
    assert near / 4 > 3 * beyond / 41


def test_a_block_with_houses_missing_is_told_from_a_full_one() -> None:
    style = shipped_style()
    floor, street = shapely.box(0, 0, 90, 60), np.array([[[0.0, 0.0], [90.0, 0.0]]])
    spots = [(x, y) for y in (8.0, 35.0) for x in (5.0, 25.0, 45.0, 65.0)]
    rings = [np.array([[x, y], [x + 11, y], [x + 11, y + 9], [x, y + 9]]) for x, y in spots]
    odds = [
        odds_of_more(
            style.more,
            survey(floor, street, 0.3, 1, stand(rings[:k], [1] * k)),
            style.manner.count_law,
        )
        for k in (1, 4, 8)
    ]
    assert odds[0] > odds[1] > odds[2]


def test_the_shipped_style_is_small_and_says_where_it_is_from() -> None:
    assert SHIPPED.stat().st_size < 5_000_000
    card = shipped_style().card
    assert "OpenStreetMap" in card["licence"]
    assert not set(card["places"]) & set(card["held_out"])
    assert card["figures"]["pose_loss"] < card["figures"]["pose_loss_by_chance"] - 1.0


def test_a_style_is_written_and_read_back(tmp_path: Path) -> None:
    path = tmp_path / "mine.npz"
    write_style(path, shipped_style())
    again = read_style(path)
    assert again.manner == shipped_style().manner
    assert again.regions.keys() == shipped_style().regions.keys()
    for name, region in shipped_style().regions.items():
        assert again.regions[name].manner == region.manner
        assert (again.regions[name].mix.houses == region.mix.houses).all()
    assert all((again.poses[n] == shipped_style().poses[n]).all() for n in shapes_of_net())
    write_style(tmp_path / "again.npz", again)
    assert path.read_bytes() == (tmp_path / "again.npz").read_bytes()


def _changed(name: str, value: object) -> bytes:
    arrays = arrays_of(shipped_style()) | {name: np.asarray(value)}
    file = io.BytesIO()
    np.savez(file, allow_pickle=True, **{k: v for k, v in arrays.items() if v.size})
    return file.getvalue()


def _bomb() -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("card.npy", b"0" * 40_000_000)
    return file.getvalue()


HOSTILE = {
    "text": lambda: b"not a model",
    "empty": lambda: b"",
    "cut": lambda: SHIPPED.read_bytes()[:2000],
    "bomb": _bomb,
    "pickle": lambda: _changed("score", np.array([{"a": 1}], object)),
    "missing": lambda: _changed("more/constant", np.zeros(0)),
    "shape": lambda: _changed("poses/score.w", np.zeros((3, 1))),
    "nan": lambda: _changed("poses/score.w", np.full(shapes_of_net()["score.w"], np.nan)),
    "words": lambda: _changed("manner/sizes", np.array(["a", "b", "c"])),
    "shares": lambda: _changed("manner/sizes", np.array([-1.0, 1, 1])),
    "card": lambda: _changed("card", np.frombuffer(b"[" * 90_000, np.uint8)),
    "mix": lambda: _changed("mix/blocks", np.full((1, 3), 1e5)),
    "no mix": lambda: _changed("mix/houses", np.zeros((1, 2))),
    "regions": lambda: _changed(
        "card",
        np.frombuffer(json.dumps({"format": FORMAT, "regions": ["nowhere"]}).encode(), np.uint8),
    ),
    "names": lambda: _changed(
        "card", np.frombuffer(json.dumps({"format": FORMAT, "regions": [[1]]}).encode(), np.uint8)
    ),
    "format": lambda: _changed("card", np.frombuffer(json.dumps({"format": 9}).encode(), np.uint8)),
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_hostile_style_files_are_refused_in_one_line(
    kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "bad.npz"
    path.write_bytes(HOSTILE[kind]())
    with pytest.raises(InputError):
        read_style(path)
    out = str(tmp_path / "out.json")
    assert run(["arrange", "sample:village-hamlet", "--style", str(path), "-o", out]) == 2
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "bad.npz" in told


def test_a_village_is_filled_in_a_style_of_ones_own(tmp_path: Path) -> None:
    style = shipped_style()
    path, out = tmp_path / "mine.npz", tmp_path / "out.json"
    write_style(path, style._replace(card=style.card | {"look": "riviera"}))
    words = ["--style", str(path), "--preset", "quick", "-q"]
    assert run(["arrange", "sample:village-hamlet", *words, "-o", str(out)]) == 0
    saved = json.loads(out.read_text())
    assert saved["brief"]["style"] == str(path)
    assert any("riviera" in piece["asset"] for piece in saved["pieces"])
    assert run(["check", str(out), "-q"]) == 0


def test_a_region_has_its_own_houses_and_one_that_is_not_known_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of the Riviera half of the houses are small, of the upper Rhine valley one in ten."""
    block = {"outline": [[0, 0], [100, 0], [100, 70], [0, 70]], "streets": [0]}
    brief = {"domain": "village", "blocks": [block]}
    small = {}
    for region in ("monaco_hills", "liechtenstein"):
        one = Brief.model_validate(brief | {"region": region})
        (problem, *_) = problems(one)
        drawn = [choose_houses(problem, np.random.default_rng(k)) for k in range(40)]
        small[region] = np.mean([problem.houses[n].size == 0 for row in drawn for n in row])
    assert small["monaco_hills"] > 2 * small["liechtenstein"]
    path = tmp_path / "far.json"
    path.write_text(json.dumps(brief | {"region": "atlantis"}))
    assert run(["arrange", str(path), "-o", str(tmp_path / "out.json")]) == 2
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "atlantis" in told
    assert "liechtenstein" in told


def test_a_style_that_is_not_there_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["arrange", "sample:village-hamlet", "--style", "none.npz", "-o", "x.json"]) == 2
    assert "no such file" in capsys.readouterr().err
