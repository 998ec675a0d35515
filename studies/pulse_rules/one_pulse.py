"""Half a cosine against Eq. (20): one pulse whose fall is its rise mirrored, friction constant, no spring."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq


@dataclass(frozen=True)
class Wave:
    """What one pulse does, with dvg = kg = 1.

    Attributes
    ----------
    straight, amplified, cosine
        dy of Eq. (20) as it is, of Eq. (20) with the factor of 1.5, of the half cosines.
    factor
        With which Eq. (20) would give the cosine's dy.
    energy, energy_amplified, energy_cosine
        V_dE of Eq. (23), with the factor of 1.5, of the half cosines.
    """

    straight: float
    amplified: float
    cosine: float
    factor: float
    energy: float
    energy_amplified: float
    energy_cosine: float


def straight(ratio: float, factor: float = 1.0) -> float:
    """Return dy of Eq. (20) with kg_(i+1) = -kg_i, in dvg^2/kg, velocities and slopes multiplied by a factor."""
    return factor * max(0.0, factor - ratio) / (factor + ratio)


def wave(ratio: float) -> Wave:
    """Return what a pulse of ku/kg = `ratio` does."""
    change, energy = _cosine(ratio)
    limit = 0.5 * np.pi
    factor = brentq(lambda f: straight(ratio, f) - change, ratio, 2.0) if ratio < limit else limit
    return Wave(
        straight(ratio),
        straight(ratio, 1.5),
        change,
        float(factor),
        float(np.sqrt(max(0.0, 1.0 - ratio))),
        1.5 * float(np.sqrt(max(0.0, 1.0 - ratio / 1.5))),
        energy,
    )


def _cosine(ratio: float, steps: int = 200_000) -> tuple[float, float]:
    """Return dy and V_dE under vg = (1 - cos(pi t)) / 2 for t from 0 to 2, with ku = `ratio`."""
    first = (
        np.arcsin(min(1.0, 2.0 * ratio / np.pi)) / np.pi
    )  # the ground gathers speed faster than the structure
    t = np.linspace(first, 2.0, steps)
    ground = 0.5 * (1.0 - np.cos(np.pi * t))
    behind = ground - ground[0] - ratio * (t - first)
    turned = np.flatnonzero(behind[1:] <= 0.0)
    end = int(turned[0]) + 1 if turned.size else steps - 1
    step = t[1] - t[0]
    acceleration = 0.5 * np.pi * np.sin(np.pi * t)
    until_peak = t <= 1.0
    put_in = float((acceleration * np.maximum(behind, 0.0))[until_peak].sum() * step)
    return float(np.maximum(behind[:end], 0.0).sum() * step), float(np.sqrt(2.0 * put_in))
