"""Numbers that Li et al. (2020) print, against what the package makes of the formulas beside them."""

from collections.abc import Callable
from functools import partial

from dcfp.constants import STANDARD_GRAVITY
from dcfp.system import LI_2020
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT
from dcfp.system.friction.li_2020 import pressure_factor, temperature_factor, velocity_factor
from dcfp.verify.check import Finding, Task, record

GROUP = "Published numbers"
_PAPER = "Li et al. (2020)"
_DIGITS = "Allowed: half of the last printed digit."

#: PGV of the records as printed [mm/s]: Li et al. (2020), Table 3.
_PRINTED_VELOCITIES = {"NCC": 449.0, "KNA": 373.0, "LPG": 447.0, "IVD": 330.0}


def _printed(
    value: Callable[[], float], expected: float, unit: str, last_digit: float, place: str
) -> Finding:
    return Finding(value(), expected, unit, 0.5 * last_digit, _DIGITS, f"{_PAPER}, {place}")


def _nominal_deceleration() -> Finding:
    note = "The paper's 421.8 is 0.043 x 9810; the package takes standard gravity, 9806.65 mm/s2, which is 0.034 % less."
    source = f"{_PAPER}, section 6.2"
    return Finding(NOMINAL_COEFFICIENT * STANDARD_GRAVITY, 421.8, "mm/s2", 5e-4, note, source, relative=True)


def _yield_displacement() -> Finding:
    value = NOMINAL_COEFFICIENT * LI_2020.vertical_force / LI_2020.elastic_stiffness
    # 0.043 x 7.540e6 N / 1900e3 N/mm by hand, from the printed N and kf
    return Finding(value, 0.1706, "mm", 5e-5, _DIGITS, f"{_PAPER}, section 5.1: r_f = mu N / kf")


def _recorded_velocity(name: str, expected: float) -> Finding:
    note = "Allowed: half of the last printed digit, and the 0.034 % between g = 9810 and 9806.65 mm/s2."
    limit = 0.5 + 3.4e-4 * expected
    return Finding(record(name).peak_velocity, expected, "mm/s", limit, note, f"{_PAPER}, Table 3")


def _task(
    name: str, value: Callable[[], float], expected: float, unit: str, last_digit: float, place: str
) -> Task:
    return Task(GROUP, name, partial(_printed, value, expected, unit, last_digit, place))


TASKS = (
    _task("pressure factor at 60 N/mm2", lambda: float(pressure_factor(60.0)), 1.000, "-", 1e-3, "Eq. (7)"),
    _task("velocity factor at 400 mm/s", lambda: float(velocity_factor(400.0)), 0.9997, "-", 1e-4, "Eq. (8)"),
    _task(
        "temperature factor at 17.5 degC", lambda: float(temperature_factor(17.5)), 1.0, "-", 1e-2, "Eq. (9)"
    ),
    _task("vertical force N", lambda: LI_2020.vertical_force / 1e6, 7.540, "MN", 1e-3, "section 5.1"),
    _task(
        "pendulum stiffness kra",
        lambda: LI_2020.restoring_stiffness / 1e3,
        0.838,
        "kN/mm",
        1e-3,
        "section 5.1",
    ),
    _task("period of the pendulum", lambda: LI_2020.period, 6.02, "s", 1e-2, "section 5.1"),
    _task("mass m", lambda: LI_2020.mass, 768.8, "t", 0.1, "section 5.1"),
    _task("half side of the contact", lambda: LI_2020.contact_half_side, 177.0, "mm", 1.0, "section 4.2"),
    Task(GROUP, "radius of the yield surface", _yield_displacement),
    Task(GROUP, "deceleration mu_n g", _nominal_deceleration),
    *(
        Task(GROUP, f"PGV of {name}", partial(_recorded_velocity, name, velocity))
        for name, velocity in _PRINTED_VELOCITIES.items()
    ),
)
