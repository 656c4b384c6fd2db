"""What people do with the studio, from the first click, in a headless browser: by mouse, keyboard
and touch. Whatever the browser complains of, or asks of another machine, is a failure."""

from __future__ import annotations

import io
import re
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from studio_driving import (
    CONTRAST,
    NAMELESS,
    begin,
    begin_drawing,
    column_over_image,
    drag,
    furnish,
    furnish_drawing,
    name_it,
    spot,
    started,
    visiting,
)
from thoroughness import only_thorough

pytest.importorskip("starlette")
browsing = pytest.importorskip("playwright.sync_api")

CHROMIUM = Path("/usr/bin/chromium")
FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
DATA = Path(__file__).parent / "data" / "field_cases"
pytestmark = [
    only_thorough,
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM.exists(), reason="no Chromium on this machine"),
]


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with browsing.sync_playwright() as made:
        yield made.chromium.launch(executable_path=str(CHROMIUM), args=FLAGS)


def test_a_flat_is_drawn_and_furnished(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path) as studio, visiting(browser, studio.link) as page:
        begin_drawing(page, "home")
        for x, name in ((300, "Living room"), (580, "Bedroom")):
            page.keyboard.press("r")
            drag(page, (x, 300), (x + 280, 600))
            name_it(page, name)
        for key, at in (("d", (580, 450)), ("d", (360, 600)), ("w", (300, 450)), ("w", (720, 300))):
            count = page.locator("#draft g[data-id]").count()
            page.keyboard.press(key)
            page.mouse.click(*at)
            page.locator("#draft g[data-id]").nth(count).wait_for()
        column_over_image(page, (430, 450))
        page.screenshot(path=tmp_path / "draft.png")
        furnish_drawing(page)
        page.screenshot(path=tmp_path / "drawn.png")
        assert page.locator("#plan .piece").count() > 5


def test_a_hall_is_drawn_with_zones_and_asked_for_by_form(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path) as studio, visiting(browser, studio.link) as page:
        begin_drawing(page, "hall")
        drag(page, (150, 250), (700, 600))
        name_it(page, "Corner shop")
        for left, right, name in ((150, 400, "Tills"), (400, 700, "Groceries")):
            page.keyboard.press("z")
            drag(page, (left, 250), (right, 600))
            name_it(page, name)
        page.keyboard.press("d")
        page.mouse.click(300, 600)
        page.fill("#opening-width", "2")
        page.keyboard.press("Tab")
        page.locator("#draft").focus()
        page.keyboard.press("Escape")
        page.fill("#wish-keys [name=theme]", "grocery")
        page.keyboard.press("Tab")
        page.locator("#wish-head").click()
        page.fill("#wish [name=category]", "gondola")
        page.fill("#wish [name=count]", "12")
        page.select_option("#wish [name=zone]", label="Groceries")
        page.click("#wish button.main")
        page.locator("#wish-list li", has_text="Groceries").wait_for()
        page.screenshot(path=tmp_path / "hall-draft.png")
        furnish_drawing(page)
        page.screenshot(path=tmp_path / "hall.png")
        gondolas = page.locator("#plan .piece:has(title:text-matches('gondola', 'i'))")
        assert gondolas.count() >= 12
        page.click("#draw")
        page.locator("#draft .zone").nth(1).wait_for()


def test_a_site_is_drawn_and_its_length_typed(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path) as studio, visiting(browser, studio.link) as page:
        begin_drawing(page, "site")
        for at in ((200, 250), (760, 230), (800, 520), (520, 640), (180, 600), (200, 250)):
            page.mouse.move(*at)
            page.mouse.click(*at)
        name_it(page, "Mill field")
        page.keyboard.press("t")
        for at in ((120, 430), (500, 420), (860, 440)):
            page.mouse.move(*at)
            page.mouse.click(*at)
        page.keyboard.press("Enter")
        name_it(page, "Mill Lane", "#street-name")
        page.keyboard.press("v")
        page.locator("#draft .length[data-row=street-1]").first.click()
        page.locator("#typed:focus").wait_for()
        page.keyboard.type("80")
        page.keyboard.press("Enter")
        page.locator("#draft .length", has_text="80.00").wait_for()
        page.screenshot(path=tmp_path / "site-draft.png")
        furnish_drawing(page)
        page.screenshot(path=tmp_path / "site.png")


def test_an_extension_is_drawn_and_a_building_moved_in_3d(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path) as studio, visiting(browser, studio.link) as page:
        begin_drawing(page, "extend")
        drag(page, (150, 300), (200, 360))
        page.locator("#draft .building").wait_for()
        page.locator("#of-building").wait_for()
        for count in (1, 2, 3):
            page.keyboard.press("Control+d")
            page.locator("#draft .building").nth(count).wait_for()
        page.keyboard.press("t")
        for at in ((120, 390), (420, 390)):
            page.mouse.move(*at)
            page.mouse.click(*at)
        page.keyboard.press("Enter")
        name_it(page, "Row", "#street-name")
        page.keyboard.press("r")
        drag(page, (420, 220), (800, 600))
        name_it(page, "East")
        page.screenshot(path=tmp_path / "extend-draft.png")
        furnish_drawing(page)
        page.screenshot(path=tmp_path / "extend.png")
        page.click("#solid")
        page.locator("#space").wait_for()
        page.locator("#note:empty").wait_for(state="attached")
        spots = [(x, y) for y in range(300, 600, 40) for x in range(300, 700, 40)]
        found = page.locator("#selected:visible #lock", has_text=re.compile("^Lock"))
        at = next(at for at in spots if not page.mouse.click(*at) and found.count())
        before = page.input_value("#at-x"), page.input_value("#at-y")
        page.mouse.move(*at)
        page.mouse.down()
        page.mouse.move(at[0] + 25, at[1] + 12)
        assert (page.input_value("#at-x"), page.input_value("#at-y")) != before
        page.mouse.up()
        page.locator("#history li", has_text=re.compile("^moved")).last.wait_for()
        page.screenshot(path=tmp_path / "extend-3d.png")


def test_a_home_is_brought_moved_undone_and_taken_away(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path) as studio, visiting(browser, studio.link) as page:
        page.set_input_files("#file", DATA / "f07_wall_gaps_for_doors.sh3d")
        page.locator("#read-rows li", has_text="wall").wait_for(state="attached")
        furnish(page)
        piece = page.locator("#plan .piece").last
        before = piece.get_attribute("transform")
        piece.focus()
        page.locator("#selected").wait_for()
        page.keyboard.press("l")
        page.locator("#history li", has_text=re.compile("^locked")).wait_for()
        page.keyboard.press("Control+z")
        page.locator("#redo:enabled").wait_for()
        assert page.locator("#plan .piece").last.get_attribute("transform") == before
        page.screenshot(path=tmp_path / "brought.png")


def test_a_sofa_moves_a_television_is_forbidden_and_all_is_exported(
    browser: Any, tmp_path: Path
) -> None:
    with started(tmp_path, "sample:home-studio") as studio, visiting(browser, studio.link) as page:
        furnish(page)
        name = page.locator("#plan .piece:has(title:text-matches('sofa|bed', 'i')) title").first
        words = str(name.text_content())
        x, y = spot(page, words)
        drag(page, (x, y), (x + 30, y + 12))
        page.locator("#history li", has_text="moved").wait_for()
        page.click("#undo")
        page.locator("#redo:enabled").wait_for()
        page.locator("#plan .piece:has(title:text-matches('television', 'i'))").first.focus()
        page.locator("#wish-head").click()
        page.fill("#wish [name=what]", "tv")
        page.check("#wish [name=forbid]")
        page.click("#wish button.main")
        page.locator("#wish-list li", has_text="tv").wait_for()
        furnish(page)
        assert page.locator("#plan .piece:has(title:text-matches('television', 'i'))").count() == 0
        page.keyboard.press("m")
        drag(page, (300, 300), (500, 300))
        assert " m" in str(page.locator("#ruler text").text_content())
        page.keyboard.press("Escape")
        page.screenshot(path=tmp_path / "wished.png")
        with page.expect_download() as taken:
            page.click("#export")
        names = zipfile.ZipFile(io.BytesIO(Path(taken.value.path()).read_bytes())).namelist()
        assert {"scene.json", "scene.glb", "scene.svg", "scene.png"} <= {*names}


def test_a_room_is_walked_through_and_photographed(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path, "sample:home-room") as studio, visiting(browser, studio.link) as page:
        furnish(page)
        page.click("#dress")
        page.locator("#looks button", has_text="teal").click()
        page.locator("#history li", has_text="restyled, retro teal").wait_for()
        page.click("#walk")
        page.locator("#minimap .here").wait_for()
        before = page.locator("#minimap .here").get_attribute("transform")
        page.keyboard.down("ArrowLeft")
        for _ in range(600):
            if page.locator("#minimap .here").get_attribute("transform") != before:
                break
            time.sleep(0.1)
        else:
            raise AssertionError("nobody turned")
        page.keyboard.up("ArrowLeft")
        page.screenshot(path=tmp_path / "walked.png")
        page.click("#picture")
        page.locator("#shown[open]").wait_for()
        assert str(page.locator("#keep-picture").get_attribute("href")).startswith("blob:")
        page.locator("#shown form button").click()
        page.set_viewport_size({"width": 640, "height": 420})
        page.click("#photo")
        page.locator("#photo", has_text="%").wait_for()
        page.click("#photo")
        page.locator("#note", has_text="stopped").wait_for()
        page.click("#photo")
        page.locator("#shown[open]").wait_for()
        assert "/photo.png" in str(page.locator("#keep-picture").get_attribute("href"))
        page.screenshot(path=tmp_path / "photographed.png")


@pytest.mark.parametrize("source", ["sample:hall-exhibition", "plots.geojson"])
def test_halls_and_sites_are_arranged(browser: Any, tmp_path: Path, source: str) -> None:
    if source.endswith(".geojson"):
        (tmp_path / source).write_bytes(
            (DATA / "f03_footprints_without_building_tag.geojson").read_bytes()
        )
    with started(tmp_path, source) as studio, visiting(browser, studio.link) as page:
        page.locator("#plan .space").first.wait_for()
        furnish(page)
        page.screenshot(path=tmp_path / "arranged.png")
        assert page.locator("#plan .piece").count() > 2


def test_breeding_leads_to_a_favourite_in_five_sheets(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path, "sample:home-room") as studio, visiting(browser, studio.link) as page:
        page.click("#breed")
        for sheet in range(1, 6):
            page.locator("#sheet-name", has_text=re.compile(f"Sheet {sheet}$")).wait_for()
            page.locator("#cards .card:not(.early) svg").nth(3).wait_for()
            page.keyboard.press("2")
            page.locator("#cards .card.best").wait_for()
            page.keyboard.press("Shift+Digit3")
            page.locator("#cards .card.worst").first.wait_for()
            page.keyboard.press("Enter")
        page.locator("#champion .card").wait_for()
        page.locator("#champion button").click()
        page.locator("#history li", has_text="took layout").wait_for()
        page.screenshot(path=tmp_path / "bred.png")


def test_two_people_work_at_once_and_one_rates_by_phone(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path, "sample:home-room") as studio, visiting(browser, studio.link) as page:
        furnish(page)
        links = []
        for name, right in (("Ada", "edit"), ("Bo", "rate")):
            page.click("#invite-people")
            page.fill("#person-name", name)
            page.select_option("#person-right", right)
            page.click("#invite button")
            page.locator("#people-list li", has_text=name).wait_for()
            links.append(page.input_value("#person-link"))
            page.click("#people-close")
        with visiting(browser, links[0]) as other:
            other.locator("#plan .piece").first.focus()
            other.click("#lock")
            page.locator("#history li", has_text="Ada: locked").wait_for()
        phone = {"has_touch": True, "is_mobile": True, "locale": "zh-CN"}
        with visiting(browser, links[1], **phone) as rater:
            rater.set_viewport_size({"width": 390, "height": 844})
            rater.locator("#cards .card").nth(2).wait_for()
            rater.locator("#cards .card").nth(1).locator(".row button").first.tap()
            rater.locator("#cards .card.best").wait_for()
            assert rater.locator("#arrange").is_hidden()
            rater.screenshot(path=tmp_path / "phone.png")
        page.click("#invite-people")
        page.locator("#liked .card").wait_for()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_guest_looks_on_a_tablet_by_day_and_by_night(
    browser: Any, tmp_path: Path, scheme: str
) -> None:
    with started(tmp_path, "sample:home-room") as studio, visiting(browser, studio.link) as page:
        page.click("#invite-people")
        page.fill("#person-name", "Cleo")
        page.select_option("#person-right", "view")
        page.click("#invite button")
        page.locator("#people-list li", has_text="Cleo").wait_for()
        link = page.input_value("#person-link")
        with visiting(browser, link, color_scheme=scheme, has_touch=True) as guest:
            guest.set_viewport_size({"width": 820, "height": 1180})
            guest.locator("#plan .space").first.wait_for()
            assert guest.locator("#arrange").is_hidden()
            for pair in (["--paper", "--ink"], ["--panel", "--soft"], ["--panel", "--bad"]):
                assert guest.evaluate(CONTRAST, pair) >= 4.5, pair
            guest.locator("#walk").tap()
            guest.locator("#minimap .here").wait_for()
            guest.screenshot(path=tmp_path / f"tablet-{scheme}.png")


def test_what_was_done_is_there_after_a_kill(browser: Any, tmp_path: Path) -> None:
    studio = begin(tmp_path, "sample:home-room")
    with visiting(browser, studio.link) as page:
        furnish(page)
        count = page.locator("#plan .piece").count()
        page.close()
        studio.process.kill()
        with studio.process:
            studio.process.wait()
    with (
        started(tmp_path, "sample-home-room.studio") as again,
        visiting(browser, again.link) as page,
    ):
        page.locator("#plan .piece").nth(count - 1).wait_for()
        assert page.locator("#plan .piece").count() == count


def test_a_flat_that_was_brought_is_drawn_over(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path, "sample:home-flat") as studio, visiting(browser, studio.link) as page:
        page.click("#draw")
        page.click("#redraw")
        page.locator("#draft path.sketch").first.wait_for()
        page.screenshot(path=tmp_path / "over.png")
        before = page.evaluate("fetch('/state').then((r) => r.json()).then((s) => s.draft.rooms)")
        frame = page.locator("#draft path.sketch[data-id]").first.bounding_box()
        edge = frame["x"] + 1, frame["y"] + frame["height"] / 2
        drag(page, edge, (edge[0] - 30, edge[1]))
        page.locator("#history li", has_text="moved a wall").wait_for(state="attached")
        after = page.evaluate("fetch('/state').then((r) => r.json()).then((s) => s.draft.rooms)")
        assert after != before
        page.screenshot(path=tmp_path / "moved.png")
        refused = "fetch('/do', { method: 'POST', body: '{\"verb\": \"fly\"}' })"
        assert page.evaluate(f"{refused}.then((r) => r.json())")["fault"]
        page.locator("#furnish:enabled").wait_for()
        page.click("#furnish")
        stage = page.locator("#stage", has_text=re.compile("mended|fitted|settled"))
        stage.wait_for(state="attached")
        page.screenshot(path=tmp_path / "stage.png")
        page.locator("#stop").wait_for(state="hidden")
        page.screenshot(path=tmp_path / "furnished.png")


def test_a_site_that_was_brought_is_drawn_over(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path, "sample:site-square") as studio, visiting(browser, studio.link) as page:
        page.click("#draw")
        page.click("#redraw")
        page.locator("#draft path.sketch").first.wait_for()
        furnish_drawing(page)


def test_keys_are_a_dialogs_and_reach_pictures(browser: Any, tmp_path: Path) -> None:
    with started(tmp_path, "sample:home-room") as studio, visiting(browser, studio.link) as page:
        furnish(page)
        page.locator("#plan .piece").first.focus()
        steps = page.locator("#history li").count()
        page.click("#dress")
        page.locator("#looks button").first.wait_for()
        page.keyboard.press("Delete")
        page.keyboard.press("Escape")
        page.locator("#wardrobe").wait_for(state="hidden")
        assert page.locator("#history li").count() == steps
        page.click("#breed")
        picture = page.get_by_role("button", name="layout 1, to see it large")
        picture.focus()
        page.keyboard.press("Enter")
        page.get_by_role("dialog", name="Layouts to choose from").wait_for()
        page.keyboard.press("Escape")
        page.get_by_role("button", name="4 of 5 stars").nth(1).click()
        page.locator("#cards .mark", has_text="★★★★").wait_for()
        page.keyboard.press("1")
        page.locator("#champion .card").wait_for()
        page.locator("#keep").select_option(index=1)
        told = page.locator("#said li", has_text="stays")
        told.wait_for()
        assert "/" not in told.inner_text()
        assert page.evaluate(NAMELESS) == []
        page.screenshot(path=tmp_path / "reached.png")
