"""Test programs: what is done to a bearing, one test after another."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from dcfp.analysis.rig.load import VerticalLoad
from dcfp.analysis.rig.waveform import Waveform
from dcfp.errors import InputError
from dcfp.schema.notebook import card, fields_card
from dcfp.system import Bearing
from dcfp.system.checks import finite
from dcfp.system.validity import LARGEST_ANGLE

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
    pause: float | None = None
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
            " amplitude, or give the bearing its true capacity (--capacity)."
        )
        raise InputError(msg)
    furthest = LARGEST_ANGLE * bearing.effective_radius
    if stroke > furthest:
        msg = (
            f"{test.name}: a stroke of {stroke:.4g} mm is more than half of the bearing's effective radius of"
            f" {bearing.effective_radius:g} mm; look at the unit of the displacement."
        )
        raise InputError(msg)
