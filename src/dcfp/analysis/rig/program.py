"""Test programs: what is done to a bearing, one test after another, and under which vertical load."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from dcfp.analysis.assumptions import LARGEST_ANGLE
from dcfp.analysis.rig.waveform import Waveform
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.checks import finite
from dcfp.schema.notebook import card, fields_card
from dcfp.schema.units import SECOND
from dcfp.system import Bearing

# The vertical load of a test.


#: Pressures on the slider that a wrong unit would pass [N/mm2].
LEAST_PRESSURE, LARGEST_PRESSURE = 0.1, 1000.0


@dataclass(frozen=True)
class VerticalLoad:
    """A vertical load, linear between its times and constant before and after them.

    Parameters
    ----------
    values
        Pressures on the slider [N/mm2], or forces [N].
    times
        At which they act [s]; increasing; none needed for a constant load.
    is_pressure
        Which of the two the values are.
    """

    values: tuple[float, ...]
    times: tuple[float, ...] = (0.0,)
    is_pressure: bool = True

    def __post_init__(self) -> None:
        if len(self.values) != len(self.times) or not self.values:
            msg = f"A vertical load has {len(self.times)} times but {len(self.values)} values."
            raise InputError(msg)
        if not np.isfinite([*self.values, *self.times]).all() or (np.diff(self.times) <= 0.0).any():
            msg = "The times of a vertical load must increase, and all its numbers must be finite."
            raise InputError(msg)
        if min(self.values) <= 0.0:
            what = "pressure" if self.is_pressure else "vertical force"
            msg = (
                f"The {what} falls to {min(self.values):g}: a sliding bearing takes no tension, so the load"
                " must stay above zero (compression is positive)."
            )
            raise InputError(msg)

    @classmethod
    def force(cls, newton: float) -> "VerticalLoad":
        """Return a constant force [N]."""
        return cls((newton,), is_pressure=False)

    def at(self, time: FloatArray, bearing: Bearing) -> FloatArray:
        """Return the force [N] at times [s].

        Raises
        ------
        InputError
            If the pressure is out of any sensible range, as it is where a unit was wrong.
        """
        factor = bearing.slider_area if self.is_pressure else 1.0
        forces = np.asarray(np.interp(time, self.times, np.array(self.values) * factor))
        check_load(forces, bearing)
        return forces


def check_load(forces: FloatArray, bearing: Bearing) -> None:
    """Refuse vertical forces [N] under which the pressure on the slider is out of any sensible range.

    Raises
    ------
    InputError
        If it is.
    """
    pressures = forces / bearing.slider_area
    for extreme in (float(pressures.min()), float(pressures.max())):
        if not LEAST_PRESSURE <= extreme <= LARGEST_PRESSURE:
            msg = (
                f"A vertical load of {extreme * bearing.slider_area / 1e3:.4g} kN puts {extreme:.3g} N/mm2 on a slider of"
                f" {bearing.slider_diameter:g} mm; from {LEAST_PRESSURE:g} to {LARGEST_PRESSURE:g} N/mm2 is possible:"
                " look at the unit of the load."
            )
            raise InputError(msg)


#: Longest pause [s].
_LONGEST_PAUSE = 7 * 24 * 3600.0
#: What a test can be to the checks of a code.
ROLES = ("wind", "increment", "maximum", "endurance", "stability")


@dataclass(frozen=True)
class RigTest:
    """One test.

    Parameters
    ----------
    name
        Such as ``"T01"``.
    waveform
        The displacement.
    load
        The vertical load; None for that of the bearing.
    pause
        Time of cooling between the test before and this one [s]; None where the plates begin at the ambient temperature.
    purpose
        What the test is for, in words.
    role
        What it is to the checks of a code: one of `ROLES`, or empty.
    """

    name: str
    waveform: Waveform
    load: VerticalLoad | None = None
    pause: float | None = field(default=None, metadata={"unit": SECOND})
    purpose: str = ""
    role: str = ""

    def __post_init__(self) -> None:
        if self.role and self.role not in ROLES:
            msg = f"The role of {self.name} must be one of {', '.join(ROLES)}, not {self.role!r}."
            raise InputError(msg)
        if self.pause is not None:
            finite(self.pause, "pause before a test", "s")
            if not 0.0 <= self.pause <= _LONGEST_PAUSE:
                msg = f"The pause before {self.name} must be from 0 to {_LONGEST_PAUSE:g} s, not {self.pause!r}."
                raise InputError(msg)

    def _repr_html_(self) -> str:
        return fields_card(self, f"Test {self.name}")


@dataclass(frozen=True)
class Program:
    """Tests in their order.

    Parameters
    ----------
    name
        What to call it.
    tests
        At least one.
    source
        Where it comes from, in words.
    citation
        Key of the source in the bibliography; empty for a user's own.
    code
        Name of the code whose checks the tests are to pass; empty for none.
    """

    name: str
    tests: tuple[RigTest, ...]
    source: str = ""
    citation: str = ""
    code: str = ""

    def __post_init__(self) -> None:
        if not self.tests:
            msg = f"{self.name}: a test program needs at least one test."
            raise InputError(msg)
        names = [test.name for test in self.tests]
        for name in names:
            if names.count(name) > 1:
                msg = f"{self.name}: two tests have the name {name!r}; give each its own."
                raise InputError(msg)

    @property
    def stories(self) -> tuple[tuple[RigTest, ...], ...]:
        """Runs of tests through which the plates keep their heat."""
        stories: list[list[RigTest]] = []
        for test in self.tests:
            if test.pause is None or not stories:
                stories.append([])
            stories[-1].append(test)
        return tuple(tuple(story) for story in stories)

    def only(self, names: Sequence[str]) -> "Program":
        """Return the program with some of its tests, in its own order, and with those before them whose heat is still in the plates.

        Raises
        ------
        InputError
            If it has no test of such a name.
        """
        known = [test.name for test in self.tests]
        for name in names:
            if name not in known:
                msg = f"{self.name} has no test {name!r}; it has {', '.join(known)}."
                raise InputError(msg)
        kept: list[RigTest] = []
        for story in self.stories:
            wanted = [place for place, test in enumerate(story) if test.name in names]
            kept.extend(story[: max(wanted) + 1] if wanted else ())
        return replace(self, tests=tuple(kept))

    def _repr_html_(self) -> str:
        rows = [
            {"test": one.name, "waveform": one.waveform.kind, "pause [s]": one.pause, "purpose": one.purpose}
            for one in self.tests
        ]
        return card(f"Test program {self.name}", {"source": self.source}, rows=rows)


def check_stroke(test: RigTest, bearing: Bearing) -> None:
    """Refuse a test that moves the slider beyond the plate.

    Raises
    ------
    InputError
        If the amplitude is above the bearing's capacity, or, where that is not known, above half of its effective radius.
    """
    stroke = test.waveform.travel().largest
    capacity = bearing.displacement_capacity
    if capacity is not None and stroke > capacity * (1.0 + 1e-9):
        msg = (
            f"{test.name}: a stroke of {stroke:.4g} mm goes beyond the plate, whose capacity is {capacity:g} mm; choose a smaller"
            " amplitude, or give the bearing its true capacity."
        )
        raise InputError(msg)
    furthest = LARGEST_ANGLE * bearing.effective_radius
    if stroke > furthest:
        msg = (
            f"{test.name}: a stroke of {stroke:.4g} mm is more than half of the bearing's effective radius of"
            f" {bearing.effective_radius:g} mm; look at the unit of the displacement."
        )
        raise InputError(msg)
