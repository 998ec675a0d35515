r"""The linear part of a building on its bearings by its complex modes, exact over a step under forces that are parabolas of time.

A mode follows :math:`z' = \lambda z + P(t)`; with :math:`\varphi_k` of :math:`\lambda h` and P = P0 + P1 t + P2 t2

.. math:: z_1 = e^{\lambda h} z_0 + h \varphi_1 P_0 + h^2 \varphi_2 P_1 + 2 h^3 \varphi_3 P_2
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel

#: Columns of what drives a step: forces on the slab as a parabola (three times x, y, torque), the ground's acceleration (x, y) and how it changes (x, y).
FORCE, GROUND, DRIVES = 0, 9, 13
#: Rows that are integrated: displacement of the slab (three), and what the ground works on (two) [t mm].
INTEGRATED = 5
#: Rows of the sums of a step: travel, first and second time integral from the start, of what is integrated.
TRAVELLED, AREA, MOMENT, SUM_ROWS = range(4)
#: Columns of the slab's acceleration and its change.
SLAB_COLUMNS = 6


class Linear(NamedTuple):
    """Complex modes; all rows are of modes, and what they sum to is the real part."""

    roots: NDArray[np.complex128]  # (modes,) [1/s]
    factors: NDArray[np.complex128]  # (levels, 6, modes): h^k phi_k of the whole step
    # (levels, 2, modes, 2 x 8): real and imaginary part of the outputs in the middle and at the end, of the modes at the start
    outputs: NDArray[np.float64]
    influence: NDArray[np.float64]  # (levels, 2 x 8, DRIVES): and of what drives the step
    gains: NDArray[
        np.complex128
    ]  # (5, modes): of forces on the slab and of the ground's acceleration on the modes
    integrated: NDArray[np.complex128]  # (INTEGRATED, modes)
    rates: NDArray[np.complex128]  # (3, modes): velocity of the slab
    # (2, 2, modes, fixed-base modes): real and imaginary part of the displacement, and of the velocity, of the modes on a fixed base, in groups that move apart
    storeys: NDArray[np.float64]
    fixed: NDArray[np.float64]  # (fixed-base modes, 5): w2, 2 z w, participation of x, y and rotation
    # (groups, 4): first mode and that after the last, first mode on a fixed base and that after the last
    groups: NDArray[np.int64]


@kernel
def add_up(parts: NDArray[np.float64], z: NDArray[np.complex128], found: NDArray[np.float64]) -> None:
    """Write the sum of the modes' rows, of which real and imaginary part are (2, modes, entries)."""
    for j in range(found.size):
        found[j] = 0.0
    for m in range(z.size):
        re, im, of_re, of_im = z[m].real, z[m].imag, parts[0, m], parts[1, m]
        if im == 0.0:  # a mode that does not oscillate
            for j in range(found.size):
                found[j] += re * of_re[j]
        else:
            for j in range(found.size):
                found[j] += re * of_re[j] - im * of_im[j]


@called_kernel
def advance_modes(
    lin: Linear, level: int, length: float, drive: NDArray[np.float64], z: NDArray[np.complex128],
    half: NDArray[np.complex128], sums: NDArray[np.float64], slab: NDArray[np.float64],
) -> None:  # fmt: skip
    """Advance the modes over a step of `length` [s]; write those in its `half`, the `sums` of what is integrated, and the absolute acceleration of the `slab` and how it changes."""
    f, g = lin.factors[level], lin.factors[level + 1]
    for r in range(SUM_ROWS):
        for j in range(INTEGRATED):
            sums[r, j] = 0.0
    _begin_slab(drive, length, slab)
    for m in range(z.size):
        p0, p1, p2 = modal_drive(lin, drive, m)
        start, twice_p2 = z[m], 2.0 * p2
        middle = g[0, m] * start + g[1, m] * p0 + g[2, m] * p1 + g[3, m] * twice_p2
        end = f[0, m] * start + f[1, m] * p0 + f[2, m] * p1 + f[3, m] * twice_p2
        once = f[1, m] * start + f[2, m] * p0 + f[3, m] * p1 + f[4, m] * twice_p2 - length * start
        twice = (
            f[2, m] * start + f[3, m] * p0 + f[4, m] * p1 + f[5, m] * twice_p2 - 0.5 * length * length * start
        )
        gone = end - start
        for j in range(INTEGRATED):
            c = lin.integrated[j, m]
            sums[TRAVELLED, j] += c.real * gone.real - c.imag * gone.imag
            sums[AREA, j] += c.real * once.real - c.imag * once.imag
            sums[MOMENT, j] += c.real * twice.real - c.imag * twice.imag
        _accelerate(lin, m, start, p0, p1, slab[0])
        time = 0.5 * length
        _accelerate(lin, m, middle, p0 + time * (p1 + time * p2), p1 + time * twice_p2, slab[1])
        _accelerate(lin, m, end, p0 + length * (p1 + length * p2), p1 + length * twice_p2, slab[2])
        half[m], z[m] = middle, end


@kernel
def _begin_slab(drive: NDArray[np.float64], length: float, slab: NDArray[np.float64]) -> None:
    """Write the ground's acceleration in x, y and rotation, and how it changes, at the start, in the middle and at the end of a step."""
    for r in range(3):
        for j in range(2):
            change = drive[GROUND + 2 + j]
            slab[r, j] = drive[GROUND + j] + 0.5 * r * length * change
            slab[r, 3 + j] = change
        slab[r, 2] = slab[r, 5] = 0.0


@kernel
def _accelerate(
    lin: Linear, m: int, z: complex, drive: complex, change: complex, row: NDArray[np.float64]
) -> None:
    """Add what a mode does to the slab's acceleration and to its change."""
    first = lin.roots[m] * z + drive
    second = lin.roots[m] * first + change
    for j in range(3):
        c = lin.rates[j, m]
        row[j] += c.real * first.real - c.imag * first.imag
        row[3 + j] += c.real * second.real - c.imag * second.imag


@kernel
def modal_drive(lin: Linear, drive: NDArray[np.float64], m: int) -> tuple[complex, complex, complex]:
    """Return what drives a mode, as a parabola of time."""
    gx, gy, gt = lin.gains[0, m], lin.gains[1, m], lin.gains[2, m]
    ax, ay = lin.gains[3, m], lin.gains[4, m]
    p0 = drive[0] * gx + drive[1] * gy + drive[2] * gt + drive[GROUND] * ax + drive[GROUND + 1] * ay
    p1 = drive[3] * gx + drive[4] * gy + drive[5] * gt + drive[GROUND + 2] * ax + drive[GROUND + 3] * ay
    p2 = drive[6] * gx + drive[7] * gy + drive[8] * gt
    return p0, p1, p2


@kernel
def work(
    sums: NDArray[np.float64], length: float, drive: NDArray[np.float64], first: int, number: int, row: int
) -> float:
    """Integrate over a step what the entries `first`, + `number`, + 2 `number` of the drive say, as a parabola, times the velocity of a row, exactly."""
    travel, area, moment = sums[TRAVELLED, row], sums[AREA, row], sums[MOMENT, row]
    linear = length * travel - area
    square = length * (length * travel - 2.0 * area) + 2.0 * moment
    return drive[first] * travel + drive[first + number] * linear + drive[first + 2 * number] * square
