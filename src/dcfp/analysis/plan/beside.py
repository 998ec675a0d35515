"""A building beside the same building without one of its properties: a rigid structure, softer springs, and what each cause does to the corners."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

from dcfp.analysis.plan.history import respond_plan
from dcfp.analysis.plan.response import PlanResponse
from dcfp.motion.station import Station
from dcfp.system import NoHeating, heating_model, plates_of
from dcfp.system.plan import Plan

#: By how much kf is divided to see what the floors owe to it.
SOFTER = 4.0


@dataclass(frozen=True)
class BesideOthers:
    """The response of a building, and those of buildings that differ in one property, each analysed when it is asked for.

    Attributes
    ----------
    response
        Of the building.
    analyse
        Analyses another plan in the same way under the same ground motion.
    """

    response: PlanResponse
    analyse: Callable[[Plan], PlanResponse]

    @cached_property
    def rigid(self) -> PlanResponse:
        """Response of a rigid structure of the same mass."""
        plan = self.response.plan
        return self.analyse(plan.rigid) if plan.storeys else self.response

    @cached_property
    def softer(self) -> PlanResponse:
        """Response on bearings whose springs (b) are `SOFTER` times softer."""
        return self.analyse(self.response.plan.with_softer_springs(SOFTER))

    @property
    def velocity_ratio(self) -> float | None:
        """V_E of the building over that of the rigid structure [-], which Akiyama (1985) takes to be one."""
        rigid = self.rigid.input_velocity
        return self.response.input_velocity / rigid if rigid > 0.0 else None

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader must know."""
        response = self.response
        still = not response.motion.y.acceleration.any()
        alone = (f"{response.name}: one component alone moves the building, in x.",) if still else ()
        return (*alone, *response.remarks)

    @property
    def document(self) -> dict[str, Any]:
        """What is told of it, ready for JSON."""
        beside = {"V_E_ratio": self.velocity_ratio} if self.response.plan.storeys else {}
        return {**self.response.summary(), **beside}

    @property
    def spring_remark(self) -> str:
        """What the floors owe to the stiffness of spring (b), with its size."""
        own, other = (float(one.peak_floor_acceleration.max()) / 1e3 for one in (self.response, self.softer))
        return (
            f"{self.response.name}: floor accelerations depend on the stiffness kf of spring (b), which tests hardly show: the largest is {own:.2f} m/s2,"
            f" and {other:.2f} m/s2 with kf {SOFTER:g} times softer."
        )


def remarks_on(found: Sequence[BesideOthers]) -> list[tuple[str, ...]]:
    """Return the remarks on each of several analyses; what the floors owe to spring (b) is said of the one whose floors are accelerated most."""
    worst = max(found, key=lambda one: float(one.response.peak_floor_acceleration.max()))
    return [
        (*one.remarks, one.spring_remark) if one is worst and one.response.plan.storeys else one.remarks
        for one in found
    ]


class Cause(NamedTuple):
    """A building that has one cause of torsion more than the one before."""

    words: str
    response: PlanResponse


def separate_causes(
    plan: Plan, motion: Station, *, vertical: bool = False, **settings: Any
) -> Iterator[Cause]:
    """Give the responses of a building to which causes of torsion are added one by one.

    Parameters
    ----------
    plan, motion
        Building and ground motion.
    vertical
        Whether the vertical component is the last cause.
    settings
        Others of `respond_plan`.
    """
    cold = tuple(
        replace(one, heating=heating_model(NoHeating.name, plates_of(one.heating))) for one in plan.systems
    )
    symmetric = replace(
        plan,
        types=cold,
        centre=plan.middle_of_bearings,
        eccentricity=(0.0, 0.0),
        loads=None,
        storeys=tuple(replace(one, centre=None, stiffness_centre=None) for one in plan.storeys),
    )
    without = {"overturning": False, **settings}
    yield Cause(
        "symmetric: mass and storeys in the middle, no heat, loads constant",
        respond_plan(symmetric, motion, **without),
    )
    yield Cause(
        "and the mass where it is, with the loads at rest",
        respond_plan(replace(plan, types=cold), motion, **without),
    )
    yield Cause("and heat", respond_plan(plan, motion, **without))
    yield Cause("and overturning", respond_plan(plan, motion, **settings))
    if vertical:
        yield Cause("and the vertical motion", respond_plan(plan, motion, vertical=True, **settings))
