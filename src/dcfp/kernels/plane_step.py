r"""One step of a bearing in the plane: two horizontal directions, coupled by a circular yield surface.

A vector is a complex number, x + i y. Per unit mass the structure follows

.. math:: \ddot u + \omega^2 u = -a_g - f, \qquad f = \frac{k_f}{m} e, \quad |e| \le \frac{\mu N}{k_f}

with the elongation e of spring (b). Over a step f is the parabola through its values at the start, in the middle and at the end, under which the oscillator is
advanced in closed form; e follows the path of u, half a step at a time, by `elongation_after`. So the energy closes to rounding, whatever the friction is.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.sum_of_exponentials import exp_neg

#: Columns of the coefficients of an oscillator over a step: h^k phi_k for k = 0 to 6, in the middle of the step and at its end.
MIDDLE, END, COEFFICIENTS = 0, 7, 14
# cosine of how far a slide may turn in half a step before the frame that turns with it is given up
_LEAST_COSINE = math.sqrt(0.5)
_TINY = 1e-300


class Force(NamedTuple):
    """A force per unit mass over a step, ``constant`` [mm/s2] + ``rate`` [mm/s3] t + ``curvature`` [mm/s4] t2."""

    constant: complex
    rate: complex
    curvature: complex


class Course(NamedTuple):
    """Displacement [mm] and velocity [mm/s] in the middle of a step and at its end."""

    middle: complex
    middle_velocity: complex
    end: complex
    end_velocity: complex


def oscillator_rows(stiffness: float, lengths: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the coefficients of an oscillator of a `stiffness` [1/s2] for steps of some `lengths` [s], shape (lengths, COEFFICIENTS)."""
    halves = np.concatenate((0.5 * lengths, lengths))
    z = stiffness * halves**2
    rows = np.empty((7, halves.size))
    series = z < 1.0
    for k in (5, 6):
        total, term = np.zeros_like(z), np.full_like(z, 1.0 / math.factorial(k))
        for n in range(14):
            total += term
            term = -term * np.where(series, z, 0.0) / ((2 * n + k + 1) * (2 * n + k + 2))
        rows[k] = total
    root = np.sqrt(z)
    with np.errstate(divide="ignore", invalid="ignore"):
        exact = [np.cos(root), np.sin(root) / root]
        for k in range(2, 7):
            exact.append((1.0 / math.factorial(k - 2) - exact[k - 2]) / z)
    for k in (5, 6):
        rows[k] = np.where(series, rows[k], exact[k])
    for k in (4, 3, 2, 1, 0):
        rows[k] = np.where(series, 1.0 / math.factorial(k) - z * rows[k + 2], exact[k])
    powered = rows * halves ** np.arange(7.0)[:, None]
    count = lengths.size
    return np.concatenate((powered[:, :count], powered[:, count:])).T.copy()


@kernel
def dot(a: complex, b: complex) -> float:
    """Scalar product of two vectors."""
    return a.real * b.real + a.imag * b.imag


@kernel
def length_of(a: complex) -> float:
    """Length of a vector."""
    return math.sqrt(a.real * a.real + a.imag * a.imag)


@kernel
def times(factor: float, a: complex) -> complex:
    """Return a multiple of a vector; the compiler would multiply with the factor as a complex number."""
    return complex(factor * a.real, factor * a.imag)


@kernel
def of_length(length: float, a: complex) -> complex:
    """Return the vector of another length in the direction of one; zero for none."""
    return times(length / math.sqrt(max(a.real * a.real + a.imag * a.imag, _TINY)), a)


@kernel
def through(start: complex, middle: complex, end: complex, length: float) -> Force:
    """Return the parabola through three values over a step of a `length` [s]."""
    over = 1.0 / length
    return Force(
        start,
        times(over, times(4.0, middle) - times(3.0, start) - end),
        times(2.0 * over * over, start - times(2.0, middle) + end),
    )


@kernel
def _combined(
    row: NDArray[np.float64], first: int, v: complex, a: complex, p: complex, q: complex
) -> complex:
    """Return four vectors times the entries of a row from `first` on."""
    c0, c1, c2, c3 = row[first], row[first + 1], row[first + 2], row[first + 3]
    return complex(
        (c0 * v.real + c1 * a.real) + (c2 * p.real + c3 * q.real),
        (c0 * v.imag + c1 * a.imag) + (c2 * p.imag + c3 * q.imag),
    )


@kernel
def advance(
    row: NDArray[np.float64], stiffness: float, displacement: complex, velocity: complex, force: Force
) -> Course:
    """Advance the oscillator over a step under a force; `row` are its coefficients."""
    a, p, q = force.constant - times(stiffness, displacement), force.rate, times(2.0, force.curvature)
    return Course(
        displacement + _combined(row, 1, velocity, a, p, q),
        _combined(row, 0, velocity, a, p, q),
        displacement + _combined(row, END + 1, velocity, a, p, q),
        _combined(row, END, velocity, a, p, q),
    )


@kernel
def areas(
    row: NDArray[np.float64], stiffness: float, displacement: complex, velocity: complex, force: Force
) -> tuple[complex, complex]:
    """First [mm s] and second [mm s2] time integral of the displacement from its start over the whole step."""
    a, p, q = force.constant - times(stiffness, displacement), force.rate, times(2.0, force.curvature)
    return _combined(row, END + 2, velocity, a, p, q), _combined(row, END + 3, velocity, a, p, q)


@kernel
def work_of(force: Force, length: float, travel: complex, area: complex, moment: complex) -> float:
    """Integrate a force times the velocity over a step, exactly [mm2/s2]."""
    first = times(length, travel) - area
    second = times(length, times(length, travel) - times(2.0, area)) + times(2.0, moment)
    return dot(force.constant, travel) + dot(force.rate, first) + dot(force.curvature, second)


@kernel
def elongation_after(
    elongation: complex, start: float, end: float, travel: complex, velocity: complex, later: complex
) -> tuple[complex, bool]:
    """Return the elongation [mm] after a `travel` [mm] from one `velocity` [mm/s] to the `later` one, and whether it slides then.

    The radius of the yield surface goes from `start` to `end` [mm]. While it slides, the direction n of the elongation follows
    n' = (v - (v . n) n) / r, exactly for a velocity that turns uniformly: relative to the velocity it is z with
    z' = beta (1 - z2) + 2 i alpha z, of which the solution is a fraction of linear functions.
    """
    tried = elongation + travel
    if dot(tried, tried) <= end * end:
        return tried, False
    if end == 0.0:  # nothing presses
        return 0j, True
    e, d, va, ra = elongation, travel, velocity, start
    inside = dot(e, e) < ra * ra * (1.0 - 1e-12)
    if inside or dot(e, d) < ra * (end - ra):
        # elastic first, up to the yield surface: the larger root of |e + s d| = start + s (end - start)
        grow = end - start
        a = dot(d, d) - grow * grow
        b = dot(e, d) - start * grow
        c = dot(e, e) - start * start
        under = math.sqrt(max(b * b - a * c, 0.0))
        if a > 0.0:
            s = (under - b) / a if b <= 0.0 else -c / (under + b)
        else:
            s = -c / (2.0 * b) if b > 0.0 else 0.0
        s = min(max(s, 0.0), 1.0)
        e = e + times(s, d)
        d = times(1.0 - s, d)
        va = va + times(s, later - va)
        ra = ra + s * grow
    path = length_of(d)
    # half of the path over the mean radius
    beta = path / (ra + end)
    speed, later_speed = length_of(va), length_of(later)
    bend, both = later * va.conjugate(), speed * later_speed
    if bend.real >= _LEAST_COSINE * both and both > 0.0 and ra > 0.0:
        # half of the angle, from its tangent
        t = bend.imag / (both + bend.real)
        t2 = t * t
        half = t * (105.0 + 55.0 * t2) / (105.0 + t2 * (90.0 + 9.0 * t2))
        beta *= 1.0 + half * half * (1.0 / 6.0 + half * half * (7.0 / 360.0))  # the path is an arc
        q = beta * beta - half * half
        # tanh(sqrt(q)) / sqrt(q), as a fraction
        above, below = 1.0, 1.0
        if q < 0.16:
            above -= q * (1.0 / 3.0 - q * (2.0 / 15.0 - q * (17.0 / 315.0 - q * (62.0 / 2835.0))))
        else:
            root = math.sqrt(q)
            fading = exp_neg(2.0 * root)
            above, below = 1.0 - fading, root * (1.0 + fading)
        # the direction relative to the velocity: its length stays one, so that the fraction is z times that of conjugate numbers
        z = times(1.0 / (ra * speed), e * va.conjugate())
        w = complex(below + above * (beta * z.real), -above * (beta * z.imag + half))
        square = dot(w, w)
        return times(end / (later_speed * square), later * (z * (w * w))), True
    # on the chord: the tangent of half the angle fades with the path
    z = of_length(1.0, e * d.conjugate())
    half = z.imag / max(1.0 + z.real, 1e-12) * exp_neg(2.0 * beta)
    return of_length(end, d * complex(1.0 - half * half, 2.0 * half)), True
