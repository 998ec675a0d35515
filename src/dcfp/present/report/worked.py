"""The governing case, step by step: each formula with its numbers put in."""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.analysis import Response
from dcfp.constants import STANDARD_GRAVITY
from dcfp.methods.li_2020 import predict_from_pgv, predict_from_pulses, predict_simplified
from dcfp.methods.li_2020.pulse_method import amplification, hysteretic_energy, input_energy
from dcfp.methods.pulses import PulsePrediction, Pulses
from dcfp.methods.result import Answer
from dcfp.present.report.checks import label_of
from dcfp.present.report.code_formulas import code_formulas
from dcfp.present.report.document import (
    Block,
    Bullets,
    Maths,
    Paragraph,
    Part,
    Section,
    Table,
    Tone,
    cells,
    heads,
    words,
    written,
)
from dcfp.present.report.references import source_of
from dcfp.schema.formulas import Formula, number
from dcfp.study.scenario import Calculation, ScenarioResult

#: Rounds of an iteration that are printed, besides the last.
_FIRST_ROUNDS = 4


@dataclass(frozen=True)
class Worked:
    """The sections of what is worked out, and its formulas."""

    sections: tuple[Section, ...]
    formulas: tuple[Formula, ...]


def governing(calculation: Calculation) -> ScenarioResult:
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
    pressure, speed = response.bearing.pressure, abs(float(response.velocity[at])) * share
    temperature = float(response.temperature[at])
    formulas = law.formulas(pressure, speed, temperature, source_of(law.citation))
    words = (
        f"At {response.time[at]:.2f} s the contact slides at {number(speed, 1)} mm/s{' on one plate' if share < 1.0 else ''} and has"
        f" {number(temperature, 1)} °C, under {number(pressure, 1)} N/mm². The analysis has a coefficient of"
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


# The predictions of Li et al. (2020), section 6, worked out for one case.


_MEGA = 1e6
_PAPER = "Li et al. (2020)"


def friction_deceleration(calculation: Calculation) -> Formula:
    """Return ku, which every method needs."""
    constants = calculation.setting.constants
    return Formula(
        f"Slope that friction gives the velocity of the structure, with the g of {constants.gravity:.10g} mm/s² of these methods (elsewhere 9806.65 mm/s²)",
        "k_u = mu_n g",
        f"{constants.nominal_friction:.5f} times {constants.gravity:.10g}",
        constants.friction_deceleration,
        1,
        "mm/s²",
        f"{_PAPER}, Eq. (19)",
    )


def pulse_formulas(calculation: Calculation, result: ScenarioResult) -> tuple[Formula, ...]:
    """Return the pulse method for its governing pulse; nothing where nothing is predicted to move."""
    pulses, constants = result.case.pulses, calculation.setting.constants
    predicted = predict_from_pulses(pulses, constants)
    i = predicted.governing
    if i is None:
        return ()
    dv, before, after = _magnitudes(pulses, i)
    k_u = constants.friction_deceleration
    factor = float(amplification(np.array([k_u / before]), constants)[0])
    said = predicted.of(i)
    m, bearing = calculation.scenario.model.bearing.mass, calculation.scenario.model.bearing
    a_dv, a_before, a_after = factor * dv, factor * before, factor * after
    arrays = (np.array([a_dv]), np.array([a_before]), np.array([k_u]))
    put_in = float(input_energy(*arrays, bearing.mass)[0]) / _MEGA
    taken = float(hysteretic_energy(np.array([said.displacement_change]), np.array([k_u]), m)[0]) / _MEGA
    u, g, n, d = number(k_u, 1), number(a_before, 1), number(a_after, 1), number(a_dv, 1)
    amplified = "" if factor == 1.0 else " of the amplified pulse"
    times = [number(float(at), 4) for at in pulses.times[i : i + 3]]
    speeds = _peaks(pulses, i)
    return (
        Formula("Change of ground velocity to the peak of the pulse", "Delta v_g = v_(g,i) - v_(g,i-1)", f"{speeds[1]} - ({speeds[0]})", dv, 1, "mm/s", f"{_PAPER}, Eq. (14)"),
        Formula("Slope before the peak", "k_g = (Delta v_g) / (t_i - t_(i-1))", f"{number(dv, 1)} / ({times[1]} - {times[0]})", before, 1, "mm/s²", f"{_PAPER}, Eq. (18)"),
        Formula("Slope after the peak", "k_(g,i+1) = (v_(g,i+1) - v_(g,i)) / (t_(i+1) - t_i)", f"({speeds[2]} - ({speeds[1]})) / ({times[2]} - {times[1]})", after, 1, "mm/s²", f"{_PAPER}, Eq. (18)"),
        friction_deceleration(calculation),
        Formula("Ratio of the slopes", "k_u / k_g", f"{u} / {number(before, 1)}", k_u / before, 3, "", f"{_PAPER}, section 6.1"),
        Formula("Factor on velocities and slopes (0.8 to 1: amplified)", "f", "", factor, 2, "", f"{_PAPER}, Figure 17"),
        Formula(f"Change of displacement{amplified}", "Delta y = ((k_g - k_u) (k_g - k_(g,i+1))) / (2 k_g^2 (k_u - k_(g,i+1))) (Delta v_g)^2", f"(({g} - {u}) times ({g} - ({n}))) / (2 times {g}^2 times ({u} - ({n}))) times {d}^2", said.displacement_change, 1, "mm", f"{_PAPER}, Eq. (20)"),
        Formula("Equivalent velocity of the energy put in", "V_(Delta E) = sqrt(1 - k_u / k_g) thin Delta v_g", f"sqrt(1 - {u} / {g}) times {d}", said.input_velocity, 1, "mm/s", f"{_PAPER}, Eq. (23)"),
        Formula("Equivalent velocity of the energy dissipated", 'V_(Delta E "hr") = V_(Delta E) sqrt((k_u (k_g - k_(g,i+1))) / (k_g (k_u - k_(g,i+1))))', f"{number(said.input_velocity, 1)} times sqrt(({u} times ({g} - ({n}))) / ({g} times ({u} - ({n}))))", said.hysteretic_velocity, 1, "mm/s", f"{_PAPER}, Eq. (24)"),
        Formula("Energy put in", "Delta E = m / 2 (1 - k_u / k_g) (Delta v_g)^2", f"{number(m, 2)} / 2 times (1 - {u} / {g}) times {d}^2 / 1000000", put_in, 2, "kN m", f"{_PAPER}, Eq. (22)"),
        Formula("Energy dissipated", 'Delta E_"hr" = m k_u Delta y', f"{number(m, 2)} times {u} times {number(said.displacement_change, 1)} / 1000000", taken, 2, "kN m", f"{_PAPER}, Eqs (21), (25)"),
    )  # fmt: skip


def simplified_formulas(calculation: Calculation, result: ScenarioResult) -> tuple[Formula, ...]:
    """Return the simplified method for its governing pulse; nothing where it cannot be used."""
    pulses, constants = result.case.pulses, calculation.setting.constants
    if not constants.slides_on_average:
        return ()
    predicted = predict_simplified(pulses, constants)
    i = predicted.governing
    if i is None:
        return ()
    dv, slope, _ = _magnitudes(pulses, i)
    speeds = _peaks(pulses, i)
    said = predicted.of(i)
    u, eps, ave = (
        number(constants.friction_deceleration, 1),
        f"{constants.fall_ratio:g}",
        f"{constants.average_slope:g}",
    )
    ratio = constants.friction_deceleration / slope
    r, put_in = number(ratio, 3), number(said.input_velocity, 1)
    part = f"{put_in} times sqrt(((1 + {eps}) times {r}) / ({eps} + {r}))" if ratio <= 1.0 else put_in
    symbols = 'V_(Delta E "hr") = V_(Delta E) sqrt(((1 + epsilon) k_u / k_g) / (epsilon + k_u / k_g))' if ratio <= 1.0 else 'V_(Delta E "hr") = V_(Delta E)'  # fmt: skip
    return (
        Formula("Change of ground velocity of the governing pulse", "Delta v_g = v_(g,i) - v_(g,i-1)", f"{speeds[1]} - ({speeds[0]})", dv, 1, "mm/s", f"{_PAPER}, Eq. (14)"),
        Formula("Ratio of the slopes", "k_u / k_g", f"{u} / {number(slope, 1)}", ratio, 3, "", f"{_PAPER}, section 6.2"),
        Formula("Equivalent velocity of the energy put in", 'V_(Delta E) = sqrt(1 - k_u / k_(g,"ave")) thin Delta v_g', f"sqrt(1 - {u} / {ave}) times {number(dv, 1)}", said.input_velocity, 1, "mm/s", f"{_PAPER}, Eq. (28)"),
        Formula("Equivalent velocity of the energy dissipated", symbols, part, said.hysteretic_velocity, 1, "mm/s", f"{_PAPER}, Eqs (26), (27)"),
        Formula("Change of displacement", 'Delta y = V_(Delta E "hr")^2 / (2 k_u)', f"{number(said.hysteretic_velocity, 1)}^2 / (2 times {u})", said.displacement_change, 1, "mm", f"{_PAPER}, Figure 21"),
    )  # fmt: skip


def largest_elsewhere(predicted: PulsePrediction) -> tuple[Paragraph, ...]:
    """Return a note on the velocities of which another pulse than the governing one has the largest; nothing where none has."""
    if predicted.governing is None:
        return ()
    largest, here = predicted.largest, predicted.of(predicted.governing)
    pairs = (
        ("V_(Delta E)", "V_dE_mm_s", largest.input_velocity, here.input_velocity),
        ('V_(Delta E "hr")', "V_dEhr_mm_s", largest.hysteretic_velocity, here.hysteretic_velocity),
    )
    parts: list[Part] = []
    for symbol, key, most, found in pairs:
        if most > found:
            parts += [", " if parts else "", Maths(symbol), f" {written(key, most)} mm/s"]
    if not parts:
        return ()
    start = "The table of predictions has the largest of any pulse, here of another than the governing one: "
    return (words(start, *parts, ".", tone=Tone.NOTE),)


def design_formulas(calculation: Calculation, result: ScenarioResult) -> tuple[Formula, ...]:
    """Return the design method; nothing where it cannot be used."""
    constants, pgv = calculation.setting.constants, result.motion.peak_velocity
    if not (constants.slides_on_average and pgv > 0.0):
        return ()
    said = predict_from_pgv(pgv, constants)
    u, eps, ave = (
        number(constants.friction_deceleration, 1),
        f"{constants.fall_ratio:g}",
        f"{constants.average_slope:g}",
    )
    slope = constants.average_slope * pgv / constants.reference_pgv
    dv, put_in, s = number(constants.change_ratio * pgv, 1), number(said.input_velocity, 1), number(slope, 1)
    slides = constants.friction_deceleration <= slope
    symbols = 'V_(Delta E "hr") = V_(Delta E) sqrt(((1 + epsilon) k_u) / (k_u + epsilon k_g))' if slides else 'V_(Delta E "hr") = V_(Delta E)'  # fmt: skip
    part = f"{put_in} times sqrt(((1 + {eps}) times {u}) / ({u} + {eps} times {s}))" if slides else put_in
    return (
        Formula("Change of ground velocity of the largest pulse", 'Delta v_g = zeta "PGV"', f"{constants.change_ratio:g} times {number(pgv, 1)}", constants.change_ratio * pgv, 1, "mm/s", f"{_PAPER}, Eq. (29)"),
        Formula("Its slope", 'k_g = k_(g,"ave") "PGV" / "PGV"_0', f"{ave} times {number(pgv, 1)} / {constants.reference_pgv:g}", slope, 1, "mm/s²", f"{_PAPER}, Eq. (30)"),
        Formula("Equivalent velocity of the energy put in", 'V_(Delta E) = sqrt(1 - k_u / k_(g,"ave")) thin zeta "PGV"', f"sqrt(1 - {u} / {ave}) times {dv}", said.input_velocity, 1, "mm/s", f"{_PAPER}, Eq. (31)"),
        Formula("Equivalent velocity of the energy dissipated", symbols, part, said.hysteretic_velocity, 1, "mm/s", f"{_PAPER}, Eq. (32)"),
        Formula("Change of displacement", 'Delta y = V_(Delta E "hr")^2 / (2 k_u)', f"{number(said.hysteretic_velocity, 1)}^2 / (2 times {u})", said.displacement_change, 1, "mm", f"{_PAPER}, Eq. (33)"),
    )  # fmt: skip


def _sign(pulses: Pulses, i: int) -> float:
    return float(np.sign(pulses.mean_accelerations[i]))


def _peaks(pulses: Pulses, i: int) -> list[str]:
    """Return the ground velocities [mm/s] at the three peaks of a pulse, mirrored so that kg is positive, as they are printed."""
    return [number(_sign(pulses, i) * float(v), 2) for v in pulses.velocities[i : i + 3]]


def _magnitudes(pulses: Pulses, i: int) -> tuple[float, float, float]:
    """Return dvg [mm/s], kg and kg_(i+1) [mm/s2] of a pulse, mirrored so that kg is positive."""
    sign = _sign(pulses, i)
    return (
        sign * float(pulses.changes[i]),
        sign * float(pulses.mean_accelerations[i]),
        sign * float(pulses.next_mean_accelerations[i]),
    )


# The bearing worked out: Li et al. (2020), sections 4 and 5.1.


_KILO = 1e3


def bearing_formulas(calculation: Calculation) -> tuple[Formula, ...]:
    """Return load, mass, stiffness, period and what follows from the nominal coefficient."""
    bearing, heating = calculation.scenario.model.bearing, calculation.scenario.model.heating
    mu_n = calculation.nominal.value
    load, radius = bearing.vertical_force / _KILO, bearing.effective_radius
    phi, sigma = f"{bearing.slider_diameter:.10g}", f"{bearing.pressure:.10g}"
    k_f, g = f"{bearing.elastic_stiffness / _KILO:.10g}", f"{STANDARD_GRAVITY / _KILO:.5f}"
    radii = " + ".join(f"{one:.10g}" for one in bearing.radii)
    double = len(bearing.radii) > 1
    mass = number(bearing.mass, 2)
    return (
        Formula("Vertical force", "N = (sigma pi phi^2) / 4", f"({sigma} times pi times {phi}^2) / (4 times 1000)", load, 2, "kN", f"{_PAPER}, section 5.1"),
        Formula("Mass of the rigid structure", "m = N / g", f"{number(load, 2)} / {g}", bearing.mass, 2, "t", f"{_PAPER}, section 5.1"),
        Formula("Effective radius", "R = R_1 + R_2" if double else "R = R_1", radii if double else "", radius, 1, "mm", f"{_PAPER}, section 5.1 (2 Rs for two equal plates)"),
        Formula("Stiffness of the pendulum, spring (a)", 'k_"ra" = N / R', f"{number(load, 2)} / {number(radius, 1)}", bearing.restoring_stiffness / _KILO, 4, "kN/mm", f"{_PAPER}, section 5.1"),
        Formula("Period of the pendulum", "T = 2 pi sqrt(R / g)", f"2 pi sqrt({number(radius, 1)} / (1000 times {g}))", bearing.period, 3, "s", f"{_PAPER}, section 5.1"),
        Formula("The same from mass and stiffness", 'T = 2 pi sqrt(m / k_"ra")', f"2 pi sqrt({mass} / (1000 times {number(bearing.restoring_stiffness / _KILO, 4)}))", 2.0 * math.pi * math.sqrt(bearing.mass / bearing.restoring_stiffness), 3, "s", "mechanics"),
        Formula("Displacement at yield, with the nominal coefficient", "r_f = (mu_n N) / k_f", f"({mu_n:.5f} times {number(load, 2)}) / {k_f}", mu_n * bearing.vertical_force / bearing.elastic_stiffness, 4, "mm", f"{_PAPER}, section 5.1"),
        Formula("Largest displacement at rest, with the nominal coefficient (the check of the residual takes the coefficient at the end of each analysis)", "d_r = mu_n R", f"{mu_n:.5f} times {number(radius, 1)}", mu_n * radius, 1, "mm", "mechanics"),
        Formula("Half side of the square with the area of the contact", "(sqrt(pi) phi) / 4", f"(sqrt(pi) times {phi}) / 4", bearing.contact_half_side, 2, "mm", f"{_PAPER}, Eq. (12)"),
        *(() if heating.name == "none" else (Formula("Factor before the integral of the temperature, in °C mm √s / N", "sqrt(D) / (k sqrt(pi))", f"sqrt({heating.diffusivity:.10g}) / ({heating.conductivity:.10g} times sqrt(pi))", heating.rise_factor, 5, "", f"{_PAPER}, Eq. (11)"),)),
    )  # fmt: skip
