"""The plan of a site: what is free to build on, what is refused, whether a building fits."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from benchmarks.site_reco import asked, compounds

from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.domains.site.brief import Site
from scenewright.domains.site.plan import site_plan, site_plans
from scenewright.ground.fit import corners_of, fits, main_direction
from thoroughness import few_or_many

FIELD = [(0, 0), (100, 0), (100, 60), (0, 60)]


def site(**more) -> Site:
    return Site.model_validate({"name": "Campus", "outline": FIELD} | more)


def shapes(plan):
    return [shapely.Polygon(block.outline, block.holes) for block in plan.blocks]


def road(*line, **more):
    return {"line": [list(p) for p in line]} | more


def test_a_road_divides_the_ground_and_distances_are_kept():
    wanted = site(
        roads=[road((40, -5), (40, 65), width=6.0)],
        setback=5,
        road_setback=4,
        spacing=8,
        landmarks=[{"at": (70, 30), "size": (10, 6, 12)}],
        holes=[[(10, 10), (20, 10), (20, 20), (10, 20)]],
    )
    plan = site_plan(wanted)
    assert len(plan.blocks) == 2
    assert plan.area == pytest.approx(5900)
    for block in shapes(plan):
        assert block.is_valid
        assert block.distance(shapely.Polygon(FIELD).exterior) >= 5 - 1e-3
        assert block.distance(shapely.box(10, 10, 20, 20)) >= 5 - 1e-3
        assert block.distance(shapely.box(37, 0, 43, 60)) == pytest.approx(4, abs=1e-3)
    east = max(shapes(plan), key=lambda block: block.centroid.x)
    assert east.distance(shapely.box(65, 27, 75, 33)) == pytest.approx(8, abs=1e-3)
    assert {(round(e.x), round(e.y)) for e in plan.entrances} == {(40, 0), (40, 60)}
    assert plan.roads[0].areas[0].area == pytest.approx(360)
    assert [line.tolist() for line in plan.roads[0].inside] == [[[40, 0], [40, 60]]]


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.0, 2.2, 4.0])
def test_the_plan_turns_with_the_site(angle):
    cos, sin = math.cos(angle), math.sin(angle)

    def spun(points):
        return [(cos * x - sin * y + 300, sin * x + cos * y - 200) for x, y in points]

    line = [(40, 0), (45, 30), (40, 60)]
    mark = [(70, 20), (80, 20), (80, 30)]
    still = site_plan(site(roads=[road(*line)], landmarks=[{"outline": mark}]))
    turned = site_plan(
        site(outline=spun(FIELD), roads=[road(*spun(line))], landmarks=[{"outline": spun(mark)}])
    )
    assert [b.area for b in turned.blocks] == pytest.approx(
        [b.area for b in still.blocks], rel=1e-4
    )
    assert len(turned.entrances) == len(still.entrances) == 2
    off = (turned.blocks[0].direction - still.blocks[0].direction - angle) % (math.pi / 2)
    assert min(off, math.pi / 2 - off) < 1e-3


@pytest.mark.parametrize(
    ("more", "told"),
    [
        (
            {"outline": [(0, 0), (10, 10), (10, 0), (0, 10)]},
            "sites[0] 'Campus': the outline crosses or touches itself at (5.00, 5.00)",
        ),
        ({"outline": [(0, 0), (10, 0), (20, 0)]}, "sites[0] 'Campus': the outline holds only 0 m²"),
        ({"outline": [(5, 5), (5, 5), (5, 5)]}, "the outline holds only 0 m²"),
        (
            {"setback": 20.0, "outline": [(0, 0), (100, 0), (100, 24), (0, 24)]},
            "the setback of 20 m leaves nothing: the site is at most 24.00 m wide, 16.00 m too "
            "narrow",
        ),
        ({"holes": [[(-1, -1), (101, -1), (101, 61), (-1, 61)]]}, "holes[0]"),
        ({"holes": [[(40, -1), (50, -1), (50, 61), (40, 61)]]}, "cuts the site in 2 pieces"),
        ({"holes": [[(400, -1), (500, -1), (500, 61), (400, 61)]]}, "holes[0] lies outside"),
        (
            {"landmarks": [{"at": (98, 30), "size": (10, 10, 5)}]},
            "sites[0] 'Campus' landmarks[0]: stands with 30.00 m² outside the site",
        ),
        (
            {
                "landmarks": [
                    {"at": (50, 30), "size": (10, 10, 5)},
                    {"id": "hall", "at": (58, 30), "size": (10, 10, 5)},
                ]
            },
            "landmarks[1]: overlaps landmarks[0] 'landmark-1' by 20.00 m²",
        ),
        ({"landmarks": [{"outline": [(50, 30), (60, 30), (55, 30)]}]}, "landmarks[0]: its outline"),
        (
            {"landmarks": [{"at": (50, 30), "model": "no-such-model"}]},
            "unknown model 'no-such-model'",
        ),
        ({"landmarks": [{"name": "Hall"}]}, "landmarks[0]: has no place"),
        ({"roads": [road((5, 5), (5, 5))]}, "roads[0]: the road has no length"),
        ({"roads": [road((0, 30), (100, 30), width=60.0)]}, "leave nothing to build on"),
        (
            {"roads": [road((0, 5), (9, 5), id="a"), road((0, 9), (9, 9), id="a")]},
            "roads[0]: the id 'a' is used twice",
        ),
        (
            {"buildings": [{"id": "a", "model": "villa"}, {"id": "a", "model": "tower"}]},
            "buildings[0]: the id 'a' is used twice",
        ),
    ],
)
def test_what_cannot_be_built_on_is_told_with_its_place(more, told):
    with pytest.raises(InputError) as caught:
        site_plan(site(**more))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
    assert caught.value.place.startswith("sites[0] 'Campus'")


def test_sites_have_ids_of_their_own():
    assert [plan.id for plan in site_plans([site(), site(), site(name="")])] == [
        "campus",
        "campus-2",
        "site-3",
    ]
    with pytest.raises(InputError, match="the id 'x' is used twice"):
        site_plans([site(id="x"), site(id="x")])


def test_a_building_too_large_is_no_error_of_the_plan_but_does_not_fit():
    plan = site_plan(site(setback=3, buildings=[{"model": "villa", "size": (500, 300, 9)}]))
    assert not fits(plan, 500, 300)
    assert fits(plan, 94, 54)
    assert fits(plan, 54, 94)
    assert not fits(plan, 54.2, 94)


def test_what_fits_in_a_slanted_block_is_found():
    angle = 0.4321
    slanted = corners_of((0, 0, angle, 30.0, 80.0))
    plan = site_plan(site(outline=slanted.tolist(), setback=0))
    assert plan.blocks[0].direction == pytest.approx(angle, abs=1e-6)
    assert fits(plan, 29.9, 79.9)
    assert fits(plan, 79.9, 29.9)
    assert not fits(plan, 30.2, 79.9)


def test_a_box_that_fits_in_a_bent_block_by_exact_search():
    """Against a slow search: boxes set at many places of an L."""
    corner = [(0, 0), (60, 0), (60, 20), (20, 20), (20, 60), (0, 60)]
    plan = site_plan(site(outline=corner, setback=0))
    ell, step = shapely.Polygon(corner).buffer(1e-6), few_or_many(2, 1)
    for width, depth in [(20, 60), (21, 40), (26, 26), (15, 34), (10, 45), (25, 25)]:
        places = np.stack(np.meshgrid(np.arange(0, 60, step), np.arange(0, 60, step)), -1)
        turned = np.linspace(0, math.pi, 24, endpoint=False)
        tried = [
            corners_of((x, y, t, width, depth)) for x, y in places.reshape(-1, 2) for t in turned
        ]
        slow = bool(shapely.covers(ell, shapely.polygons(np.array(tried))).any())
        assert fits(plan, width, depth) or not slow, (width, depth)
    assert fits(plan, 20, 60)
    assert not fits(plan, 21, 40)
    assert not fits(plan, 61, 10)


def test_landmarks_by_outline_have_the_box_about_them():
    square = corners_of((50, 30, 0.3, 20.0, 10.0))
    plan = site_plan(site(landmarks=[{"outline": square.tolist(), "height": 7.0}]))
    mark = plan.landmarks[0]
    assert mark.height == 7.0
    back = shapely.Polygon(corners_of(mark.box))
    assert back.symmetric_difference(shapely.Polygon(square)).area < 1e-6
    assert abs(math.remainder(mark.box[2] + math.pi / 2, math.tau)) <= math.pi / 4 + 1e-9


def test_the_main_direction_is_that_of_most_edges():
    ring = np.array([(0, 0), (50, 0), (50, 20), (25, 45), (0, 20)], float)
    assert main_direction([ring]) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.realdata
def test_every_real_compound_makes_a_plan(real_data):
    rows = compounds(real_data / "site_reco_sample" / "reco_sample.json", setback=0.0)
    assert len(rows) == 91
    told = np.zeros(2, np.int64)
    for place, designed in rows:
        plan = site_plan(place)
        outline = shapely.Polygon(place.outline)
        assert plan.buildable == pytest.approx(outline.area, rel=1e-3)
        assert (np.sin(designed.boxes[:, 2]) <= 1e-6).all()
        boxes = shapely.polygons(corners(designed.boxes))  # those about bent buildings may not fit
        whole = shapely.covers(outline.buffer(1e-3), boxes)
        assert all(fits(plan, *box) for box in designed.boxes[whole, 3:])
        told += int(whole.sum()), int((~whole).sum())
        assert sum(b.count for b in asked(place, designed, "villa").buildings) == len(
            designed.boxes
        )
    assert told[0] > 9 * told[1] > 0
