"""Spectra and the methods of codes: an independent integration, published iterations, closed forms against numerical roots."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
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
from dcfp.verify.check import Finding, Task, scaled_record

GROUP = "Spectra and codes"
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


def _spectrum(name: str) -> Finding:
    motion = scaled_record(name, 500.0)
    expected = _simulated(name)
    off = response_spectrum(motion, _PERIODS).displacement / expected - 1.0
    worst = int(np.argmax(np.abs(off)))
    note = f"Largest relative difference of five periods, at {_PERIODS[worst]:g} s. Allowed: half of what was aimed at, 0.5 %."
    return Finding(float(off[worst]), 0.0, "-", 2.5e-3, note, "scipy.signal.lsim in a twentieth of the step")


def _energy(name: str) -> Finding:
    motion = scaled_record(name, 500.0)
    found = input_energy_spectrum(motion, _PERIODS, 0.0)
    omega = 2.0 * np.pi / _PERIODS
    kept: list[float] = []
    for one in omega.tolist():
        system = _signal.StateSpace(
            [[0.0, 1.0], [-(one**2), 0.0]], [[0.0], [-1.0]], [[one, 0.0], [0.0, 1.0]], [[0.0], [0.0]]
        )
        _, last, _ = _signal.lsim(system, motion.acceleration, motion.time)
        kept.append(0.5 * float((last[-1] ** 2).sum()))
    gap = float(np.abs(found.final - np.array(kept)).max() / found.relative.max())
    note = "Undamped: what was put in is there at the end as kinetic and strain energy. Allowed: rounding over thousands of steps."
    return Finding(gap, 0.0, "-", 1e-8, note, "scipy.signal.lsim, the exact discrete system")


@dataclass(frozen=True)
class _ConstantVelocity:
    """A spectrum S_1 / T at every period, of S_1 in units of gravity."""

    one_second: float
    name: str = "S_1 / T"
    unconfirmed: tuple[str, ...] = ()

    def acceleration(self, period: ArrayLike) -> FloatArray:
        return np.asarray(self.one_second / np.asarray(period, dtype=np.float64) * STANDARD_GRAVITY)


def _printed_iteration(one_second: float, displacement: float, period: float, damping: float) -> Finding:
    pendulum = PendulumWithFriction(152.0 * _INCH, 13.36 / 152.0)
    # the printed rounds are of a spectrum S_1 / T throughout, and of g = 386.4 in/s2: D is as the root of g times S_1
    one_second *= math.sqrt(386.4 * _INCH / STANDARD_GRAVITY)
    found = asce_2016.equivalent_lateral_force(pendulum, _ConstantVelocity(one_second))
    note = (
        f"R 152 in, mu 0.0879, S_1 {one_second:.4g} g (for g = 386.4 in/s2). Printed with it: T {period:g} s and beta {damping:g}; ours"
        f" {found.period or 0.0:.3f} s and {found.damping or 0.0:.3f}. Allowed: one unit of the last printed digit."
    )
    source = "calculation report of a public repository (mjamiv/isolation), nominal rows"
    return Finding(found.displacement / _INCH, displacement, "in", 1e-3, note, source)


def _balance() -> Finding:
    worst = 0.0
    for friction in (0.01, 0.043, 0.1):
        for velocity in (200.0, 800.0, 3000.0):
            pendulum = PendulumWithFriction(9000.0, friction)
            found = aij_2016.energy_balance(pendulum, velocity)

            def residual(at: float, mu: float = friction, v_e: float = velocity) -> float:
                g = STANDARD_GRAVITY
                return 0.5 * g / 9000.0 * at**2 + 8.0 * mu * g * at - 0.5 * v_e**2

            root = float(_optimize.brentq(residual, 1e-9, 1e6, xtol=1e-12, rtol=1e-15))
            worst = max(worst, abs(found.displacement / root - 1.0))
    note = "Largest relative difference of nine cases. Allowed: rounding."
    return Finding(worst, 0.0, "-", 1e-12, note, "numerical root of k D^2/2 + 8 mu W D = M V_E^2/2")


def _two_methods() -> Finding:
    pendulum = PendulumWithFriction(9000.0, 0.043)
    periods = np.geomspace(0.01, 100.0, 20)
    level = 800.0
    spectrum = TabulatedSpectrum(periods, level * 2.0 * np.pi / periods)
    iterated = aij_2016.method_1(pendulum, spectrum).displacement
    note = "S_v 800 mm/s at every period. Allowed: where the iteration stops."
    return Finding(
        aij_2016.method_2(pendulum, level).displacement,
        iterated,
        "mm",
        1e-6,
        note,
        "AIJ method 1, iterated",
        relative=True,
    )


def _task(name: str, measure: Callable[[], Finding]) -> Task:
    return Task(GROUP, name, measure)


TASKS = (
    *(
        _task(f"response spectrum of {name}", partial(_spectrum, name))
        for name in ("NCC", "KNA", "LPG", "IVD")
    ),
    *(_task(f"undamped input energy, {name}", partial(_energy, name)) for name in ("NCC", "IVD")),
    _task("ASCE 7 iteration, S_D1 0.6 g", partial(_printed_iteration, 0.6, 7.128, 2.325, 0.415)),
    _task("ASCE 7 iteration, S_M1 0.9 g", partial(_printed_iteration, 0.9, 14.745, 2.854, 0.303)),
    _task("AIJ energy balance", _balance),
    _task("AIJ method 2 against method 1", _two_methods),
)
