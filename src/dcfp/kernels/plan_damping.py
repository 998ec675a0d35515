"""Energy that the damping of the storeys takes."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plan_modes import Linear

#: Columns: how fast energy is taken, and the first and second derivative of that, at one time.
RATE, SLOPE, BEND, RATE_COLUMNS = range(4)


@called_kernel
def observe(
    lin: Linear, half: NDArray[np.complex128], z: NDArray[np.complex128], storeys: NDArray[np.float64]
) -> None:
    """Write displacement and velocity of the modes on a fixed base in the middle of a step and at its end, of each from the complex modes of its group."""
    for g in range(lin.groups.shape[0]):
        first, last, low, high = lin.groups[g, 0], lin.groups[g, 1], lin.groups[g, 2], lin.groups[g, 3]
        for part in range(2):
            _add_up_both(
                lin.storeys[part, :, first:last, low:high], half[first:last], z[first:last],
                storeys[0, part, low:high], storeys[1, part, low:high],
            )  # fmt: skip


@kernel
def _add_up_both(
    parts: NDArray[np.float64], half: NDArray[np.complex128], z: NDArray[np.complex128], middle: NDArray[np.float64], end: NDArray[np.float64]
) -> None:  # fmt: skip
    """Do what `add_up` does for two times at once: of many storeys reading the rows takes the time."""
    for n in range(middle.size):
        middle[n] = 0.0
        end[n] = 0.0
    for m in range(z.size):
        re, im, of_re, of_im = z[m].real, z[m].imag, parts[0, m], parts[1, m]
        half_re, half_im = half[m].real, half[m].imag
        if im == 0.0 and half_im == 0.0:  # a mode that does not oscillate
            for n in range(middle.size):
                middle[n] += half_re * of_re[n]
                end[n] += re * of_re[n]
        else:
            for n in range(middle.size):
                middle[n] += half_re * of_re[n] - half_im * of_im[n]
                end[n] += re * of_re[n] - im * of_im[n]


@called_kernel
def note_rate(
    lin: Linear, slab: NDArray[np.float64], storeys: NDArray[np.float64], row: NDArray[np.float64]
) -> None:
    """Write how fast energy is taken while the `slab` has this acceleration and this change of it, for which the storeys were observed."""
    ax, ay, at, jx, jy, jt = slab[0], slab[1], slab[2], slab[3], slab[4], slab[5]
    taken, slope, bend = 0.0, 0.0, 0.0
    for n in range(lin.fixed.shape[0]):
        square, damping = lin.fixed[n, 0], lin.fixed[n, 1]
        y, v = storeys[0, n], storeys[1, n]
        a = -damping * v - square * y - (lin.fixed[n, 2] * ax + lin.fixed[n, 3] * ay + lin.fixed[n, 4] * at)
        j = -damping * a - square * v - (lin.fixed[n, 2] * jx + lin.fixed[n, 3] * jy + lin.fixed[n, 4] * jt)
        taken += damping * v * v
        slope += 2.0 * damping * v * a
        bend += 2.0 * damping * (a * a + v * j)
    row[RATE], row[SLOPE], row[BEND] = taken, slope, bend


@kernel
def taken_over(rates: NDArray[np.float64], length: float) -> float:
    """Energy over a step of `length` [s] from its rates at the start, in the middle and at the end: exact for a polynomial of degree nine."""
    half, start, middle, end = 0.5 * length, rates[0], rates[1], rates[2]
    values = 41.0 * (start[RATE] + end[RATE]) + 128.0 * middle[RATE]
    slopes = start[SLOPE] - end[SLOPE]
    bends = start[BEND] + end[BEND] + 16.0 * middle[BEND]
    return half * (values / 105.0 + half * (slopes * (2.0 / 35.0) + half * bends / 315.0))
