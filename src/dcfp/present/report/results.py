"""Results: peaks of all cases, a page for each, and every method beside the analysis."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from dcfp.analysis import Status
from dcfp.analysis.response import PEAKS
from dcfp.inference.statistics import ratios
from dcfp.methods import Prediction
from dcfp.methods.code import CodeResult, code_methods, code_objects
from dcfp.methods.pulses import CHANGE
from dcfp.present.report.document import (
    DECIMALS,
    Block,
    Cell,
    Drawing,
    Maths,
    Part,
    Parts,
    Section,
    Table,
    Tone,
    cells,
    heads,
    maths_of,
    powered,
    shortened,
    words,
    written,
)
from dcfp.present.report.references import energies_of, label_of
from dcfp.schema.check import Verdict
from dcfp.schema.formulas import true_minus
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import Unit
from dcfp.study.scenario import Calculation, ScenarioResult

if TYPE_CHECKING:
    from matplotlib.figure import Figure


#: Heights of the sheet of the analysis with the temperature along the plates, and of the pulses, so that both stand on one page [in].
_SHEET_WITH_PROFILE, _PULSES = 5.35, 3.55
#: Characters of a record's name that the head of a figure has room for.
_LONGEST = 40
_METHODS: tuple[tuple[str, Parts], ...] = (
    ("dy_mm", (Maths("Delta y"), "\n[mm]")),
    ("V_dE_mm_s", (Maths("V_(Delta E)"), "\nlargest of\nany pulse\n[mm/s]")),
    ("V_dEhr_mm_s", (Maths('V_(Delta E "hr")'), "\nlargest of\nany pulse\n[mm/s]")),
)


def results_section(calculation: Calculation) -> Section:
    """Return the section of the results."""
    key: list[Part] = []
    for one in _peaks():
        key += [", " if key else "", *_symbol(one), f" {one.words}"]
    key.append(". Numbers are rounded to the digits shown; dcfp report --json prints all of them.")
    parts = [Section(f"Case {place}: {label_of(one)}", _case(one, calculation), on_new_page=True) for place, one in enumerate(calculation.results, 1)]  # fmt: skip
    return Section(
        "Results of the analyses", (peaks_table(calculation), words(*key, tone=Tone.NOTE)), tuple(parts)
    )


def peaks_table(calculation: Calculation) -> Table:
    """Return the peaks of all cases."""
    peaks = _peaks()
    head = [("Record",), *((*_symbol(one), f"\n[{_digits(one)[0].name}]") for one in peaks), ("Status",)]
    rows: list[tuple[Cell, ...]] = []
    for one in calculation.results:
        response = one.response
        verdict = Verdict.MET if response.status is Status.OK else Verdict.NOT_MET
        numbers = [true_minus(peak.text(response, *_digits(peak))) for peak in peaks]
        rows.append((*cells(one.motion.name, *numbers), Cell((response.status.value,), verdict)))
    return Table(tuple(head), tuple(rows), "l" + "r" * len(peaks) + "l", (1.0, *[0.0] * len(peaks), 0.9), "Peaks")  # fmt: skip


def _peaks() -> list[Quantity]:
    """Return what is declared of a response, as far as it is a number that both data and tables have."""
    return [one for one in PEAKS.values() if one.is_number and one.printed and one.stored]


def _digits(one: Quantity) -> tuple[Unit, int | None]:
    """Return unit and decimals of a peak in a report: its own for data where the report has digits for it, else those of tables."""
    return (one.unit, DECIMALS[one.key]) if one.key in DECIMALS else (one.shown, None)


def _symbol(one: Quantity) -> Parts:
    """Return the symbol of a quantity, or its name where it has none."""
    source = maths_of(one.symbol)
    is_word = source.count('"') == 2 and source.startswith('"') and source.endswith('"')
    return (source.strip('"') if is_word else Maths(source) if source else one.title,)


def _case(one: ScenarioResult, calculation: Calculation) -> tuple[Block, ...]:
    name, shown = label_of(one), shortened(one.motion.name, _LONGEST)

    def draw_response() -> "Figure":
        from dcfp.present.figures import plot_response  # late: Matplotlib takes long to import

        response = one.response
        figure = plot_response(replace(response, motion=replace(response.motion, name=shown)))
        if response.profiles is not None:
            figure.set_figheight(_SHEET_WITH_PROFILE)
        return figure

    def draw_pulses() -> "Figure":
        from dcfp.present.figures import plot_pulses

        constants = calculation.methods.constants
        figure = plot_pulses(replace(one.case, record=shown), response=one.response, constants=constants)
        figure.set_figheight(_PULSES)
        return figure

    return (
        Drawing(
            draw_response,
            f"Force-displacement loop and histories of velocity, displacement, temperature, friction and energy, {name}",
        ),
        Drawing(draw_pulses, f"Ground velocity with its pulses, velocities and displacement, {name}"),
        _energies(one),
    )


def _energies(one: ScenarioResult) -> Table:
    found = energies_of(one)
    names = ("input", "hysteretic", "strain", "kinetic", "residual", "absolute_input")
    symbols = ("E", "E_h", "E_s", "E_k", "", 'E_"abs"')
    head: list[Parts] = [(Maths(symbol) if symbol else "residual", "\n[kN m]") for symbol in symbols]
    row = [
        powered(found[f"{name}_kN_m"])
        if name == "residual"
        else written("energy_kN_m", found[f"{name}_kN_m"])
        for name in names
    ]
    return Table(
        (*head, ("largest residual\nover largest input",)),
        (cells(*row, powered(found["largest_residual_over_largest_input"])),),
        "rrrrrrr",
        (*[1.0] * 6, 1.6),
        "Energy balance at the end: input, hysteretic, strain and kinetic energy, what is left over, absolute input",
    )


def methods_section(calculation: Calculation) -> Section:
    """Return every method beside the analysis, a pair of tables for each case."""
    note = words(
        "Methods of Li et al. (2020) predict ", Maths("Delta y"), ", and are above the analysis where it is at least that of the analysis; the march and the codes where their"
        " largest displacement is. ", Maths('y_"max"'), " over the analysis takes ", Maths("Delta y"), " where a method has no largest displacement, as Li et al. (2020), section 6.1.2, do."
        " Above or below says nothing of whether a method may be used. Methods that know the record only, and the analysis, have ", Maths("V_(Delta E)"), " and ",
        Maths('V_(Delta E "hr")'), " as the largest of any pulse or swing, each on its own; those that know the analysis too have them of the pulse that it found to govern."
        " Codes know the record's own spectrum.",
        tone=Tone.NOTE,
    )  # fmt: skip
    parts = [Section(label_of(one), _methods(one)) for one in calculation.results]
    return Section("Predictions and codes against the analysis", (note,), tuple(parts), on_new_page=True)


def _methods(one: ScenarioResult) -> tuple[Block, ...]:
    y = one.response.peak_displacement
    analysis = (*_row(("analysis", ""), one.case.analysed.whole, y, (1.0, 1.0)), *cells(""))
    rows: list[tuple[Cell, ...]] = [tuple(replace(cell, strong=True) for cell in analysis)]
    for variant, said in one.case.predicted.items():
        if variant.method in one.case.codes:
            continue
        change = _known(float(ratios([one.case], variant, CHANGE)[0]))
        bound = _known(said.bound / y) if y > 0.0 else None
        texts = (variant.method, variant.information.words)
        against = _against(change if said.displacement is None else bound)
        rows.append((*_row(texts, said, said.displacement, (change, bound)), against))
    head = heads("Method", "Knows", *(words for _, words in _METHODS), (Maths('y_"max"'), "\n[mm]"), (Maths("Delta y"), " over\nanalysis\n[–]"), (Maths('y_"max"'), " over\nanalysis\n[–]"), "Against\nanalysis")  # fmt: skip
    blocks: list[Block] = [Table(head, tuple(rows), "llrrrrrrl", (1.0, 1.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9), "Predictions")]  # fmt: skip
    if one.case.codes:
        blocks.append(_codes(one, y))
    remarks = [f"{said.method}: {' '.join(said.remarks)}" for said in one.case.codes.values() if said.remarks]
    missing = [name for name in code_methods() if name not in one.case.codes]
    remarks += [f"No solution: {', '.join(missing)}."] if missing else []
    return (*blocks, words(" ".join(remarks), tone=Tone.NOTE)) if remarks else tuple(blocks)


def _codes(one: ScenarioResult, y: float) -> Table:
    rows: list[tuple[Cell, ...]] = []
    for said in one.case.codes.values():
        ratio = said.displacement / y if y > 0.0 else None
        numbers = code_objects([said])[0]
        keys = ("displacement_mm", "base_shear_over_weight", "effective_period_s", "effective_damping")
        rows.append(
            (
                *cells(said.method, *(written(key, numbers[key]) for key in keys), written("ratio", ratio)),
                _against(ratio),
                Cell((said.verdict,), _verdict(said)),
            )
        )
    head = heads("Method", "D\n[mm]", (Maths('V_b "/" W'), "\n[–]"), "Period\n[s]", "Damping\n[–]", "Over the\nanalysis [–]", "Against\nanalysis", "May be used")  # fmt: skip
    return Table(head, tuple(rows), "lrrrrrll", (1.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9, 1.6), "Codes under the record's own spectrum")  # fmt: skip


def _verdict(said: CodeResult) -> Verdict:
    if not said.conditions or said.valid is None:
        return Verdict.NOT_KNOWN
    return Verdict.MET if said.valid else Verdict.NOT_MET


def _row(
    texts: tuple[str, str],
    said: Prediction,
    displacement: float | None,
    over: tuple[float | None, float | None],
) -> tuple[Cell, ...]:
    """Return what a method gives: dy, energies, y_max, and dy and y_max over the analysis."""
    values = (said.displacement_change, said.input_velocity, said.hysteretic_velocity, displacement)
    keys = (*(key for key, _ in _METHODS), "y_mm")
    numbers = (written(key, _known(value)) for key, value in zip(keys, values, strict=True))
    return cells(*texts, *numbers, *(written("ratio", one) for one in over))


def _against(ratio: float | None) -> Cell:
    """Return a word on a ratio to the analysis; above it has no colour, as it does not make a method safe."""
    if ratio is None:
        return Cell(("no prediction",), Verdict.NOT_KNOWN)
    return Cell(("above analysis",)) if ratio >= 1.0 else Cell(("below analysis",), Verdict.NOT_KNOWN)


def _known(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else value
