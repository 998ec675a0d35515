"""Ground motions from formulas: harmonic, Ricker wavelet, and the pulse of Mavroeidis and Papageorgiou."""

import math

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion, Origin
from dcfp.schema.parameters import POSITIVE, Parameter
from dcfp.schema.units import NONE

#: Steps in a period where no time step is given; PGV is then within 0.03 % of the formula's.
STEPS_PER_PERIOD = 200

#: Largest number of values that is made.
MAXIMUM_POINTS = 10_000_000

_FINITE = Parameter("any", NONE)
_OSCILLATION = Parameter("oscillation", NONE, 1.0, 1000.0, above=True)


def harmonic(
    amplitude: float,
    period: float,
    cycles: float,
    *,
    phase: float = 0.0,
    ramp: float = 0.0,
    time_step: float | None = None,
) -> GroundMotion:
    r"""Return a harmonic acceleration, :math:`a(t) = A \sin(2\pi t/T + \varphi)`.

    Parameters
    ----------
    amplitude
        Amplitude of the acceleration [mm/s2].
    period
        Period [s].
    cycles
        Number of periods that it lasts [-].
    phase
        Phase at the beginning [rad].
    ramp
        Number of periods over which it grows at the beginning and fades at the end, along half a cosine [-].
    time_step
        Interval between two values [s]; `STEPS_PER_PERIOD` to a period when not given.

    Raises
    ------
    InputError
        If a parameter is not positive (the phase may be any number, the ramp zero), or the ramps overlap.

    Notes
    -----
    The ground starts from rest, so with phase 0 and no ramp its velocity is
    :math:`AT/2\pi\,(1-\cos 2\pi t/T)`, of one sign and with a peak of :math:`AT/\pi`; with phase
    :math:`\pi/2` the mean velocity is zero.
    """
    _check("harmonic", POSITIVE, amplitude=amplitude, period=period, cycles=cycles)
    _check("harmonic", _FINITE, phase=phase, ramp=ramp)
    if not 0.0 <= ramp <= 0.5 * cycles:
        msg = f"harmonic: the ramp must last 0 to {0.5 * cycles:g} periods, half of the motion, not {ramp!r}."
        raise InputError(msg)
    time, step = _times("harmonic", cycles * period, period, time_step)
    values = amplitude * np.sin(2.0 * math.pi * time / period + phase)
    if ramp > 0.0:
        share = np.clip(np.minimum(time, cycles * period - time) / (ramp * period), 0.0, 1.0)
        values = values * (0.5 * (1.0 - np.cos(math.pi * share)))
    values = np.where(time <= cycles * period * (1.0 + 1e-12), values, 0.0)
    text = f"A = {amplitude:g} mm/s2, T = {period:g} s, {cycles:g} cycles"
    return _motion("harmonic", values, step, f"{text}, phase {phase:g} rad, ramp {ramp:g} cycles")


def ricker(
    peak: float,
    frequency: float,
    *,
    quantity: str = "velocity",
    time_step: float | None = None,
) -> GroundMotion:
    r"""Return a ground motion whose velocity, or acceleration, is a Ricker wavelet.

    .. math:: w(t) = P\,(1 - 2u^2)\,e^{-u^2}, \quad u = \pi f (t - t_c)

    Parameters
    ----------
    peak
        Peak of the wavelet: PGV [mm/s] or PGA [mm/s2].
    frequency
        Frequency at which the wavelet's spectrum has its maximum [Hz].
    quantity
        What has this form: ``"velocity"`` (the acceleration is its exact derivative) or ``"acceleration"``.
    time_step
        Interval between two values [s]; `STEPS_PER_PERIOD` to ``1 / frequency`` when not given.

    Raises
    ------
    InputError
        If a parameter is not positive, or the quantity is neither.

    Notes
    -----
    The motion lasts ``4 / frequency`` with the wavelet's centre in the middle; before and after, the wavelet
    is less than 1e-14 of its peak. Its integral and, for the acceleration, its double integral vanish, so the
    ground comes to rest where it was.

    Reference: Ricker, N. (1953), The form and laws of propagation of seismic wavelets, Geophysics 18, 10-40.
    """
    _check("Ricker wavelet", POSITIVE, peak=peak, frequency=frequency)
    if quantity not in {"velocity", "acceleration"}:
        msg = f"Ricker wavelet: the quantity must be 'velocity' or 'acceleration', not {quantity!r}."
        raise InputError(msg)
    time, step = _times("Ricker wavelet", 4.0 / frequency, 1.0 / frequency, time_step)
    u = math.pi * (frequency * time - 2.0)
    if quantity == "velocity":
        values = peak * math.pi * frequency * (4.0 * u**3 - 6.0 * u) * np.exp(-(u**2))
    else:
        values = peak * (1.0 - 2.0 * u**2) * np.exp(-(u**2))
    unit = "mm/s" if quantity == "velocity" else "mm/s2"
    return _motion("Ricker wavelet", values, step, f"{quantity}, peak {peak:g} {unit}, f = {frequency:g} Hz")


def mavroeidis_papageorgiou(
    amplitude: float,
    frequency: float,
    oscillation: float,
    *,
    phase: float = 0.0,
    peak_time: float | None = None,
    duration: float | None = None,
    time_step: float | None = None,
) -> GroundMotion:
    r"""Return the near-fault velocity pulse of Mavroeidis and Papageorgiou (2003).

    .. math::
        v(t) = \frac{A}{2}\left[1 + \cos\frac{2\pi f_p}{\gamma}(t-t_0)\right]
               \cos\left[2\pi f_p (t-t_0) + \nu\right], \quad |t - t_0| \le \frac{\gamma}{2 f_p}

    and zero elsewhere. The acceleration is its exact derivative.

    Parameters
    ----------
    amplitude
        :math:`A`, the amplitude of the envelope of the velocity [mm/s]; PGV equals it where the phase is 0.
    frequency
        :math:`f_p`, the prevailing frequency [Hz].
    oscillation
        :math:`\gamma`, which sets how many cycles there are [-]; greater than 1.
    phase
        :math:`\nu` [rad]; 0 gives a symmetric and :math:`\pm\pi/2` an antisymmetric velocity.
    peak_time
        :math:`t_0`, the time of the envelope's peak [s]; :math:`\gamma/2f_p`, the earliest, when not given.
    duration
        Length of the motion [s]; to the end of the pulse when not given.
    time_step
        Interval between two values [s]; `STEPS_PER_PERIOD` to ``1 / frequency`` when not given.

    Raises
    ------
    InputError
        If a parameter is out of these bounds, or the pulse does not fit between 0 and the duration.

    Notes
    -----
    The ground comes to rest, but not where it was: its displacement afterwards is

    .. math:: d = \frac{A \cos\nu \sin\pi\gamma}{2\pi f_p\,(1-\gamma^2)}

    which is zero only for a whole :math:`\gamma` or :math:`\nu = \pm\pi/2`.

    Reference: Mavroeidis, G. P., and Papageorgiou, A. S. (2003), A mathematical representation of near-fault
    ground motions, Bulletin of the Seismological Society of America 93, 1099-1131.
    """
    name = "Mavroeidis-Papageorgiou pulse"
    _check(name, POSITIVE, amplitude=amplitude, frequency=frequency)
    _check(name, _FINITE, phase=phase)
    _check(name, _OSCILLATION, oscillation=oscillation)
    half = 0.5 * oscillation / frequency
    centre = half if peak_time is None else peak_time
    length = centre + half if duration is None else duration
    if not (half * (1.0 - 1e-9) <= centre <= (length - half) * (1.0 + 1e-9)):
        msg = f"{name}: the pulse lasts {half:g} s before and after its peak; this must fit into the motion."
        raise InputError(msg)
    time, step = _times(name, length, 1.0 / frequency, time_step)
    values = _pulse_acceleration(time - centre, amplitude, frequency, oscillation, phase)
    text = f"A = {amplitude:g} mm/s, f_p = {frequency:g} Hz, gamma = {oscillation:g}, nu = {phase:g} rad"
    return _motion(name, values, step, f"{text}, t_0 = {centre:g} s")


def _pulse_acceleration(
    time: FloatArray, amplitude: float, frequency: float, oscillation: float, phase: float
) -> FloatArray:
    slow = 2.0 * math.pi * frequency / oscillation * time
    fast = 2.0 * math.pi * frequency * time + phase
    shape = np.sin(slow) * np.cos(fast) + oscillation * np.sin(fast) * (1.0 + np.cos(slow))
    inside = np.abs(slow) < math.pi
    return np.where(inside, -amplitude * math.pi * frequency / oscillation * shape, 0.0)


def _times(name: str, length: float, period: float, time_step: float | None) -> tuple[FloatArray, float]:
    step = period / STEPS_PER_PERIOD if time_step is None else time_step
    _check(name, POSITIVE, time_step=step, duration=length)
    intervals = length / step
    if not intervals < MAXIMUM_POINTS:
        msg = f"{name}: {length:g} s at a time step of {step:g} s are too many values; take a longer step."
        raise InputError(msg)
    # One more step where the end falls between two values, so that the motion is whole.
    points = math.ceil(intervals * (1.0 - 1e-9)) + 1
    return np.arange(max(points, 2), dtype=np.float64) * step, step


def _motion(name: str, values: FloatArray, time_step: float, parameters: str) -> GroundMotion:
    origin = Origin(source=f"{name}: {parameters}", file_format="synthetic", processing="none needed")
    return GroundMotion(values, time_step, name, origin)


def _check(motion: str, rule: Parameter, **values: float) -> None:
    """Refuse values that a rule does not allow."""
    for name, value in values.items():
        rule.checked(value, f"{motion}: the {name.replace('_', ' ')}")
