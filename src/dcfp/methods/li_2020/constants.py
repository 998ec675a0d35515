"""Constants of the prediction of Li et al. (2020), section 6."""

import math
from dataclasses import dataclass

from dcfp.errors import InputError
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT


@dataclass(frozen=True)
class Constants:
    """What the three methods of Li et al. (2020) take as given.

    Parameters
    ----------
    nominal_friction
        mu_n [-], section 4.4.
    gravity
        g [mm/s2]; the paper's figures are those of 9810.
    amplification
        Factor on velocities and slopes of a pulse with ku/kg from `amplified_from` to 1 [-]; Figure 17.
    amplified_from
        Ratio ku/kg from which on a pulse is amplified [-].
    fall_ratio
        eps, Eq. (26) [-]: slope after a peak over that before it.
    average_slope
        kg_ave, Eq. (28) [mm/s2]: mean slope of the pulse of the largest displacement, at `reference_pgv`.
    reference_pgv
        PGV to which `average_slope` belongs, Eq. (30) [mm/s].
    change_ratio
        zeta, Eq. (29) [-]: velocity change of the largest pulse over PGV.

    Raises
    ------
    InputError
        If a value is not positive, or the friction is not below one.
    """

    nominal_friction: float = NOMINAL_COEFFICIENT
    gravity: float = 9810.0
    amplification: float = 1.5
    amplified_from: float = 0.8
    fall_ratio: float = 0.25
    average_slope: float = 930.0
    reference_pgv: float = 250.0
    change_ratio: float = 1.5

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not (math.isfinite(value) and value > 0.0):
                msg = f"The constant {name} of the prediction must be positive, not {value!r}."
                raise InputError(msg)
        if self.nominal_friction >= 1.0:
            msg = f"The nominal coefficient of friction must lie between 0 and 1, not {self.nominal_friction!r}."
            raise InputError(msg)

    @property
    def friction_deceleration(self) -> float:
        """mu_n g [mm/s2]."""
        return self.nominal_friction * self.gravity

    @property
    def slides_on_average(self) -> bool:
        """Whether mu_n g is below kg_ave, as the simplified and the design method need."""
        return self.friction_deceleration < self.average_slope


#: The paper's own.
LI_2020 = Constants()
