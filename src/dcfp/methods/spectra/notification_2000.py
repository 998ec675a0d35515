"""The very rare earthquake of the Japanese notifications 1457 and 1461 (2000) and 2009 (2000).

The notifications themselves were not read. The spectrum on the bedrock agrees in three public programs (the calculation basis of matsumok/Squid-N, a
``soil.py`` and a ``japan.js``), the amplification of all soil classes in the last two. Published points of class 1, and one of class 2, are in the tests.
"""

from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.methods.spectra.elastic import DesignSpectrum
from dcfp.schema.parameters import Parameter, declared
from dcfp.schema.units import NONE

_METRES = 1000.0
#: Corner periods [s] and levels [m/s2] of the spectrum on the engineering bedrock.
_RISE_END, _PLATEAU_END, _AT_ZERO, _SLOPE, _PLATEAU, _FALL = 0.16, 0.64, 3.2, 30.0, 8.0, 5.12
#: Amplification of soil class 1: largest, where it begins to fall [s], and least.
_CLASS_1 = (1.5, 0.576, 1.35)
#: Of classes 2 and 3: largest at short periods, and at long ones.
_SHORT, _LONG = 1.5, {2: 2.025, 3: 2.7}


@declared
class Notification2000Spectrum(DesignSpectrum):
    """Spectrum on the engineering bedrock times the amplification of the soil.

    Parameters
    ----------
    soil
        Class 1 (hard), 2 or 3 (soft).
    zone
        Zone factor Z [-].
    level
        1 for the very rare earthquake, 0.2 for the rare one [-].
    """

    noun = "a spectrum of Notification 1457"
    option: ClassVar[str] = "japan"
    words: ClassVar[str] = "very rare earthquake of Notification 1457 on soil class 1, 2 or 3"

    soil: Annotated[int, Parameter("soil class", NONE, 1, 3)] = 2
    zone: Annotated[float, Parameter("zone factor", NONE, 0.1, 10.0, symbol="Z", option=False)] = 1.0
    level: Annotated[
        float, Parameter("level, 0.2 for the rare earthquake", NONE, 0.01, 10.0, option=False)
    ] = 1.0

    @property
    def name(self) -> str:
        """What to call it."""
        return f"Notification 1457, soil {self.soil}"

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration at a damping of 5 % [mm/s2] at a period [s]."""
        T = np.maximum(np.asarray(period, dtype=np.float64), 1e-9)
        rising = _AT_ZERO + _SLOPE * T
        bedrock = np.where(T < _RISE_END, rising, np.where(T < _PLATEAU_END, _PLATEAU, _FALL / T))
        return np.asarray(self.level * self.zone * bedrock * self.amplification(T) * _METRES)

    def amplification(self, period: FloatArray) -> FloatArray:
        """Amplification G_s of the soil [-] at a period [s]."""
        T = period
        if self.soil == 1:
            most, begins, least = _CLASS_1
            return np.asarray(np.clip(most * begins / T, least, most))
        return np.asarray(np.clip(_SHORT * T / _PLATEAU_END, _SHORT, _LONG[self.soil]))
