"""Intervals held against earthquakes that they do not know, constants refitted, classes of earthquakes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from cases import PGVS
from numpy.typing import NDArray

from dcfp.inference.case import Case
from dcfp.inference.coverage import Coverage, coverage, grouped_splits
from dcfp.inference.refit import refit_as_paper, refit_by_squares
from dcfp.methods import Prediction
from dcfp.methods.li_2020 import LI_2020, Constants, predict_from_pgv, predict_simplified
from dcfp.methods.li_2020.constants import DESIGN, PULSE, SIMPLIFIED
from dcfp.methods.method import Information, Variant
from dcfp.methods.prediction import Methods
from dcfp.methods.pulse_march import NAME as MARCH
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, INPUT, TOTAL
from dcfp.motion.named import StoredRecord
from dcfp.schema.quantities import Quantity

Array = NDArray[np.float64]
#: By name, the method and whether the spectrum of the record is known besides.
VIEWS: dict[str, tuple[Variant | None, Methods | None]] = {
    "PGV only": (None, None),
    "PGV and spectrum": (None, Methods()),
    "pulse": (Variant(PULSE, Information.BLIND), Methods()),
    "simplified": (Variant(SIMPLIFIED, Information.BLIND), Methods()),
    "march": (Variant(MARCH, Information.BLIND), Methods()),
}
QUANTITIES = (CHANGE, DISPLACEMENT, INPUT, TOTAL)


def by_pgv(cases: Sequence[Case]) -> list[Sequence[Case]]:
    """Return the cases, all records at one PGV after the other, in groups of one PGV."""
    size = len(cases) // len(PGVS)
    return [cases[i * size : (i + 1) * size] for i in range(len(PGVS))]


def coverages(cases: Sequence[Case]) -> dict[tuple[str, Quantity], Coverage]:
    """Return coverage and width of the intervals; a method that does not say V_E is left out there."""
    groups = by_pgv(cases)
    return {
        (name, quantity): coverage(groups, variant, quantity, methods)
        for name, (variant, methods) in VIEWS.items()
        for quantity in QUANTITIES
        if quantity is not TOTAL or name not in ("pulse", "simplified")
    }


Predict = Callable[[Case, Constants], Prediction]
Refit = Callable[[Sequence[Case]], Constants]
METHODS: dict[str, tuple[Predict, Refit]] = {
    "simplified": (
        lambda case, constants: predict_simplified(case.pulses, constants).largest,
        refit_by_squares,
    ),
    "design": (
        lambda case, constants: predict_from_pgv(case.pgv, constants),
        partial(refit_by_squares, method=DESIGN),
    ),
}


def errors(cases: Sequence[Case], predict: Predict, constants: Sequence[Constants]) -> Array:
    """Return ln of prediction over analysis of dy, V_dE and V_dEhr, shape (3, cases), each with its constants."""
    said = [predict(case, one) for case, one in zip(cases, constants, strict=True)]
    with np.errstate(divide="ignore"):
        return np.log(
            [
                [getattr(one, name) / getattr(case.analysed.whole, name) for name in _NAMES]
                for one, case in zip(said, cases, strict=True)
            ]
        ).T


_NAMES = ("displacement_change", "input_velocity", "hysteretic_velocity")


@dataclass(frozen=True)
class HeldOut:
    """Bias and dispersion of dy, V_dE and V_dEhr in held-out halves, means over all splits, shape (3,)."""

    bias: Array
    dispersion: Array


def held_out(
    cases: Sequence[Case], predict: Predict, refit: Refit | None, classes: Array, splits: int
) -> HeldOut:
    """Fit the constants to each class of one half of the earthquakes, and look at the other half.

    `classes` is the class of each case; without a `refit` the constants are the paper's.
    """
    events = [case.event for case in cases]
    found = []
    for training in grouped_splits(events[: len(events) // len(PGVS)], splits):
        chosen = np.tile(training, len(PGVS))
        by_class: dict[float, Constants] = {}
        for kind in np.unique(classes):
            known = [case for case, there in zip(cases, chosen & (classes == kind), strict=True) if there]
            enough = len(known) > 10
            by_class[kind] = refit(known) if refit and enough else LI_2020
        rest = np.flatnonzero(~chosen)
        off = errors([cases[i] for i in rest], predict, [by_class[classes[i]] for i in rest])
        good = np.isfinite(off).all(axis=0)
        found.append((off[:, good].mean(axis=1), off[:, good].std(axis=1, ddof=1)))
    means, deviations = np.array(found).transpose(1, 0, 2)
    return HeldOut(np.exp(means.mean(axis=0)), deviations.mean(axis=0))


def refits(cases: Sequence[Case], splits: int = 200) -> dict[str, HeldOut]:
    """Return what refitting brings, by method and way of fitting."""
    one = np.zeros(len(cases))
    found: dict[str, HeldOut] = {}
    for name, (predict, least_squares) in METHODS.items():
        for words, refit in (
            ("the paper's constants", None),
            ("refitted as the paper", refit_as_paper),
            ("least squares", least_squares),
        ):
            found[f"{name}, {words}"] = held_out(cases, predict, refit, one, splits)
    return found


def classes(records: Sequence[StoredRecord]) -> dict[str, Array]:
    """Return classes of the records, tiled over the PGVs."""
    magnitude = np.array([one.magnitude for one in records])
    distance = np.array([one.closest_distance for one in records])
    near = np.array(["-NF-" in one.motion.name for one in records])
    pulse = np.array(["nearfield_pulse" in one.motion.origin.source for one in records])
    kinds = {
        "none": np.zeros(len(records)),
        "magnitude from 7.0 or below": magnitude >= 7.0,
        "distance from 10 km or below": distance >= 10.0,
        "near or far field": near,
        "far field, near field with and without pulse": near + 1.0 * pulse,
    }
    found = {name: np.tile(np.asarray(kind, dtype=np.float64), len(PGVS)) for name, kind in kinds.items()}
    found["PGV"] = np.repeat(np.array(PGVS), len(records))
    return found


def by_class(
    cases: Sequence[Case], records: Sequence[StoredRecord], splits: int = 50
) -> dict[tuple[str, str], tuple[HeldOut, dict[float, Constants]]]:
    """Return what classes bring to each method, in held-out halves, and the constants of each class from all records."""
    found: dict[tuple[str, str], tuple[HeldOut, dict[float, Constants]]] = {}
    for method, (predict, refit) in METHODS.items():
        for name, kinds in classes(records).items():
            constants = {
                kind: refit([case for case, own in zip(cases, kinds, strict=True) if own == kind])
                for kind in np.unique(kinds)
            }
            found[method, name] = (held_out(cases, predict, refit, kinds, splits), constants)
    return found
