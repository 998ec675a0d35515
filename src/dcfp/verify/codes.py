"""Spectra and the methods of codes: an independent integration, published iterations, closed forms against numerical roots."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy import linalg, optimize, signal

from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.methods import aij_2016, asce_2016
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.spectra import TabulatedSpectrum, input_energy_spectrum, response_spectrum
from dcfp.motion import treatment
from dcfp.verify.check import Found, scaled_record

_INCH = 25.4
#: Periods of the check [s], and by how much the record's step is divided for it.
_PERIODS = np.array([0.1, 0.3, 1.0, 3.0, 6.0])
_FINER = 20

_optimize: Any = optimize
_signal: Any = signal
_linalg: Any = linalg


def _simulated(name: str) -> FloatArray:
    """Largest displacement of oscillators by another program's simulation of a linear system, in a twentieth of the record's step."""
    motion = treatment.resample(scaled_record(name, 500.0), _FINER)
    # all oscillators as one system, since a call of lsim goes through the samples in Python
    states = [np.array([[0.0, 1.0], [-(omega**2), -0.1 * omega]]) for omega in 2.0 * np.pi / _PERIODS]
    count = len(states)
    system = _signal.StateSpace(
        _linalg.block_diag(*states),
        np.tile([[0.0], [-1.0]], (count, 1)),
        np.kron(np.eye(count), [1.0, 0.0]),
        np.zeros((count, 1)),
    )
    _, displacement, _ = _signal.lsim(system, motion.acceleration, motion.time)
    return np.abs(displacement).max(axis=0)


def spectrum(record: str) -> dict[str, float]:
    """Return the relative differences of the response spectrum [-] by periods [s]."""
    found = response_spectrum(scaled_record(record, 500.0), _PERIODS)
    off = found.displacement / _simulated(record) - 1.0
    return {f"{period:g}": float(one) for period, one in zip(_PERIODS, off, strict=True)}


def input_energy(record: str) -> float:
    """Return the largest difference of what was put in and what is there at the end over the largest input [-]."""
    motion = scaled_record(record, 500.0)
    found = input_energy_spectrum(motion, _PERIODS, 0.0)
    kept: list[float] = []
    for one in (2.0 * np.pi / _PERIODS).tolist():
        system = _signal.StateSpace(
            [[0.0, 1.0], [-(one**2), 0.0]], [[0.0], [-1.0]], [[one, 0.0], [0.0, 1.0]], [[0.0], [0.0]]
        )
        _, last, _ = _signal.lsim(system, motion.acceleration, motion.time)
        kept.append(0.5 * float((last[-1] ** 2).sum()))
    return float(np.abs(found.final - np.array(kept)).max() / found.relative.max())


@dataclass(frozen=True)
class _ConstantVelocity:
    """A spectrum S_1 / T at every period, of S_1 in units of gravity."""

    one_second: float
    name: str = "S_1 / T"
    unconfirmed: tuple[str, ...] = ()

    def acceleration(self, period: ArrayLike) -> FloatArray:
        return np.asarray(self.one_second / np.asarray(period, dtype=np.float64) * STANDARD_GRAVITY)


def printed_iteration(one_second: float, expected: float) -> Found:
    """Return the displacement of the iteration, and the one that is printed [in]."""
    pendulum = PendulumWithFriction(152.0 * _INCH, 13.36 / 152.0)
    # the printed rounds are of a spectrum S_1 / T throughout, and of g = 386.4 in/s2: D is as the root of g times S_1
    scaled = one_second * math.sqrt(386.4 * _INCH / STANDARD_GRAVITY)
    found = asce_2016.equivalent_lateral_force(pendulum, _ConstantVelocity(scaled))
    words = {"scaled": scaled, "ours": found.period or 0.0, "ours_damping": found.damping or 0.0}
    return Found(found.displacement / _INCH, expected, words=words)


def energy_balance() -> float:
    """Return the largest relative difference from the numerical root of nine cases [-]."""
    worst = 0.0
    for friction in (0.01, 0.043, 0.1):
        for velocity in (200.0, 800.0, 3000.0):
            found = aij_2016.energy_balance(PendulumWithFriction(9000.0, friction), velocity)

            def residual(at: float, mu: float = friction, v_e: float = velocity) -> float:
                g = STANDARD_GRAVITY
                return 0.5 * g / 9000.0 * at**2 + 8.0 * mu * g * at - 0.5 * v_e**2

            root = float(_optimize.brentq(residual, 1e-9, 1e6, xtol=1e-12, rtol=1e-15))
            worst = max(worst, abs(found.displacement / root - 1.0))
    return worst


def two_methods() -> tuple[float, float]:
    """Return the displacements of methods 2 and 1 of the AIJ [mm]."""
    pendulum = PendulumWithFriction(9000.0, 0.043)
    periods = np.geomspace(0.01, 100.0, 20)
    level = 800.0
    spectrum = TabulatedSpectrum(periods, level * 2.0 * np.pi / periods)
    iterated = aij_2016.method_1(pendulum, spectrum).displacement
    return aij_2016.method_2(pendulum, level).displacement, iterated
