"""The governing case, step by step: each formula with its numbers put in."""

from dataclasses import dataclass

import numpy as np

from dcfp.analysis import Response
from dcfp.methods.li_2020 import predict_from_pulses, predict_simplified
from dcfp.methods.result import Answer
from dcfp.present.report.bearing_formulas import bearing_formulas
from dcfp.present.report.checks import label_of
from dcfp.present.report.code_formulas import code_formulas
from dcfp.present.report.digits import number, written
from dcfp.present.report.document import Block, Bullets, Formula, Section, Table, Tone, cells, heads, words
from dcfp.present.report.laws import State, friction_formulas
from dcfp.present.report.prediction_formulas import (
    design_formulas,
    largest_elsewhere,
    pulse_formulas,
    simplified_formulas,
)
from dcfp.present.report.references import source_of
from dcfp.study.scenario import Calculation, Result

#: Rounds of an iteration that are printed, besides the last.
_FIRST_ROUNDS = 4


@dataclass(frozen=True)
class Worked:
    """The sections of what is worked out, and its formulas."""

    sections: tuple[Section, ...]
    formulas: tuple[Formula, ...]


def governing(calculation: Calculation) -> Result:
    """Return the case with the largest displacement."""
    return max(calculation.results, key=lambda one: one.response.peak_displacement)


def worked_out(calculation: Calculation) -> Worked:
    """Work out the bearing, and friction, predictions and codes of the governing case."""
    result = governing(calculation)
    bearing = bearing_formulas(calculation)
    friction, state = _friction(result.response)
    pulse = pulse_formulas(calculation, result)
    simplified = simplified_formulas(calculation, result)
    design = design_formulas(calculation, result)
    codes = code_formulas(calculation, result)
    name = label_of(result)
    pulses, constants = result.case.pulses, calculation.setting.constants
    note = words(
        f"For {name}, the case with the largest displacement, and in it for the pulse that governs each method. The tables of the results have what comes out of every case,"
        " there with the largest velocities of any pulse. Results are calculated with all digits"
        " and rounded for print, so that the last digit of a line may differ from that of its printed numbers.",
        tone=Tone.NOTE,
    )
    sections = [
        Section("Bearing", bearing),
        Section(
            "Friction at the hottest moment",
            (words(state), *friction) if friction else (words("The law has no formula for a single state."),),
        ),
        Section("Prediction by the pulse method", (*_or_nothing(pulse, "every pulse has a ratio above 1, so nothing is predicted to move"), *largest_elsewhere(predict_from_pulses(pulses, constants)))),
        Section("Prediction by the simplified method", (*_or_nothing(simplified, "the method cannot be used"), *(largest_elsewhere(predict_simplified(pulses, constants)) if simplified else ()))),
        Section("Prediction by the design method", _or_nothing(design, "the method cannot be used")),
        *(_code(result.case.answers[name], formulas) for name, formulas in codes.items()),
    ]  # fmt: skip
    groups = (bearing, friction, pulse, simplified, design, *codes.values())
    whole = Section("Calculation step by step", (note,), tuple(sections), on_new_page=True)
    return Worked((whole,), tuple(one for group in groups for one in group))


def _or_nothing(formulas: tuple[Formula, ...], why: str) -> tuple[Block, ...]:
    return formulas or (words(f"No prediction: {why}."),)


def _friction(response: Response) -> tuple[tuple[Formula, ...], str]:
    """Return the friction at the moment of the highest temperature while sliding, on the lower plate."""
    law = response.friction_law
    slides = np.abs(response.sliding) > 0.0
    if not slides.any():
        return (), ""
    at = int(np.argmax(np.where(slides, response.temperature, -np.inf)))
    share = response.bearing.shares[0] if law.speed_is_of_surface else 1.0
    state = State(
        response.bearing.pressure, abs(float(response.velocity[at])) * share, float(response.temperature[at])
    )
    formulas = friction_formulas(law, state, source_of(law.citation))
    words = (
        f"At {response.time[at]:.2f} s the contact slides at {number(state.speed, 1)} mm/s{' on one plate' if share < 1.0 else ''} and has"
        f" {number(state.temperature, 1)} °C, under {number(state.pressure, 1)} N/mm². The analysis has a coefficient of"
        f" {written('friction_min', float(response.friction[at]))} there."
    )
    return formulas, words


def _code(said: Answer, formulas: tuple[Formula, ...]) -> Section:
    blocks: list[Block] = []
    if len(said.steps) > 1:  # a single one was found by changes of sign, as its remark says
        blocks.append(_rounds(said))
    blocks += formulas
    if said.unconfirmed:
        blocks.append(
            words(f"Could not be confirmed in its source: {'; '.join(said.unconfirmed)}.", tone=Tone.NOTE)
        )
    if said.remarks:
        blocks.append(Bullets(tuple((remark,) for remark in said.remarks)))
    return Section(said.method, tuple(blocks))


def _rounds(said: Answer) -> Table:
    numbered = list(enumerate(said.steps, 1))
    shown = numbered if len(numbered) <= _FIRST_ROUNDS + 1 else [*numbered[:_FIRST_ROUNDS], numbered[-1]]
    rows = tuple(
        cells(
            str(place),
            f"{step.displacement:.2f}",
            f"{step.period:.3f}",
            f"{step.damping:.4f}",
            f"{step.reduction:.4f}",
        )
        for place, step in shown
    )
    left_out = len(numbered) - len(shown)
    words = f"Rounds of the iteration, each from the displacement of the one before ({left_out} between not printed)"
    return Table(
        heads("Round", "D\n[mm]", "Period\n[s]", "Damping\n[–]", "Factor on the\nspectrum [–]"),
        rows,
        "rrrrr",
        (0.0, 1.0, 1.0, 1.0, 1.0),
        words if left_out else words.partition(" (")[0],
    )
