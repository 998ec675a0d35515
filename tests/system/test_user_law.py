"""A law that a user writes: called by address, kept on the disk where it is safe, and refused at once where it gives no number."""

import math
import os
import pickle
from pathlib import Path

import numba
import numpy as np
import pytest
from forked import output

import dcfp
from dcfp import AnalysisError, UserFriction
from dcfp.analysis.plan.shear_building import respond_in_one_direction, shear_building
from dcfp.kernels.friction import coefficient
from dcfp.kernels.law import Law, law_by_address
from dcfp.kernels.user_law import CompiledLaw, compile_law
from dcfp.schema.declared import declared
from dcfp.system import FrictionLaw

pytestmark = pytest.mark.filterwarnings("error")


def slow_rise(pressure: float, speed: float, temperature: float) -> float:
    return 0.04 + 1e-5 * speed + 1e-6 * pressure - 1e-5 * temperature


def raises(pressure: float, speed: float, temperature: float) -> float:
    if temperature > 25.0:
        msg = "too hot"
        raise ValueError(msg)
    return 0.05


def divides(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if temperature < 25.0 else 1.0 / (temperature - temperature)


def is_infinite(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if temperature < 25.0 else np.inf


def is_nan(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if temperature < 25.0 else math.nan


DOORS = {
    "respond": lambda law: dcfp.respond(dcfp.load_motion("NCC"), friction=law),
    "pulses": lambda law: dcfp.march_through_pulses(dcfp.load_motion("NCC"), friction=law),
    "test": lambda law: dcfp.run_program(dcfp.load_program("asce"), friction=law),
    "building": lambda law: respond_in_one_direction(
        shear_building(1, 0.5, dcfp.System(friction=law)), dcfp.load_motion("NCC")
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("door", DOORS)
@pytest.mark.parametrize("law", [raises, divides, is_infinite, is_nan])
def test_a_law_without_a_number_is_named_at_once(law, door: str) -> None:
    with pytest.raises(AnalysisError, match=rf"no finite number; look at the friction law '{law.__name__}'"):
        DOORS[door](UserFriction(law))


def test_the_time_and_the_label_are_told() -> None:
    with pytest.raises(AnalysisError, match=r"^NCC at 4\.26 s: .* law 'my law'"):
        dcfp.respond(dcfp.load_motion("NCC"), friction=UserFriction(raises, "my law"))


@pytest.mark.slow
@pytest.mark.parametrize("door", DOORS)
def test_a_law_travels_as_a_function(door: str) -> None:
    law = pickle.loads(pickle.dumps(UserFriction(slow_rise, "slow")))
    assert law == UserFriction(slow_rise, "slow")
    DOORS[door](law)


def test_a_law_under_numba_keeps_its_options() -> None:
    fast = UserFriction(numba.njit(fastmath=True)(slow_rise))
    assert float(fast.coefficient(60.0, 100.0, 20.0)) == pytest.approx(0.04086)


def with_constants(constants, pressure: float, speed: float, temperature: float, cycling: float) -> float:
    return constants[0] * (1.0 - constants[1] * speed) + constants[5] * cycling + 0.0 * pressure * temperature


@declared
class OwnLaw(FrictionLaw):
    """A law with constants of its own, by address."""

    name = "own"

    def at_pressure(self, pressure: float) -> Law:
        return law_by_address(
            compile_law(with_constants, None).address, (0.001 * pressure, 1e-4, 0.0, 0.0, 0.0, 1e-9)
        )


@pytest.mark.slow
def test_a_law_by_address_sees_its_constants_and_the_cycling_parameter() -> None:
    law = OwnLaw().at_pressure(60.0)
    assert coefficient(law, 60.0, 100.0, 20.0, 1e6) == pytest.approx(0.06 * 0.99 + 1e-3, rel=1e-14)
    response = dcfp.respond(dcfp.load_motion("NCC"), friction=OwnLaw())
    assert response.friction.max() > 0.06


def of_pressure(pressure: float, speed: float, temperature: float) -> float:
    if pressure > 100.0:
        msg = "too much"
        raise ValueError(msg)
    return (0.05 + 1e-5 * speed - 1e-5 * temperature) * (pressure / 60.0) ** -0.19 / math.log(pressure)


@pytest.fixture(scope="module")
def anywhere() -> CompiledLaw:
    """A law compiled for no pressure."""
    return compile_law(of_pressure, None)


# at 60 the compiler knows a part to be 1, at 120 that there is no number
@pytest.mark.slow
@pytest.mark.parametrize("usual", [60.0, 73.1, 120.0])
def test_a_law_made_for_one_pressure_holds_at_any(anywhere: CompiledLaw, usual: float) -> None:
    there = compile_law(of_pressure, None, usual)
    for pressure in (40.0, 60.0, 73.1, 120.0):
        for speed, temperature in ((0.0, 20.0), (123.4, 56.7), (800.0, 300.0)):
            values = (law(pressure, speed, temperature) for law in (anywhere, there))
            np.testing.assert_array_equal(*values)


def test_the_pressure_that_is_asked_for_first_counts() -> None:
    law = UserFriction(slow_rise)
    assert law.at_pressure(60.0) == law.at_pressure(40.0) == UserFriction(slow_rise).at_pressure(30.0)
    first = coefficient(law.at_pressure(60.0), 40.0, 100.0, 20.0, 0.0)
    assert first == float(law.coefficient(40.0, 100.0, 20.0))


def test_under_fast_mathematics_no_pressure_counts() -> None:
    """A number that the compiler knows would change the last digit there."""
    law = UserFriction(numba.njit(fastmath=True)(of_pressure))
    speeds = np.linspace(0.0, 800.0, 100)
    found = [coefficient(law.at_pressure(60.0), 60.0, speed, 56.7, 0.0) for speed in speeds]
    np.testing.assert_array_equal(found, law.coefficient(60.0, speeds, 56.7))


SCRIPT = """
import dcfp
from {module} import mu
law = dcfp.UserFriction(mu)
callback = law._compiled._callback
print(float(law.coefficient(60.0, 100.0, 20.0)), getattr(callback, "cache_hits", 0))
"""
OWN_MODULE = """
import math
import numpy as np
from numba import njit
{imports}
FACTOR = {factor}
@njit
def rise(speed):
    return 1.0 - 0.5 * math.exp(-0.02 * speed)
def mu(pressure, speed, temperature):
    return FACTOR * rise(speed) * np.exp(-0.001 * temperature){extra}
"""


def answers(folder: Path, module: str = "laws") -> tuple[float, int]:
    """Return what a new process says of the law in a module, and how often its code came from the disk."""
    value, hits = output(SCRIPT.format(module=module), folder, dict(os.environ)).split()
    return float(value), int(hits)


def value_of(factor: float) -> float:
    return factor * (1.0 - 0.5 * math.exp(-2.0)) * math.exp(-0.02)


@pytest.mark.slow
def test_the_code_of_a_law_is_kept_until_the_law_is_edited(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("DCFP_CACHE_DIR", str(tmp_path / "cache"))
    source = tmp_path / "laws.py"
    source.write_text(OWN_MODULE.format(imports="", factor=0.06, extra=""))
    assert answers(tmp_path) == (pytest.approx(value_of(0.06)), 0)
    assert answers(tmp_path) == (pytest.approx(value_of(0.06)), 1)
    source.write_text(OWN_MODULE.format(imports="", factor=0.07, extra=""))
    assert answers(tmp_path) == (pytest.approx(value_of(0.07)), 0)
    # a value that the law takes from elsewhere, and code that it takes from elsewhere
    source.write_text(OWN_MODULE.format(imports="from other import SCALE, halved", factor="SCALE", extra=""))
    other = "SCALE = {}\nfrom numba import njit\n@njit\ndef halved(x):\n    return {} * x\n"
    (tmp_path / "other.py").write_text(other.format(0.06, 0.5))
    assert answers(tmp_path)[1] == 1
    (tmp_path / "other.py").write_text(other.format(0.05, 0.5))
    assert answers(tmp_path) == (pytest.approx(value_of(0.05)), 0)
    source.write_text(
        OWN_MODULE.format(imports="from other import halved", factor=0.06, extra=" + halved(0.01)")
    )
    assert answers(tmp_path) == (pytest.approx(value_of(0.06) + 0.005), 0)
    (tmp_path / "other.py").write_text(other.format(0.05, 0.4))
    assert answers(tmp_path) == (pytest.approx(value_of(0.06) + 0.004), 0)
