"""Friction that depends on pressure, velocity and temperature, with constants from tests of a bearing."""

import math
from typing import Annotated, ClassVar

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Expression, number
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import DEGC, MM_PER_S, N_PER_MM2, NONE, PER_DEGC, S_PER_MM
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import Factor, FrictionLaw, Tested, coefficient_parameter

#: Temperature at which Eq. (9) of Li et al. (2020) is one [degC].
REFERENCE_TEMPERATURE = math.log(li_2020.BETA_SCALE) / li_2020.BETA_RATE


@declared
class FittedFriction(FrictionLaw):
    r"""The form of the law of Li et al. (2020) with free constants, :math:`\mu = \mu_0 \gamma \alpha \beta`.

    .. math:: \gamma = (1 - c)\,(p / p_{ref})^{-n} + c, \quad
              \alpha = 1 - a\,e^{-b |v|}, \quad
              \beta = e^{-r\,(T - T_{ref})}

    Parameters
    ----------
    speed_rate
        b [s/mm], for the relative speed of the plates.

    Notes
    -----
    The defaults restate Eqs (7)-(10) of Li et al. (2020), whose factor of pressure is 1.0005 at 60 N/mm2, within 0.06 % from 20 to 120 N/mm2.
    `dcfp identify` writes a bearing file with the constants of a bearing that was tested.
    """

    name: ClassVar[str] = "fitted"
    words: ClassVar[str] = "fitted to tests, in the form of Li et al. (2020)"
    citation: ClassVar[str] = "li_2020"
    reference_parameter: ClassVar[str] = "mu_0"

    mu_0: Annotated[
        float,
        coefficient_parameter("coefficient at the reference pressure and temperature and at high speed"),
    ] = li_2020.MU_0
    pressure_exponent: Annotated[
        float, Parameter("exponent of the pressure", NONE, 0.0, 5.0, symbol="n", step=0.01)
    ] = -li_2020.GAMMA_POWER
    pressure_floor: Annotated[
        float,
        Parameter(
            "part of the coefficient that no pressure takes away", NONE, 0.0, 1.0, symbol="c", step=0.01
        ),
    ] = li_2020.GAMMA_FLOOR
    reference_pressure: Annotated[
        float, Parameter("reference pressure", N_PER_MM2, 0.1, 1000.0, symbol=r"p_{\mathrm{ref}}", step=1.0)
    ] = 60.0
    speed_drop: Annotated[
        float,
        Parameter(
            "part of the coefficient that is missing at zero speed", NONE, 0.0, 0.999, symbol="a", step=0.01
        ),
    ] = li_2020.ALPHA_DROP
    speed_rate: Annotated[
        float,
        Parameter("rate of the velocity factor", S_PER_MM, 0.0, 10.0, symbol="b", above=True, step=0.001),
    ] = li_2020.ALPHA_RATE
    temperature_rate: Annotated[
        float, Parameter("rate of the temperature factor", PER_DEGC, 0.0, 0.2, symbol="r", step=0.001)
    ] = li_2020.BETA_RATE
    reference_temperature: Annotated[
        float, Parameter("reference temperature", DEGC, -60.0, 1000.0, symbol=r"T_{\mathrm{ref}}", step=1.0)
    ] = REFERENCE_TEMPERATURE
    tested_pressure: Annotated[
        tuple[float, float] | None,
        Parameter("smallest and largest pressure of the tests", N_PER_MM2, 0.0, 1000.0, vary=False),
    ] = None
    tested_speed: Annotated[
        tuple[float, float] | None,
        Parameter("smallest and largest speed of the tests", MM_PER_S, 0.0, 1e5, vary=False),
    ] = None
    tested_ambient: Annotated[
        float | None, Parameter("temperature before the tests", DEGC, -60.0, 200.0, vary=False)
    ] = None

    def check_relations(self) -> None:
        """Refuse ranges of tests that are not in order."""
        for name in ("tested_pressure", "tested_speed"):
            pair = getattr(self, name)
            if pair is not None and pair[0] > pair[1]:
                msg = f"{name} must be the smallest and the largest value in this order, not {pair!r}."
                raise InputError(msg)

    def tests(self) -> Tested | None:
        """Return the tests that the constants rest on, if the law says which."""
        if self.tested_pressure is None or self.tested_speed is None:
            return None
        return Tested(
            self.tested_pressure, self.tested_speed, "the tests it was fitted to", self.tested_ambient
        )

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        return exponential_law(
            self.mu_0 * float(self.pressure_factor(pressure)),
            self.speed_drop,
            self.speed_rate,
            math.exp(self.temperature_rate * self.reference_temperature),
            self.temperature_rate,
            0.0,
        )

    def factors(self) -> tuple[Factor, ...]:
        """Return the three factors."""
        of_pressure = {
            "c": ("c", f"{self.pressure_floor:g}"),
            "n": ("n", f"{self.pressure_exponent:g}"),
            "ref": ('p_"ref"', f"{self.reference_pressure:g}"),
        }
        of_speed = {"a": ("a", f"{self.speed_drop:g}"), "b": ("b", f"{self.speed_rate:g}")}
        of_temperature = {
            "r": ("r", f"{self.temperature_rate:g}"),
            "ref": ('T_"ref"', number(self.reference_temperature, 2)),
        }
        gamma = Expression("(1 - {c}) ({x} / {ref})^(-{n}) + {c}", "p", of_pressure)
        alpha = Expression("1 - {a} exp(-{b}{dot}{x})", "v", of_speed)
        beta = Expression("exp(-{r} ({x} - {ref}))", "T", of_temperature)
        return (
            Factor("pressure", "gamma", gamma, self._of_pressure),
            Factor("speed", "alpha", alpha, self._of_speed),
            Factor("temperature", "beta", beta, self._of_temperature),
        )

    def _of_pressure(self, pressure: FloatArray) -> FloatArray:
        ratio = pressure / self.reference_pressure
        return (1.0 - self.pressure_floor) * ratio**-self.pressure_exponent + self.pressure_floor

    def _of_speed(self, speed: FloatArray) -> FloatArray:
        return 1.0 - self.speed_drop * np.exp(-self.speed_rate * np.abs(speed))

    def _of_temperature(self, temperature: FloatArray) -> FloatArray:
        return np.exp(-self.temperature_rate * (temperature - self.reference_temperature))
