"""What a method of a design code is given, how it is asked, with nominal properties of the bearing or with both bounds of them, and its result."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Annotated, Any, TypeVar

import numpy as np

from dcfp.errors import InputError
from dcfp.methods.equivalent_linear import PendulumWithFriction, Step, iterate
from dcfp.methods.method import METHODS, Information, Method
from dcfp.methods.spectra.elastic import ElasticSpectrum, displacement, velocity
from dcfp.methods.spectra.of_record import PERIODS, input_energy_spectrum, response_spectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.check import COLUMNS, Check, Verdict, at_least
from dcfp.schema.declared import Declared, declared
from dcfp.schema.formulas import Formula, number
from dcfp.schema.notebook import card, told
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import FRACTION, KM, METRE, MM, NONE, PERCENT, SECOND
from dcfp.system import Bearing

T = TypeVar("T")

#: Site classes of ASCE/SEI 7.
SITE_CLASSES = ("A", "B", "C", "D", "E", "F")

#: Damping ratio of the input energy spectrum that Akiyama (1985) takes [-].
ENERGY_DAMPING = 0.10


@dataclass(frozen=True)
class CodeResult:
    """What a method of a code says."""

    method: str
    displacement: float  #: of the isolation layer [mm]
    base_shear: float  #: horizontal force over the weight that goes with it [-]
    period: float | None = None  #: effective [s]; None where the method has none
    damping: float | None = None  #: effective ratio [-]; None where the method has none
    steps: tuple[Step, ...] = ()  #: rounds of the iteration, the last of them the answer
    conditions: tuple[Check, ...] = ()  #: under which the method may be used
    unconfirmed: tuple[str, ...] = ()  #: what in the method could not be confirmed in its source
    remarks: tuple[str, ...] = ()  #: sentences that a reader must know

    @property
    def valid(self) -> bool | None:
        """Whether every condition is met; None where none is broken but some are not known."""
        verdicts = {one.passed for one in self.conditions}
        return False if False in verdicts else None if None in verdicts else True

    @property
    def verdict(self) -> str:
        """The verdict in a word or two, which must stand beside every result."""
        if not self.conditions:
            return "no limits known"
        broken = sum(one.passed is False for one in self.conditions)
        if broken:
            return f"outside its limits ({broken})"
        unknown = sum(one.passed is None for one in self.conditions)
        return f"within its limits, {unknown} not known" if unknown else "within its limits"

    def _repr_html_(self) -> str:
        rows = Table(tuple(COLUMNS), self.conditions).objects()
        return card(self.method, told(CODE_RESULTS, self), rows=rows, remarks=self.remarks)


@declared
class Structure(Declared):
    """A building on the isolation layer; what is None is not known, and the conditions that ask for it say so."""

    noun = "a building and its site"

    fixed_base_period: Annotated[
        float | None,
        Parameter(
            "period of the structure without isolation",
            SECOND,
            0.0,
            10.0,
            more="0 for a rigid one",
            symbol="T_f",
        ),
    ] = None
    height: Annotated[
        float | None, Parameter("height above the isolation", METRE, 0.0, 1000.0, above=True, symbol="h_n")
    ] = None
    site_class: Annotated[str | None, Parameter("site class of ASCE 7", choices=SITE_CLASSES)] = None
    plan: Annotated[
        float | None, Parameter("larger dimension of the plan", METRE, 0.0, 1000.0, above=True)
    ] = None
    fault_distance: Annotated[
        float | None, Parameter("distance to a fault of magnitude 6.5 or more", KM, 0.0, 1e4, above=True)
    ] = None
    weight_above: Annotated[float | None, Parameter("weight above the base level over the whole, for V_st of ASCE 7", FRACTION, 0.0, 0.9999, above=True, symbol="W_s / W")] = None  # fmt: skip

    def over_fixed_base(self, period: float, least: float) -> tuple[Verdict, str]:
        """Return whether a period [s] is at least so many times that of the fixed base, and what it is, in words."""
        if self.fixed_base_period == 0.0:
            return Verdict.MET, "rigid structure"
        return unless_unknown(
            self.fixed_base_period, lambda fixed: (at_least(period, least * fixed), f"{period / fixed:.1f}")
        )


def unless_unknown(value: T | None, judge: Callable[[T], tuple[Verdict, str]]) -> tuple[Verdict, str]:
    """Return what is found of a value and in words what it is; not known where it is not given."""
    return (Verdict.NOT_KNOWN, "not given") if value is None else judge(value)


#: What is told of a round of an iteration.
ROUNDS = [
    Quantity("displacement_mm", "displacement that it began with", MM, decimals=2, head="D", get="displacement"),
    Quantity("period_s", "effective period", SECOND, decimals=3, head="T_eff", get="period"),
    Quantity("damping", "effective damping ratio", NONE, PERCENT, 2, head="beta_eff", get="damping"),
    Quantity("reduction", "factor on the spectrum", NONE, decimals=4, head="Reduction", get="reduction"),
]  # fmt: skip
#: What is told of a result; `over` is that of a line of a `CodeComparison`.
CODE_RESULTS = [
    Quantity("method", "method", head="Method", get="method"),
    Quantity("displacement_mm", "displacement of the isolation layer", MM, decimals=1, name="displacement", head="D", get="displacement"),
    Quantity("base_shear_over_weight", "base shear over the weight", NONE, decimals=3, head="V_b/W", get="base_shear"),
    Quantity("effective_period_s", "effective period", SECOND, decimals=2, name="effective_period", head="T_eff", get="period"),
    Quantity("effective_damping", "effective damping ratio", NONE, PERCENT, 1, head="beta_eff", get="damping"),
    Quantity("over_analysis", "displacement over that of the analysis", NONE, decimals=2, head="D over\nanalysis", get="over", stored=False),
    Quantity("within_limits", "whether it is within the limits of the method", get=lambda said: said.valid if said.conditions else None, printed=False),
    Quantity("verdict", "the same in words", head="Verdict", get="verdict"),
    Quantity("conditions", "conditions of the method", get=lambda said: Table(tuple(COLUMNS), said.conditions).objects(), flat=False, printed=False),
    Quantity("iteration", "rounds of the iteration", get=lambda said: Table(tuple(ROUNDS), said.steps).objects(), flat=False, printed=False),
    Quantity("unconfirmed", "what could not be confirmed", get="unconfirmed", printed=False),
    Quantity("remarks", "what a reader must know", get="remarks", printed=False),
]  # fmt: skip


def code_objects(results: Iterable[CodeResult]) -> list[dict[str, Any]]:
    """Return results with their verdicts, conditions and iterations, ready for JSON."""
    return Table(tuple(CODE_RESULTS), list(results)).objects()


@declared
class Bounds(Declared):
    """Property modification factors on the coefficient of friction, the same for every code: ASCE/SEI 7-16, section 17.2.8 (and EN 1998-1, 10.8, from memory)."""

    noun = "bounds of the properties"

    least: Annotated[float, Parameter("property modification factor lambda_min", NONE, 0.1, 10.0, symbol=r"\lambda_{\min}")] = 1.0  # fmt: skip
    largest: Annotated[float, Parameter("property modification factor lambda_max", NONE, 0.1, 10.0, symbol=r"\lambda_{\max}")] = 1.0  # fmt: skip
    source: Annotated[str, Parameter("where the factors come from")] = "nominal properties"

    def check_relations(self) -> None:
        """Refuse bounds in the wrong order."""
        if self.least > self.largest:
            msg = f"lambda_min, {self.least:g}, must not exceed lambda_max, {self.largest:g}."
            raise InputError(msg)


@dataclass(frozen=True, eq=False)
class CodeInputs:
    """What the methods of codes are given; record and bearing, for methods that need them, are None with a design spectrum."""

    spectrum: ElasticSpectrum  #: at a damping of 5 %
    pendulum: PendulumWithFriction  #: the bearing as the methods take it
    structure: Structure = field(default_factory=Structure)  #: building and site, for their conditions
    motion: GroundMotion | None = None  #: the record whose spectrum it is
    bearing: Bearing | None = None
    energy_velocity: float | None = None  #: V_E of the energy balance [mm/s], where it is given

    @classmethod
    def of_record(
        cls, motion: GroundMotion, bearing: Bearing, friction: float, structure: Structure | None = None
    ) -> "CodeInputs":
        """Return what the codes are given of a record itself, with a constant coefficient of friction [-]."""
        pendulum = PendulumWithFriction(bearing.effective_radius, friction)
        return cls(response_spectrum(motion), pendulum, structure or Structure(), motion, bearing)

    @cached_property
    def input_velocity(self) -> float:
        """V_E of the energy balance [mm/s]: of a record as Akiyama (1985) takes it, of a spectrum alone the largest pseudo-velocity, below which it hardly is."""
        if self.energy_velocity is not None:
            return self.energy_velocity
        if self.motion is None:
            return float(velocity(self.spectrum, PERIODS).max())
        period = np.array([self.pendulum.free_period])
        return float(input_energy_spectrum(self.motion, period, ENERGY_DAMPING).equivalent_velocity[0])

    def with_friction(self, factor: float) -> "CodeInputs":
        """Return the same with the coefficient of friction multiplied by a factor [-]."""
        if factor == 1.0:
            return self
        return replace(self, pendulum=replace(self.pendulum, friction=self.pendulum.friction * factor))


@dataclass(frozen=True, kw_only=True)
class CodeMethod(Method):
    """A method of a design code.

    It is calculated from its inputs, with an AnalysisError where there is no solution. Remarks are of its results with both bounds, the governing one first,
    whose friction the inputs then have; formulas are of the last round, with its numbers, for the report.
    """

    calculate: Callable[[CodeInputs], CodeResult]
    remarks: Callable[[Sequence[CodeResult], CodeInputs], tuple[str, ...]] | None = None
    formulas: Callable[[CodeResult, CodeInputs], tuple[Formula, ...]] | None = None
    knows: tuple[Information, ...] = (Information.SPECTRUM,)
    #: of displacement, period, damping and base shear, as its remarks have them
    symbols: tuple[str, str, str, str] = ("D", "T_eq", "h_eq", "Q/W")
    needs_record: bool = False  #: whether it can do nothing with a design spectrum

    def result(self, inputs: CodeInputs, bounds: Bounds | None = None) -> CodeResult:
        """Return what the code says; with bounds, the larger displacement and the larger force of both.

        Raises
        ------
        AnalysisError
            If there is no solution.
        """
        bounds = bounds or Bounds()
        factors = tuple(dict.fromkeys((bounds.least, bounds.largest)))
        results = [self.calculate(inputs.with_friction(factor)) for factor in factors]
        order = sorted(range(len(results)), key=lambda place: -results[place].displacement)
        governing, *others = (results[place] for place in order)
        remarks = [remark for one in results for remark in one.remarks]
        if self.remarks is not None:
            remarks += self.remarks([governing, *others], inputs.with_friction(factors[order[0]]))
        conditions, unconfirmed = governing.conditions, dict.fromkeys(governing.unconfirmed)
        names = ("lower", "upper") if order[0] == 0 else ("upper", "lower")
        for other in others:
            conditions += tuple(
                replace(one, name=f"{one.name}, {names[1]} bound")
                for one in other.conditions
                if one not in governing.conditions
            )
            unconfirmed |= dict.fromkeys(other.unconfirmed)
            remarks.append(
                f"{names[1].capitalize()} bound: {self._told(other)}; {names[0]} bound: {self.symbols[3]} {governing.base_shear:.3f}."
            )
            remarks.append(
                f"Friction from {bounds.least:g} to {bounds.largest:g} times mu ({bounds.source}): displacement from the {names[0]}, force from"
                " the worse bound."
            )
        return replace(
            governing,
            base_shear=max(one.base_shear for one in results),
            conditions=conditions,
            unconfirmed=tuple(unconfirmed),
            remarks=tuple(dict.fromkeys(remarks)),
        )

    def _told(self, result: CodeResult) -> str:
        """Return the numbers of a result in words, as far as it has them."""
        displacement, period, damping, shear = self.symbols
        parts = [
            f"{displacement} {result.displacement:.0f} mm",
            *(() if result.period is None else (f"{period} {result.period:.2f} s",)),
            *(() if result.damping is None else (f"{damping} {100.0 * result.damping:.1f} %",)),
            f"{shear} {result.base_shear:.3f}",
        ]
        return ", ".join(parts)


def iterated(
    method: str,
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    reduction: Callable[[float], float],
    part: float = 1.0,
) -> CodeResult:
    """Return what a method finds by iteration on effective period and damping, without its conditions; arguments and errors as for `iterate`."""
    steps, remarks = iterate(pendulum, spectrum, reduction, part)
    last = steps[-1]
    return CodeResult(
        method=method,
        displacement=last.displacement,
        base_shear=pendulum.force(last.displacement),
        period=last.period,
        damping=last.damping,
        steps=steps,
        unconfirmed=spectrum.unconfirmed,
        remarks=remarks,
    )


def code_methods() -> Mapping[str, CodeMethod]:
    """Return every method of a code by its name, in the order of tables."""
    return {one.name: one for one in METHODS.values() if isinstance(one, CodeMethod)}


#: Sources of what the reports of several codes have in common.
MECHANICS, OF_RECORD = "mechanics", "spectrum of the record"


def decimals_of(length: float) -> int:
    """Return with how many decimals a length [mm] is put into a formula, so that its result comes out."""
    return 2 if length >= 10.0 else 4


def millimetres(length: float) -> str:
    """Return a length [mm] as it is put into a formula."""
    return number(length, decimals_of(length))


def equivalent_formulas(
    result: CodeResult, inputs: CodeInputs, period: str, damping: str, source: str
) -> tuple[Formula, ...]:
    """Return secant stiffness, period and damping at the displacement of a result; `period` and `damping` are their symbols."""
    pendulum, D = inputs.pendulum, result.displacement
    at, mu, radius = millimetres(D), f"{pendulum.friction:.5f}", number(pendulum.radius, 1)
    per_metre = 1e3 * pendulum.effective_stiffness(D)
    return (
        Formula("Effective stiffness over the weight", 'k_"eff" / W = 1 / R + mu_n / D', f"1000 times (1 / {radius} + {mu} / {at})", per_metre, 4, "1/m", MECHANICS),
        Formula("Effective period", f'{period} = 2 pi sqrt(W / (k_"eff" g))', f"2 pi sqrt(1 / ({number(per_metre, 4)} times 9.80665))", pendulum.effective_period(D), 3, "s", source),
        Formula("Effective damping", f"{damping} = 2 / pi mu_n / (mu_n + D / R)", f"2 / pi times {mu} / ({mu} + {at} / {radius})", pendulum.effective_damping(D), 4, "", source),
    )  # fmt: skip


def demand_formula(result: CodeResult, inputs: CodeInputs) -> Formula:
    """Return the ordinate of the spectrum at the effective period of a result."""
    name = "Spectral displacement of the record at this period and a damping of 5 %"
    ordinate = float(displacement(inputs.spectrum, np.array([result.period]))[0])
    return Formula(name, "S_d", "", ordinate, decimals_of(ordinate), "mm", OF_RECORD)


def shear_formula(result: CodeResult, inputs: CodeInputs, source: str, symbol: str = "V_b / W") -> Formula:
    """Return the base shear from friction and displacement."""
    pendulum = inputs.pendulum
    numbers = f"{pendulum.friction:.5f} + {millimetres(result.displacement)} / {number(pendulum.radius, 1)}"
    name = "Base shear over the weight"
    return Formula(name, f"{symbol} = mu_n + D / R", numbers, result.base_shear, 4, "", source)
