"""What the reproduction rests on: the paper's records at its four PGVs, and the hundred components beside them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from dcfp.analysis import Response, respond
from dcfp.inference import Case, Setting, compare
from dcfp.inference.calibration import calibration_set, cases_at
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import ALIASES, VELOCITIES, named_motion
from dcfp.system import LI_2020, ConstantFriction, Li2020, NoHeating, PreciseHeating

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


def analyse(motions: Sequence[GroundMotion], report: Callable[[], None] | None = None) -> Analyses:
    """Analyse the paper's bearing under every motion at every PGV; `report` is called after each analysis."""

    def done() -> None:
        if report is not None:
            report()

    cases: list[Case] = []
    precise: list[Response] = []
    constant: list[Response] = []
    for motion in motions:
        for velocity in VELOCITIES:
            scaled = motion.scaled_to_pgv(velocity)
            cases.append(compare(scaled, keep_response=True))
            done()
            precise.append(respond(scaled, LI_2020, Li2020(), PreciseHeating()))
            done()
            constant.append(respond(scaled, LI_2020, ConstantFriction(), NoHeating()))
            done()
    setting = Setting()
    hundred = [case for velocity in VELOCITIES for case in cases_at(velocity, setting, done)]
    return Analyses(tuple(cases), tuple(precise), tuple(constant), tuple(hundred))
