"""Input energy spectra: Akiyama (1985), Uang and Bertero (1988)."""

from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import oscillators as k
from dcfp.methods.spectra.oscillators import DAMPING, PERIODS, checked, coefficients, pieces
from dcfp.motion.ground_motion import GroundMotion, refined
from dcfp.schema.notebook import fields_card


@dataclass(frozen=True, eq=False)
class EnergySpectrum:
    """Energies that a ground motion puts into elastic oscillators, per unit mass.

    Attributes
    ----------
    periods
        [s], shape (n,).
    damping
        Ratio of critical damping [-].
    final
        Relative input energy at the end of the motion [mm2/s2], shape (n,).
    relative, absolute
        Largest relative and absolute input energy at any time [mm2/s2], shape (n,).
    displacement, velocity, total_acceleration
        Largest relative displacement [mm] and velocity [mm/s], and absolute acceleration [mm/s2], shape (n,).
    name
        What to call it.
    """

    periods: FloatArray
    damping: float
    final: FloatArray
    relative: FloatArray
    absolute: FloatArray
    displacement: FloatArray
    velocity: FloatArray
    total_acceleration: FloatArray
    name: str = "record"

    @property
    def equivalent_velocity(self) -> FloatArray:
        """V_E = sqrt(2 E / m) of the largest relative input energy [mm/s], shape (n,): Akiyama (1985)."""
        return np.sqrt(2.0 * self.relative)

    def _repr_html_(self) -> str:
        return fields_card(self, f"Input energy spectra of {self.name}")


def input_energy_spectrum(
    motion: GroundMotion, periods: FloatArray = PERIODS, damping: float = DAMPING
) -> EnergySpectrum:
    """Return the input energy spectra of a ground motion; arguments and errors as for `response_spectrum`.

    The relative input energy, - integral of a_g dv over the relative displacement, is in closed form between samples; the absolute one, the work of the
    ground on the oscillator, is more by v_g (v_g / 2 + v) for each unit of mass.
    """
    periods = checked(periods, damping)
    found = np.empty((k.ROWS, periods.size))
    for part, parts in pieces(motion, periods):
        step = motion.time_step / max(parts, 1)
        acceleration = refined(motion.acceleration, parts)
        ground = np.concatenate(([0.0], np.cumsum(0.5 * step * (acceleration[1:] + acceleration[:-1]))))
        state = np.zeros((k.ROWS, periods[part].size))
        rows = coefficients(np.ascontiguousarray(periods[part]), damping, step)
        k.respond_with_energy(rows, step, acceleration, ground, state)
        found[:, part] = state
    return EnergySpectrum(
        periods=freeze(periods),
        damping=damping,
        final=freeze(found[k.INPUT]),
        relative=freeze(found[k.PEAK_INPUT]),
        absolute=freeze(found[k.PEAK_ABSOLUTE]),
        displacement=freeze(found[k.PEAK_U]),
        velocity=freeze(found[k.PEAK_V]),
        total_acceleration=freeze(found[k.PEAK_A]),
        name=motion.name,
    )
