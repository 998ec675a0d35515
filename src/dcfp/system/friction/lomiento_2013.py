"""Friction that depends on load, velocity and the dose of rubbing: after Lomiento, Bonessio and Benzoni (2013).

*Unconfirmed*: the form is that by which later work describes the model (one scalar for cycling, no temperature); neither the equations
nor calibrated constants could be read in the paper itself. Constants therefore are this package's own; see `Lomiento2013`.
"""

import math
from typing import Annotated, ClassVar

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, cycling_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Expression
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import MM_PER_S, N_PER_MM2, N_PER_S, NONE
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import Factor, FrictionLaw, Tested, coefficient_parameter


@declared
class Lomiento2013(FrictionLaw):
    r"""Law after Lomiento et al. (2013), :math:`\mu = \mu_0 f_N f_v f_c`. *Unconfirmed*.

    .. math:: f_N = e^{-N / N_{ref}}, \quad f_v = \gamma + (1 - \gamma)\,e^{-|v| / v_{ref}}, \quad
              f_c = e^{-(c / c_{ref})^\beta} \ \text{with}\ c = \int p\,v^2\,dt

    The load is a pressure p, so that it holds for every size of slider, and v the speed of the slider on the plate; a factor before the
    integral would go into c_ref.

    Notes
    -----
    What wears off does not come back: there is no cooling, so the law is for one strong motion. It knows no temperature; a heating model
    beside it only reports one. The defaults restate the law of Li et al. (2020): its pressure factor from 40 to 80 N/mm2 within 1.1 %, its velocity factor, and
    for the cycling effect a fit to the friction at zero displacement in its dependency test T01 (precise model, four cycles; within 0.9 %).
    """

    name: ClassVar[str] = "lomiento2013"
    words: ClassVar[str] = "Lomiento et al. (2013), unconfirmed"
    citation: ClassVar[str] = "lomiento_2013"
    reference_parameter: ClassVar[str] = "mu_0"
    speed_is_of_surface: ClassVar[bool] = True
    tested: ClassVar[Tested | None] = Tested(
        (40.0, 80.0), (0.0, 400.0), "the range in which its constants restate Li et al. 2020", 20.0
    )
    caution: ClassVar[str] = (
        "its form is unconfirmed and its constants are this package's own; what has worn off never recovers."
    )

    mu_0: Annotated[float, coefficient_parameter("coefficient of a slow first motion under no load")] = (
        0.45 * li_2020.MU_0 * math.exp(60.0 / 325.6)
    )
    reference_pressure: Annotated[
        float,
        Parameter(
            "reference load, as a pressure", N_PER_MM2, 1.0, 1e5, symbol=r"N_{\mathrm{ref}}", step=10.0
        ),
    ] = 325.6
    velocity_ratio: Annotated[
        float, Parameter("fast coefficient over the slow one", NONE, 0.1, 100.0, symbol=r"\gamma", step=0.1)
    ] = 1.0 / 0.45
    reference_speed: Annotated[
        float,
        Parameter(
            "reference speed of the slider on a plate",
            MM_PER_S,
            0.1,
            1e4,
            symbol=r"v_{\mathrm{ref}}",
            step=1.0,
        ),
    ] = 0.5 / li_2020.ALPHA_RATE
    reference_dose: Annotated[
        float,
        Parameter(
            "reference of the cycling parameter", N_PER_S, 1e3, 1e15, symbol=r"c_{\mathrm{ref}}", step=1e6
        ),
    ] = 2.1e7
    dose_power: Annotated[
        float, Parameter("power of the cycling parameter", NONE, 0.1, 3.0, symbol=r"\beta", step=0.01)
    ] = 0.28

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        fast = self.mu_0 * float(self.pressure_factor(pressure)) * self.velocity_ratio
        return cycling_law(
            fast,
            1.0 - 1.0 / self.velocity_ratio,
            1.0 / self.reference_speed,
            1.0 / self.reference_dose,
            self.dose_power,
        )

    def factors(self) -> tuple[Factor, ...]:
        """Return the three factors."""
        pressure, speed, dose = (
            {"ref": (f'{symbol}_"ref"', f"{value:g}")}
            for symbol, value in (
                ("p", self.reference_pressure),
                ("v", self.reference_speed),
                ("c", self.reference_dose),
            )
        )
        ratio = {"ratio": ("gamma", f"{self.velocity_ratio:g}")}
        power = {"power": ("beta", f"{self.dose_power:g}")}
        of_speed = Expression("{ratio} + (1 - {ratio}) exp(-{x} / {ref})", "v", speed | ratio)
        return (
            Factor("pressure", "f_N", Expression("exp(-{x} / {ref})", "p", pressure), self._of_load),
            Factor("speed", "f_v", of_speed, self._of_speed),
            Factor(
                "dose", "f_c", Expression("exp(-({x} / {ref})^{power})", "c", dose | power), self._of_dose
            ),
        )

    def _of_load(self, pressure: FloatArray) -> FloatArray:
        return np.exp(-pressure / self.reference_pressure)

    def _of_speed(self, speed: FloatArray) -> FloatArray:
        fall = np.exp(-np.abs(speed) / self.reference_speed)
        return self.velocity_ratio + (1.0 - self.velocity_ratio) * fall

    def _of_dose(self, dose: FloatArray) -> FloatArray:
        return np.exp(-((dose / self.reference_dose) ** self.dose_power))
