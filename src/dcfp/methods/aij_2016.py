"""The two equivalent-linear methods and the energy balance of the AIJ recommendations for isolated buildings (2016).

The recommendations themselves were not read: Li et al. (2020), section 2, describe the methods, and the equations follow from that. F_h is that of
Notification 2009 and agrees in five sources; its floor of 0.4 is in one, word for word. The part of 0.8 of the loop's damping was found nowhere (the calculation
basis of matsumok/Squid-N takes the whole), nor was D_h.
"""

import math
from collections.abc import Callable

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.methods.equivalent_linear import PendulumWithFriction, agreements, iterate, several
from dcfp.methods.result import Answer
from dcfp.methods.spectra.elastic import ElasticSpectrum
from dcfp.schema.checks import positive

METHOD_1, METHOD_2, ENERGY_BALANCE = "AIJ method 1", "AIJ method 2", "AIJ energy balance"
#: Part of the damping of a steady loop that counts in an earthquake [-].
_LOOP_PART = 0.8
#: Least damping correction [-].
_LEAST_CORRECTION = 0.4
#: Steady loops at the largest displacement that dissipate the energy of the earthquake [-]: Akiyama (1985).
LOOPS = 2.0
_HALVINGS = 200

_PART = "the part of 0.8 of the loop's damping"
_FLOOR = "the least F_h of 0.4, which one source gives"
_KASAI = "D_h for recorded motions"


def equivalent_damping(pendulum: PendulumWithFriction, displacement: float) -> float:
    """Damping ratio h_eq = 0.8 / (4 pi) dW / W [-] at a displacement [mm]: 0.8 of that of the steady loop, unconfirmed."""
    return _LOOP_PART * pendulum.effective_damping(displacement)


def damping_correction(damping: float) -> float:
    """Factor F_h = 1.5 / (1 + 10 h) [-] at a damping ratio [-], at least 0.4 (one source); above 1 only below a damping of 5 %."""
    return max(1.5 / (1.0 + 10.0 * damping), _LEAST_CORRECTION)


def kasai_correction(damping: float, reference: float = 0.05) -> float:
    """Factor D_h = sqrt((1 + 25 h0) / (1 + 25 h)) [-] for recorded motions at a damping ratio [-]; Kasai et al. (2003), unconfirmed."""
    return math.sqrt((1.0 + 25.0 * reference) / (1.0 + 25.0 * damping))


def _unconfirmed(correction: Callable[[float], float]) -> tuple[str, ...]:
    of_correction: dict[Callable[[float], float], tuple[str, ...]] = {
        damping_correction: (_FLOOR,),
        kasai_correction: (_KASAI,),
    }
    return (_PART, *of_correction.get(correction, ()))


def method_1(
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    correction: Callable[[float], float] = damping_correction,
) -> Answer:
    """Iterate on equivalent period and damping against a response spectrum.

    Raises
    ------
    AnalysisError
        If the iteration has no solution.
    """

    def damping(at: float) -> float:
        return equivalent_damping(pendulum, at)

    steps = iterate(pendulum, spectrum, correction, damping)
    last = steps[-1]
    return Answer(
        method=METHOD_1,
        displacement=last.displacement,
        base_shear=pendulum.force(last.displacement),
        period=last.period,
        damping=last.damping,
        steps=steps,
        unconfirmed=(*spectrum.unconfirmed, *_unconfirmed(correction)),
        remarks=several(agreements(pendulum, spectrum, correction, damping), steps),
    )


def reduction_curve(
    ratio: FloatArray, correction: Callable[[float], float] = damping_correction
) -> tuple[FloatArray, FloatArray]:
    r"""Return displacement and base shear over those of the frictionless pendulum under a constant velocity spectrum [-], shape (n,).

    `ratio` is alpha = mu R / D [-], the friction over the pendulum's force. With :math:`\omega_{eq} = \omega_f \sqrt{1 + \alpha}` and h_eq, which
    depends on alpha alone,

    .. math:: D / D_f = F_h / \sqrt{1 + \alpha}, \qquad Q / Q_f = F_h \sqrt{1 + \alpha}
    """
    damping = _LOOP_PART * 2.0 / np.pi * ratio / (1.0 + ratio)
    F_h = np.array([correction(float(h)) for h in np.atleast_1d(damping)])
    return F_h / np.sqrt(1.0 + ratio), F_h * np.sqrt(1.0 + ratio)


def method_2(
    pendulum: PendulumWithFriction,
    pseudo_velocity: float,
    correction: Callable[[float], float] = damping_correction,
) -> Answer:
    """Read the response off the reduction curve of a velocity spectrum that is constant over the period, without iteration on a spectrum.

    `pseudo_velocity` S_v at a damping of 5 % [mm/s].
    """
    S_v = positive(pseudo_velocity, "pseudo-velocity", "mm/s")
    free = S_v / pendulum.free_frequency

    def displacement(alpha: float) -> float:
        return free * float(reduction_curve(np.array([alpha]), correction)[0][0])

    # the point of the curve whose alpha is that of the bearing at its displacement: alpha D(alpha) = mu R
    low, high = 1e-12, 1e12
    for _ in range(_HALVINGS):
        alpha = math.sqrt(low * high)
        low, high = (alpha, high) if alpha * displacement(alpha) < pendulum.rest else (low, alpha)
    D = displacement(math.sqrt(low * high))
    return Answer(
        method=METHOD_2,
        displacement=D,
        base_shear=pendulum.force(D),
        period=pendulum.effective_period(D),
        damping=equivalent_damping(pendulum, D),
        unconfirmed=_unconfirmed(correction),
    )


def energy_balance(
    pendulum: PendulumWithFriction, equivalent_velocity: float, loops: float = LOOPS
) -> Answer:
    r"""Return the displacement at which spring and friction take up the energy of the earthquake.

    .. math:: \tfrac12 k_f D^2 + 4 n_1 \mu W D = \tfrac12 M V_E^2

    `equivalent_velocity` V_E [mm/s]; `loops` n_1 [-], two steady loops at the largest displacement. With
    :math:`\omega_f = \sqrt{g/R}` and :math:`a = \mu g / (\omega_f V_E)`, :math:`D \omega_f / V_E = \sqrt{(4 n_1 a)^2 + 1} - 4 n_1 a`.
    """
    V_E = positive(equivalent_velocity, "equivalent velocity V_E", "mm/s")
    n_1 = positive(loops, "number of loops", "-")
    omega = pendulum.free_frequency
    a = pendulum.friction * pendulum.radius * omega / V_E  # mu g / (omega V_E), with g = omega^2 R
    b = 4.0 * n_1 * a
    D = V_E / omega / (b + math.hypot(b, 1.0))  # the difference of the roots, without cancelling
    return Answer(method=ENERGY_BALANCE, displacement=D, base_shear=pendulum.force(D))


def energy_balance_curve(
    radius: float, frictions: FloatArray, equivalent_velocity: float, loops: float = LOOPS
) -> tuple[FloatArray, FloatArray]:
    """Return displacement [mm] and base shear coefficient [-] for each coefficient of friction [-], shape (n,); the curve of the recommendations."""
    answers = [
        energy_balance(PendulumWithFriction(radius, float(friction)), equivalent_velocity, loops)
        for friction in frictions
    ]
    return np.array([one.displacement for one in answers]), np.array([one.base_shear for one in answers])
