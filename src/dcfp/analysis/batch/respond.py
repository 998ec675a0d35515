"""The batch: lanes sorted into families, each in one call of the kernel."""

import math
import os

import numpy as np

from dcfp.analysis.batch.families import Family, families_of
from dcfp.analysis.batch.ground import GroundSet
from dcfp.analysis.batch.lanes import Lanes
from dcfp.analysis.batch.peaks import Peaks
from dcfp.analysis.kernel_input import tallies_at
from dcfp.analysis.respond import TOLERANCE
from dcfp.arrays import FloatArray, IntArray
from dcfp.errors import InputError
from dcfp.kernels.batch import LANE_MODEL, LANE_RECORD, LANE_SIZE, OUT_ENDED, OUT_SIZE, Workspace, march_lanes
from dcfp.kernels.march import OUT_OF_CELLS, STATE_SIZE, TEMPERATURE
from dcfp.system.plates import cold_notes

#: Cells that a plate may be widened to before a lane is given up.
_MOST_CELLS = 1_000_000


def respond_in_batch(grounds: GroundSet, lanes: Lanes, *, tolerance: float = TOLERANCE) -> Peaks:
    """Analyse every lane on the calling thread; the interpreter's lock is free meanwhile.

    The numbers of a lane are those of `dcfp.respond` for its record, scale and model, and do not depend on what else is in the
    batch.

    Parameters
    ----------
    grounds
        The records.
    lanes
        What is analysed; lanes of the same record and scale are best side by side.
    tolerance
        As for `dcfp.respond` [-].

    Raises
    ------
    InputError
        If the tolerance is out of range.
    """
    if not (math.isfinite(tolerance) and 0.0 < tolerance < 1.0):
        msg = f"The tolerance must lie between 0 and 1, not {tolerance!r}."
        raise InputError(msg)
    outcome = np.full((len(lanes), OUT_SIZE), np.nan)
    for family in families_of(lanes.models):
        rows = np.full(len(lanes.models), -1, dtype=np.intp)
        rows[family.members] = np.arange(len(family.members))
        row = rows[lanes.model]
        chosen = np.flatnonzero(row >= 0)
        _march_family(grounds, lanes, family, chosen, row, tolerance, outcome)
    return Peaks.of(outcome, lanes)


def available_threads() -> int:
    """Return the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _march_family(
    grounds: GroundSet,
    lanes: Lanes,
    family: Family,
    chosen: IntArray,
    row: IntArray,
    tolerance: float,
    outcome: FloatArray,
) -> None:
    """March through the lanes numbered in `chosen`, again on wider plates for those whose slider left them."""
    work = Workspace(
        acceleration=np.zeros(grounds.longest),
        state=np.zeros(STATE_SIZE),
        histories=np.empty((0, TEMPERATURE + family.plates)),
    )
    margin = family.margin
    while chosen.size:
        which = np.empty((chosen.size, LANE_SIZE), dtype=np.intp)
        which[:, LANE_RECORD], which[:, LANE_MODEL] = lanes.record[chosen], row[chosen]
        part = np.empty((chosen.size, OUT_SIZE))
        work.acceleration[:] = 0.0
        march_lanes(
            family.law,
            family.heat(margin),
            family.plates,
            margin,
            family.table,
            family.banks,
            tallies_at(0.0),
            cold_notes(0.0),
            grounds.ground,
            which,
            lanes.scale[chosen],
            tolerance,
            work,
            part,
        )
        outcome[chosen] = part
        margin = 2 * margin + 1
        if margin > _MOST_CELLS:
            return
        chosen = chosen[part[:, OUT_ENDED] == OUT_OF_CELLS]
