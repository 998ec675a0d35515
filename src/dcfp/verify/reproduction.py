"""The findings and figures of Li et al. (2020), section 6, made again and put beside what the paper prints; and all of them as one page."""

import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from importlib.resources import files
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.arrays import FloatArray
from dcfp.inference import Case, Methods, compare
from dcfp.inference.forecast import calibration_set, cases_at
from dcfp.inference.refit import average_slope, change_ratio, fall_ratio
from dcfp.inference.statistics import displacement_over_change, ratios, scatter
from dcfp.methods.li_2020 import LI_2020, predict_from_pgv
from dcfp.methods.li_2020.constants import (
    DERIVED_DESIGN,
    PAPER,
    PRINTED_RANGES,
    PRINTED_ROUNDING,
)
from dcfp.methods.method import Information, Variant
from dcfp.methods.pulse_march import NAME as MARCH
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, HYSTERETIC, INPUT, value_of
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import ALIASES, VELOCITIES, named_motion
from dcfp.present.report import document as doc
from dcfp.present.report.forms import page_with
from dcfp.schema.check import Verdict
from dcfp.schema.quantities import Quantity as Column
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, NONE
from dcfp.system import LI_2020 as BEARING
from dcfp.system import ConstantFriction, Li2020, NoHeating, PreciseHeating
from dcfp.verify.check import tasks
from dcfp.verify.explanation import explain
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.present.figures.li_2020 import PaperFigure

T = TypeVar("T")

#: Analyses of one record at one PGV: with simplified and precise heating, and with the constant coefficient.
_MODELS = 3


@dataclass(frozen=True, eq=False)
class Analyses:
    """All analyses.

    Attributes
    ----------
    cases
        The paper's records at its PGVs, with simplified heating as in the paper, record by record; each keeps its response.
    precise
        The same with precise heating.
    constant
        The same with the constant nominal coefficient.
    hundred
        The 100 components of FEMA P-695 at the same PGVs.
    """

    cases: tuple[Case, ...]
    precise: tuple[Response, ...]
    constant: tuple[Response, ...]
    hundred: tuple[Case, ...]


def number_of(records: int) -> int:
    """Return how many analyses `analyse` makes of so many records."""
    return len(VELOCITIES) * (records * _MODELS + len(calibration_set()))


def paper_motions(others: Sequence[GroundMotion] = ()) -> list[GroundMotion]:
    """Return the identified records of Li et al. (2020), Table 3, and those that the user has besides."""
    return [*(named_motion(alias) for alias in ALIASES), *others]


def analyse(motions: Sequence[GroundMotion], report: Callable[[], None] = lambda: None) -> Analyses:
    """Analyse the paper's bearing under every motion at every PGV; `report` is called after each analysis."""

    def told(one: T) -> T:
        report()
        return one

    methods = Methods()
    scaled = [motion.scaled_to_pgv(velocity) for motion in motions for velocity in VELOCITIES]
    return Analyses(
        tuple(told(compare(motion, keep_response=True)) for motion in scaled),
        tuple(told(respond(motion, BEARING, Li2020(), PreciseHeating())) for motion in scaled),
        tuple(told(respond(motion, BEARING, ConstantFriction(), NoHeating())) for motion in scaled),
        tuple(case for velocity in VELOCITIES for case in cases_at(velocity, methods, report)),
    )


@dataclass(frozen=True)
class Outside:
    """A case outside a printed range: its PGV [mm/s], prediction over analysis [-], and what sets it apart."""

    record: str
    pgv: float
    ratio: float
    words: str

    def __str__(self) -> str:
        return f"{self.record} at {self.pgv / 1e3:.2f} m/s, {self.ratio:.2f}: {self.words}"


class Basis(StrEnum):
    """What a finding rests on: the paper prints it, or it follows from the paper's formulas, which is not printed; or it is the project's own."""

    PRINTED = "printed"
    DERIVED = "derived"
    OURS = "ours"


@dataclass(frozen=True)
class Finding:
    """One finding of the paper beside ours.

    Attributes
    ----------
    name
        What is found.
    basis
        Whether the paper prints it, it follows from the paper's formulas, or it is the project's own.
    place
        Where the paper prints it, or has the formulas.
    paper, ours
        In words, with units; of the project's own there is nothing of the paper.
    hundred
        The same of the 100 components of FEMA P-695; empty where it was not looked at.
    agrees
        Whether ours is what the paper prints or its formulas give, to the last digit; None where the two cannot be compared.
    words
        Why it differs, or how it was found.
    outside
        The cases outside a printed range.
    """

    name: str
    basis: Basis
    place: str
    paper: str
    ours: str
    hundred: str
    agrees: bool | None
    words: str = ""
    outside: tuple[Outside, ...] = ()

    @property
    def sign(self) -> str:
        """Whether ours is as printed or derived, in words."""
        if self.basis is Basis.OURS:
            return "no word of the paper"
        return {True: f"as {self.basis}", False: "differs", None: "not comparable"}[self.agrees]


#: What is told of a finding.
FINDINGS = [
    Column("Finding", "what is found, and where the paper has it", get=lambda one: f"{one.name} ({one.place})", stored=False),
    Column("name", "what is found", get="name", printed=False),
    Column("place", "where the paper has it", get="place", printed=False),
    Column("basis", "printed by the paper, derived from its formulas, or ours", head="Basis", get="basis"),
    Column("paper", "as the paper prints it or its formulas give", head="Paper", get="paper"),
    Column("ours", "as it is found here", head="Ours", get="ours"),
    Column("100 components", "of the components of FEMA P-695", get="hundred", stored=False),
    Column("hundred_components", "of the components of FEMA P-695", get=lambda one: one.hundred or None, printed=False),
    Column("agrees", "whether it is as printed or derived", get="agrees", printed=False),
    Column(" ", "the same in words", get=lambda one: "" if one.agrees or one.basis is Basis.OURS else one.sign, stored=False),
    Column("words", "why it differs, or how it was found", get="words", printed=False),
    Column("outside", "cases outside a printed range", get=lambda one: Table(tuple(OUTSIDE), one.outside).objects(), flat=False, printed=False),
]  # fmt: skip
OUTSIDE = [
    Column("record", "name of the ground motion", get="record"),
    Column("pgv_m_s", "peak ground velocity", M_PER_S, get="pgv"),
    Column("ratio", "prediction over analysis", NONE, get="ratio"),
    Column("words", "what sets it apart", get="words"),
]


@dataclass(frozen=True)
class _Found:
    """Whether a finding is as printed, what its texts in ``findings.toml`` hold in braces, and the cases outside a printed range."""

    agrees: bool | None
    words: Mapping[str, object]
    outside: tuple[Outside, ...] = ()


def findings_of(analyses: Analyses) -> list[Finding]:
    """Return every finding of the paper's section 6, printed or derived, beside ours."""
    by: dict[str, Callable[[Analyses], list[_Found]]] = {
        "ranges": _ranges,
        "average_slope": _average_slope,
        "fall_ratio": _fall_ratio,
        "change_ratio": _change_ratio,
        "design": _design,
        "derived": _derived,
        "march": _march,
        "heating": _heating,
        "larger_change": _larger_change,
        "constant": _constant,
    }
    text = files("dcfp.verify").joinpath("findings.toml").read_text(encoding="utf-8")
    findings: list[Finding] = []
    for row in tomllib.loads(text)["finding"]:
        basis = Basis(row.pop("basis"))
        for found in by[row.pop("by")](analyses):
            told = {key: str(words).format(**found.words) for key, words in row.items()}
            findings.append(Finding(**told, basis=basis, agrees=found.agrees, outside=found.outside))
    return findings


def _ranges(analyses: Analyses) -> list[_Found]:
    """Return the printed ranges of predictions over analyses, half of the last printed digit allowed."""
    together = list(zip(analyses.cases, analyses.precise, analyses.constant, strict=True))
    found: list[_Found] = []
    for (variant, quantity), (low, high, place) in PRINTED_RANGES.items():
        values, hundred = (ratios(cases, variant, quantity) for cases in (analyses.cases, analyses.hundred))
        least, most = low - PRINTED_ROUNDING, high + PRINTED_ROUNDING
        outside = tuple(
            Outside(case.record, case.pgv, float(value), explain(case, precise, constant, variant, quantity))
            for (case, precise, constant), value in zip(together, values, strict=True)
            if not least <= value <= most
        )
        measures = scatter(hundred)
        informed = ratios(analyses.cases, Variant(variant.method, Information.INFORMED), quantity)
        words = {
            "quantity": quantity.title,
            "method": variant.method,
            "where": place,
            "low": low,
            "high": high,
            "values": _span(values),
            "spread": f"{measures.least:.2f} to {measures.largest:.2f}",
            "part": 100.0 * ((least <= hundred) & (hundred <= most)).mean(),
            "without": f", {measures.without} without a prediction" if measures.without else "",
            "inside": len(values) - len(outside),
            "count": len(values),
            "informed": _span(informed),
        }
        found.append(_Found(not outside, words, outside))
    return found


def _span(values: FloatArray) -> str:
    return f"{np.nanmin(values):.2f} to {np.nanmax(values):.2f}"


def _constant_of_design(
    paper: float,
    measure: Callable[[Sequence[Case]], float],
    within: float,
    analyses: Analyses,
    **more: object,
) -> list[_Found]:
    """Return a constant of the design method, with how far ours may be off for the printed digits to be the same."""
    ours, hundred = measure(analyses.cases), measure(analyses.hundred)
    return [_Found(abs(ours - paper) <= within, {"paper": paper, "ours": ours, "hundred": hundred, **more})]


def _average_slope(analyses: Analyses) -> list[_Found]:
    slopes = ", ".join(
        f"{case.record} {abs(float(case.pulses.mean_accelerations[case.analysed.pulse])):.0f}"
        for case in _weak(analyses.cases)
        if case.analysed.pulse is not None
    )
    records = ", ".join(dict.fromkeys(case.record for case in analyses.cases))
    packaged = [case for case in analyses.cases if case.record in ALIASES]
    of_packaged = (
        f" Of those that come with the package it is {average_slope(packaged):.0f} mm/s²." if packaged else ""
    )
    return _constant_of_design(
        LI_2020.average_slope,
        average_slope,
        5.0,
        analyses,
        records=records,
        count=len(records.split(", ")),
        slopes=slopes,
        packaged=of_packaged,
    )


def _fall_ratio(analyses: Analyses) -> list[_Found]:
    weak = fall_ratio(_weak(analyses.hundred))
    return _constant_of_design(LI_2020.fall_ratio, fall_ratio, 0.05, analyses, weak=weak)


def _change_ratio(analyses: Analyses) -> list[_Found]:
    return _constant_of_design(LI_2020.change_ratio, change_ratio, 0.05, analyses)


def _weak(cases: Sequence[Case]) -> list[Case]:
    return [case for case in cases if np.isclose(case.pgv, VELOCITIES[0])]


def _design(analyses: Analyses) -> list[_Found]:
    del analyses  # from the PGV alone
    found: list[_Found] = []
    for pgv, known in DERIVED_DESIGN.items():
        said = predict_from_pgv(pgv)
        agrees = all(
            abs(value_of(said, quantity) - value) <= 0.5 * digit for quantity, (value, digit) in known.items()
        )
        derived = [known[quantity][0] for quantity in (INPUT, HYSTERETIC, CHANGE)]
        words = {"pgv": pgv / 1e3, "derived": derived, "said": said, "slide": LI_2020.friction_deceleration}
        found.append(_Found(agrees, words))
    return found


#: Group of the checks of what follows from the paper's formulas, and those of them that have a finding of their own.
_DERIVED, _OF_DESIGN = "Derived from published formulas", "design method"


def _derived(analyses: Analyses) -> list[_Found]:
    """Return the numbers of `dcfp verify` that follow from the paper's formulas."""
    del analyses  # from the formulas alone
    checks = [
        task.run() for task in tasks() if task.group == _DERIVED and not task.name.startswith(_OF_DESIGN)
    ]
    return [
        _Found(
            one.passed,
            {
                "check": one,
                "where": one.source.removeprefix(f"{PAPER}, "),
                "unit": "" if one.unit == "-" else f" {one.unit.replace('2', '²')}",
            },
        )
        for one in checks
    ]


def _march(analyses: Analyses) -> list[_Found]:
    found: list[_Found] = []
    for name, quantity in (("y_max", DISPLACEMENT), ("dy", CHANGE)):
        values, hundred = (
            ratios(cases, Variant(MARCH, Information.BLIND), quantity)
            for cases in (analyses.cases, analyses.hundred)
        )
        measures = scatter(hundred)
        words = {
            "quantity": name,
            "values": _span(values),
            "of_hundred": _span(hundred),
            "dispersion": measures.dispersion,
        }
        found.append(_Found(None, words))
    return found


#: Displacement with simplified over that with precise heating, up to which the two are similar [-].
_SIMILAR = 0.1


def _heating(analyses: Analyses) -> list[_Found]:
    simplified = np.array([case.analysed.whole.bound for case in analyses.cases])
    precise = np.array([response.peak_displacement for response in analyses.precise])
    over = simplified / precise
    outside = tuple(
        Outside(case.record, case.pgv, float(ratio), f"{one:.0f} against {other:.0f} mm")
        for case, ratio, one, other in zip(analyses.cases, over, simplified, precise, strict=True)
        if abs(ratio - 1.0) > _SIMILAR
    )
    inside = np.abs(over - 1.0)[np.abs(over - 1.0) <= _SIMILAR]
    words = {
        "span": _span(over),
        "similar": 100.0 * _SIMILAR,
        "inside": inside.size,
        "count": over.size,
        "others": 100.0 * inside.max(initial=0.0),
    }
    return [_Found(not outside, words, outside)]


def _larger_change(analyses: Analyses) -> list[_Found]:
    over, hundred = (displacement_over_change(cases) for cases in (analyses.cases, analyses.hundred))
    words = {"span": _span(over), "of_hundred": _span(hundred), "part": 100.0 * (hundred < 1.0).mean()}
    return [_Found(bool((over < 1.0).mean() > 0.5), words)]


def _constant(analyses: Analyses) -> list[_Found]:
    constant = np.array([response.peak_displacement for response in analyses.constant])
    over = constant / np.array([case.analysed.whole.bound for case in analyses.cases])
    pgvs = np.array([case.pgv for case in analyses.cases])
    means = {one: np.exp(np.log(over[np.isclose(pgvs, one)]).mean()) for one in VELOCITIES}
    middle = ", ".join(f"{velocity / 1e3:g}: {mean:.2f}" for velocity, mean in means.items())
    return [_Found(None, {"span": _span(over), "middle": middle})]


# ----- the page -----


def reproduction_page(
    findings: Sequence[Finding],
    figures: "Sequence[PaperFigure]",
    records: Sequence[str],
    missing: Sequence[str],
    remarks: Sequence[str] = (),
) -> str:
    """Return findings and figures as a page of HTML that needs no other file, with the names of the records that were analysed and of those that were missing.

    Parameters
    ----------
    findings
        Of the paper and ours.
    figures
        In the form of the paper's.
    records
        Names of the records that were analysed.
    missing
        Names of those of the paper that were not there.
    remarks
        On records that the user has supplied.
    """
    lacking = (
        f" Not at hand are {', '.join(missing)}; ranges and means of the paper are of all eight records."
    )
    head = doc.cells("Finding", "Basis", "Paper", "Ours", "100 components of FEMA P-695", "")
    rows = [row for one in findings for row in _rows(one)]
    front = (
        "Li et al. (2020), section 6. Applied Sciences 10(15), 5259, doi:10.3390/app10155259",
        f"Records: {', '.join(records)}, each at a PGV of 0.25, 0.50, 0.75 and 1.00 m/s, under the paper's bearing with its friction law"
        f" and simplified heating.{lacking if missing else ''} Made by dcfp {version()} with dcfp reproduce.",
        *remarks,
    )
    table = doc.Table(head, tuple(rows), "llllll", (1.0,) * 6)
    drawings = [_drawing(one) for one in figures]
    return page_with(
        "Energy-based prediction of the displacement of DCFP bearings, made again",
        [doc.words(sentence) for sentence in front],
        (
            doc.Section("Findings", (doc.words(agreement(findings)), table)),
            doc.Section("Figures", (doc.words("In the form of the paper's, with its numbers."), *drawings)),
        ),
    )


def agreement(findings: Sequence[Finding]) -> str:
    """Return in words how many findings are as the paper prints or its formulas give, and what the labels mean."""

    def count(basis: Basis) -> str:
        own = [one.agrees for one in findings if one.basis is basis]
        return f"{own.count(True)} of {len(own)}"

    return (
        f"{count(Basis.PRINTED)} that the paper prints are found as printed; of those derived, which follow from its formulas and which it does not print,"
        f" {count(Basis.DERIVED)} are as derived. What is ours is the project's own, and the paper says nothing of it."
        " Where ours differs, the line says by how much and why."
    )


def _rows(finding: Finding) -> tuple[tuple[doc.Cell, ...], ...]:
    """Return what is found in one row, and why it is so in another one below it."""
    name = f"{finding.name}\n{finding.place}"
    found = doc.cells(name, finding.basis, finding.paper, finding.ours, finding.hundred)
    sign = doc.Cell((finding.sign,), Verdict.of(finding.agrees))
    why = "\n".join([finding.words, *(str(one) for one in finding.outside)])
    return (*found, sign), (doc.Cell((why,), span=6),)


def _drawing(figure: "PaperFigure") -> doc.Drawing:
    title = f"Figure {figure.number}. {figure.title}"
    return doc.Drawing(lambda: figure.figure, title, f"{title}. {figure.words}")
