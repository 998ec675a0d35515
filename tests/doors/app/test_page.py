"""The page in a real browser: its numbers are those of the package, and its files can be taken away."""

import re
import tomllib

import openpyxl
import pytest

import dcfp
from dcfp.analysis.integration import PLATES
from dcfp.analysis.response import PEAKS

from .conftest import at2_text, knet_text, pulse_motion
from .page_reading import (
    DISPLACEMENT,
    FORCE,
    TEMPERATURE,
    fill,
    send,
    show,
    slide,
    tile,
    wait_for_tile,
)

HTML_NAME = "<img src=x onerror=alert(1)>.AT2"


def displacement(response: dcfp.Response) -> str:
    return f"{response.peak_displacement:.1f}"


def test_the_first_numbers_are_those_of_the_paper_s_bearing(shared_page):
    page = shared_page
    response = dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
    assert tile(page, DISPLACEMENT) == displacement(response)
    assert tile(page, FORCE) == f"{response.peak_force / 1e3:.0f}"
    assert tile(page, TEMPERATURE) == f"{response.peak_temperature:.0f}"
    assert page.locator(".status").inner_text() == response.status.value
    told = {name for name, one in PEAKS.items() if one.printed and one.is_number}
    tiles = page.locator("[data-tile]:visible")
    assert {tiles.nth(i).get_attribute("data-tile") for i in range(tiles.count())} == told


def test_predictions_and_codes_stand_beside_the_analysis(shared_page):
    page = shared_page
    table = page.get_by_role("region", name="Predictions beside the analysis")
    table.get_by_text("Eurocode 8 simplified").wait_for()
    case = dcfp.compare(dcfp.load_motion("NCC").scaled_to_pgv(500.0), codes=True)
    for answer in case.codes.values():
        row = table.locator("tr", has_text=answer.method)
        assert f"{answer.displacement:.1f}" in row.inner_text()
        assert answer.verdict in row.inner_text()


def test_the_animation_follows_the_record(shared_page):
    page = shared_page
    words = page.locator(".section-words")
    response = dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
    assert f"{response.peak_displacement:.0f}" in words.inner_text().replace("-", "")
    page.get_by_label("Time in the record").fill("0")
    assert words.inner_text().startswith("0.00 s: displacement 0.0 mm, contact 20 °C")
    page.get_by_role("button", name="Play").click()
    page.wait_for_function("Number.parseFloat(document.querySelector('.section-words').textContent) > 0.3")
    page.get_by_role("button", name="Pause").click()
    still = words.inner_text()
    page.wait_for_timeout(200)
    assert words.inner_text() == still


def test_units_are_for_showing_only(shared_page):
    page = shared_page
    page.get_by_label("Unit of lengths").click()
    page.get_by_role("option", name="in", exact=True).click()
    response = dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
    wait_for_tile(page, DISPLACEMENT, f"{response.peak_displacement / 25.4:.2f}")
    page.get_by_label("Unit of temperatures").click()
    page.get_by_role("option", name="°F").click()
    wait_for_tile(page, TEMPERATURE, f"{response.peak_temperature * 1.8 + 32.0:.0f}")
    assert page.get_by_label("Effective radius of the lower plate [mm]").first.input_value() == "4500"
    page.get_by_label("Unit of lengths").click()
    page.get_by_role("option", name="mm", exact=True).click()
    page.get_by_label("Unit of temperatures").click()
    page.get_by_role("option", name="°C").click()
    wait_for_tile(page, DISPLACEMENT, displacement(response))


def test_the_test_machine(shared_page):
    page = shared_page
    show(page, "Test machine")
    table = page.get_by_role("region", name="Measures of each cycle")
    tests = dcfp.run_program(dcfp.load_program("dependency"))
    table.locator("tbody tr").nth(15).wait_for()
    second = table.locator("tbody tr").nth(1).inner_text()
    assert f"{tests[0].cycles[1].friction:.4f}" in second
    assert f"{tests[0].cycles[1].effective_stiffness / 1e3:.3f}" in second
    page.get_by_label("Program", exact=True).click()
    page.get_by_role("option", name="a sine of your own").click()
    fill(page, "Amplitude [mm]", "500")
    page.get_by_role("alert").filter(has_text="goes beyond the plate").wait_for()
    fill(page, "Amplitude [mm]", "100")
    wave = dcfp.analysis.rig.Sine(100.0, 400.0, 4)
    (own,) = dcfp.run_program(dcfp.Program("sine", (dcfp.analysis.rig.RigTest("sine", wave),)))
    expected = f"{own.cycles[3].friction:.4f}"
    table.locator("tbody tr").nth(3).filter(has_text=expected).wait_for()


def test_a_building_in_plan(open_page):
    from dcfp.system.project import plan_of

    page = open_page()
    show(page, "Building")
    table = page.get_by_role("region", name="Peaks of every bearing")
    table.locator("tbody tr").nth(23).wait_for(timeout=60_000)
    motion = dcfp.load_station("P695-FF-2").scaled_to_pgv(500.0)
    area = page.get_by_label("PROJECT.toml")
    text = area.input_value().replace("count = 8", "count = 1").replace('"120 MN"', '"40 MN"')
    area.fill(text)
    response = dcfp.respond_plan(plan_of(text.encode(), "project", None), motion)
    last = table.locator("tbody tr").nth(23)
    last.filter(has_text=f"{response.largest_load[-1] / 1e3:.0f}").wait_for(timeout=60_000)
    levels = page.get_by_role("region", name="Peaks of slab and floors")
    assert levels.locator("tbody tr").count() == 3
    assert (
        f"{response.peak_floor_acceleration[2] / 1e3:.2f}" in levels.locator("tbody tr").nth(2).inner_text()
    )
    assert page.locator("img[alt^='Plan with the paths']").get_attribute("src").startswith("data:image/png")
    area.fill(text.replace("grid", "grit"))
    page.get_by_role("alert").filter(has_text="line 10").wait_for()


@pytest.mark.slow
def test_the_design_chart(shared_page):
    from dcfp.inference.design_space import RADII, survey
    from dcfp.motion.named import record_set
    from dcfp.system import System

    page = shared_page
    show(page, "Design chart")
    table = page.get_by_role("region", name=re.compile("Least coefficient"))
    table.locator("tbody tr").nth(4).wait_for(timeout=60_000)
    motions = record_set("P695-FF")
    assert motions is not None
    ends = [0, RADII.size - 1]
    space = survey(motions, 500.0, System(), RADII[ends])
    least, force = space.holding(300.0, 0.95)
    for row, mu, ratio in zip(ends, least.tolist(), force.tolist(), strict=True):
        assert table.locator("tbody tr").nth(row).inner_text().split()[-2:] == [f"{mu:.3f}", f"{ratio:.3f}"]
    slide(page, "Allowed displacement", "ArrowRight", 10)
    least, _ = space.holding(400.0, 0.95)
    table.locator("tbody tr").first.filter(has_text=f"{least[0]:.3f}").wait_for(timeout=5_000)


def test_another_bearing_gives_other_numbers(shared_page):
    page = shared_page
    fill(page, "Effective radius of the lower plate [mm]", "2500")
    fill(page, "Effective radius of the upper plate [mm]", "3000")
    fill(page, "Diameter of the slider [mm]", "350")
    fill(page, "Coefficient at 60 N/mm2, 400 mm/s and 17.5 degC", "0.09")
    fill(page, "Temperature at the start [°C]", "-10")
    bearing = dcfp.Bearing((2500.0, 3000.0), 350.0, 60.0, 1.9e6, 440.0)
    motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
    response = dcfp.respond(motion, bearing, dcfp.Li2020(0.09), dcfp.SimplifiedHeating(ambient=-10.0))
    wait_for_tile(page, DISPLACEMENT, displacement(response))
    wait_for_tile(page, TEMPERATURE, f"{response.peak_temperature:.0f}")
    fill(page, "Effective radius of the lower plate [mm]", "")
    page.get_by_role("alert").filter(
        has_text="The effective radius of the lower plate [mm] is missing."
    ).wait_for()
    page.get_by_text("of the last valid input").wait_for()
    page.get_by_role("button", name="Bearing of the paper").first.click()
    wait_for_tile(page, DISPLACEMENT, displacement(dcfp.respond(motion)))
    assert not page.get_by_role("alert").filter(has_text="missing").is_visible()
    assert not page.get_by_text("of the last valid input").is_visible()


def test_precise_heating_shows_the_plate(shared_page):
    page = shared_page
    page.get_by_label("Temperature of the contact from").first.click()
    page.get_by_role("option", name="the whole line of the plate (precise)").click()
    motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
    response = dcfp.respond(motion, heating=dcfp.PreciseHeating(), keep=dcfp.Keep(every=10))
    wait_for_tile(page, DISPLACEMENT, displacement(response))
    plate = page.get_by_role("img", name=re.compile("Temperature along the plate"))
    plate.scroll_into_view_if_needed()
    page.wait_for_function(
        "document.querySelector('[aria-label^=\"Temperature along the plate\"]').dataset.drawn > 0"
    )
    page.get_by_role("button", name="Bearing of the paper").click()
    wait_for_tile(page, DISPLACEMENT, displacement(dcfp.respond(motion)))
    plate.wait_for(state="hidden")


def choose_alone(page, name: str) -> None:
    """Choose one record in place of what is chosen."""
    box = page.get_by_role("combobox", name="Records")
    chips = page.locator(".q-chip__icon--remove")
    chips.click()
    chips.wait_for(state="detached")
    box.fill(name)
    page.get_by_role("option", name=re.compile(f"^{name} ·")).click()
    page.keyboard.press("Escape")


def test_a_station_has_its_orbit_and_its_plate_over_time(shared_page):
    page = shared_page
    choose_alone(page, "P695-FF-2")
    response = dcfp.respond("P695-FF-2", pgv=500.0, keep=PLATES)
    wait_for_tile(page, DISPLACEMENT, displacement(response))
    wait_for_tile(page, "peak_displacement_y", f"{response.peak_displacement_y:.1f}")
    wait_for_tile(page, "peak_point_temperature", f"{response.peak_point_temperature:.0f}")
    words, fields = page.locator(".plate-words"), response.fields
    assert fields is not None
    hottest = fields.time[fields.hottest]
    words.filter(has_text=f"{hottest:.2f} s: hottest point {fields.temperature.max():.0f} °C").wait_for()
    page.get_by_label("Moment of the plate").fill("12")
    assert words.inner_text().startswith(
        f"{fields.time[12]:.2f} s: hottest point {fields.temperature[12].max():.0f} °C"
    )
    orbit = page.get_by_role("img", name=re.compile("Displacement in both directions"))
    orbit.scroll_into_view_if_needed()
    page.wait_for_function(
        "document.querySelector('[aria-label^=\"Displacement in both directions\"]').dataset.drawn > 0"
    )
    fill(page, "Angle to turn them by, from x towards y [°]", "90")
    wait_for_tile(page, "peak_displacement_y", f"{response.peak_displacement_x:.1f}")
    page.get_by_role("switch", name="Vertical force follows the vertical component").click()
    page.get_by_role("alert").filter(has_text="has no vertical component").wait_for()
    page.get_by_role("switch", name="Vertical force follows the vertical component").click()
    fill(page, "Angle to turn them by, from x towards y [°]", "")
    choose_alone(page, "NCC")
    wait_for_tile(page, DISPLACEMENT, displacement(dcfp.respond("NCC", pgv=500.0)))
    orbit.wait_for(state="hidden")


@pytest.mark.slow
def test_what_can_be_taken_away(shared_page, tmp_path):
    page = shared_page
    slide(page, "PGV of every record", "ArrowRight", 5)
    response = dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(550.0))
    wait_for_tile(page, DISPLACEMENT, displacement(response))

    def take(label: str) -> bytes:
        with page.expect_download() as waited:
            page.get_by_role("button", name=label).first.click()
        path = tmp_path / waited.value.suggested_filename
        waited.value.save_as(path)
        return path.read_bytes()

    content = tomllib.loads(take("Scenario (TOML)").decode())
    assert content["factors"]["record"] == ["NCC"]
    from dcfp.study.scenario import calculate, read_scenario

    found = calculate(read_scenario(tmp_path / "scenario.toml")).results[0].response
    assert found.peak_displacement == pytest.approx(response.peak_displacement, rel=1e-9)
    table = take("Histories (CSV)").decode().splitlines()
    assert len(table) == response.time.size + 1
    assert take("All data (NetCDF)")[:4] == b"\x89HDF"
    assert take("Figure (PNG)")[:4] == b"\x89PNG"
    assert take("Report (PDF)")[:5] == b"%PDF-"
    assert take("Workbook (Excel)")[:2] == b"PK"
    slide(page, "PGV of every record", "ArrowLeft", 5)


@pytest.mark.slow
def test_the_report_and_the_workbook_of_a_station(shared_page, tmp_path):
    page = shared_page
    choose_alone(page, "P695-FF-2")
    response = dcfp.respond("P695-FF-2", pgv=500.0)
    wait_for_tile(page, DISPLACEMENT, displacement(response))
    for label, begins in (("Report (PDF)", b"%PDF-"), ("Workbook (Excel)", b"PK")):
        with page.expect_download() as waited:
            page.get_by_role("button", name=label).first.click()
        path = tmp_path / waited.value.suggested_filename
        waited.value.save_as(path)
        assert path.read_bytes().startswith(begins)
    cells = [
        cell for row in openpyxl.load_workbook(path)["Summary"].iter_rows(values_only=True) for cell in row
    ]
    assert any(isinstance(cell, float) and cell == pytest.approx(response.peak_displacement_x, rel=1e-9) for cell in cells)  # fmt: skip
    choose_alone(page, "NCC")
    wait_for_tile(page, DISPLACEMENT, displacement(dcfp.respond("NCC", pgv=500.0)))


def test_little_motion_for_who_wants_little(shared_page):
    page = shared_page
    page.emulate_media(reduced_motion="reduce")
    page.get_by_label("Time in the record").fill("0")
    page.evaluate(
        """() => {
            window.seen = new Set();
            new MutationObserver(() => window.seen.add(document.querySelector('.section-words').textContent))
                .observe(document.querySelector('.section-words'), {characterData: true, subtree: true, childList: true});
        }"""
    )
    page.get_by_role("button", name="Play").click()
    page.wait_for_timeout(2500)
    assert 1 <= page.evaluate("window.seen.size") <= 3
    page.get_by_role("button", name="Pause").click()
    page.emulate_media(reduced_motion="no-preference")


def test_several_records_in_one_table(shared_page, record_file):
    page = shared_page
    page.get_by_role("combobox", name="Records").fill("KNA")
    page.get_by_role("option", name=re.compile(r"^KNA ·")).click()
    table = page.get_by_role("region", name="Peaks of every record")
    table.get_by_role("button", name="KNA").click()
    response = dcfp.respond(dcfp.load_motion("KNA").scaled_to_pgv(500.0))
    wait_for_tile(page, DISPLACEMENT, displacement(response))


def test_a_file_of_peer_and_one_of_k_net(shared_page, record_file):
    page = shared_page
    path = record_file("pulse.AT2", at2_text(pulse_motion()))
    send(page, path)
    motion = dcfp.load_motion(path).scaled_to_pgv(500.0)
    wait_for_tile(page, DISPLACEMENT, displacement(dcfp.respond(motion)))
    assert page.locator("h2", has_text="pulse, PGV").is_visible()
    path = record_file("AOM003.NS", knet_text(pulse_motion(size=1500.0)))
    send(page, path)
    motion = dcfp.load_motion(path)
    page.get_by_role("switch", name="As recorded, not scaled").click()
    wait_for_tile(page, DISPLACEMENT, displacement(dcfp.respond(motion)))
    as_recorded = tile(page, DISPLACEMENT)
    page.get_by_role("switch", name="As recorded, not scaled").click()
    # the tests that follow begin with what is shown then
    page.wait_for_function(
        "([name, text]) => document.querySelector(`[data-tile='${name}']`)?.textContent !== text",
        arg=[DISPLACEMENT, as_recorded],
    )


# ----- what may go wrong -----


def test_a_wrong_file_gets_its_sentence(shared_page, record_file):
    page = shared_page
    before = tile(page, DISPLACEMENT)
    path = record_file("notes.txt", "these are words\nand no numbers\n")
    with pytest.raises(dcfp.InputError) as raised:
        dcfp.load_motion(path)
    send(page, path)
    sentence = str(raised.value).replace(str(path), "notes.txt")
    page.get_by_role("alert").filter(has_text=sentence).wait_for()
    assert tile(page, DISPLACEMENT) == before


def test_a_name_that_is_markup_is_shown_as_it_is(shared_page, tmp_path):
    page = shared_page
    content = at2_text(pulse_motion()).encode()
    page.locator("input[type=file]").set_input_files(
        [{"name": HTML_NAME, "mimeType": "text/plain", "buffer": content}]
    )
    page.locator("h2", has_text="<img src=x onerror=alert(1)>, PGV").wait_for()
    assert page.locator("img[src=x]").count() == 0
    content = b"<script>alert(2)</script>"
    page.locator("input[type=file]").set_input_files(
        [{"name": "<b>bold</b>.txt", "mimeType": "text/plain", "buffer": content}]
    )
    page.get_by_role("alert").filter(has_text="b>.txt").wait_for()
    page.wait_for_timeout(300)  # a script would have run by now; the fixture looks for dialogs


def test_a_path_is_not_followed(shared_page):
    page = shared_page
    content = at2_text(pulse_motion()).encode()
    page.locator("input[type=file]").set_input_files(
        [{"name": "../../etc/passwd.AT2", "mimeType": "text/plain", "buffer": content}]
    )
    page.locator("h2", has_text=re.compile("^passwd, PGV")).wait_for()


@pytest.mark.slow
def test_too_many_files(shared_page):
    page = shared_page
    content = at2_text(pulse_motion(points=400)).encode()
    files = [{"name": f"r{i}.AT2", "mimeType": "text/plain", "buffer": content} for i in range(13)]
    page.locator("input[type=file]").set_input_files(files)
    page.get_by_role("alert").filter(has_text="at most 12 of your files").wait_for()
