"""What a study can vary, of the ground motion, the system and the procedure; and how that is sampled."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Annotated, Any, TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.methods import METHODS
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import PGV, Parameter, unknown
from dcfp.schema.units import M_PER_S2, NONE
from dcfp.system import System, system_parameters
from dcfp.system.system import OF_LAW as OF_LAW

Value: TypeAlias = float | str

#: Factors of the ground motion.
OF_MOTION = {
    "record": Parameter("ground motion", key="record", kind=str),
    "pgv": PGV,
    "pga": Parameter("peak ground acceleration", M_PER_S2, 1e-3, 200.0, symbol=r"\mathrm{PGA}", key="pga"),
    "scale": Parameter("factor on the ground motion", NONE, 1e-3, 1e3, key="scale"),
}
_BEARING = Parameter("bearing file", key="bearing", kind=str)
_PROCEDURE = Parameter("response history analysis, or a method of prediction", key="procedure", kind=str)
#: The procedure that is the analysis itself; the others are the methods of prediction.
ANALYSIS = "analysis"


def catalogue() -> dict[str, Parameter]:
    """Return every factor by its name, in the order in which they are applied: a whole bearing first, then the law, then what changes a law."""
    of_system = {
        key: replace(one, counts=(), repeat=1, optional=False)
        for key, one in system_parameters().items()
        if one.vary
    }
    procedure = replace(_PROCEDURE, choices=(ANALYSIS, *METHODS))
    return {**OF_MOTION, "bearing": _BEARING, **of_system, "procedure": procedure}


def factor(name: str) -> Parameter:
    """Return a factor by its name; ``friction.`` and a name is that parameter of the friction law.

    Raises
    ------
    InputError
        If there is none of that name.
    """
    known = catalogue()
    if name not in known:
        msg = unknown(name, known, "factor")
        raise InputError(msg)
    return known[name]


def is_of_system(name: str) -> bool:
    """Whether a factor changes the bearing, its friction or its heating."""
    return name not in OF_MOTION and name != _PROCEDURE.key


def changed(system: System, values: Mapping[str, Value], bearings: Mapping[str, System]) -> System:
    """Return a system with the values of factors put before its own; the factor ``bearing`` names one of `bearings`.

    Raises
    ------
    InputError
        If there cannot be such a system.
    """
    if "bearing" in values:
        system = bearings[str(values["bearing"])]
    return system.changed({name: value for name, value in values.items() if name != "bearing"})


LATIN_HYPERCUBE, SOBOL, SALTELLI = "latin-hypercube", "sobol", "saltelli"
DESIGNS = (LATIN_HYPERCUBE, SOBOL, SALTELLI)


@dataclass(frozen=True)
class Uniform:
    """Equally likely between two values; with `logarithmic` the logarithm is."""

    least: float
    most: float
    logarithmic: bool = False

    def __post_init__(self) -> None:
        if not (math.isfinite(self.least) and math.isfinite(self.most) and self.least < self.most):
            msg = f"a range goes from a smaller to a larger number, not from {self.least:g} to {self.most:g}."
            raise InputError(msg)
        if self.logarithmic and self.least <= 0.0:
            msg = f"a logarithmic range must be of positive numbers, not from {self.least:g}."
            raise InputError(msg)

    def at(self, probability: FloatArray) -> FloatArray:
        """Return the value that is not exceeded with a probability [-]."""
        if self.logarithmic:
            return self.least * (self.most / self.least) ** probability
        return self.least + (self.most - self.least) * probability


@dataclass(frozen=True)
class Normal:
    """A normal distribution; with `logarithmic` of the logarithm: `centre` is then the median and `spread` the dispersion [-]."""

    centre: float
    spread: float
    logarithmic: bool = False

    def __post_init__(self) -> None:
        if not (math.isfinite(self.spread) and self.spread > 0.0 and math.isfinite(self.centre)):
            msg = f"the spread of a distribution must be a positive number, not {self.spread!r}."
            raise InputError(msg)
        if self.logarithmic and self.centre <= 0.0:
            msg = f"the median of a lognormal distribution must be positive, not {self.centre!r}."
            raise InputError(msg)

    def at(self, probability: FloatArray) -> FloatArray:
        """Return the value that is not exceeded with a probability [-]."""
        from scipy.special import ndtri

        standard = np.asarray(ndtri(probability))
        if self.logarithmic:
            return self.centre * np.exp(self.spread * standard)
        return self.centre + self.spread * standard


@dataclass(frozen=True)
class Choice:
    """Each of a few values, equally likely."""

    values: tuple[Value, ...]

    def __post_init__(self) -> None:
        if not self.values:
            msg = "a choice needs at least one value."
            raise InputError(msg)

    def at(self, probability: FloatArray) -> "np.ndarray[Any, Any]":
        """Return the value that is not exceeded with a probability [-], in the order of the values."""
        place = np.minimum((probability * len(self.values)).astype(np.intp), len(self.values) - 1)
        return np.array(self.values)[place]


Distribution: TypeAlias = Uniform | Normal | Choice


@declared
class Sampling(Declared):
    """A design over several factors, which vary together along the dimension ``sample``.

    Parameters
    ----------
    factors
        Distribution of each factor, in the units of the package.
    count
        Number of samples, a power of two for ``sobol`` and ``saltelli``; of the latter of base samples, each
        of which makes two more than there are factors.
    method
        ``"latin-hypercube"``, ``"sobol"``, or ``"saltelli"``, which is what Sobol indices need (Saltelli et
        al. 2010).
    """

    noun = "a sampling"

    factors: Mapping[str, Distribution]
    count: Annotated[int, Parameter("number of samples", NONE, 1, 1_000_000)]
    method: Annotated[str, Parameter("method", choices=DESIGNS)] = LATIN_HYPERCUBE
    seed: Annotated[int, Parameter("seed of the random numbers", NONE, 0)] = 1

    def check_relations(self) -> None:
        """Refuse a number of samples that the method does not have, and a design of no factor."""
        if self.method != LATIN_HYPERCUBE and self.count & (self.count - 1):
            near = 1 << (self.count.bit_length() - 1)
            msg = f"{self.method} needs a power of two samples, for example {near} or {2 * near}, not {self.count}."
            raise InputError(msg)
        if not self.factors:
            msg = "nothing is sampled; give at least one factor."
            raise InputError(msg)

    def values(self) -> dict[str, "np.ndarray[Any, Any]"]:
        """Return the values of each factor, shape (samples,)."""
        design = self._design()
        return {
            name: distribution.at(column)
            for (name, distribution), column in zip(self.factors.items(), design.T, strict=True)
        }

    def _design(self) -> FloatArray:
        """Return points of the unit cube, shape (samples, factors)."""
        size = len(self.factors)
        if self.method == SALTELLI:
            problem = {"num_vars": size, "names": list(self.factors), "bounds": [[0.0, 1.0]] * size}
            sample = salib("sample.sobol").sample
            return np.asarray(sample(problem, self.count, calc_second_order=False, seed=self.seed))
        from scipy.stats import qmc

        sampler: Any = qmc.LatinHypercube if self.method == LATIN_HYPERCUBE else qmc.Sobol
        return np.asarray(sampler(d=size, rng=np.random.default_rng(self.seed)).random(self.count))


def salib(part: str) -> Any:
    """Return a module of SALib.

    Raises
    ------
    InputError
        If it is not installed.
    """
    try:
        return import_module(f"SALib.{part}")
    except ImportError as error:
        msg = "samples in the scheme of Saltelli and Sobol indices need SALib; install it with pip install 'dcfp[studies]'."
        raise InputError(msg) from error
