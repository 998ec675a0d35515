"""What a method of a code gives: its answer, how it came to it, and whether it may be used; and what its conditions ask of the building and its site."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from dcfp.errors import InputError
from dcfp.schema.check import COLUMNS, Check, Verdict, at_least
from dcfp.schema.notebook import card
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import MM, NONE, PERCENT, SECOND


@dataclass(frozen=True)
class Step:
    """One round of an iteration.

    Attributes
    ----------
    displacement
        It began with [mm].
    period
        Effective period [s].
    damping
        Effective damping ratio [-].
    reduction
        Factor on the spectrum at a damping of 5 % [-].
    """

    displacement: float
    period: float
    damping: float
    reduction: float


@dataclass(frozen=True)
class Answer:
    """What a method says.

    Attributes
    ----------
    method
        Its name.
    displacement
        Of the isolation layer [mm].
    base_shear
        Horizontal force over the weight that goes with it [-].
    period, damping
        Effective period [s] and damping ratio [-]; None where the method has none.
    steps
        The iteration, the last of them the answer; empty where there is none.
    conditions
        Under which the method may be used.
    unconfirmed
        What in the method could not be confirmed in its source.
    remarks
        Sentences that a reader must know.
    """

    method: str
    displacement: float
    base_shear: float
    period: float | None = None
    damping: float | None = None
    steps: tuple[Step, ...] = ()
    conditions: tuple[Check, ...] = ()
    unconfirmed: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def valid(self) -> bool | None:
        """Whether every condition is met; None where none is broken but some are not known."""
        verdicts = {one.verdict for one in self.conditions}
        if Verdict.NOT_MET in verdicts:
            return False
        return None if Verdict.NOT_KNOWN in verdicts else True

    @property
    def verdict(self) -> str:
        """The verdict in a word or two, which must stand beside every result."""
        if not self.conditions:
            return "no limits known"
        broken = sum(one.verdict is Verdict.NOT_MET for one in self.conditions)
        if broken:
            return f"outside its limits ({broken})"
        open_ = sum(one.verdict is Verdict.NOT_KNOWN for one in self.conditions)
        return f"within its limits, {open_} not known" if open_ else "within its limits"

    def _repr_html_(self) -> str:
        facts = {
            "verdict": self.verdict,
            "displacement [mm]": self.displacement,
            "base shear over weight": self.base_shear,
            "effective period [s]": self.period,
            "effective damping": self.damping,
        }
        rows = [
            {"condition": one.name, "verdict": one.verdict.value, "found": one.found, "limit": one.limit}
            for one in self.conditions
        ]
        return card(self.method, facts, rows=rows, remarks=self.remarks)


#: What is told of an answer; `over` is that of a line of a `Panel`.
ANSWERS = [
    Quantity("method", "method", head="Method", get="method"),
    Quantity("displacement_mm", "displacement of the isolation layer", MM, decimals=1, name="displacement", head="D", get="displacement"),
    Quantity("base_shear_over_weight", "base shear over the weight", NONE, decimals=3, head="V_b/W", get="base_shear"),
    Quantity("effective_period_s", "effective period", SECOND, decimals=2, name="effective_period", head="T_eff", get="period"),
    Quantity("effective_damping", "effective damping ratio", NONE, PERCENT, 1, head="beta_eff", get="damping"),
    Quantity("over_analysis", "displacement over that of the analysis", NONE, decimals=2, head="D over\nanalysis", get="over", stored=False),
    Quantity("within_limits", "whether it is within the limits of the method", get=lambda said: said.valid if said.conditions else None, printed=False),
    Quantity("verdict", "the same in words", head="Verdict", get="verdict"),
    Quantity("conditions", "conditions of the method", get=lambda said: Table(tuple(COLUMNS), said.conditions).objects(), flat=False, printed=False),
    Quantity("iteration", "rounds of the iteration", get=lambda said: Table(tuple(STEPS), said.steps).objects(), flat=False, printed=False),
    Quantity("unconfirmed", "what could not be confirmed", get="unconfirmed", printed=False),
    Quantity("remarks", "what a reader must know", get="remarks", printed=False),
]  # fmt: skip
#: What is told of a round of an iteration.
STEPS = [
    Quantity("displacement_mm", "displacement that it began with", MM, decimals=2, head="D", get="displacement"),
    Quantity("period_s", "effective period", SECOND, decimals=3, head="T_eff", get="period"),
    Quantity("damping", "effective damping ratio", NONE, PERCENT, 2, head="beta_eff", get="damping"),
    Quantity("reduction", "factor on the spectrum", NONE, decimals=4, head="Reduction", get="reduction"),
]  # fmt: skip


def answer_objects(answers: Iterable[Answer]) -> list[dict[str, Any]]:
    """Return answers with their verdicts, conditions and iterations, ready for JSON."""
    return Table(tuple(ANSWERS), list(answers)).objects()


#: Site classes of ASCE/SEI 7.
SITE_CLASSES = ("A", "B", "C", "D", "E", "F")


@dataclass(frozen=True)
class Structure:
    """A building on the isolation layer; what is None is not known, and the conditions that ask for it say so.

    Parameters
    ----------
    fixed_base_period
        Of the structure without isolation [s]; 0 for a rigid one.
    height
        Above the isolation [mm].
    site_class
        After ASCE/SEI 7, ``"A"`` to ``"F"``.
    plan
        Larger dimension of the plan [mm].
    fault_distance
        To the nearest fault of a magnitude of 6.5 or more [mm].
    weight_above
        Weight of the structure above the base level over the whole weight, W_s / W [-].

    Raises
    ------
    InputError
        If there is no such site class.
    """

    fixed_base_period: float | None = None
    height: float | None = None
    site_class: str | None = None
    plan: float | None = None
    fault_distance: float | None = None
    weight_above: float | None = None

    def __post_init__(self) -> None:
        if self.site_class is not None and self.site_class not in SITE_CLASSES:
            msg = f"The site classes of ASCE 7 are {', '.join(SITE_CLASSES)}, not {self.site_class!r}."
            raise InputError(msg)

    def over_fixed_base(self, period: float, least: float) -> tuple[Verdict, str]:
        """Return whether a period [s] is at least so many times that of the fixed base, and what it is, in words."""
        fixed = self.fixed_base_period
        if fixed is None:
            return Verdict.NOT_KNOWN, "not given"
        if fixed == 0.0:
            return Verdict.MET, "rigid structure"
        return at_least(period, least * fixed), f"{period / fixed:.1f}"
