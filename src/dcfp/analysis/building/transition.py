r"""Exact transitions of a building under linear inputs, for the kernels.

The state is :math:`z = (u, \dot u)`, displacements of base and floors relative to the ground, with inputs :math:`a_g` and the push on the base :math:`f`,
both linear in time:

.. math:: M \ddot u + C \dot u + K u = f e_0 - M 1 a_g

Sticking, K has springs (a) and (b) at the base; sliding, only spring (a). State, inputs and their rates are one linear system without
input, :math:`\dot q = A q`, so a step of length h is :math:`q(h) = e^{Ah} q(0)`. The energy that damping takes is
:math:`\int \dot u^T C \dot u\,dt = q^T W q`, and :math:`W(2h) = W(h) + e^{A^T h} W(h) e^{Ah}`.
"""

from typing import TYPE_CHECKING, cast

import numpy as np
from scipy import linalg

from dcfp.analysis.building.shear_building import ShearBuilding
from dcfp.arrays import FloatArray
from dcfp.kernels.building import INPUTS, LEVELS, Building
from dcfp.system import Bearing

if TYPE_CHECKING:
    from collections.abc import Callable

#: scipy's types do not say that it takes stacks of matrices.
_exponential = cast("Callable[[FloatArray], FloatArray]", linalg.expm)


def building_of(building: ShearBuilding, bearing: Bearing, step: float) -> Building:
    """Return the kernels' view of `building` on `bearing` for a fine step [s]; everything per unit of the bearing's mass."""
    own = building.scaled_to(bearing.mass)
    mass = np.array(own.masses) / bearing.mass
    damping = own.damping_matrix / bearing.mass
    sliding = own.storey_stiffness / bearing.mass
    sliding[0, 0] += bearing.restoring_stiffness / bearing.mass
    sticking = sliding.copy()
    sticking[0, 0] += bearing.elastic_stiffness / bearing.mass
    pairs = [_transitions(mass, stiffness, damping, step) for stiffness in (sticking, sliding)]
    damped = own.damping is not None
    return Building(
        floors=mass.size,
        step=step,
        inertia=mass,
        stiffness=np.array([0.0, *own.stiffnesses]) / bearing.mass,
        resistance=np.hstack((-sliding, -damping)) / mass[:, np.newaxis],
        steps=np.stack([steps for steps, _ in pairs]),
        losses=np.stack([losses for _, losses in pairs]) if damped else np.zeros((2, 0, 1, 1)),
        vectors=np.zeros((3, 2 * mass.size + INPUTS)),
    )


def _transitions(
    mass: FloatArray, stiffness: FloatArray, damping: FloatArray, step: float
) -> tuple[FloatArray, FloatArray]:
    """Return the transposed transitions, with two integrals, and the losses to damping, of every level."""
    floors = mass.size
    size, inputs = 2 * floors, 2 * floors + INPUTS
    # displacements in units of a velocity over this frequency, so that all entries are of one size
    frequency = float(np.sqrt((np.diag(stiffness) / mass).max()))
    unit = np.ones(inputs + 2)
    unit[:floors] = unit[inputs:] = 1.0 / frequency
    system = np.zeros((inputs + 2, inputs + 2))
    system[:floors, floors:size] = np.eye(floors)
    system[floors:size, :floors] = -stiffness / mass[:, np.newaxis]
    system[floors:size, floors:size] = -damping / mass[:, np.newaxis]
    system[floors:size, size] = -1.0
    system[floors, size + 2] = 1.0 / mass[0]
    system[size, size + 1] = system[size + 2, size + 3] = 1.0  # the inputs' rates
    system[inputs, :floors] = mass  # time integrals of the mean displacement and of the base's
    system[inputs + 1, 0] = 1.0
    lengths: FloatArray = np.ldexp(step, -np.arange(LEVELS + 1))
    scaled = system * unit / unit[:, np.newaxis]
    whole = _exponential(scaled * lengths[:, np.newaxis, np.newaxis]) * unit[:, np.newaxis] / unit
    rows = [*range(size), inputs, inputs + 1]
    advance = whole[:, :inputs, :inputs]
    return whole[:LEVELS, rows, :inputs].transpose(0, 2, 1).copy(), _losses(advance, damping, lengths)


def _losses(advance: FloatArray, damping: FloatArray, lengths: FloatArray) -> FloatArray:
    """Return the quadratic form W of each level; by Simpson's rule for the shortest step, then by doubling."""
    floors = damping.shape[0]
    rate = np.zeros(advance.shape[1:])
    rate[floors : 2 * floors, floors : 2 * floors] = damping
    losses = np.empty((LEVELS, *rate.shape))
    middle, end = advance[LEVELS], advance[LEVELS - 1]
    losses[-1] = lengths[LEVELS - 1] / 6.0 * (rate + 4.0 * middle.T @ rate @ middle + end.T @ rate @ end)
    for level in reversed(range(LEVELS - 1)):
        half, shorter = advance[level + 1], losses[level + 1]
        losses[level] = shorter + half.T @ shorter @ half
    return losses
