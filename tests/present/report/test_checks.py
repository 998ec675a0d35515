"""Checks of an analysis: met, not met, not known."""

from dataclasses import replace

import pytest

import dcfp
from dcfp.schema.check import Verdict


def verdicts(
    bearing: dcfp.Bearing = dcfp.LI_2020, record: str = "NCC", pgv: float = 500.0, **more
) -> dict[str, Verdict]:
    motion = dcfp.load_motion(record).scaled_to_pgv(pgv)
    return {one.name: one.verdict for one in dcfp.respond(motion, bearing, **more).checks}


def test_an_ordinary_analysis_meets_what_is_known() -> None:
    found = verdicts()
    assert found.pop("temperature of the contact within the tests") is Verdict.NOT_KNOWN
    assert set(found.values()) == {Verdict.MET}


@pytest.mark.parametrize(
    ("made", "name", "verdict"),
    [
        ({"bearing": replace(dcfp.LI_2020, displacement_capacity=80.0)}, "largest displacement within the capacity", Verdict.NOT_MET),
        ({"bearing": replace(dcfp.LI_2020, displacement_capacity=None)}, "largest displacement within the capacity", Verdict.NOT_KNOWN),
        ({"bearing": replace(dcfp.LI_2020, pressure=120.0)}, "pressure within the tests of the friction law", Verdict.NOT_MET),
        ({"bearing": replace(dcfp.LI_2020, elastic_stiffness=1e5)}, "spring (b) stiff: its stretch before sliding", Verdict.NOT_MET),
        ({"pgv": 1000.0}, "speed within the tests of the friction law", Verdict.NOT_MET),
        ({"heating": dcfp.SimplifiedHeating(ambient=-10.0)}, "temperature at the start as in the tests", Verdict.NOT_MET),
        ({"friction": dcfp.ConstantFriction()}, "speed within the tests of the friction law", Verdict.NOT_KNOWN),
        ({"tail": 0.0, "bearing": replace(dcfp.LI_2020, radii=(200.0, 200.0), slider_diameter=100.0), "pgv": 1500.0}, "largest displacement in the linear range of the pendulum", Verdict.NOT_MET),
    ],
)  # fmt: skip
def test_what_is_not_as_it_should_be_is_found(made, name: str, verdict: Verdict) -> None:
    assert verdicts(**made)[name] is verdict


def test_the_verdict_on_the_capacity_is_that_of_the_status() -> None:
    peak = dcfp.respond(dcfp.load_motion("NCC")).peak_displacement
    for part, met in ((1.0, Verdict.MET), (1.0 - 1e-15, Verdict.NOT_MET)):
        response = dcfp.respond(
            dcfp.load_motion("NCC"), replace(dcfp.LI_2020, displacement_capacity=part * peak)
        )
        found = {one.name: one.verdict for one in response.checks}
        assert found["largest displacement within the capacity"] is met
        assert (response.status.value == "ok") == (met is Verdict.MET)
