"""Both forms hold the numbers of the JSON, with the digits that it states."""

import json

import pytest

import dcfp
from dcfp.present.report import Document
from dcfp.present.report.document import DECIMALS, powered, written
from dcfp.schema.formulas import number
from dcfp.study.scenario import Calculation

pytestmark = pytest.mark.slow

PEAKS = (
    "pgv_m_s", "y_max_mm", "dy_max_mm", "v_max_mm_s", "residual_mm", "force_max_kN", "temperature_max_degC", "friction_min", "V_E_mm_s",
    "V_Eh_mm_s",
)  # fmt: skip


@pytest.fixture(scope="module", params=["pdf", "page"])
def text(request: pytest.FixtureRequest, reading) -> str:
    if request.param == "page":
        return reading.of_page(request.getfixturevalue("page"))
    return reading.plain(" ".join(request.getfixturevalue("pages")))


def test_numbers_are_those_of_the_analyses(calculation: Calculation, document: Document) -> None:
    numbers = json.loads(json.dumps(document.numbers, allow_nan=False))
    assert len(numbers["cases"]) == 2
    for one, case in zip(calculation.results, numbers["cases"], strict=True):
        row = one.response.summary()
        assert {key: case[key] for key in row} == row
        alone = dcfp.respond(one.motion, calculation.scenario.model.bearing)
        assert case["y_max_mm"] == alone.peak_displacement
        assert [said["method"] for said in case["codes"]] == list(one.case.codes)
        assert {said["method"] for said in case["predictions"]} == {
            "pulse",
            "simplified",
            "design",
            "design with spectrum",
            "pulse march",
        }
        (record,) = (m for m in calculation.scenario.study.motions if m.name == one.motion.name)
        assert (case["record_sha256"], case["scaled_record_sha256"]) == (record.digest, one.motion.digest)
        assert case["remarks"] == [
            f"{one.motion.name}: {'; '.join(one.motion.treatment)}.",
            *one.response.remarks,
        ]
    assert numbers["kernels_sha256"]
    assert numbers["version"] == dcfp.version()


def test_the_peaks_of_every_case_are_in_the_text(document: Document, text: str) -> None:
    for case in document.numbers["cases"]:
        row = " ".join([case["record"], *(written(key, case[key]) for key in PEAKS), case["status"]])
        assert row in text


def test_predictions_and_codes_are_in_the_text(document: Document, text: str) -> None:
    bases = {"blind": "record", "informed": "record and analysis", "PGV only": "PGV", "spectrum": "spectrum"}
    for case in document.numbers["cases"]:
        for said in case["predictions"]:
            values = [written(key, said[key]) for key in ("dy_mm", "V_dE_mm_s", "V_dEhr_mm_s", "y_mm")]
            march = said["method"] == "pulse march"
            bound = said["y_mm"] if march else said["dy_mm"]
            change, largest = said["ratios"]["dy"], bound / case["y_max_mm"]
            values += [written("ratio", change), written("ratio", largest)]
            word = "above analysis" if (largest if march else change) >= 1.0 else "below analysis"
            assert " ".join([said["method"], bases[said["basis"]], *values, word]) in text
        for said in case["codes"]:
            keys = ("displacement_mm", "base_shear_over_weight", "effective_period_s", "effective_damping")
            ratio = written("ratio", said["displacement_mm"] / case["y_max_mm"])
            word = "above analysis" if said["displacement_mm"] >= case["y_max_mm"] else "below analysis"
            row = " ".join([said["method"], *(written(key, said[key]) for key in keys), ratio, word])
            assert row in text
            assert said["verdict"] in text


def test_energies_checks_and_formulas_are_in_the_text(document: Document, text: str, reading) -> None:
    for case in document.numbers["cases"]:
        energies = case["energies"]
        row = " ".join(
            [
                *(written("energy_kN_m", energies[f"{name}_kN_m"]) for name in ("input", "hysteretic", "strain", "kinetic")),
                powered(energies["residual_kN_m"]),
                written("energy_kN_m", energies["absolute_input_kN_m"]),
                powered(energies["largest_residual_over_largest_input"]),
            ]
        )  # fmt: skip
        assert row in text
        for check in case["checks"]:
            assert reading.plain(f"{check['found']}: {check['verdict']}") in text
            assert reading.plain(check["limit"]) in text
            assert reading.plain(check["source"]) in text
    for formula in document.numbers["formulas"]:
        assert number(formula["value"], formula["decimals"]).removeprefix("-") in text
        assert reading.plain(formula["name"]) in text


def test_the_head_says_who_and_what(document: Document, text: str, reading) -> None:
    heading = document.heading
    for word in (
        document.title,
        heading.project,
        heading.client,
        heading.author,
        heading.checker,
        heading.number,
    ):
        assert reading.plain(word) in text
    assert f"dcfp {dcfp.version()}" in text
    assert document.numbers["kernels_sha256"] in text
    for name, version in document.numbers["versions"].items():
        assert f"{name} {version}" in text


def test_sources_are_those_of_the_methods(document: Document, text: str, reading) -> None:
    references = document.numbers["references"]
    assert any("Applied Sciences, 10(15), 5259. doi:" in line for line in references)
    for word in ("EN 1998-1", "EN 1998-2", "Architectural Institute", "Akiyama", "Iwan", "Hadjian", "P-695"):
        assert any(word in line for line in references)
    for line in references:
        assert reading.plain(line).split(" doi:")[0] in text


def test_the_record_printed_is_the_one_before_scaling(document: Document, text: str) -> None:
    for case in document.numbers["cases"]:
        assert f"before scaling {case['record_sha256']}" in text


def test_what_could_not_be_confirmed_says_so(document: Document, text: str, reading) -> None:
    open_ones = [one for one in document.numbers["formulas"] if not one["confirmed"]]
    assert len(open_ones) > 5
    for one in open_ones:
        assert reading.plain(f"{one['source']}, unconfirmed") in text


def test_the_digits_are_stated(document: Document) -> None:
    assert document.numbers["decimals"] == DECIMALS
    assert written("residual_mm", -3.849) == "−3.8"
    assert written("residual_mm", -0.01) == "0.0"
    assert written("y_max_mm", None) == "–"
    assert powered(-4.8e-13) == "−4.8e−13"
