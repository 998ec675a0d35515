"""A study: which analyses, and what of each is kept."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.analysis.integration import DEFAULT, Integration
from dcfp.analysis.response import HISTORIES
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import refuse_a_drift
from dcfp.schema.notebook import card
from dcfp.schema.parameters import Parameter, unknown
from dcfp.study.factors import ANALYSIS, Value, factor
from dcfp.study.results import INTENSITIES
from dcfp.study.sampling import Choice, Distribution, Sampling, Uniform
from dcfp.system import System

if TYPE_CHECKING:
    from dcfp.study.plan import Plan

RECORD, SAMPLE = "record", "sample"


@dataclass(frozen=True, eq=False)
class Study:
    """Analyses of every combination of the factors.

    Parameters
    ----------
    motions
        The ground motions, unscaled.
    factors
        Values of each factor of the grid in the units of the package, in the order of the dimensions of the results; ``record``
        stands first unless it is named here (then with the names of the motions). Those of one value are a dimension too.
    sampling
        Factors that vary together instead of each with each.
    model
        The bearing, law and heating that the factors change.
    bearings
        Models that the factor ``bearing`` names.
    title, name
        For people, and for files.
    settings
        How each analysis goes.
    histories
        Names of the histories that are kept besides the peaks, over the length of each record.
    text
        The study file, where it came from one.

    Raises
    ------
    InputError
        If a factor is not known, has no value, has one twice, or a value that cannot be.
    """

    motions: Sequence[GroundMotion]
    factors: Mapping[str, Sequence[Value]] = field(default_factory=dict[str, Sequence[Value]])
    sampling: Sampling | None = None
    model: System = field(default_factory=System)
    bearings: Mapping[str, System] = field(default_factory=dict[str, System])
    title: str = "Study"
    name: str = "study"
    settings: Integration = DEFAULT
    histories: tuple[str, ...] = ()
    text: str = ""

    def __post_init__(self) -> None:
        names = [motion.name for motion in self.motions]
        if not names:
            msg = "factor 'record' has no value; name at least one record, for example NCC."
            raise InputError(msg)
        _refuse_twice(self.motions)
        given = dict(self.factors)
        sampled: dict[str, Distribution] = {}
        if self.sampling is not None:
            sampled |= self.sampling.factors
        grid = given if RECORD in given or RECORD in sampled else {RECORD: names, **given}
        both = sorted(set(grid) & set(sampled))
        if both:
            msg = f"factor {both[0]!r} is both in the grid and sampled; give it once."
            raise InputError(msg)
        known = {name: self._factor(name) for name in (*grid, *sampled)}
        checked = {name: _checked(known[name], _plain(values)) for name, values in grid.items()}
        object.__setattr__(self, "factors", checked)
        if self.sampling is not None:
            drawn = {name: _checked_distribution(known[name], one) for name, one in sampled.items()}
            object.__setattr__(self, "sampling", replace(self.sampling, factors=drawn))
        for name in self.histories:
            if name not in HISTORIES:
                raise InputError(unknown(name, HISTORIES, "history"))
        _refuse_without_effect(self)
        if self.intensity in ("pgv", "pga"):
            for motion in self.motions:
                _check_scalable(motion)

    def _factor(self, name: str) -> Parameter:
        """Return a factor with the words that it may have here."""
        one = factor(name)
        choices = {
            RECORD: tuple(motion.name for motion in self.motions),
            "bearing": tuple(self.bearings),
        }
        return replace(one, choices=choices.get(name, one.choices))

    def values_of(self, name: str) -> list[Value] | None:
        """Return the values that a factor can have: of the grid, or of a choice that is sampled; None where it is not varied or has a range."""
        if name in self.factors:
            return list(self.factors[name])
        one = None if self.sampling is None else self.sampling.factors.get(name)
        return list(one.values) if isinstance(one, Choice) else None

    @cached_property
    def plan(self) -> "Plan":
        """What the study comes to.

        Raises
        ------
        InputError
            If a bearing, law or heating that it needs cannot be.
        """
        from dcfp.study.plan import Plan

        return Plan(self)

    def __getstate__(self) -> dict[str, Any]:
        # the plan is made again where the study is unpacked
        return {name: value for name, value in vars(self).items() if name != "plan"}

    @property
    def intensity(self) -> str | None:
        """Name of the factor that scales the ground motions."""
        sampling = self.sampling
        sampled = sampling.factors.keys() if sampling is not None else frozenset[str]()
        return next((name for name in INTENSITIES if name in self.factors or name in sampled), None)

    def _repr_html_(self) -> str:
        facts = {
            "records": tuple(motion.name for motion in self.motions),
            **{name: tuple(values) for name, values in self.factors.items() if name != RECORD},
            "analyses": self.plan.count,
            "bearing": self.model.bearing.name,
        }
        return card(self.title, facts)


def _plain(values: Any) -> list[Value]:
    """Return values as a list of Python's own numbers, also those of an array."""
    found: list[Value] = values.tolist() if isinstance(values, np.ndarray) else list(values)
    return found


def _refuse_twice(motions: Sequence[GroundMotion]) -> None:
    seen: dict[str, str] = {}
    names: set[str] = set()
    for motion in motions:
        other = seen.setdefault(motion.digest, motion.name)
        if motion.name in names or other != motion.name:
            what = "named twice" if motion.name in names else f"the same record as {other}"
            msg = f"{motion.name}: this is {what}; name it once, or it would count twice."
            raise InputError(msg)
        names.add(motion.name)


def _refuse_without_effect(study: Study) -> None:
    """Refuse factors that would change nothing, or undo each other."""
    sampled = study.sampling.factors.keys() if study.sampling is not None else frozenset[str]()
    names = {*study.factors, *sampled}
    chosen = [name for name in INTENSITIES if name in names]
    if len(chosen) > 1:
        msg = f"{' and '.join(chosen)} both scale the ground motions; give one of them."
        raise InputError(msg)
    if "radius" in names and names & {"lower_radius", "upper_radius"}:
        msg = "radius is that of each plate, so that lower_radius and upper_radius have no place beside it."
        raise InputError(msg)
    heatings = study.values_of("heating") or [study.model.heating.name]
    idle = sorted(names & {"conductivity", "diffusivity", "thickness"})
    if idle and heatings == ["none"] and not study.bearings:
        msg = f"without heating {idle[0]!r} changes nothing; leave it out, or choose another heating."
        raise InputError(msg)
    if study.histories and ANALYSIS not in (study.values_of("procedure") or [ANALYSIS]):
        msg = f"histories are of the procedure {ANALYSIS!r}, which is not among those of the study."
        raise InputError(msg)


def _check_scalable(motion: GroundMotion) -> None:
    refuse_a_drift(motion)
    if motion.peak_velocity == 0.0:
        msg = f"{motion.name}: every value is zero, so the record cannot be scaled."
        raise InputError(msg)


def _checked(one: Parameter, values: Sequence[Value]) -> list[Value]:
    """Return the values of a factor, words as they are declared."""
    if len(values) == 0:
        msg = f"factor {one.key!r} has no value; give it at least one."
        raise InputError(msg)
    allowed = [_allowed(one, value) for value in values]
    found = list(values) if one.is_number else allowed  # a number keeps its last digit
    if len(set(found)) != len(found):
        twice = next(value for value in found if found.count(value) > 1)
        shown = repr(twice) if isinstance(twice, str) else one.text(twice)
        msg = f"factor {one.key!r} has the value {shown} twice; give it once."
        raise InputError(msg)
    return found


def _allowed(one: Parameter, value: Any) -> Any:
    """Return a value of a factor if it is allowed; a complaint has it in the declared unit."""
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return one.checked(one.unit.shown(value) if is_number else value, f"factor {one.key!r}", one.unit)


def _checked_distribution(one: Parameter, distribution: Distribution) -> Distribution:
    if isinstance(distribution, Choice):
        return Choice(tuple(_checked(one, distribution.values)))
    if not one.is_number:
        msg = f"factor {one.key!r} takes words; sample it from a list of values."
        raise InputError(msg)
    # what a sample will hardly ever leave: the whole range, or four standard deviations
    ends = np.array([0.0, 1.0]) if isinstance(distribution, Uniform) else np.array([3.2e-5, 1.0 - 3.2e-5])
    for value in distribution.at(ends).tolist():
        _allowed(one, value)
    return distribution
