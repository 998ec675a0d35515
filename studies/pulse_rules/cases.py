"""The records, their analyses, and how far the methods of Li et al. (2020) are from them with one rule or another."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from rules import Rule

import dcfp
from dcfp.analysis import Response
from dcfp.analysis.swings import swings_of
from dcfp.inference import Methods
from dcfp.inference.case import Case, analysed_of, event_of, predictions
from dcfp.inference.refit import average_slope, change_ratio, fall_ratio
from dcfp.inference.statistics import Scatter, ratios, scatter
from dcfp.methods.li_2020 import LI_2020, predict_from_pulses
from dcfp.methods.li_2020.constants import PRINTED_RANGES, PRINTED_ROUNDING, PULSE, SIMPLIFIED
from dcfp.methods.method import Information, Variant
from dcfp.methods.prediction import Ground
from dcfp.methods.pulses import CHANGE, HYSTERETIC, INPUT
from dcfp.motion.named import VELOCITIES as PGVS
from dcfp.motion.named import StoredRecord, all_keys, read_stored

Array = NDArray[np.float64]
#: The records of the paper that are at hand.
NAMED = ("NCC", "KNA", "LPG", "IVD")
#: Ranges of prediction over analysis in the paper, of dy, V_dE and V_dEhr [-].
RANGES = {
    method: tuple(
        PRINTED_RANGES[(method, Information.BLIND), quantity][:2] for quantity in (CHANGE, INPUT, HYSTERETIC)
    )
    for method in (PULSE, SIMPLIFIED)
}
BASES = (Information.BLIND, Information.INFORMED)


def stored() -> list[StoredRecord]:
    """Return the hundred components of FEMA P-695."""
    return read_stored(all_keys())


def analyses(motions: Sequence[dcfp.GroundMotion]) -> list[Response]:
    """Return the responses at every PGV, all records at one PGV after the other."""
    return [dcfp.respond(motion.scaled_to_pgv(pgv)) for pgv in PGVS for motion in motions]


def cases_by(rule: Rule, responses: Sequence[Response], methods: Methods | None = None) -> list[Case]:
    """Return the cases with the pulses of a rule; the march through the pulses keeps those of the package."""
    methods = Methods() if methods is None else methods
    return [_case(rule, response, methods) for response in responses]


def _case(rule: Rule, response: Response, methods: Methods) -> Case:
    motion = response.motion
    pulses = rule(motion)
    analysed = analysed_of(response, pulses)
    ground = Ground(motion.peak_velocity, motion, {methods.threshold: pulses})
    predicted = predictions(ground, methods, analysed.pulse)
    return Case(motion.name, event_of(motion), motion.peak_velocity, pulses, analysed, predicted)


@dataclass(frozen=True)
class Marks:
    """What is to be said of a rule.

    Attributes
    ----------
    pulses
        Mean number in a record.
    inside, inside_rounded
        Ratios within the paper's ranges, of 48, and with the ranges widened by `ROUNDING`: by method and whether informed.
    slope, slope_of_all
        Mean kg of the governing pulse at a PGV of 250 mm/s, of the four records and of the hundred [mm/s2].
    change, change_simplified
        dy over that of the analysis: four hundred cases, pulse and simplified method, blind.
    least, most
        The ratios of dy of the four records, pulse method, blind.
    zeta, eps
        Refitted to the four hundred as in the paper.
    unmatched, unmoved
        Of the four hundred, swings behind which no pulse was found, or one that moves nothing by the method.
    """

    pulses: float
    inside: dict[Variant, int]
    inside_rounded: dict[Variant, int]
    slope: float
    slope_of_all: float
    change: Scatter
    change_simplified: Scatter
    least: float
    most: float
    zeta: float
    eps: float
    unmatched: int
    unmoved: int


def marks(rule: Rule, few: Sequence[Response], many: Sequence[Response]) -> Marks:
    """Return what is to be said of a rule on the paper's records and on the hundred."""
    own, all_cases = cases_by(rule, few), cases_by(rule, many)
    blind = view_ratios(own, Variant(PULSE, Information.BLIND))
    return Marks(
        pulses=float(np.mean([case.pulses.count for case in all_cases])),
        inside={(m, b): inside(own, Variant(m, b)) for m in RANGES for b in BASES},
        inside_rounded={(m, b): inside(own, Variant(m, b), PRINTED_ROUNDING) for m in RANGES for b in BASES},
        slope=average_slope(own),
        slope_of_all=average_slope(all_cases),
        change=scatter(ratios(all_cases, Variant(PULSE, Information.BLIND), CHANGE)),
        change_simplified=scatter(ratios(all_cases, Variant(SIMPLIFIED, Information.BLIND), CHANGE)),
        least=float(blind[0].min()),
        most=float(blind[0].max()),
        zeta=change_ratio(all_cases),
        eps=fall_ratio(all_cases),
        unmatched=sum(case.analysed.pulse is None for case in all_cases),
        unmoved=sum(
            case.predicted[Variant(PULSE, Information.INFORMED)].displacement_change == 0.0
            for case in all_cases
        ),
    )


def view_ratios(cases: Sequence[Case], view: Variant) -> Array:
    """Return prediction over analysis of dy, V_dE and V_dEhr, shape (3, cases)."""
    return np.array([ratios(cases, view, quantity) for quantity in (CHANGE, INPUT, HYSTERETIC)])


def inside(cases: Sequence[Case], view: Variant, wider: float = 0.0) -> int:
    """Return how many of the ratios are within the paper's ranges, each wider by so much at both ends."""
    found = view_ratios(cases, view)
    low, high = np.array(RANGES[view[0]]).T
    return int(((low[:, None] - wider <= found) & (found <= high[:, None] + wider)).sum())


def without_amplified_energies(cases: Sequence[Case]) -> list[Case]:
    """Return the cases with the factor of 1.5 for ku/kg from 0.8 to 1 in the displacement only."""
    found = []
    for case in cases:
        plain = predict_from_pulses(case.pulses, replace(LI_2020, amplification=1.0))
        said = dict(case.predicted)
        for basis, of_plain in (
            (Information.BLIND, plain.largest),
            (Information.INFORMED, plain.of(case.analysed.pulse)),
        ):
            amplified = said[PULSE, basis]
            said[PULSE, basis] = replace(of_plain, displacement_change=amplified.displacement_change)
        found.append(replace(case, predicted=said))
    return found


def with_amplification(cases: Sequence[Case], factor: float, limit: float) -> tuple[Scatter, Scatter]:
    """Return the ratios of dy and V_dE of the blind pulse method with another factor from another ku/kg on."""
    constants = replace(LI_2020, amplification=factor, amplified_from=limit)
    said = [predict_from_pulses(case.pulses, constants).largest for case in cases]
    whole = [case.analysed.whole for case in cases]
    pairs = list(zip(said, whole, strict=True))
    return (
        scatter(np.array([one.displacement_change / other.displacement_change for one, other in pairs])),
        scatter(np.array([one.input_velocity / other.input_velocity for one, other in pairs])),
    )


def against_net_input(cases: Sequence[Case], responses: Sequence[Response]) -> Array:
    """Return V_dE of the blind pulse method over the largest V_dEr of the analysis, Eq. (15) over whole swings."""
    found = []
    for case, response in zip(cases, responses, strict=True):
        net = float(swings_of(response).net_input.max())
        said = case.predicted[Variant(PULSE, Information.BLIND)].input_velocity
        found.append(said / float(np.sqrt(2.0 * net / response.bearing.mass)))
    return np.array(found)


def with_peak_within(cases: Sequence[Case]) -> list[Case]:
    """Return the cases with the pulse behind the largest swing only where its peak is within the swing."""
    found = []
    for case in cases:
        swing, pulses = case.analysed.swing, case.pulses
        assert swing is not None
        fits = (swing.start <= pulses.peaks) & (pulses.peaks <= swing.end)
        fits &= np.sign(pulses.changes) == -np.sign(swing.change)
        pulse = int(np.argmax(np.where(fits, np.abs(pulses.changes), 0.0))) if fits.any() else None
        found.append(replace(case, analysed=replace(case.analysed, pulse=pulse)))
    return found


def friction_ratios(case: Case) -> tuple[float, float]:
    """Return ku/kg of the pulse that governs by the pulse method, and of that behind the largest swing."""
    slopes = np.abs(case.pulses.mean_accelerations)
    governing = predict_from_pulses(case.pulses).governing
    found = [np.nan if i is None else float(slopes[i]) for i in (governing, case.analysed.pulse)]
    return LI_2020.friction_deceleration / found[0], LI_2020.friction_deceleration / found[1]
