"""The horizontal elastic spectrum of Eurocode 8: EN 1998-1:2004, section 3.2.2.2, Tables 3.2 and 3.3."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.checks import positive

#: S [-], T_B, T_C and T_D [s] of every ground type: Table 3.2 (type 1) and Table 3.3 (type 2).
TABLES: dict[int, dict[str, tuple[float, float, float, float]]] = {
    1: {
        "A": (1.0, 0.15, 0.4, 2.0),
        "B": (1.2, 0.15, 0.5, 2.0),
        "C": (1.15, 0.20, 0.6, 2.0),
        "D": (1.35, 0.20, 0.8, 2.0),
        "E": (1.4, 0.15, 0.5, 2.0),
    },
    2: {
        "A": (1.0, 0.05, 0.25, 1.2),
        "B": (1.35, 0.05, 0.25, 1.2),
        "C": (1.5, 0.10, 0.25, 1.2),
        "D": (1.8, 0.10, 0.30, 1.2),
        "E": (1.6, 0.05, 0.25, 1.2),
    },
}
#: Plateau over the ground acceleration [-]: Eqs (3.2) to (3.5).
_PLATEAU = 2.5


@dataclass(frozen=True)
class Eurocode8Spectrum:
    """Four branches: rising, constant acceleration, constant velocity, constant displacement.

    Parameters
    ----------
    ground_acceleration
        a_g on ground type A, with the importance factor [mm/s2].
    ground
        Ground type, ``"A"`` to ``"E"``.
    kind
        1 for regions of large earthquakes, 2 where those that matter are below M_s 5.5.

    Notes
    -----
    The code gives the spectrum up to 4 s; beyond, the displacement is kept constant here, which is on the safe side of its Annex A.

    Raises
    ------
    InputError
        If there is no such ground type or spectrum, or the acceleration is not positive.
    """

    ground_acceleration: float
    ground: str = "B"
    kind: int = 1
    unconfirmed: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        positive(self.ground_acceleration, "ground acceleration a_g", "mm/s2")
        if self.kind not in TABLES:
            msg = f"Eurocode 8 has a spectrum of type 1 and one of type 2, not {self.kind!r}."
            raise InputError(msg)
        if self.ground not in TABLES[self.kind]:
            msg = f"The ground types of Eurocode 8 are {', '.join(TABLES[self.kind])}, not {self.ground!r}."
            raise InputError(msg)

    @property
    def name(self) -> str:
        """What to call it."""
        return (
            f"Eurocode 8 type {self.kind}, ground {self.ground}, a_g {self.ground_acceleration / 1e3:g} m/s²"
        )

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration S_e at a damping of 5 % [mm/s2] at a period [s]: Eqs (3.2)-(3.5)."""
        T = np.maximum(np.asarray(period, dtype=np.float64), 1e-9)
        S, T_B, T_C, T_D = TABLES[self.kind][self.ground]
        rising = 1.0 + T / T_B * (_PLATEAU - 1.0)
        falling = _PLATEAU * T_C / T
        shape = np.where(
            T < T_B, rising, np.where(T <= T_C, _PLATEAU, np.where(T <= T_D, falling, falling * T_D / T))
        )
        return np.asarray(self.ground_acceleration * S * shape)
