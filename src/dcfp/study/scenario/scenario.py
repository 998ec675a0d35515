"""A scenario: what is to be calculated, and for whom."""

from dataclasses import dataclass, field
from functools import cached_property

from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.notebook import card
from dcfp.study import Study
from dcfp.system import Model

#: Analyses that a scenario has at most: each gets pages of its own in a report.
MOST_ANALYSES = 40


@dataclass(frozen=True)
class Heading:
    """What stands at the top of a report; all of it may be empty.

    Attributes
    ----------
    project, client, author, checker
        Names.
    number
        Of the document.
    date
        As it is to be printed.
    notes
        Anything else.
    """

    project: str = ""
    client: str = ""
    author: str = ""
    checker: str = ""
    number: str = ""
    date: str = ""
    notes: str = ""


@dataclass(frozen=True, eq=False)
class Scenario:
    """One bearing under ground motions, each at one or several intensities.

    Parameters
    ----------
    study
        A study that varies nothing but the record and its intensity.
    heading
        Of its report.

    Raises
    ------
    InputError
        If the study varies anything else, or has too many analyses.
    """

    study: Study
    heading: Heading = field(default_factory=Heading)

    def __post_init__(self) -> None:
        varied = ("record", self.study.intensity)
        for name, values in self.study.factors.items():
            if name not in varied and len(values) > 1:
                msg = f"a scenario has one bearing, but factor {name!r} has {len(values)} values; that is a study (dcfp study)."
                raise InputError(msg)
        if self.study.sampling is not None:
            msg = "a scenario has one bearing, but there is a [sampling]; that is a study (dcfp study)."
            raise InputError(msg)
        if "procedure" in self.study.factors:
            msg = "a scenario is calculated by every procedure; leave out the factor 'procedure'."
            raise InputError(msg)
        if self.study.plan.count > MOST_ANALYSES:
            msg = f"a scenario has at most {MOST_ANALYSES} analyses, not {self.study.plan.count}; for more there is dcfp study."
            raise InputError(msg)

    @property
    def title(self) -> str:
        """Title of the report and of the page."""
        return self.study.title

    @cached_property
    def model(self) -> Model:
        """The bearing, its friction law and its heating model."""
        return self.study.plan.models_at_ends()[0]

    @cached_property
    def motions(self) -> list[GroundMotion]:
        """The ground motions as they shake the bearing, in the order of the study."""
        plan = self.study.plan
        found: list[GroundMotion] = []
        for block in plan.blocks():
            lanes = plan.cases(block).lanes
            for record, scale in zip(lanes.record, lanes.scale, strict=True):
                motion = self.study.motions[int(record)]
                found.append(motion if scale == 1.0 else motion.scaled(float(scale)))
        return found

    def _repr_html_(self) -> str:
        facts = {
            "bearing": self.model.bearing.name,
            "friction": repr(self.model.friction),
            "heating": repr(self.model.heating),
            "ground motions": tuple(motion.name for motion in self.motions),
        }
        return card(self.title, facts)
