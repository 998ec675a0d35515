"""Reports of unusual scenarios: nothing moves, nothing is predicted, other laws and plates."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.present.report import build_report
from dcfp.present.report.forms import data_of
from dcfp.study.scenario import Calculation, calculate, read_scenario

MOTION = '[motion]\nunits = "m/s2"\n'
SCENARIOS = {
    "zeros": ('[factors]\nrecord = ["zeros.txt"]\n' + MOTION, "No method of a code has an answer."),
    "drift": ('[factors]\nrecord = ["drift.txt"]\n' + MOTION + "[analysis]\ntail = 0\n", "untreated baseline"),
    "soft": ('[factors]\nrecord = ["NCC"]\npgv = { values = [0.005], unit = "m/s" }\n', "nothing is predicted to move"),
    "high friction": ('[factors]\nrecord = ["NCC"]\n[bearing.friction]\nlaw = "constant"\nmu = 0.12\n', "the method cannot be used"),
    "wearing": ('[factors]\nrecord = ["KNA"]\n[bearing]\nradii = [2000, 3000]\n[bearing.friction]\nlaw = "lomiento2013"\n', "The law has no formula for a single state."),
    "thin plates": ('[factors]\nrecord = ["KNA"]\n[bearing.heating]\nmodel = "precise"\nthickness = 40\nback = "ambient"\n', "Back of plates of finite thickness"),
}  # fmt: skip


@pytest.mark.parametrize("name", SCENARIOS)
def test_an_unusual_scenario_has_its_report(name: str, tmp_path: Path) -> None:
    time = np.arange(201) * 0.01
    for file, wave in (("zeros", 0.0 * time), ("drift", np.sin(7.0 * time) + 0.4)):
        np.savetxt(tmp_path / f"{file}.txt", np.column_stack((time, wave)), fmt="%.6f")
    text, words = SCENARIOS[name]
    path = tmp_path / "scenario.toml"
    path.write_text(text, encoding="utf-8")
    document = build_report(calculate(read_scenario(path)))
    data, drawings = data_of(document)
    assert words in data
    assert len(drawings) == 2
    assert json.dumps(document.numbers, allow_nan=False)
    assert not re.search(r"\b(nan|inf)\b", data)


def test_a_calculation_without_results_has_none(calculation: Calculation) -> None:
    empty = Calculation(calculation.scenario, calculation.methods, calculation.nominal, ())
    with pytest.raises(InputError, match="no analysis to report"):
        build_report(empty)
