"""The governing case, step by step: each formula with its numbers put in."""

import math
from typing import TYPE_CHECKING

import numpy as np

from dcfp.constants import STANDARD_GRAVITY
from dcfp.inference.case import code_inputs
from dcfp.methods.code import CodeResult, code_methods
from dcfp.methods.prediction import Ground, Methods, PredictionMethod, prediction_methods
from dcfp.methods.pulses import PulsePrediction
from dcfp.motion.station import Station
from dcfp.present.report import document as doc
from dcfp.present.report.results import governing, label_of
from dcfp.schema.citations import source_of
from dcfp.schema.formulas import Formula, number
from dcfp.schema.units import KN, KN_PER_MM, M_PER_S2
from dcfp.study.scenario import Calculation, ScenarioResult

if TYPE_CHECKING:
    from dcfp.analysis.response import RigidResponse

#: Rounds of an iteration that are printed, besides the last.
_FIRST_ROUNDS = 4


def worked_out(calculation: Calculation) -> tuple[doc.Section, tuple[Formula, ...]]:
    """Return the section of the bearing, and of friction, predictions and codes of the governing case, and all its formulas."""
    result = governing(calculation)
    bearing = bearing_formulas(calculation)
    friction, state = _friction(result.response)
    predictions, codes = _of_one_direction(result, calculation.methods)
    name = label_of(result)
    of_pulses = ", and in it for the pulse that governs each method. The tables of the results have what comes out of every case, there with the largest velocities of any pulse."
    note = doc.note(
        f"For {name}, the case with the largest displacement{'.' if result.case is None else of_pulses} Results are calculated with all digits"
        " and rounded for print, so that the last digit of a line may differ from that of its printed numbers.",
    )
    sections = [
        doc.Section("Bearing", bearing),
        doc.Section(
            "Friction at the hottest moment",
            (doc.words(state), *friction)
            if friction
            else (doc.words("The law has no formula for a single state."),),
        ),
        *(section for section, _ in predictions if section is not None),
        *(_code(result.codes[name], formulas) for name, formulas in codes.items()),
    ]
    groups = (bearing, friction, *(formulas for _, formulas in predictions), *codes.values())
    whole = doc.Section("Calculation step by step", (note,), tuple(sections), on_new_page=True)
    return whole, tuple(one for group in groups for one in group)


def _of_one_direction(
    result: ScenarioResult, methods: Methods
) -> tuple[list[tuple[doc.Section | None, tuple[Formula, ...]]], dict[str, tuple[Formula, ...]]]:
    """Return what `_prediction` does for every method, and the formulas of every code; nothing of a station."""
    if isinstance(result.motion, Station):
        return [], {}
    ground, inputs = Ground.of(result.motion), code_inputs(result.motion, methods)
    codes = {
        name: () if (formulas := code_methods()[name].formulas) is None else formulas(code_result, inputs)
        for name, code_result in result.codes.items()
    }
    return [_prediction(method, ground, methods) for method in prediction_methods().values()], codes


def _prediction(
    method: PredictionMethod, ground: Ground, methods: Methods
) -> tuple[doc.Section | None, tuple[Formula, ...]]:
    """Return the section of a method of prediction, with its formulas; None for a method that brings none."""
    if method.formulas is None:
        return None, ()
    formulas = method.formulas(ground, methods)
    predicted = method.predict(ground, methods)
    by_pulse = None if predicted is None else predicted.by_pulse
    blocks: tuple[doc.Block, ...] = formulas or (doc.words(f"No prediction: {method.without}."),)
    notes: list[doc.Block] = [] if by_pulse is None else [*largest_elsewhere(by_pulse)]
    if predicted is not None and predicted.remarks:
        notes.append(doc.Bullets(tuple((remark,) for remark in predicted.remarks)))
    return doc.Section(f"Prediction by the {method.name} method", (*blocks, *notes)), formulas


def _friction(response: "RigidResponse") -> tuple[tuple[Formula, ...], str]:
    """Return the friction at the moment of the highest temperature while sliding, on the lower plate."""
    law = response.friction_law
    slides = np.abs(response.sliding) > 0.0
    if not slides.any():
        return (), ""
    at = int(np.argmax(np.where(slides, response.temperature, -np.inf)))
    share = response.bearing.shares[0] if law.speed_is_of_surface else 1.0
    pressure, speed = response.bearing.pressure, abs(float(response.velocity[at])) * share
    temperature = float(response.temperature[at])
    formulas = law.formulas(pressure, speed, temperature, source_of(law.citation))
    words = (
        f"At {response.time[at]:.2f} s the contact slides at {number(speed, 1)} mm/s{' on one plate' if share < 1.0 else ''} and has"
        f" {number(temperature, 1)} °C, under {number(pressure, 1)} N/mm². The analysis has a coefficient of"
        f" {doc.written('friction_min', float(response.friction[at]))} there."
    )
    return formulas, words


def _code(said: CodeResult, formulas: tuple[Formula, ...]) -> doc.Section:
    blocks: list[doc.Block] = []
    if len(said.steps) > 1:  # a single one was found by changes of sign, as its remark says
        blocks.append(_rounds(said))
    blocks += formulas
    if said.unconfirmed:
        blocks.append(doc.note(f"Could not be confirmed in its source: {'; '.join(said.unconfirmed)}."))
    if said.remarks:
        blocks.append(doc.Bullets(tuple((remark,) for remark in said.remarks)))
    return doc.Section(said.method, tuple(blocks))


def _rounds(said: CodeResult) -> doc.Table:
    numbered = list(enumerate(said.steps, 1))
    shown = numbered if len(numbered) <= _FIRST_ROUNDS + 1 else [*numbered[:_FIRST_ROUNDS], numbered[-1]]
    rows = tuple(
        doc.cells(
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
    return doc.Table(
        doc.cells("Round", "D\n[mm]", "Period\n[s]", "Damping\n[–]", "Factor on the\nspectrum [–]"),
        rows,
        "rrrrr",
        (0.0, 1.0, 1.0, 1.0, 1.0),
        words if left_out else words.partition(" (")[0],
    )


def largest_elsewhere(predicted: PulsePrediction) -> tuple[doc.Paragraph, ...]:
    """Return a note on the velocities of which another pulse than the governing one has the largest; nothing where none has."""
    if predicted.governing is None:
        return ()
    largest, here = predicted.largest, predicted.of(predicted.governing)
    pairs = (
        ("V_(Delta E)", "V_dE_mm_s", largest.input_velocity, here.input_velocity),
        ('V_(Delta E "hr")', "V_dEhr_mm_s", largest.hysteretic_velocity, here.hysteretic_velocity),
    )
    parts: list[doc.Part] = []
    for symbol, key, most, found in pairs:
        if most > found:
            parts += [", " if parts else "", doc.Maths(symbol), f" {doc.written(key, most)} mm/s"]
    if not parts:
        return ()
    start = "The table of predictions has the largest of any pulse, here of another than the governing one: "
    return (doc.note(start, *parts, "."),)


#: Sections 4 and 5.1 of it.
_PAPER = "Li et al. (2020)"


def bearing_formulas(calculation: Calculation) -> tuple[Formula, ...]:
    """Return load, mass, stiffness, period and what follows from the nominal coefficient."""
    bearing, heating = calculation.scenario.model.bearing, calculation.scenario.model.heating
    mu_n = calculation.nominal.value
    load, radius = KN.shown(bearing.vertical_force), bearing.effective_radius
    phi, sigma = f"{bearing.slider_diameter:.10g}", f"{bearing.pressure:.10g}"
    k_f, g = f"{KN_PER_MM.shown(bearing.elastic_stiffness):.10g}", f"{M_PER_S2.shown(STANDARD_GRAVITY):.5f}"
    radii = " + ".join(f"{one:.10g}" for one in bearing.radii)
    double = len(bearing.radii) > 1
    mass = number(bearing.mass, 2)
    return (
        Formula("Vertical force", "N = (sigma pi phi^2) / 4", f"({sigma} times pi times {phi}^2) / (4 times 1000)", load, 2, "kN", f"{_PAPER}, section 5.1"),
        Formula("Mass of the rigid structure", "m = N / g", f"{number(load, 2)} / {g}", bearing.mass, 2, "t", f"{_PAPER}, section 5.1"),
        Formula("Effective radius", "R = R_1 + R_2" if double else "R = R_1", radii if double else "", radius, 1, "mm", f"{_PAPER}, section 5.1 (2 Rs for two equal plates)"),
        Formula("Stiffness of the pendulum, spring (a)", 'k_"ra" = N / R', f"{number(load, 2)} / {number(radius, 1)}", KN_PER_MM.shown(bearing.restoring_stiffness), 4, "kN/mm", f"{_PAPER}, section 5.1"),
        Formula("Period of the pendulum", "T = 2 pi sqrt(R / g)", f"2 pi sqrt({number(radius, 1)} / (1000 times {g}))", bearing.period, 3, "s", f"{_PAPER}, section 5.1"),
        Formula("The same from mass and stiffness", 'T = 2 pi sqrt(m / k_"ra")', f"2 pi sqrt({mass} / (1000 times {number(KN_PER_MM.shown(bearing.restoring_stiffness), 4)}))", 2.0 * math.pi * math.sqrt(bearing.mass / bearing.restoring_stiffness), 3, "s", "mechanics"),
        Formula("Displacement at yield, with the nominal coefficient", "r_f = (mu_n N) / k_f", f"({mu_n:.5f} times {number(load, 2)}) / {k_f}", mu_n * bearing.vertical_force / bearing.elastic_stiffness, 4, "mm", f"{_PAPER}, section 5.1"),
        Formula("Largest displacement at rest, with the nominal coefficient (the check of the residual takes the coefficient at the end of each analysis)", "d_r = mu_n R", f"{mu_n:.5f} times {number(radius, 1)}", mu_n * radius, 1, "mm", "mechanics"),
        *(() if calculation.in_plane else (Formula("Half side of the square with the area of the contact", "(sqrt(pi) phi) / 4", f"(sqrt(pi) times {phi}) / 4", bearing.contact_half_side, 2, "mm", f"{_PAPER}, Eq. (12)"),)),
        *(() if heating.name == "none" else (Formula("Factor before the integral of the temperature, in °C mm √s / N", "sqrt(D) / (k sqrt(pi))", f"sqrt({heating.diffusivity:.10g}) / ({heating.conductivity:.10g} times sqrt(pi))", heating.rise_factor, 5, "", f"{_PAPER}, Eq. (11)"),)),
    )  # fmt: skip
