"""Every method on the same bearing, from a spectrum or from a record."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dcfp.analysis import respond
from dcfp.errors import AnalysisError, InputError
from dcfp.methods import aij_2016, asce_2016, eurocode_8, iwan_1980
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.result import ANSWERS, Answer, Structure, answer_objects
from dcfp.methods.spectra.elastic import ElasticSpectrum, velocity
from dcfp.methods.spectra.of_record import (
    PERIODS,
    ResponseSpectrum,
    input_energy_spectrum,
    response_spectrum,
    spectrum_of_set,
)
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.notebook import card
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import M_PER_S, MM, NONE
from dcfp.system import Bearing, FrictionLaw, Heating

#: Names of the methods that need no more than a spectrum, in the order of tables; of a record Iwan's comes last.
NAMES = (
    asce_2016.NAME,
    eurocode_8.NAME,
    aij_2016.METHOD_1,
    aij_2016.METHOD_2,
    aij_2016.ENERGY_BALANCE,
)
#: Damping ratio of the input energy spectrum that Akiyama (1985) takes [-].
ENERGY_DAMPING = 0.10
#: Shortest period over which the velocity of a spectrum is averaged for the method of a constant velocity [s].
_SHORTEST = 2.0
#: Where the V_E of the energy balance comes from.
_OF_RECORD = "largest relative input energy at the period of the pendulum and a damping of 10 %"
_OF_SPECTRUM = "the largest pseudo-velocity of the spectrum, which is a lower bound"
#: Number of periods of that mean.
_PERIODS = 25


def answers_for_spectrum(
    spectrum: ElasticSpectrum,
    pendulum: PendulumWithFriction,
    structure: Structure | None = None,
    bounds: asce_2016.Bounds | None = None,
    equivalent_velocity: float | None = None,
) -> dict[str, Answer]:
    """Return what every method says under a spectrum at a damping of 5 %, by its name; a method that has no solution is not there.

    Parameters
    ----------
    spectrum, pendulum
        The demand and the bearing.
    structure, bounds
        As for `equivalent_lateral_force`.
    equivalent_velocity
        V_E of the energy balance [mm/s]; by default the largest pseudo-velocity of the spectrum, below which the V_E of an oscillator hardly is.
    """
    level = constant_velocity(spectrum, pendulum)
    given = equivalent_velocity is not None
    V_E = equivalent_velocity if given else float(velocity(spectrum, PERIODS).max())
    words = _OF_RECORD if given else _OF_SPECTRUM
    made = {
        asce_2016.NAME: lambda: asce_2016.equivalent_lateral_force(pendulum, spectrum, structure, bounds),
        eurocode_8.NAME: lambda: eurocode_8.simplified_linear_analysis(pendulum, spectrum, structure),
        aij_2016.METHOD_1: lambda: aij_2016.method_1(pendulum, spectrum),
        aij_2016.METHOD_2: lambda: _of_level(aij_2016.method_2(pendulum, level), level, pendulum),
        aij_2016.ENERGY_BALANCE: lambda: _of_energy(aij_2016.energy_balance(pendulum, V_E), V_E, words),
    }
    found: dict[str, Answer] = {}
    for name, make in made.items():
        try:
            found[name] = make()
        except AnalysisError:
            continue
    return found


def _of_level(answer: Answer, level: float, pendulum: PendulumWithFriction) -> Answer:
    """Return an answer of the method of a constant velocity with the level that it rests on [mm/s]."""
    longest = max(pendulum.free_period, _SHORTEST)
    remark = f"S_v {level:.0f} mm/s, the mean from {_SHORTEST:g} to {longest:.1f} s"
    outside = answer.period is not None and not _SHORTEST <= answer.period <= longest
    note = ", a band in which its own effective period is not" if outside else ""
    return replace(answer, remarks=(*answer.remarks, f"{remark}{note}."))


def _of_energy(answer: Answer, velocity: float, words: str) -> Answer:
    """Return an answer of the energy balance with the V_E that it rests on [mm/s]."""
    return replace(
        answer,
        remarks=(*answer.remarks, f"V_E {velocity:.0f} mm/s: {words}."),
        unconfirmed=(
            *answer.unconfirmed,
            "two loops at the largest displacement, and which V_E belongs to them",
        ),
    )


def answers_for_motion(
    motion: GroundMotion,
    pendulum: PendulumWithFriction,
    structure: Structure | None = None,
    bounds: asce_2016.Bounds | None = None,
    bearing: Bearing | None = None,
) -> dict[str, Answer]:
    """Return what every method says under the spectra of a record itself, by its name; nothing for a record without motion.

    V_E is the largest relative input energy at the period of the pendulum and a damping of 10 %, as Akiyama (1985) takes it.
    Iwan's method needs the `bearing`, for its stiffness before it slides.
    """
    if motion.peak_acceleration == 0.0:
        return {}
    spectrum = response_spectrum(motion)
    V_E = input_velocity(motion, pendulum)
    found = answers_for_spectrum(spectrum, pendulum, structure, bounds, equivalent_velocity=V_E)
    if bearing is not None:
        with suppress(AnalysisError):
            found[iwan_1980.NAME] = iwan_1980.equivalent_linear(motion, bearing, pendulum.friction)
    return found


def input_velocity(motion: GroundMotion, pendulum: PendulumWithFriction) -> float:
    """Return V_E of the largest relative input energy at the period of the pendulum and a damping of 10 % [mm/s]: Akiyama (1985)."""
    energy = input_energy_spectrum(motion, np.array([pendulum.free_period]), ENERGY_DAMPING)
    return float(energy.equivalent_velocity[0])


def constant_velocity(spectrum: ElasticSpectrum, pendulum: PendulumWithFriction) -> float:
    """Return the level of a velocity spectrum as if it were constant [mm/s]: its mean from 2 s to the period of the pendulum."""
    longest = max(pendulum.free_period, _SHORTEST)
    return float(velocity(spectrum, np.linspace(_SHORTEST, longest, _PERIODS)).mean())


@dataclass(frozen=True, eq=False)
class Panel:
    """What every method says of one demand.

    Attributes
    ----------
    name
        Of the spectrum or the record.
    spectrum
        At a damping of 5 %.
    pendulum
        The bearing as the methods take it.
    answers
        By name; a method that has no solution is not there.
    pgv
        Of the record [mm/s], or None.
    displacement, base_shear
        y_max [mm] and the largest force over the weight [-] of the response history analysis, or None where there is no record.
    equivalent_velocity
        V_E of the energy balance [mm/s], or None where it was taken from the spectrum.
    remarks
        Sentences that a reader of the numbers must know, besides those of the answers.
    """

    name: str
    spectrum: ElasticSpectrum
    pendulum: PendulumWithFriction
    answers: dict[str, Answer]
    pgv: float | None = None
    displacement: float | None = None
    base_shear: float | None = None
    equivalent_velocity: float | None = None
    remarks: tuple[str, ...] = ()

    @property
    def missing(self) -> tuple[str, ...]:
        """Names of the methods that have no solution."""
        return tuple(name for name in NAMES if name not in self.answers)

    def _repr_html_(self) -> str:
        rows = [
            {
                "method": name,
                "displacement [mm]": said.displacement,
                "base shear over weight": said.base_shear,
                "verdict": said.verdict,
            }
            for name, said in self.answers.items()
        ]
        return card(self.name, {"analysis [mm]": self.displacement}, rows=rows, remarks=self.remarks)


@dataclass(frozen=True)
class Line:
    """A line of a panel: an answer, the analysis, or a method that has no solution."""

    panel: Panel
    method: str
    said: Answer | None = None
    displacement: float | None = None
    base_shear: float | None = None
    verdict: str = ""

    def __getattr__(self, name: str) -> Any:
        return getattr(self.said, name, None)

    @property
    def over(self) -> float | None:
        """Displacement over that of the analysis [-]."""
        analysed = self.panel.displacement
        return self.displacement / analysed if analysed and self.displacement is not None else None


def lines_of(panel: Panel, *, missing: bool = False) -> list[Line]:
    """Return the analysis, where there is one, every answer, and the methods that have no solution where they are asked for."""
    analysis = [Line(panel, "analysis", None, panel.displacement, panel.base_shear)]
    return [
        *(analysis if panel.displacement is not None else []),
        *(
            Line(panel, one.method, one, one.displacement, one.base_shear, one.verdict)
            for one in panel.answers.values()
        ),
        *(Line(panel, name, verdict="no solution") for name in panel.missing if missing),
    ]


def line_quantities(*, of_records: bool = True) -> tuple[Quantity, ...]:
    """Return what is told in each line."""
    return (
        Quantity("name", "record or spectrum", head="Record" if of_records else "Spectrum", get="panel.name"),
        Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, name="pgv", head="PGV", get="panel.pgv", printed=of_records),
        *(one for one in ANSWERS if one.flat and (of_records or one.key != "over_analysis")),
    )  # fmt: skip


#: What is told of a panel.
PANELS = [
    Quantity("name", "record or spectrum", get="name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, places=12, get="pgv"),
    Quantity("friction", "coefficient of the methods", NONE, get="pendulum.friction"),
    Quantity("radius_mm", "effective radius", MM, get="pendulum.radius"),
    Quantity(
        "analysis", "what the analysis gives", flat=False,
        get=lambda panel: None if panel.displacement is None else {"displacement_mm": panel.displacement, "base_shear_over_weight": panel.base_shear},
    ),
    Quantity("answers", "what the methods say", get=lambda panel: answer_objects(panel.answers.values()), flat=False),
    Quantity("without_solution", "methods without a solution", get="missing"),
    Quantity("remarks", "what a reader must know", get="remarks"),
]  # fmt: skip


def panel_of_spectrum(
    spectrum: ElasticSpectrum,
    pendulum: PendulumWithFriction,
    structure: Structure | None = None,
    bounds: asce_2016.Bounds | None = None,
) -> Panel:
    """Ask every method under a spectrum; arguments as for `answers_for_spectrum`."""
    return Panel(
        spectrum.name, spectrum, pendulum, answers_for_spectrum(spectrum, pendulum, structure, bounds)
    )


def panel_of_motion(
    motion: GroundMotion,
    bearing: Bearing,
    friction: FrictionLaw,
    heating: Heating,
    pendulum: PendulumWithFriction,
    structure: Structure | None = None,
    bounds: asce_2016.Bounds | None = None,
) -> Panel:
    """Ask every method under the spectrum of a record, and analyse the record on the bearing with its own law and heating."""
    response = respond(motion, bearing, friction, heating)
    return Panel(
        name=motion.name,
        spectrum=response_spectrum(motion),
        pendulum=pendulum,
        answers=answers_for_motion(motion, pendulum, structure, bounds, bearing),
        pgv=motion.peak_velocity,
        displacement=response.peak_displacement,
        base_shear=response.peak_force / bearing.vertical_force,
        equivalent_velocity=input_velocity(motion, pendulum) if motion.peak_acceleration > 0.0 else None,
        remarks=response.remarks,
    )


def panel_of_set(
    panels: Sequence[Panel],
    part: float | None = None,
    structure: Structure | None = None,
    bounds: asce_2016.Bounds | None = None,
) -> Panel:
    """Ask every method under the spectrum of a set of records, beside the same measure of their analyses.

    Parameters
    ----------
    panels
        Of the records, by `panel_of_motion`.
    part
        What this part of the records stay below [-]; None for the geometric mean.
    structure, bounds
        As for `answers_for_spectrum`.

    Raises
    ------
    InputError
        If there is no record.
    """
    moving = [one for one in panels if one.equivalent_velocity is not None]
    if not moving:
        msg = "The spectrum of a set needs a record in which the ground moves."
        raise InputError(msg)
    spectrum = spectrum_of_set(
        [one.spectrum for one in moving if isinstance(one.spectrum, ResponseSpectrum)], part
    )
    pendulum = moving[0].pendulum

    def measure(values: list[float | None]) -> float:
        known = np.array([value for value in values if value is not None])
        return float(
            np.exp(np.log(np.maximum(known, 1e-9)).mean()) if part is None else np.quantile(known, part)
        )

    V_E = measure([one.equivalent_velocity for one in moving])
    silent = len(panels) - len(moving)
    return Panel(
        name=spectrum.name,
        spectrum=spectrum,
        pendulum=pendulum,
        answers=answers_for_spectrum(spectrum, pendulum, structure, bounds, V_E),
        displacement=measure([one.displacement for one in moving]),
        base_shear=measure([one.base_shear for one in moving]),
        equivalent_velocity=V_E,
        remarks=(f"{silent} records in which the ground does not move are left out.",) if silent else (),
    )


def capacity_remarks(panel: Panel, bearing: Bearing) -> tuple[str, ...]:
    """Return a sentence where a method asks for more than the capacity of a bearing."""
    capacity = bearing.displacement_capacity
    beyond = [
        f"{name} {said.displacement:.0f} mm"
        for name, said in panel.answers.items()
        if capacity is not None and said.displacement > capacity
    ]
    return (
        (f"{panel.name}: beyond the capacity of {capacity:.0f} mm: {', '.join(beyond)}.",) if beyond else ()
    )
