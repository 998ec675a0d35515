"""The work on one block: its analyses in one call of the batch, its predictions one by one."""

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from types import SimpleNamespace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.batch import Lanes, respond_in_batch
from dcfp.analysis.response import FAILED, NUMBERS, Status
from dcfp.analysis.response_history import analyse_record
from dcfp.arrays import IntArray
from dcfp.errors import AnalysisError
from dcfp.inference.case import code_inputs
from dcfp.methods import METHODS, NOTHING, Prediction
from dcfp.methods.code import CodeMethod
from dcfp.methods.code_comparison import code_results
from dcfp.methods.prediction import Ground, Methods, PredictionMethod
from dcfp.motion.ground_motion import GroundMotion
from dcfp.study.factors import ANALYSIS
from dcfp.study.results import STATUS, added_peaks, kept_peaks, peaks_of
from dcfp.study.study import Block, Cases, Plan

if TYPE_CHECKING:
    from dcfp.analysis import Response
    from dcfp.analysis.plane_response import PlaneResponse

Results = dict[str, NDArray[np.float64] | NDArray[np.uint8]]


def work_off(plan: Plan, block: Block) -> Results:
    """Return every quantity of a block and its status, in the shape of the block."""
    cases = plan.cases(block)
    size = len(cases.lanes)
    results: Results = {name: np.full(size, np.nan) for name in kept_peaks(in_plane=plan.study.in_plane)}
    results[STATUS] = np.full(size, FAILED, dtype=np.uint8)
    for number, name in enumerate(plan.procedures):
        chosen = np.flatnonzero(cases.procedures == number)
        if chosen.size == 0:
            continue
        if name == ANALYSIS:
            every = cases.lanes  # a model that none of the chosen has costs little
            lanes = Lanes(every.record[chosen], every.scale[chosen], every.model[chosen], every.models)
            found: Results = respond_in_batch(plan.grounds, lanes)
            found |= _added(plan, lanes, found)
        else:
            found = _predicted(plan, cases, chosen, name)
        for quantity in results.keys() & found.keys():
            results[quantity][chosen] = found[quantity]
    whole: Results = {name: values.reshape(block.shape) for name, values in results.items()}
    return whole | _histories(plan, block, cases)


def _added(plan: Plan, lanes: Lanes, found: Results) -> Results:
    """Return what was added to the peaks of an analysis: from its other peaks where they are enough, else made again."""
    in_plane = plan.study.in_plane
    known = peaks_of(in_plane=in_plane)
    added: Results = {name: np.full(len(lanes), np.nan) for name in added_peaks(in_plane=in_plane)}
    for lane in np.flatnonzero(found[STATUS] != FAILED).tolist() if added else ():
        peaks = SimpleNamespace(**{name: values[lane].item() for name, values in found.items()})
        for name in added:
            try:
                added[name][lane] = known[name].of(peaks)
            except AttributeError:
                added[name][lane] = known[name].of(response_of(plan, lanes, lane))
    return added


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
        samples = len(response.motion.acceleration)
        every = round(response.motion.time_step / (response.time[1] - response.time[0]))
        for name in names:
            history = response.history(name)[::every][:samples]
            found[f"history_{name}"][lane, : history.size] = history
    return {name: values.reshape((*block.shape, -1)) for name, values in found.items()}


def response_of(plan: Plan, lanes: Lanes, lane: int) -> "Response | PlaneResponse":
    """Return the response history analysis of one lane, with its histories."""
    system = lanes.models[int(lanes.model[lane])]
    return analyse_record(plan.motion(lanes, lane), system, plan.study.settings, vertical=plan.study.vertical)


def predict(motion: GroundMotion, methods: Methods, key: str) -> Prediction:
    """Return what a method says of a ground motion, without knowing the analysis."""
    method = METHODS[key]
    if isinstance(method, CodeMethod):
        result = code_results(code_inputs(motion, methods), only=(method,)).get(method.name)
        return NOTHING if result is None else replace(NOTHING, displacement=result.displacement)
    predicted = method.predict(Ground.of(motion), methods) if isinstance(method, PredictionMethod) else None
    return NOTHING if predicted is None else predicted.prediction


def _predicted(plan: Plan, cases: Cases, chosen: IntArray, name: str) -> Results:
    """Return what a method says of the analyses in `chosen`; not a number where it says nothing."""
    lanes = cases.lanes
    methods = [Methods.of(model) for model in lanes.models]
    said: list[Prediction] = []
    for lane in chosen.tolist():
        motion = plan.motion(lanes, lane)
        assert isinstance(motion, GroundMotion)  # of a station nothing is predicted
        said.append(predict(motion, methods[int(lanes.model[lane])], name))
    displacement = np.array([one.bound for one in said])
    velocity = [np.nan if one.total_velocity is None else one.total_velocity for one in said]
    return {
        "peak_displacement": displacement,
        "peak_change": np.array([one.displacement_change for one in said]),
        "input_velocity": np.array(velocity),
        STATUS: np.where(np.isfinite(displacement), NUMBERS[Status.OK], FAILED).astype(np.uint8),
    }


#: Parts that are tried for each thread, and analyses in each at most, and of stations.
_TRIED, _MOST_ANALYSES, _MOST_PLANE_ANALYSES = 12, 64, 8


@dataclass(frozen=True)
class Projection:
    """What is to be expected of a study: analyses per second [1/s], duration [s] and uncompressed size [byte]."""

    analyses: int
    blocks: int
    tried: int
    rate: float
    duration: float
    size: int


def project(plan: Plan, threads: int) -> Projection:
    """Time some analyses of a plan on so many threads, and say what all will take, each in proportion to its record."""
    blocks = list(plan.blocks())
    chosen: list[int] = np.unique(
        np.linspace(0, len(blocks) - 1, _TRIED * threads).round().astype(int)
    ).tolist()
    most = _MOST_PLANE_ANALYSES if plan.study.in_plane else _MOST_ANALYSES
    parts = [_beginning(blocks[number], most) for number in chosen]
    work_off(plan, _beginning(blocks[0], 1))  # compiles, or loads what is compiled
    began = time.perf_counter()
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(partial(work_off, plan), parts))
    elapsed = time.perf_counter() - began
    tried = sum(part.size for part in parts)
    cost = sum(plan.cost(part) for part in parts)
    duration = elapsed * sum(plan.cost(block) for block in blocks) / cost
    numbers = len(kept_peaks(in_plane=plan.study.in_plane)) + len(plan.study.histories) * plan.longest_record
    return Projection(
        plan.count, len(blocks), tried, plan.count / duration, duration, plan.count * (8 * numbers + 1)
    )


def _beginning(block: Block, most: int) -> Block:
    """Return the middle of a block, with no more analyses than that: neither the weakest nor the strongest motions alone."""
    region = list(block.region)
    while Block(block.number, tuple(region)).size > most:
        longest = max(range(len(region)), key=lambda axis: region[axis].stop - region[axis].start)
        length = region[longest].stop - region[longest].start
        begin = region[longest].start + (length - length // 2) // 2
        region[longest] = slice(begin, begin + length // 2)
    return Block(block.number, tuple(region))
