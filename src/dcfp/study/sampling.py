"""Sampled factors: their distributions, and the designs that fill the space between them."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Annotated, Any, TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import NONE
from dcfp.study.factors import Value

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
        Number of samples; of ``saltelli`` of base samples, each of which makes two more than there are factors. A power of two for
        ``sobol`` and ``saltelli``.
    method
        ``"latin-hypercube"``, ``"sobol"``, or ``"saltelli"``, which is what Sobol indices need (Saltelli et al. 2010).
    seed
        Of the random numbers.

    Raises
    ------
    InputError
        If the method is not known or the count cannot be.
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
        design = _design(self.method, len(self.factors), self.count, self.seed, list(self.factors))
        return {
            name: distribution.at(column)
            for (name, distribution), column in zip(self.factors.items(), design.T, strict=True)
        }


def _design(method: str, factors: int, count: int, seed: int, names: Sequence[str]) -> FloatArray:
    """Return points of the unit cube, shape (samples, factors)."""
    if method == SALTELLI:
        return _saltelli(count, seed, names)
    from scipy.stats import qmc

    sampler: Any = qmc.LatinHypercube if method == LATIN_HYPERCUBE else qmc.Sobol
    return np.asarray(sampler(d=factors, rng=np.random.default_rng(seed)).random(count))


def _saltelli(count: int, seed: int, names: Sequence[str]) -> FloatArray:
    problem = {"num_vars": len(names), "names": list(names), "bounds": [[0.0, 1.0]] * len(names)}
    design = salib("sample.sobol").sample(problem, count, calc_second_order=False, seed=seed)
    return np.asarray(design, dtype=np.float64)


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
