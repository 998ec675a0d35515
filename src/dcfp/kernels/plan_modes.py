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
#: Rows of the storeys' state: velocity and acceleration of the modes on a fixed base, at the start and at the end.
RATE_0, PUSH_0, RATE_1, PUSH_1, STOREY_ROWS = range(5)


class Linear(NamedTuple):
    """Complex modes; all rows are of modes, and what they sum to is the real part."""

    roots: NDArray[np.complex128]  # (modes,) [1/s]
    factors: NDArray[np.complex128]  # (levels, 6, modes): h^k phi_k of the whole step
    outputs: NDArray[
        np.complex128
    ]  # (levels, 2 x 8, modes): outputs in the middle and at the end, of the modes at the start
    influence: NDArray[np.float64]  # (levels, 2 x 8, DRIVES): and of what drives the step
    gains: NDArray[
        np.complex128
    ]  # (5, modes): of forces on the slab and of the ground's acceleration on the modes
    integrated: NDArray[np.complex128]  # (INTEGRATED, modes)
    accelerations: NDArray[np.complex128]  # (3, modes): acceleration of the slab of the modes' derivatives
    storeys: NDArray[np.complex128]  # (2 x fixed-base modes, modes): their displacement and velocity
    fixed: NDArray[np.float64]  # (fixed-base modes, 5): w2, 2 z w, participation of x, y and rotation


@called_kernel
def outputs_of(lin: Linear, level: int, z: NDArray[np.complex128], found: NDArray[np.float64]) -> None:
    """Write the outputs in the middle and at the end of a step without any drive."""
    for j in range(found.size):
        real = 0.0
        for m in range(z.size):
            c = lin.outputs[level, j, m]
            real += c.real * z[m].real - c.imag * z[m].imag
        found[j] = real


@kernel
def sum_of(row: NDArray[np.complex128], z: NDArray[np.complex128]) -> float:
    """Real part of a row times the modes."""
    real = 0.0
    for m in range(z.size):
        real += row[m].real * z[m].real - row[m].imag * z[m].imag
    return real


@called_kernel
def advance_modes(
    lin: Linear, level: int, length: float, drive: NDArray[np.float64], z: NDArray[np.complex128], sums: NDArray[np.float64]
) -> None:  # fmt: skip
    """Advance the modes over a step of `length` [s]; write the `sums` of what is integrated."""
    f = lin.factors[level]
    for r in range(SUM_ROWS):
        for j in range(INTEGRATED):
            sums[r, j] = 0.0
    for m in range(z.size):
        p0, p1, p2 = modal_drive(lin, drive, m)
        p2 = 2.0 * p2
        start = z[m]
        end = f[0, m] * start + f[1, m] * p0 + f[2, m] * p1 + f[3, m] * p2
        once = f[1, m] * start + f[2, m] * p0 + f[3, m] * p1 + f[4, m] * p2 - length * start
        twice = f[2, m] * start + f[3, m] * p0 + f[4, m] * p1 + f[5, m] * p2 - 0.5 * length * length * start
        gone = end - start
        for j in range(INTEGRATED):
            c = lin.integrated[j, m]
            sums[TRAVELLED, j] += c.real * gone.real - c.imag * gone.imag
            sums[AREA, j] += c.real * once.real - c.imag * once.imag
            sums[MOMENT, j] += c.real * twice.real - c.imag * twice.imag
        z[m] = end


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


@called_kernel
def _note_storeys(
    lin: Linear, z: NDArray[np.complex128], drive: NDArray[np.float64], time: float, row: int, storeys: NDArray[np.float64], rates: NDArray[np.float64]
) -> None:  # fmt: skip
    """Write how fast the storeys' damping takes energy at a `time` [s] into a step, and the first and second derivative of that, into `rates` from entry `row` on."""
    ax, ay, at, jx, jy, jt = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for m in range(z.size):
        p0, p1, p2 = modal_drive(lin, drive, m)
        now, change = p0 + time * (p1 + time * p2), p1 + 2.0 * time * p2
        first = lin.roots[m] * z[m] + now
        second = lin.roots[m] * first + change
        cx, cy, ct = lin.accelerations[0, m], lin.accelerations[1, m], lin.accelerations[2, m]
        ax += cx.real * first.real - cx.imag * first.imag
        ay += cy.real * first.real - cy.imag * first.imag
        at += ct.real * first.real - ct.imag * first.imag
        jx += cx.real * second.real - cx.imag * second.imag
        jy += cy.real * second.real - cy.imag * second.imag
        jt += ct.real * second.real - ct.imag * second.imag
    ax += drive[GROUND] + time * drive[GROUND + 2]
    ay += drive[GROUND + 1] + time * drive[GROUND + 3]
    jx += drive[GROUND + 2]
    jy += drive[GROUND + 3]
    count = lin.fixed.shape[0]
    taken, slope, bend = 0.0, 0.0, 0.0
    for n in range(count):
        square, damping = lin.fixed[n, 0], lin.fixed[n, 1]
        y, v = storeys[0, n], storeys[1, n]
        a = -damping * v - square * y - (lin.fixed[n, 2] * ax + lin.fixed[n, 3] * ay + lin.fixed[n, 4] * at)
        j = -damping * a - square * v - (lin.fixed[n, 2] * jx + lin.fixed[n, 3] * jy + lin.fixed[n, 4] * jt)
        taken += damping * v * v
        slope += 2.0 * damping * v * a
        bend += 2.0 * damping * (a * a + v * j)
    rates[row], rates[row + 1], rates[row + 2] = taken, slope, bend


@kernel
def _observe(lin: Linear, z: NDArray[np.complex128], storeys: NDArray[np.float64]) -> None:
    """Write displacement and velocity of the modes on a fixed base."""
    count = lin.fixed.shape[0]
    for n in range(count):
        storeys[0, n] = sum_of(lin.storeys[n], z)
        storeys[1, n] = sum_of(lin.storeys[count + n], z)


@called_kernel
def damped_before(
    lin: Linear, level: int, length: float, drive: NDArray[np.float64], z: NDArray[np.complex128], half: NDArray[np.complex128], storeys: NDArray[np.float64], rates: NDArray[np.float64]
) -> None:  # fmt: skip
    """Note how fast the storeys' damping takes energy at the start of a step, as they were observed at the end of the one before, and in the middle; `half` is room for the modes there."""
    _note_storeys(lin, z, drive, 0.0, 0, storeys, rates)
    f = lin.factors[level + 1]
    for m in range(z.size):
        p0, p1, p2 = modal_drive(lin, drive, m)
        half[m] = f[0, m] * z[m] + f[1, m] * p0 + f[2, m] * p1 + f[3, m] * (2.0 * p2)
    _observe(lin, half, storeys)
    _note_storeys(lin, half, drive, 0.5 * length, 3, storeys, rates)


@called_kernel
def damped_over(
    lin: Linear, length: float, drive: NDArray[np.float64], z: NDArray[np.complex128], storeys: NDArray[np.float64], rates: NDArray[np.float64]
) -> float:  # fmt: skip
    """Energy that the storeys' damping took over a step [N mm], now that the modes are at its end.

    By the rule with first and second derivatives at both ends, over the whole and over the halves: its error falls with the sixth power, and so is left out.
    """
    _observe(lin, z, storeys)
    _note_storeys(lin, z, drive, length, 6, storeys, rates)
    whole = _between(rates, 0, 6, length)
    halves = _between(rates, 0, 3, 0.5 * length) + _between(rates, 3, 6, 0.5 * length)
    return halves + (halves - whole) / 63.0


@kernel
def _between(rates: NDArray[np.float64], first: int, last: int, length: float) -> float:
    values, slopes, bends = (
        rates[first] + rates[last],
        rates[first + 1] - rates[last + 1],
        rates[first + 2] + rates[last + 2],
    )
    return length * (0.5 * values + length * (0.1 * slopes + length * bends / 120.0))
