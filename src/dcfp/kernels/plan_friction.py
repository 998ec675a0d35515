"""Friction of a bearing under a load that changes."""

import math

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import coefficient
from dcfp.kernels.law import CYCLING, Law
from dcfp.kernels.plan_bearing import (
    AREA,
    FIRST_LOG,
    FORM,
    KNOWN_REFERENCE,
    LAW,
    LEAST_PRESSURE,
    OVER_KNOWN,
    PER_LOG,
    PLATES,
    POWER,
    REFERENCE,
    SHARE,
    SPEED,
    Bearings,
)

#: Change of a pressure over itself up to which the reference follows a power of it, by three terms.
_NEAR = 0.03


@kernel
def law_at(b: Bearings, i: int, kind: int, load: float, changes: bool) -> tuple[Law, float]:
    """Friction law of a bearing under a load [N], and its pressure [N/mm2]."""
    c, k = b.constants[i], b.kinds[kind]
    pressure = max(load / c[AREA], c[LEAST_PRESSURE])
    form, reference = int(k[FORM]), k[LAW]
    if form <= CYCLING:
        reference = _reference(b, i, kind, pressure) if changes else c[REFERENCE]
    return Law(
        form, reference, k[LAW + 1], k[LAW + 2], k[LAW + 3], k[LAW + 4], k[LAW + 5]
    ), pressure  # fmt: skip


@kernel
def _reference(b: Bearings, i: int, kind: int, pressure: float) -> float:
    """Return the reference of the law at a pressure [N/mm2]: by its power, from where it was looked up last if that is near."""
    s = b.state[i]
    off = pressure * s[OVER_KNOWN] - 1.0
    if not -_NEAR < off < _NEAR:
        k = b.kinds[kind]
        place = (math.log(pressure) - k[FIRST_LOG]) * k[PER_LOG]
        cell = min(max(int(place), 0), b.references.shape[1] - 2)
        low, high = b.references[kind, cell], b.references[kind, cell + 1]
        s[OVER_KNOWN], s[POWER] = 1.0 / pressure, (high - low) * k[PER_LOG]
        s[KNOWN_REFERENCE] = math.exp(low + (place - cell) * (high - low))
        return s[KNOWN_REFERENCE]
    power = s[POWER]
    bent = off * (power - 1.0) * (0.5 + off * (power - 2.0) * (1.0 / 6.0))
    return s[KNOWN_REFERENCE] * (1.0 + off * power * (1.0 + bent))


@kernel
def mean_of_plates(
    b: Bearings, kind: int, law: Law, pressure: float, speed: float, t0: float, t1: float, c0: float, c1: float
) -> tuple[float, float, float]:  # fmt: skip
    """Coefficient of a bearing [-], and of each plate, at their temperatures [degC] and cycling parameters [N/s]."""
    k = b.kinds[kind]
    one = coefficient(law, pressure, k[SPEED] * speed, t0, c0)
    if k[PLATES] == 1.0:
        return one, one, one
    other = coefficient(law, pressure, k[SPEED + 1] * speed, t1, c1)
    return k[SHARE] * one + k[SHARE + 1] * other, one, other
