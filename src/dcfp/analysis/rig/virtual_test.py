"""What results of virtual tests have in common, in one direction and in the plane: when they begin, and a row for each of their cycles or laps."""

import json
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from dcfp.analysis.result import Result
from dcfp.analysis.rig.program import RigTest
from dcfp.schema.notebook import card, told
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE, SECOND
from dcfp.system.plates import memory_of

if TYPE_CHECKING:
    from dcfp.analysis.rig.measures import Cycle
    from dcfp.analysis.rig.plane_loops import Lap

#: What is told of one test in one direction as a whole.
TEST = Quantities("quantity of a test")
TEST.add("test", Quantity("test", "name of the test", get="test.name"))
TEST.add("law", Quantity("friction", "friction law", get="friction_law.name"))
TEST.add("heating", Quantity("heating", "heating model", get="heating.name"))
TEST.add("waveform", Quantity("waveform", "waveform", get="test.waveform.kind"))
TEST.add("begins", Quantity("begins_s", "time since the plates were cold, at the start", SECOND, decimals=1, name="begins"))  # fmt: skip
TEST.add("count", Quantity("cycles", "number of cycles", NONE, decimals=0, get=lambda one: len(one.cycles)))
TEST.tell("peak_displacement", "displacement_max_mm", name="displacement_max", decimals=1)
TEST.tell("peak_velocity", "velocity_max_mm_s", name="velocity_max", decimals=3)
TEST.tell("peak_temperature", "temperature_max_degC", name="temperature_max", decimals=0)
TEST.tell("elapsed", "elapsed_s")


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class VirtualTest(Result, ABC):
    """Histories of one test.

    Attributes
    ----------
    begins
        Time at which the test begins since the plates were at the ambient temperature [s].
    round_name, rounds_key, rounds_told
        What it goes through several times, a cycle or a lap; what a data set calls all of them; and what is told of each.
    """

    round_name: ClassVar[str]
    rounds_key: ClassVar[str]
    rounds_told: ClassVar[Sequence[Quantity]]

    test: RigTest
    begins: float

    @property
    @abstractmethod
    def rounds(self) -> "Sequence[Cycle] | Sequence[Lap]":
        """Measures of each cycle, or of each lap in the plane."""

    @property
    def name(self) -> str:
        """Name of the test."""
        return self.test.name

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"Virtual test {self.test.name}"

    @property
    def peak_displacement(self) -> float:
        """Largest displacement, to either side or from the middle [mm]."""
        return float(np.abs(self.displacement).max())

    @property
    def heat_age(self) -> float:
        """Time since the plates were cold, at the end [s]."""
        return self.begins + float(self.time[-1])

    @property
    def memory(self) -> float:
        """Time for which heat is remembered [s]: chosen for all tests since the plates were cold, up to a longest."""
        return memory_of(self.heat_age) * (1.0 + 1e-9)

    @property
    def cooled(self) -> bool:
        """Whether the plates have cooled in a pause."""
        return self.begins > 0.0

    @property
    def attributes(self) -> dict[str, Any]:
        """What a data set says of it besides its system."""
        load = None if self.test.load is None else asdict(self.test.load)
        rows = objects_of(rounds_of([self]), self.rounds_told)
        return {**self.summary(), self.rounds_key: json.dumps(rows), "vertical_load": json.dumps(load)}

    def _repr_html_(self) -> str:
        rows = [told(self.rounds_told, one) for one in rounds_of([self])]
        return card(self.title, rows=rows, remarks=self.remarks)


@dataclass(frozen=True)
class ToldRound:
    """One cycle or lap with the name of its test and the area of the slider [mm2]; the loops of a virtual test, or the file of a measured one."""

    cycle: "Cycle | Lap"
    test: str
    area: float
    loops: VirtualTest | None = None
    file: str | None = None


def rounds_of(tests: Sequence[VirtualTest]) -> list[ToldRound]:
    """Return every cycle or lap of virtual tests."""
    return [
        ToldRound(one, test.name, test.bearing.slider_area, test) for test in tests for one in test.rounds
    ]


def objects_of(rounds: Sequence[ToldRound], quantities: Sequence[Quantity]) -> list[dict[str, Any]]:
    """Return what JSON holds of cycles or laps; only those of a measured test have a file."""
    rows = Table(tuple(quantities), rounds).objects()
    return [{key: value for key, value in row.items() if key != "file" or value is not None} for row in rows]
