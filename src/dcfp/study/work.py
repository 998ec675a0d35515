"""The work on one block: its analyses in one call of the batch, its predictions one by one."""

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis import Response, respond
from dcfp.analysis.batch import Lanes, respond_in_batch
from dcfp.analysis.response import FAILED, NUMBERS, Status
from dcfp.arrays import IntArray
from dcfp.errors import AnalysisError
from dcfp.study.plan import Block, Cases, Plan
from dcfp.study.procedures import ANALYSIS, peaks_of, predict, setting_of
from dcfp.study.results import QUANTITIES, STATUS

Results = dict[str, NDArray[np.float64] | NDArray[np.uint8]]


def work_off(plan: Plan, block: Block) -> Results:
    """Return every quantity of a block and its status, in the shape of the block."""
    cases = plan.cases(block)
    size = len(cases.lanes)
    results: Results = {name: np.full(size, np.nan) for name in QUANTITIES}
    results[STATUS] = np.full(size, FAILED, dtype=np.uint8)
    for number, name in enumerate(plan.procedures):
        chosen = np.flatnonzero(cases.procedures == number)
        if chosen.size == 0:
            continue
        if name == ANALYSIS:
            lanes = _part(cases.lanes, chosen)
            found = respond_in_batch(plan.grounds, lanes, tolerance=plan.study.settings.tolerance).arrays()
        else:
            found = _predicted(plan, cases, chosen, name)
        for quantity, values in found.items():
            results[quantity][chosen] = values
    whole: Results = {name: values.reshape(block.shape) for name, values in results.items()}
    return whole | _histories(plan, block, cases)


def _histories(plan: Plan, block: Block, cases: Cases) -> Results:
    """Return the histories that are kept, over the length of each record; not a number after it and where nothing is analysed."""
    names = plan.study.histories
    if not names:
        return {}
    shape = (len(cases.lanes), plan.longest_record)
    found: Results = {f"history_{name}": np.full(shape, np.nan) for name in names}
    for lane in range(len(cases.lanes)):
        if plan.procedures[int(cases.procedures[lane])] != ANALYSIS:
            continue
        try:
            response = response_of(plan, cases.lanes, lane)
        except AnalysisError:  # its status says so
            continue
        samples = response.motion.acceleration.size
        every = round(response.motion.time_step / (response.time[1] - response.time[0]))
        for name in names:
            history = getattr(response, name)[::every][:samples]
            found[f"history_{name}"][lane, : history.size] = history
    return {name: values.reshape((*block.shape, -1)) for name, values in found.items()}


def response_of(plan: Plan, lanes: Lanes, lane: int) -> Response:
    """Return the response history analysis of one lane, with its histories."""
    settings, model = plan.study.settings, lanes.models[int(lanes.model[lane])]
    motion = plan.study.motions[int(lanes.record[lane])]
    scale = float(lanes.scale[lane])
    return respond(
        motion if scale == 1.0 else motion.scaled(scale),
        model.bearing,
        model.friction,
        model.heating,
        tail=settings.tail,
        tolerance=settings.tolerance,
        step=settings.step,
    )


def _part(lanes: Lanes, chosen: IntArray) -> Lanes:
    """Return some of the lanes; a model that none of them has is left in, for it costs little."""
    if chosen.size == len(lanes):
        return lanes
    return Lanes(lanes.record[chosen], lanes.scale[chosen], lanes.model[chosen], lanes.models)


def _predicted(plan: Plan, cases: Cases, chosen: IntArray, name: str) -> Results:
    lanes = cases.lanes
    settings = [setting_of(model)[0] for model in lanes.models]
    found: dict[str, list[float]] = {}
    for lane in chosen.tolist():
        motion = plan.study.motions[int(lanes.record[lane])].scaled(float(lanes.scale[lane]))
        said = peaks_of(predict(motion, settings[int(lanes.model[lane])], name))
        for quantity, value in said.items():
            found.setdefault(quantity, []).append(value)
    results: Results = {quantity: np.array(values) for quantity, values in found.items()}
    predicted = np.isfinite(results["peak_displacement"])
    results[STATUS] = np.where(predicted, NUMBERS[Status.OK], FAILED).astype(np.uint8)
    return results
