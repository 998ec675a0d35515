"""The law at the samples of several tests, its fit, how sure the estimates are, and what it leaves unexplained."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import lmfit
import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError, InputError
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.schema.declared import parameters
from dcfp.schema.parameters import Parameter, unknown
from dcfp.system import Heating, System
from dcfp.system.friction import FittedFriction
from dcfp.system.system import OF_LAW

#: Times that the scatter of each test is taken from the residuals and the fit repeated.
_ROUNDS = 2
#: Least scatter of a test over the coefficient, below which weights would tell of rounding errors [-].
_LEAST_SCATTER = 1e-6
#: Condition of scaled normal equations above which they determine nothing.
_LARGEST_CONDITION = 1e12
#: Length of a block over that of the correlation of the residuals, below which the intervals may be too short [-].
_LEAST_BLOCK = 4.0
#: Mean residual over the standard error of a stroke's mean, above which the law is said to miss a test [-], and over the coefficient [-].
_MISSES, _LEAST_MISS = 5.0, 0.01


#: Probability that an interval contains the truth.
CONFIDENCE = 0.95
_DECLARED = {**parameters(FittedFriction), **parameters(Heating)}


@dataclass(frozen=True)
class FitParameter(Parameter):
    """A declared constant of the law, or of the plates, that can be fitted.

    A scale is positive by its nature, so that its interval is symmetric in its logarithm. The `worth` is half
    of the longest 95 % interval at which the data are said to determine it, in its unit, of a scale over the
    estimate.
    """

    worth: float = math.inf
    is_scale: bool = False


def _fitted(name: str, worth: float, *, is_scale: bool = False, **limits: float) -> FitParameter:
    known: dict[str, Any] = {
        one.name: getattr(_DECLARED[name], one.name) for one in fields(Parameter)
    } | limits
    return FitParameter(**known, worth=worth, is_scale=is_scale)


#: What can be fitted, by name, in the order in which it is told; of the limits some are closer than those of the law.
PARAMETERS = {
    one.name: one
    for one in (
        _fitted("mu_0", 0.25, is_scale=True, least=1e-4, most=0.99),
        _fitted("pressure_exponent", 0.15),
        _fitted("pressure_floor", 0.5, most=0.999),
        _fitted("speed_drop", 0.25),
        _fitted("speed_rate", 0.5, is_scale=True, least=1e-5),
        _fitted("temperature_rate", 0.007),
        _fitted("conductivity", 0.5, is_scale=True),
    )
}
#: What can only be fixed.
REFERENCES = ("reference_pressure", "reference_temperature", "diffusivity")


def parameter(name: str) -> FitParameter:
    """Return a parameter by its name.

    Raises
    ------
    InputError
        If there is none of that name, or it is one that can only be fixed.
    """
    if name in PARAMETERS:
        return PARAMETERS[name]
    if name == "diffusivity":
        msg = (
            "The diffusivity cannot be fitted: in a half-space only sqrt(diffusivity) / conductivity acts on the temperature of the contact;"
            " fit the conductivity, or fix both."
        )
    elif name in REFERENCES:
        msg = f"The {name} cannot be fitted, it is where mu_0 stands; choose it (fix {name}=VALUE)."
    else:
        msg = f"Identification: {unknown(name, PARAMETERS, 'parameter')}"
    raise InputError(msg)


def unit_of(name: str) -> str:
    """Return the unit of a constant as it is typed; empty for a number."""
    unit = _DECLARED[name].unit
    return unit.name.replace("°", "deg").replace("²", "2") if unit.has_dimension else ""


def value_of(system: System, name: str) -> float:
    """Return a constant of the law or of the plates by its name."""
    return float(getattr(system.friction if hasattr(system.friction, name) else system.heating, name))


def with_values(system: System, values: Mapping[str, float]) -> System:
    """Return a system with some of the constants of its law and of its plates changed.

    Raises
    ------
    InputError
        If there is none of a name, or a value is out of range.
    """
    known = [name if name in REFERENCES else parameter(name).name for name in values]
    of_law = parameters(FittedFriction)
    return system.changed({f"{OF_LAW}{name}" if name in of_law else name: values[name] for name in known})


def in_order(names: Iterable[str]) -> tuple[str, ...]:
    """Return the names of parameters in the order in which they are told, each once."""
    wanted = set(names)
    return tuple(name for name in PARAMETERS if name in wanted)


#: Blocks that the samples are cut into, at least; a stroke is one where there are enough of them.
_FEWEST_BLOCKS = 30


@dataclass(frozen=True, eq=False)
class Samples:
    """Samples of sliding; every array has the shape (n,).

    The rise is that of the temperature above the start, with the conductivity that it was calculated with
    [degC]; within a block errors may depend on each other.
    """

    coefficient: FloatArray
    pressure: FloatArray
    speed: FloatArray
    rise: FloatArray
    test: NDArray[np.int64]
    block: NDArray[np.int64]

    @classmethod
    def of(cls, histories: Sequence[FrictionHistory], ambient: float) -> "Samples":
        """Put the histories together, whose plates started at a temperature [degC]."""
        tests = np.concatenate([np.full(np.count_nonzero(h.used), i) for i, h in enumerate(histories)])
        return cls(
            coefficient=np.concatenate([h.coefficient[h.used] for h in histories]),
            pressure=np.concatenate([h.pressure[h.used] for h in histories]),
            speed=np.concatenate([h.speed[h.used] for h in histories]),
            rise=np.concatenate([h.temperature[h.used] - ambient for h in histories]),
            test=tests,
            block=_blocks([h.stroke[h.used] for h in histories]),
        )


def _blocks(strokes: Sequence[NDArray[np.int64]]) -> NDArray[np.int64]:
    """Return the number of the stroke of each sample of all tests; where strokes are few, each is cut in equal parts."""
    found = sum(np.unique(own).size for own in strokes)
    parts = -(-_FEWEST_BLOCKS // found)
    numbers: list[NDArray[np.int64]] = []
    count = 0
    for own in strokes:
        number = np.empty(own.size, dtype=np.int64)
        for stroke in np.unique(own):
            place = np.flatnonzero(own == stroke)
            number[place] = count + np.arange(place.size) * parts // place.size
            count += parts
        numbers.append(number)
    return np.unique(np.concatenate(numbers), return_inverse=True)[1]


class LawAtSamples:
    """The law at the samples, whose rises are those with the conductivity and the ambient temperature of a system."""

    def __init__(self, samples: Samples, system: System) -> None:
        self.speed = samples.speed
        self.rise = samples.rise
        self.pressure = np.log(samples.pressure / value_of(system, "reference_pressure"))
        self.start = system.heating.ambient - value_of(system, "reference_temperature")
        self.conductivity = system.heating.conductivity

    def __call__(self, values: Mapping[str, float]) -> FloatArray:
        """Return the coefficient [-]."""
        return self.derivatives(values, ())[0]

    def derivatives(self, values: Mapping[str, float], names: Sequence[str]) -> tuple[FloatArray, FloatArray]:
        """Return the coefficient [-], and its derivatives by the parameters, shape (n, parameters)."""
        floor, rate = values["pressure_floor"], values["temperature_rate"]
        power = np.exp(-values["pressure_exponent"] * self.pressure)
        gamma = (1.0 - floor) * power + floor
        faded = np.exp(-values["speed_rate"] * self.speed)
        alpha = 1.0 - values["speed_drop"] * faded
        rise = self.rise * (self.conductivity / values["conductivity"])
        beta = np.exp(-rate * (self.start + rise))
        scaled = values["mu_0"] * beta
        coefficient = scaled * gamma * alpha
        columns: dict[str, Callable[[], FloatArray]] = {
            "mu_0": lambda: beta * gamma * alpha,
            "pressure_exponent": lambda: scaled * alpha * ((floor - 1.0) * power * self.pressure),
            "pressure_floor": lambda: scaled * alpha * (1.0 - power),
            "speed_drop": lambda: -scaled * gamma * faded,
            "speed_rate": lambda: scaled * gamma * (values["speed_drop"] * self.speed * faded),
            "temperature_rate": lambda: -coefficient * (self.start + rise),
            "conductivity": lambda: coefficient * rise * (rate / values["conductivity"]),
        }
        slopes = [columns[name]() for name in names]
        return coefficient, np.stack(slopes, axis=1) if slopes else np.empty((coefficient.size, 0))


@dataclass(frozen=True, eq=False)
class Jackknife:
    """Covariance of least squares estimates, infinite where a block alone determines one, and its degrees of freedom.

    The parameter `lost` cannot be told from the others, where there is one.
    """

    covariance: FloatArray
    freedom: FloatArray
    blocks: int
    lost: int | None = None

    @property
    def standard_error(self) -> FloatArray:
        """Standard errors of the estimates."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def half_width(self) -> FloatArray:
        """Half of the length of the 95 % intervals."""
        return np.asarray(student.ppf(0.5 + 0.5 * CONFIDENCE, self.freedom)) * self.standard_error

    @property
    def correlation(self) -> FloatArray:
        """Correlation of the estimates."""
        error = self.standard_error
        with np.errstate(invalid="ignore"):
            return np.clip(self.covariance / np.outer(error, error), -1.0, 1.0)


@dataclass(frozen=True, eq=False)
class Fit:
    """A least squares fit: the names of the free parameters, the values of all, and how sure the free ones are.

    The residual is measured less fitted [-], the scatter its root mean square of each test [-].
    """

    names: tuple[str, ...]
    values: dict[str, float]
    jackknife: Jackknife
    residual: FloatArray
    scatter: FloatArray


def fit_law(samples: Samples, system: System, names: Sequence[str]) -> Fit:
    """Fit the parameters `names` to the samples; the others are those of the system's law and heating model.

    The squares of the residuals are weighted by the scatter of each test, which two rounds of the fit find;
    the solver is that of lmfit, a trust region within the limits of the parameters, with exact derivatives.

    Raises
    ------
    AnalysisError
        If the solver does not end.
    """
    law, measured = LawAtSamples(samples, system), samples.coefficient
    values = {name: value_of(system, name) for name in PARAMETERS}
    if "mu_0" in names:
        shape = law({**values, "mu_0": 1.0})
        values["mu_0"] = float(np.clip(np.median(measured / shape), 1e-3, 0.9))
    scatter = np.ones(int(samples.test.max()) + 1)
    for _ in range(_ROUNDS + 1):
        values = _solve(law, measured, 1.0 / scatter[samples.test], values, names)
        scatter = _scatter(samples, measured - law(values))
    weight = 1.0 / scatter[samples.test]
    fitted, slopes = law.derivatives(values, names)
    residual = measured - fitted
    return Fit(
        names=tuple(names),
        values=values,
        jackknife=jackknife(slopes * weight[:, None], residual * weight, samples.block),
        residual=residual,
        scatter=scatter,
    )


def _scatter(samples: Samples, residual: FloatArray) -> FloatArray:
    least = _LEAST_SCATTER * float(np.median(samples.coefficient))
    return np.maximum(np.sqrt(np.bincount(samples.test, residual**2) / np.bincount(samples.test)), least)


def _solve(
    law: LawAtSamples,
    measured: FloatArray,
    weight: FloatArray,
    start: Mapping[str, float],
    names: Sequence[str],
) -> dict[str, float]:
    free: Any = lmfit.Parameters()
    for name, value in start.items():
        one = PARAMETERS[name]
        free.add(name, value=value, min=one.least, max=one.most, vary=name in names)

    def residual(parameters: Any) -> FloatArray:
        return (law(parameters.valuesdict()) - measured) * weight

    def slopes(parameters: Any) -> FloatArray:
        return law.derivatives(parameters.valuesdict(), names)[1] * weight[:, None]

    # lmfit takes roots of a covariance that may be singular, and would warn; `jackknife` says how sure the estimates are
    with np.errstate(invalid="ignore", divide="ignore"):
        solved: Any = lmfit.Minimizer(residual, free).least_squares(
            jac=slopes, x_scale="jac", ftol=1e-12, xtol=1e-10, gtol=1e-12
        )
    if not solved.success:
        msg = f"The fit of {', '.join(names)} does not end ({solved.message}); fix one of them."
        raise AnalysisError(msg)
    return {name: float(value) for name, value in solved.params.valuesdict().items()}


def jackknife(slopes: FloatArray, residual: FloatArray, block: NDArray[np.int64]) -> Jackknife:
    r"""Return the covariance of least squares estimates by leaving out one block of samples after another.

    .. math:: \mathrm{Cov} = \frac{G - 1}{G} \sum_g d_g d_g^T, \quad d_g = (J^T J - J_g^T J_g)^{-1} J_g^T r_g

    J and r are the weighted slopes, shape (n, parameters), and residuals, shape (n,), at the solution, and
    :math:`d_g` is the change of the estimates when block g is left out, to first order. Within a block errors
    may depend on each other, from block to block they must not. This is the estimator CR3 for clustered
    errors (Bell and McCaffrey 2002), not too small in the mean where blocks weigh unequally. The degrees of
    freedom for Student's t follow from the part :math:`\tau_g^2` that each block has in the variance if all
    errors are alike, :math:`\nu = (\sum \tau_g^2)^2 / \sum \tau_g^4` (Satterthwaite).

    Parameters
    ----------
    slopes, residual
        J and r at the solution, weighted, shapes (n, parameters) and (n,).
    block
        Number of the block of each sample, from zero without gaps, shape (n,).
    """
    blocks, count = int(block.max()) + 1, int(slopes.shape[1])
    size = np.sqrt((slopes**2).sum(axis=0))
    size[size == 0.0] = 1.0
    order = np.argsort(block, kind="stable")
    bounds = np.searchsorted(block[order], np.arange(blocks))
    scaled = slopes[order] / size
    parts: list[FloatArray] = [part.T @ part for part in np.split(scaled, bounds[1:])]
    own: FloatArray = np.array(parts)
    pull: FloatArray = np.add.reduceat(scaled * residual[order, None], bounds, axis=0)
    whole: FloatArray = own.sum(axis=0)
    left: FloatArray = whole - own
    weakest = int(np.argmax(np.linalg.cond(left)))
    if not np.linalg.cond(left[weakest]) < _LARGEST_CONDITION:
        # the parameter that the equations tell least of; of several the last
        direction: FloatArray = np.abs(np.linalg.eigh(left[weakest])[1][:, 0])
        lost = int(np.flatnonzero(direction > 0.9 * direction.max())[-1])
        return Jackknife(np.full((count, count), np.inf), np.ones(count), blocks, lost)
    change = np.asarray(np.linalg.solve(left, pull[:, :, None])[:, :, 0], dtype=np.float64)
    covariance: FloatArray = (blocks - 1) / blocks * change.T @ change
    inverse = np.asarray(np.linalg.inv(whole), dtype=np.float64)
    share: FloatArray = np.einsum("ij,gjk,ki->gi", inverse, own, inverse)
    freedom = np.asarray(share.sum(axis=0) ** 2 / (share**2).sum(axis=0))
    return Jackknife(covariance / np.outer(size, size), freedom, blocks)


@dataclass(frozen=True)
class ResidualStatistics:
    """What the law leaves unexplained of one test, as `dcfp.inference.identification.result.RESIDUALS` says of each."""

    name: str
    samples: int
    left_out: int
    scatter: float
    bias: float
    relative_scatter: float
    correlation: float
    pressure: float
    peak_speed: float
    peak_temperature: float
    speed_window: int
    load_window: int


def residuals_of(
    histories: Sequence[FrictionHistory],
    temperatures: Sequence[FloatArray],
    samples: Samples,
    found: Fit,
) -> tuple[ResidualStatistics, ...]:
    """Return the statistics of each test, of which `temperatures` [degC] are those with the conductivity that was found."""
    rows: list[ResidualStatistics] = []
    for i, (history, temperature) in enumerate(zip(histories, temperatures, strict=True)):
        own = samples.test == i
        residual, scatter = found.residual[own], float(found.scatter[i])
        rows.append(
            ResidualStatistics(
                name=history.name,
                samples=int(residual.size),
                left_out=int(history.used.size - residual.size),
                scatter=scatter,
                bias=float(residual.mean()),
                relative_scatter=scatter / float(samples.coefficient[own].mean()),
                correlation=_correlation(residual, 1),
                pressure=float(samples.pressure[own].mean()),
                peak_speed=float(samples.speed[own].max()),
                peak_temperature=float(temperature[history.used].max()),
                speed_window=history.speed_window,
                load_window=history.load_window,
            )
        )
    return tuple(rows)


def remarks_on(histories: Sequence[FrictionHistory], samples: Samples, found: Fit) -> tuple[str, ...]:
    """Return what must be known of a fit."""
    remarks: list[str] = []
    for name in found.names:
        one = PARAMETERS[name]
        span = one.most - one.least
        for limit in (one.least, one.most):
            if abs(found.values[name] - limit) < 1e-6 * span and not (one.is_scale and limit == one.least):
                remarks.append(f"{name} is at its limit of {limit:g}: its interval is not to be trusted.")
    for i, history in enumerate(histories):
        own = samples.test == i
        residual = found.residual[own]
        blocks, sizes = np.unique(samples.block[own], return_counts=True)
        length = _correlation_length(residual, int(sizes.max()))
        if length * _LEAST_BLOCK > float(np.median(sizes)):
            remarks.append(
                f"{history.name}: the residuals stay alike for {length} samples, and the intervals come from blocks of {np.median(sizes):.0f}:"
                " they may be too short."
            )
        miss = abs(float(residual.mean()))
        means = np.bincount(samples.block[own], residual)[blocks] / sizes
        spread = float(np.std(means)) / np.sqrt(sizes.size)
        if miss > _MISSES * spread and miss > _LEAST_MISS * float(samples.coefficient[own].mean()):
            remarks.append(
                f"{history.name}: the law misses the mean coefficient of this test by {float(residual.mean()):+.4f}; its form, the bearing or the"
                " temperature at the start may not be those of the test."
            )
    return tuple(remarks)


def _correlation(residual: FloatArray, lag: int) -> float:
    """Return the correlation of residuals so many samples apart [-]; zero where there are none."""
    square = float(residual @ residual)
    return float(residual[lag:] @ residual[:-lag]) / square if square > 0.0 and lag < residual.size else 0.0


def _correlation_length(residual: FloatArray, longest: int) -> int:
    """Return after how many samples the correlation has fallen below 1/e."""
    lag = 1
    while lag < longest and _correlation(residual, lag) > np.exp(-1.0):
        lag = lag + 1 if lag < 20 else int(1.2 * lag)
    return lag
