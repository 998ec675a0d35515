"""Results and verdicts: peaks of all cases, a page for each, every method beside the analysis, every check; and what they come to on the first page."""

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from dcfp.analysis import Response, Status
from dcfp.analysis.result import EnergyBalance
from dcfp.inference.case import Case
from dcfp.inference.statistics import ratios
from dcfp.methods import Prediction
from dcfp.methods.code import code_methods, code_objects
from dcfp.methods.pulses import CHANGE
from dcfp.present.report import document as doc
from dcfp.schema.check import Check, Verdict
from dcfp.schema.formulas import true_minus
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import KN_M, NONE, Unit
from dcfp.study.scenario import OF_ONE_DIRECTION, Calculation, ScenarioResult

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ANALYSIS = "analysis"
#: Heights of the sheet of the analysis with the temperature along the plates, and of the pulses, so that both stand on one page [in].
_SHEET_WITH_PROFILE, _PULSES = 5.35, 3.55
#: Characters of a record's name that the head of a figure has room for.
_LONGEST = 40
_METHODS: tuple[tuple[str, doc.Parts], ...] = (
    ("dy_mm", (doc.Maths("Delta y"), "\n[mm]")),
    ("V_dE_mm_s", (doc.Maths("V_(Delta E)"), "\nlargest of\nany pulse\n[mm/s]")),
    ("V_dEhr_mm_s", (doc.Maths('V_(Delta E "hr")'), "\nlargest of\nany pulse\n[mm/s]")),
)
#: Cases beside each other in a table.
_BESIDE = 4
#: Cases that are named in a line of the first page.
_NAMED = 3
#: Cases whose peaks stand on the first page.
_FEW = 4


def label_of(result: ScenarioResult) -> str:
    """Return the name of a case: the record and the PGV."""
    return f"{result.motion.name}, {doc.written('pgv_m_s', result.motion.peak_velocity / 1e3)} m/s"


def checks_of(result: ScenarioResult) -> tuple[Check, ...]:
    """Return every check of a case: those of the analysis, then the conditions of each code."""
    of_analysis = [replace(one, of=ANALYSIS) for one in result.response.checks]
    of_codes = [replace(one, of=name) for name, said in result.codes.items() for one in said.conditions]
    return (*of_analysis, *of_codes)


def governing(calculation: Calculation) -> ScenarioResult:
    """Return the case with the largest displacement."""
    return max(calculation.results, key=lambda one: one.response.peak_displacement)


def _at_end(name: str) -> Callable[[EnergyBalance], float]:
    return lambda energy: float(getattr(energy, name)[-1])


#: Energies at the end of an analysis, and the residual of their balance.
ENERGIES = [
    Quantity("input_kN_m", "input", KN_M, symbol="E", get=_at_end("input")),
    Quantity("hysteretic_kN_m", "hysteretic", KN_M, symbol="E_h", get=_at_end("hysteretic")),
    Quantity("strain_kN_m", "strain", KN_M, symbol="E_s", get=_at_end("strain")),
    Quantity("kinetic_kN_m", "kinetic", KN_M, symbol="E_k", get=_at_end("kinetic")),
    Quantity("residual_kN_m", "residual", KN_M, get=_at_end("residual")),
    Quantity("absolute_input_kN_m", "absolute input", KN_M, symbol=r"E_{\mathrm{abs}}", get=_at_end("absolute_input")),
    Quantity("largest_residual_over_largest_input", "largest residual\nover largest input", NONE, get="relative_residual"),
]  # fmt: skip


# ----- results -----


def results_section(calculation: Calculation) -> doc.Section:
    """Return the section of the results."""
    key: list[doc.Part] = []
    for one in _peaks(calculation):
        key += [", " if key else "", *_symbol(one), f" {one.words}"]
    key.append(". Numbers are rounded to the digits shown; dcfp report --json prints all of them.")
    parts = [doc.Section(f"Case {place}: {label_of(one)}", _case(one, calculation), on_new_page=True) for place, one in enumerate(calculation.results, 1)]  # fmt: skip
    return doc.Section("Results of the analyses", (peaks_table(calculation), doc.note(*key)), tuple(parts))


def peaks_table(calculation: Calculation) -> doc.Table:
    """Return the peaks of all cases."""
    peaks = _peaks(calculation)
    units = [(*_symbol(one), f"\n[{_digits(one)[0].name}]") for one in peaks]
    rows: list[tuple[doc.Cell, ...]] = []
    for one in calculation.results:
        response = one.response
        verdict = Verdict.MET if response.status is Status.OK else Verdict.NOT_MET
        numbers = [true_minus(peak.text(response, *_digits(peak))) for peak in peaks]
        rows.append((*doc.cells(one.motion.name, *numbers), doc.Cell((response.status.value,), verdict)))
    widths = (1.0, *[0.0] * len(peaks), 0.9)
    head = doc.cells("Record", *units, "Status")
    return doc.Table(head, tuple(rows), f"l{'r' * len(peaks)}l", widths, "Peaks")


def _peaks(calculation: Calculation) -> list[Quantity]:
    """Return what is declared of a response, as far as it is a number that both data and tables have."""
    return [one for one in calculation.quantities.values() if one.is_number and one.printed and one.stored]


def _digits(one: Quantity) -> tuple[Unit, int | None]:
    """Return unit and decimals of a peak in a report: its own for data where the report has digits for it, else those of tables."""
    return (one.unit, doc.DECIMALS[one.key]) if one.key in doc.DECIMALS else (one.shown, None)


def _symbol(one: Quantity) -> doc.Parts:
    """Return the symbol of a quantity, or its name where it has none."""
    source = doc.maths_of(one.symbol)
    is_word = source.count('"') == 2 and source.startswith('"') and source.endswith('"')
    return (source.strip('"') if is_word else doc.Maths(source) if source else one.title,)


def _case(one: ScenarioResult, calculation: Calculation) -> tuple[doc.Block, ...]:
    name, shown = label_of(one), doc.shortened(one.motion.name, _LONGEST)

    def draw_response() -> "Figure":
        response = one.response
        figure = replace(response, motion=replace(response.motion, name=shown)).plot()
        if response.profiles is not None:
            figure.set_figheight(_SHEET_WITH_PROFILE)
        return figure

    response, case = one.response, one.case
    if case is None or not isinstance(response, Response):
        words = f"Paths of displacement and force in the plane, and histories of ground velocity, displacement, temperature, friction and energy, {name}"
        return (doc.Drawing(draw_response, words), _energies(one))

    def draw_pulses() -> "Figure":
        from dcfp.present.figures import plot_pulses  # late: Matplotlib takes long to import

        constants = calculation.methods.constants
        figure = plot_pulses(replace(case, record=shown), response=response, constants=constants)
        figure.set_figheight(_PULSES)
        return figure

    return (
        doc.Drawing(
            draw_response,
            f"Force-displacement loop and histories of velocity, displacement, temperature, friction and energy, {name}",
        ),
        doc.Drawing(draw_pulses, f"Ground velocity with its pulses, velocities and displacement, {name}"),
        _energies(one),
    )


def _energies(one: ScenarioResult) -> doc.Table:
    head: list[doc.Parts] = []
    row: list[str] = []
    for part in ENERGIES:
        value = part.datum(one.response.energy)
        name = doc.Maths(doc.maths_of(part.symbol)) if part.symbol else part.words
        head.append((name, "\n[kN m]") if part.unit.has_dimension else (name,))
        row.append(doc.written("energy_kN_m", value) if part.symbol else doc.powered(value))
    words = "Energy balance at the end: input, hysteretic, strain and kinetic energy, what is left over, absolute input"
    return doc.Table(doc.cells(*head), (doc.cells(*row),), "rrrrrrr", (*[1.0] * 6, 1.6), words)


def methods_section(calculation: Calculation) -> doc.Section:
    """Return every method beside the analysis, a pair of tables for each case."""
    title = "Predictions and codes against the analysis"
    if calculation.in_plane:
        return doc.Section(title, (doc.words(OF_ONE_DIRECTION),))
    note = doc.note(
        "Methods of Li et al. (2020) predict ", doc.Maths("Delta y"), ", and are above the analysis where it is at least that of the analysis; the march and the codes where their"
        " largest displacement is. ", doc.Maths('y_"max"'), " over the analysis takes ", doc.Maths("Delta y"), " where a method has no largest displacement, as Li et al. (2020), section 6.1.2, do."
        " Above or below says nothing of whether a method may be used. Methods that know the record only, and the analysis, have ", doc.Maths("V_(Delta E)"), " and ",
        doc.Maths('V_(Delta E "hr")'), " as the largest of any pulse or swing, each on its own; those that know the analysis too have them of the pulse that it found to govern."
        " Codes know the record's own spectrum.",
    )  # fmt: skip
    parts = [
        doc.Section(label_of(one), _methods(one.case, one.response.peak_displacement))
        for one in calculation.results
        if one.case is not None
    ]
    return doc.Section(title, (note,), tuple(parts), on_new_page=True)


def _methods(case: Case, y: float) -> tuple[doc.Block, ...]:
    analysis = (*_row(("analysis", ""), case.analysed.whole, y, (1.0, 1.0)), *doc.cells(""))
    rows: list[tuple[doc.Cell, ...]] = [tuple(replace(cell, strong=True) for cell in analysis)]
    for variant, said in case.predicted.items():
        if variant.method in case.codes:
            continue
        change = float(ratios([case], variant, CHANGE)[0])
        bound = said.bound / y if y > 0.0 else None
        texts = (variant.method, variant.information.words)
        against = _against(change if said.displacement is None else bound)
        rows.append((*_row(texts, said, said.displacement, (change, bound)), against))
    head = doc.cells("Method", "Knows", *(words for _, words in _METHODS), (doc.Maths('y_"max"'), "\n[mm]"), (doc.Maths("Delta y"), " over\nanalysis\n[–]"), (doc.Maths('y_"max"'), " over\nanalysis\n[–]"), "Against\nanalysis")  # fmt: skip
    blocks: list[doc.Block] = [doc.Table(head, tuple(rows), "llrrrrrrl", (1.0, 1.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9), "Predictions")]  # fmt: skip
    if case.codes:
        blocks.append(_codes(case, y))
    remarks = [f"{said.method}: {' '.join(said.remarks)}" for said in case.codes.values() if said.remarks]
    missing = [name for name in code_methods() if name not in case.codes]
    remarks += [f"No solution: {', '.join(missing)}."] if missing else []
    return (*blocks, doc.note(" ".join(remarks))) if remarks else tuple(blocks)


def _codes(case: Case, y: float) -> doc.Table:
    rows: list[tuple[doc.Cell, ...]] = []
    for said in case.codes.values():
        ratio = said.displacement / y if y > 0.0 else None
        numbers = code_objects([said])[0]
        keys = ("displacement_mm", "base_shear_over_weight", "effective_period_s", "effective_damping")
        texts = [said.method, *(doc.written(key, numbers[key]) for key in keys), doc.written("ratio", ratio)]
        verdict = doc.Cell((said.verdict,), Verdict.of(said.valid if said.conditions else None))
        rows.append((*doc.cells(*texts), _against(ratio), verdict))
    head = doc.cells("Method", "D\n[mm]", (doc.Maths('V_b "/" W'), "\n[–]"), "Period\n[s]", "Damping\n[–]", "Over the\nanalysis [–]", "Against\nanalysis", "May be used")  # fmt: skip
    return doc.Table(head, tuple(rows), "lrrrrrll", (1.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9, 1.6), "Codes under the record's own spectrum")  # fmt: skip


def _row(
    texts: tuple[str, str],
    said: Prediction,
    displacement: float | None,
    over: tuple[float | None, float | None],
) -> tuple[doc.Cell, ...]:
    """Return what a method gives: dy, energies, y_max, and dy and y_max over the analysis."""
    values = (said.displacement_change, said.input_velocity, said.hysteretic_velocity, displacement)
    keys = (*(key for key, _ in _METHODS), "y_mm")
    numbers = (doc.written(key, value) for key, value in zip(keys, values, strict=True))
    return doc.cells(*texts, *numbers, *(doc.written("ratio", one) for one in over))


def _against(ratio: float | None) -> doc.Cell:
    """Return a word on a ratio to the analysis; above it has no colour, as it does not make a method safe."""
    if ratio is None or not math.isfinite(ratio):
        return doc.Cell(("no prediction",), Verdict.NOT_KNOWN)
    return doc.Cell(("above analysis",)) if ratio >= 1.0 else doc.Cell(("below analysis",), Verdict.NOT_KNOWN)


# ----- verdicts -----


def checks_section(calculation: Calculation) -> doc.Section:
    """Return every check of every case, in a section for the analyses and one for each code."""
    labels = [label_of(one) for one in calculation.results]
    every = [checks_of(one) for one in calculation.results]
    groups = list(dict.fromkeys(check.of for checks in every for check in checks))
    parts: list[doc.Section] = []
    for group in groups:
        rows = _rows(every, group)
        title = "Analyses" if group == ANALYSIS else f"Conditions of {group}"
        tables = [_table(rows, [labels[i] for i in places], list(places)) for places in _batches(len(labels))]
        parts.append(doc.Section(title, tuple(tables)))
    note = doc.note(
        "Met, not met, or not known where the scenario does not say what a condition asks for. A clause that is called unconfirmed could not be read in the code"
        " itself and stands as other sources have it.",
    )
    return doc.Section("Checks", (note,), tuple(parts), on_new_page=True)


def _batches(count: int) -> list[tuple[int, ...]]:
    return [tuple(range(first, min(first + _BESIDE, count))) for first in range(0, count, _BESIDE)]


def _rows(every: Sequence[Sequence[Check]], group: str) -> dict[str, list[Check | None]]:
    """Return the conditions of a group by their names, one for each case."""
    of_case = [{one.name: one for one in checks if one.of == group} for checks in every]
    names = list(dict.fromkeys(name for known in of_case for name in known))
    return {name: [known.get(name) for known in of_case] for name in names}


def _table(rows: dict[str, list[Check | None]], labels: list[str], places: list[int]) -> doc.Table:
    made: list[tuple[doc.Cell, ...]] = []
    for name, of_case in rows.items():
        here = [of_case[place] for place in places]
        first = next((one for one in here if one is not None), None)
        if first is None:
            continue
        if len({one.limit for one in here if one}) > 1:
            msg = f"the limit of {name!r} depends on the case; it belongs to what was found."
            raise ValueError(msg)
        source = first.source if first.confirmed else f"{first.source} (unconfirmed)"
        same = len({(one.found, one.verdict) if one else None for one in here}) == 1
        found = (_found(first, len(here)),) if same else tuple(_found(one) for one in here)
        made.append((*doc.cells(name, first.limit_words, source), *found))
    head = doc.cells("Check", "Limit", "Source or clause", *labels)
    count = len(places)
    return doc.Table(
        head, tuple(made), "lll" + "l" * count, (2.2, 2.0, 1.6, *[1.15 if count > 1 else 1.8] * count)
    )


def _found(one: Check | None, span: int = 1) -> doc.Cell:
    if one is None:
        return doc.Cell(("no answer",), Verdict.NOT_KNOWN, span)
    return doc.Cell((f"{one.found_words}: {one.verdict}",), one.verdict, span)


def front_blocks(calculation: Calculation) -> tuple[doc.Block, ...]:
    """Return the verdicts in short: the displacement, and a line for each check of the analyses and for each code."""
    few = len(calculation.results) <= _FEW
    peaks = (peaks_table(calculation),) if few else ()
    return (_headline(calculation), *peaks, _summary(calculation), _codes_summary(calculation))


def _headline(calculation: Calculation) -> doc.Block:
    worst = governing(calculation)
    found = worst.response.peak_displacement
    capacity = calculation.scenario.model.bearing.displacement_capacity
    count = len(calculation.results)
    among = f", the largest displacement of {count} cases" if count > 1 else ""
    what = "Largest resultant displacement " if calculation.in_plane else "Largest displacement "
    start = (what, doc.Maths('y_"max"'), f" = {doc.written('y_max_mm', found)} mm under {label_of(worst)}{among}. ")  # fmt: skip
    if capacity is None:
        return doc.words(*start, "No capacity is given.", tone=doc.Tone.OPEN)
    beyond = sum(one.response.peak_displacement > capacity for one in calculation.results)
    if beyond:
        where = f" in {beyond} of them" if count > 1 else ""
        end = f"The capacity of {doc.short(capacity)} mm is exceeded{where}."
        return doc.words(*start, end, tone=doc.Tone.BAD)
    return doc.words(*start, f"The capacity of {doc.short(capacity)} mm is not exceeded.", tone=doc.Tone.GOOD)


def _summary(calculation: Calculation) -> doc.Table:
    labels = [label_of(one) for one in calculation.results]
    rows: list[tuple[doc.Cell, ...]] = []
    for name, of_case in _rows([checks_of(one) for one in calculation.results], ANALYSIS).items():
        known = [(label, one) for label, one in zip(labels, of_case, strict=True) if one is not None]
        verdict = _worst([one for _, one in known])
        count = doc.Cell((_count(known, verdict),), verdict)
        rows.append((*doc.cells(name), count, *doc.cells(_where(known, verdict))))
    return doc.Table(doc.cells("Check of the analyses", "Verdict", "Where, and what is allowed"), tuple(rows), "lll", (2.2, 1.3, 2.8), "Verdicts")  # fmt: skip


def _worst(conditions: Sequence[Check]) -> Verdict:
    verdicts = {one.verdict for one in conditions}
    return next(one for one in (Verdict.NOT_MET, Verdict.NOT_KNOWN, Verdict.MET) if one in verdicts)


def _count(known: list[tuple[str, Check]], verdict: Verdict) -> str:
    count = sum(one.verdict is verdict for _, one in known)
    return verdict.value if count == len(known) else f"{verdict} in {count} of {len(known)}"


def _where(known: list[tuple[str, Check]], verdict: Verdict) -> str:
    concerned = [(label, one) for label, one in known if one.verdict is verdict]
    limit = concerned[0][1].limit_words
    if verdict is not Verdict.NOT_MET:
        return limit
    named = "; ".join(f"{label}: {one.found_words}" for label, one in concerned[:_NAMED])
    more = len(concerned) - _NAMED
    return f"{named}{f'; and {more} more' if more > 0 else ''} ({limit})"


def _codes_summary(calculation: Calculation) -> doc.Block:
    if calculation.in_plane:
        return doc.note(OF_ONE_DIRECTION)
    rows: list[tuple[doc.Cell, ...]] = []
    answers = [one.codes for one in calculation.results]
    for name in dict.fromkeys(name for known in answers for name in known):
        said = [known[name] for known in answers if name in known]
        inside, outside = sum(one.valid is True for one in said), sum(one.valid is False for one in said)
        conditions = [condition for one in said for condition in one.conditions]
        broken = Counter(one.name for one in conditions if one.verdict is Verdict.NOT_MET)
        if not conditions:
            verdict, text = Verdict.NOT_KNOWN, "no limits known"
        elif outside:
            verdict, text = Verdict.NOT_MET, f"no, in {outside} of {len(said)}"
        else:
            verdict = Verdict.MET if inside == len(said) else Verdict.NOT_KNOWN
            text = "yes" if verdict is Verdict.MET else "conditions not known"
        below = sum(
            one.response.peak_displacement > known[name].displacement
            for one, known in zip(calculation.results, answers, strict=True)
            if name in known
        )
        why = ", ".join(f"{condition} ({count})" for condition, count in broken.items()) or "–"
        told = doc.cells(f"{below} of {len(said)}", why)
        rows.append((*doc.cells(name), doc.Cell((text,), verdict), *told))
    if not rows:
        return doc.note("No method of a code has an answer.")
    return doc.Table(doc.cells("Code", "May be used", "Below the analysis", "Conditions not met (cases)"), tuple(rows), "llll", (1.4, 1.3, 1.0, 2.6))  # fmt: skip
