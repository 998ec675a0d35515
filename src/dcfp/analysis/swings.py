"""The swings of a response, from one peak of displacement to the next: Li et al. (2020), sections 2 and 6.1."""

from dataclasses import dataclass

import numpy as np

from dcfp.analysis.response import Response
from dcfp.analysis.result import equivalent_velocity
from dcfp.arrays import FloatArray, IntArray


@dataclass(frozen=True)
class Swing:
    """One swing.

    Attributes
    ----------
    start, end, change
        Times of the two peaks [s], and dy_i = y_i - y_(i-1), with its sign [mm].
    input_velocity
        V_dE [mm/s]: of the largest input energy since the start. It is reached when the ground turns, at its own peak; from there on the ground takes energy back.
    net_input_velocity
        V_dEr [mm/s]: of the input energy over the whole swing, on the left of Eqs (15) and (16); zero where the ground took back more than it gave.
    hysteretic_velocity
        V_dEhr [mm/s]: of the energy dissipated over the whole swing, on the right of Eq. (16).
    """

    start: float
    end: float
    change: float
    input_velocity: float
    net_input_velocity: float
    hysteretic_velocity: float


@dataclass(frozen=True, eq=False)
class Swings:
    """All swings of a response, in their order; the one still going on at the end is not among them.

    The elastic oscillation while the bearing sticks turns too, so most of the swings are of less than a millimetre.

    Attributes
    ----------
    times, displacements
        Of the peaks of displacement [s], and y_i there [mm], shape (n + 1,); the first is the start.
    most_input, net_input, hysteretic, strain
        dE_i, dEr_i, dEhr_i and dEsr_i of each swing [N mm], shape (n,).
    mass
        Of the structure [t].
    """

    times: FloatArray
    displacements: FloatArray
    most_input: FloatArray
    net_input: FloatArray
    hysteretic: FloatArray
    strain: FloatArray
    mass: float

    @property
    def changes(self) -> FloatArray:
        """dy_i, with its sign [mm], shape (n,)."""
        return np.diff(self.displacements)

    @property
    def largest(self) -> Swing | None:
        """The swing with the largest change of displacement; None where the response never turns."""
        changes = self.changes
        return self[int(np.argmax(np.abs(changes)))] if changes.size else None

    @property
    def input_velocity(self) -> float:
        """Largest V_dE of all swings [mm/s]."""
        return equivalent_velocity(float(self.most_input.max(initial=0.0)), self.mass)

    @property
    def hysteretic_velocity(self) -> float:
        """Largest V_dEhr of all swings [mm/s]."""
        return equivalent_velocity(float(self.hysteretic.max(initial=0.0)), self.mass)

    def __len__(self) -> int:
        return self.most_input.size

    def __getitem__(self, number: int) -> Swing:
        return Swing(
            start=float(self.times[number]),
            end=float(self.times[number + 1]),
            change=float(self.changes[number]),
            input_velocity=equivalent_velocity(float(self.most_input[number]), self.mass),
            net_input_velocity=equivalent_velocity(float(self.net_input[number]), self.mass),
            hysteretic_velocity=equivalent_velocity(float(self.hysteretic[number]), self.mass),
        )


def swings_of(response: Response) -> Swings:
    """Return the swings of a response, from its histories.

    Between two samples the velocity is taken as the parabola that brings about the displacement; two turns between the same two
    samples, as only the elastic oscillation can make them, are not seen.
    """
    velocity, displacement = response.velocity, response.displacement
    energy, dissipated = response.energy.input, response.energy.hysteretic
    side = np.sign(velocity)
    at = np.flatnonzero((side[:-1] != 0.0) & (side[1:] != side[:-1]))
    step = float(response.time[1] - response.time[0])
    first, last, mean = velocity[at], velocity[at + 1], (displacement[at + 1] - displacement[at]) / step
    share = _zero_of_parabola(first, last, mean)
    travel = step * _travel(first, last, mean, share)
    turned = displacement[at] + travel
    after = np.abs(displacement[at + 1] - turned)
    whole = np.abs(travel) + after
    part = np.divide(np.abs(travel), whole, out=np.ones_like(whole), where=whole > 0.0)
    input_there = energy[at] - response.bearing.mass * response.ground_acceleration[at] * travel
    dissipated_there = dissipated[at] + part * (dissipated[at + 1] - dissipated[at])
    inputs = np.concatenate((energy[:1], input_there))
    return Swings(
        times=np.concatenate((response.time[:1], response.time[at] + share * step)),
        displacements=np.concatenate((displacement[:1], turned)),
        most_input=_most_since(energy, inputs, at),
        net_input=np.diff(inputs),
        hysteretic=np.diff(np.concatenate((dissipated[:1], dissipated_there))),
        strain=np.diff(np.concatenate((response.energy.strain[:1], _strain_at(response, at, travel)))),
        mass=response.bearing.mass,
    )


def _strain_at(response: Response, at: IntArray, travel: FloatArray) -> FloatArray:
    """Return the elastic strain energy where it turns, `travel` after the samples `at` [N mm]."""
    bearing = response.bearing
    # sliding drags the other end of spring (b) along, so that it is not longer than friction makes it
    held = response.friction[at] * bearing.vertical_force / bearing.elastic_stiffness
    longest = np.maximum(held, np.abs(response.elongation[at]))
    elongation = np.clip(response.elongation[at] + travel, -longest, longest)
    turned = response.displacement[at] + travel
    return 0.5 * (bearing.restoring_stiffness * turned**2 + bearing.elastic_stiffness * elongation**2)


def _zero_of_parabola(first: FloatArray, last: FloatArray, mean: FloatArray) -> FloatArray:
    """Return where in 0 to 1 a parabola with these ends, of opposite sign, and this mean passes zero."""
    bulge = 6.0 * mean - 3.0 * (first + last)  # v = first (1 - s) + last s + bulge s (1 - s)
    linear = last - first + bulge
    root = np.sqrt(np.maximum(linear**2 + 4.0 * bulge * first, 0.0))
    # of the two forms of the solution the one that does not cancel, and holds for a straight line too
    below = np.sign(first) * root - linear
    share = np.divide(2.0 * first, below, out=np.ones_like(first), where=below != 0.0)
    return np.clip(share, 0.0, 1.0)


def _travel(first: FloatArray, last: FloatArray, mean: FloatArray, share: FloatArray) -> FloatArray:
    """Return the integral of that parabola from 0 to `share`."""
    bulge = 6.0 * mean - 3.0 * (first + last)
    return share * (first + share * (0.5 * (last - first + bulge) - bulge * share / 3.0))


def _most_since(energy: FloatArray, inputs: FloatArray, at: IntArray) -> FloatArray:
    """Return the largest energy at the samples of each swing over that at its start."""
    if at.size == 0:
        return np.empty(0)
    starts = np.concatenate(([0], at[:-1] + 1))
    most = np.maximum.reduceat(energy[: at[-1] + 1], starts)
    return np.maximum(np.maximum(most, inputs[1:]) - inputs[:-1], 0.0)
