"""The report of a scenario whose records are stations."""

from pathlib import Path

import pytest

from dcfp import load_motion, load_station, respond
from dcfp.present.report import Document, build_report, page_of
from dcfp.study.scenario import OF_ONE_DIRECTION, Calculation, calculate, read_scenario

TEXT = """
title = "Tower under a station"
[factors]
record = ["P695-FF-2"]
pgv = { values = [0.25, 0.5], unit = "m/s" }
[bearing]
capacity = 300
[bearing.heating]
model = "simplified"
"""


@pytest.fixture(scope="module")
def calculation(tmp_path_factory: pytest.TempPathFactory) -> Calculation:
    path = tmp_path_factory.mktemp("station") / "station.toml"
    path.write_text(TEXT, encoding="utf-8")
    return calculate(read_scenario(Path(path)))


@pytest.fixture(scope="module")
def document(calculation: Calculation) -> Document:
    return build_report(calculation)


def test_the_numbers_are_those_of_the_analyses(calculation: Calculation, document: Document) -> None:
    station = load_station("P695-FF-2")
    assert station is not None
    alone = respond(station.scaled_to_pgv(500.0), heating="simplified")
    case = document.numbers["cases"][1]
    for key in ("y_max_mm", "y1_max_mm", "y2_max_mm", "temperature_point_max_degC", "dy_max_mm"):
        assert case[key] == pytest.approx(alone.summary()[key], rel=1e-12)
    assert case["record_sha256"] == station.digest
    assert "predictions" not in case
    assert calculation.results[1].case is None
    assert {check["of"] for check in case["checks"]} == {"analysis"}


def test_it_says_what_is_of_one_direction_and_shows_both(document: Document, reading, lighter) -> None:
    text = reading.of_page(page_of(lighter(document)))
    # in short, in the place of the predictions, and among the limits
    assert text.count(OF_ONE_DIRECTION) == 3
    assert "Largest resultant displacement" in text
    assert "in two horizontal directions" in text
    assert "in one direction" not in text
    assert "Half side of the square" not in text
    first = load_motion("P695-FF-2-a")
    told = (
        f"P695-FF-2-a: PGA {first.peak_acceleration / 1e3:.3f} m/s², PGV {first.peak_velocity / 1e3:.3f} m/s"
    )
    assert f"Direction x {told}" in text.replace("\u00a0", " ")
    assert "pulse" not in text.lower()
