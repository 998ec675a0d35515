"""Every method of a code on the same bearing, under a spectrum or a record."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from dcfp.analysis import respond
from dcfp.errors import AnalysisError, InputError
from dcfp.methods.code import (
    CODE_RESULTS,
    Bounds,
    CodeInputs,
    CodeMethod,
    CodeResult,
    Structure,
    code_methods,
    code_objects,
)
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.spectra.elastic import ElasticSpectrum
from dcfp.methods.spectra.of_record import ResponseSpectrum, spectrum_of_set
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.notebook import card, told
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import M_PER_S, MM, NONE
from dcfp.system import Bearing, System


def code_results(
    inputs: CodeInputs, bounds: Bounds | None = None, only: Sequence[CodeMethod] = ()
) -> dict[str, CodeResult]:
    """Return what every method of a code says, by its name; one that has no solution is not there, and none under a record without motion.

    Parameters
    ----------
    inputs
        What they are given.
    bounds
        Of the properties; without, they are nominal.
    only
        Methods to ask, where not all are.
    """
    found: dict[str, CodeResult] = {}
    if inputs.motion is None or inputs.motion.peak_acceleration > 0.0:
        for method in only or _asked(inputs).values():
            with suppress(AnalysisError):
                found[method.name] = method.result(inputs, bounds)
    return found


def _asked(inputs: CodeInputs) -> dict[str, CodeMethod]:
    return {
        name: method
        for name, method in code_methods().items()
        if inputs.motion is not None or not method.needs_record
    }


@dataclass(frozen=True, eq=False)
class CodeComparison:
    """What every method of a code says of one demand, beside the response history analysis where there is a record."""

    name: str  #: of the spectrum or the record
    inputs: CodeInputs  #: what the methods were given
    results: dict[str, CodeResult]  #: by name; a method that has no solution is not there
    pgv: float | None = None  #: of the record [mm/s], or None
    displacement: float | None = None  #: y_max of the analysis [mm]
    base_shear: float | None = None  #: largest force of the analysis over the weight [-]
    remarks: tuple[str, ...] = ()  #: besides those of the results

    @property
    def missing(self) -> tuple[str, ...]:
        """Names of the methods that have no solution."""
        return tuple(name for name in _asked(self.inputs) if name not in self.results)

    def capacity_remarks(self, bearing: Bearing) -> tuple[str, ...]:
        """Return a sentence where a method asks for more than the capacity of a bearing."""
        capacity = bearing.displacement_capacity
        beyond = [
            f"{name} {result.displacement:.0f} mm"
            for name, result in self.results.items()
            if capacity is not None and result.displacement > capacity
        ]
        what = ", ".join(beyond)
        return (f"{self.name}: beyond the capacity of {capacity:.0f} mm: {what}.",) if beyond else ()

    def _repr_html_(self) -> str:
        rows = [told(CODE_RESULTS, one) for one in self.results.values()]
        return card(self.name, {"analysis [mm]": self.displacement}, rows=rows, remarks=self.remarks)


@dataclass(frozen=True)
class Line:
    """A line of a comparison: a result, the analysis, or a method that has no solution."""

    comparison: CodeComparison
    method: str
    result: CodeResult | None = None
    displacement: float | None = None
    base_shear: float | None = None
    verdict: str = ""

    def __getattr__(self, name: str) -> Any:
        return getattr(self.result, name, None)

    @property
    def over(self) -> float | None:
        """Displacement over that of the analysis [-]."""
        analysed = self.comparison.displacement
        return self.displacement / analysed if analysed and self.displacement is not None else None


def lines_of(comparison: CodeComparison, *, missing: bool = False) -> list[Line]:
    """Return the analysis, where there is one, every result, and the methods that have no solution where they are asked for."""
    analysis = [Line(comparison, "analysis", None, comparison.displacement, comparison.base_shear)]
    return [
        *(analysis if comparison.displacement is not None else []),
        *(
            Line(comparison, one.method, one, one.displacement, one.base_shear, one.verdict)
            for one in comparison.results.values()
        ),
        *(Line(comparison, name, verdict="no solution") for name in comparison.missing if missing),
    ]


def line_quantities(*, of_records: bool = True) -> tuple[Quantity, ...]:
    """Return what is told in each line."""
    return (
        Quantity("name", "record or spectrum", head="Record" if of_records else "Spectrum", get="comparison.name"),
        Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, name="pgv", head="PGV", get="comparison.pgv", printed=of_records),
        *(one for one in CODE_RESULTS if one.flat and (of_records or one.key != "over_analysis")),
    )  # fmt: skip


#: What is told of a comparison.
CODE_COMPARISONS = [
    Quantity("name", "record or spectrum", get="name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, places=12, get="pgv"),
    Quantity("friction", "coefficient of the methods", NONE, get="inputs.pendulum.friction"),
    Quantity("radius_mm", "effective radius", MM, get="inputs.pendulum.radius"),
    Quantity(
        "analysis", "what the analysis gives", flat=False,
        get=lambda one: None if one.displacement is None else {"displacement_mm": one.displacement, "base_shear_over_weight": one.base_shear},
    ),
    Quantity("answers", "what the methods say", get=lambda one: code_objects(one.results.values()), flat=False),
    Quantity("without_solution", "methods without a solution", get="missing"),
    Quantity("remarks", "what a reader must know", get="remarks"),
]  # fmt: skip


def codes_under_spectrum(
    spectrum: ElasticSpectrum,
    pendulum: PendulumWithFriction,
    structure: Structure | None = None,
    bounds: Bounds | None = None,
) -> CodeComparison:
    """Ask every method under a design spectrum; `bounds` as for `code_results`."""
    inputs = CodeInputs(spectrum, pendulum, structure or Structure())
    return CodeComparison(spectrum.name, inputs, code_results(inputs, bounds))


def codes_under_record(
    motion: GroundMotion,
    system: System,
    friction: float,
    structure: Structure | None = None,
    bounds: Bounds | None = None,
) -> CodeComparison:
    """Ask every method under the spectrum of a record, and analyse the record on the system with its own law and heating.

    `friction` is the constant coefficient of the methods [-]; `bounds` as for `code_results`.
    """
    response = respond(motion, system)
    inputs = CodeInputs.of_record(motion, system.bearing, friction, structure)
    return CodeComparison(
        name=motion.name,
        inputs=inputs,
        results=code_results(inputs, bounds),
        pgv=motion.peak_velocity,
        displacement=response.peak_displacement,
        base_shear=response.peak_force / system.bearing.vertical_force,
        remarks=response.remarks,
    )


def codes_under_set(
    comparisons: Sequence[CodeComparison], part: float | None = None, bounds: Bounds | None = None
) -> CodeComparison:
    """Ask every method under the spectrum of a set of records, beside the same measure of their analyses.

    Parameters
    ----------
    comparisons
        Of the records, by `codes_under_record`.
    part
        What this part of the records stay below [-]; None for the geometric mean.
    bounds
        As for `code_results`.

    Raises
    ------
    InputError
        If there is no record.
    """
    moving = [one for one in comparisons if one.inputs.motion and one.inputs.motion.peak_acceleration > 0.0]
    if not moving:
        msg = "The spectrum of a set needs a record in which the ground moves."
        raise InputError(msg)
    spectra = [one.inputs.spectrum for one in moving if isinstance(one.inputs.spectrum, ResponseSpectrum)]

    def measure(values: list[float | None]) -> float:
        known = np.array([value for value in values if value is not None])
        return float(
            np.exp(np.log(np.maximum(known, 1e-9)).mean()) if part is None else np.quantile(known, part)
        )

    first = moving[0].inputs
    inputs = CodeInputs(
        spectrum_of_set(spectra, part),
        first.pendulum,
        first.structure,
        energy_velocity=measure([one.inputs.input_velocity for one in moving]),
    )
    still = len(comparisons) - len(moving)
    return CodeComparison(
        name=inputs.spectrum.name,
        inputs=inputs,
        results=code_results(inputs, bounds),
        displacement=measure([one.displacement for one in moving]),
        base_shear=measure([one.base_shear for one in moving]),
        remarks=(f"{still} records in which the ground does not move are left out.",) if still else (),
    )
