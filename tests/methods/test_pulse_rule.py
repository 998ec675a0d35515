"""The rule for peaks against its definition, spelled out place by place."""

import itertools

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from dcfp.kernels.pulses import find_turning_points
from dcfp.methods import find_pulses
from dcfp.motion.ground_motion import GroundMotion

SEARCH = settings(max_examples=200, deadline=None, derandomize=True)


def places_of(values: list[float], least: float) -> list[int]:
    places = np.empty(len(values) + 1, dtype=np.int64)
    return places[: find_turning_points(np.array(values), least, places)].tolist()


def stands_out(values: list[float], place: int, least: float) -> bool:
    """Whether both ways from a high the history falls by `least` before it is as high again (to the right: higher)."""

    def falls(walk: list[float], *, may_touch: bool) -> bool:
        for value in walk:
            if value > values[place] or (value == values[place] and not may_touch):
                return False
            if values[place] - value >= least:
                return True
        return False

    return falls(values[:place][::-1], may_touch=False) and falls(values[place + 1 :], may_touch=True)


def by_hand(values: list[float], least: float) -> list[int]:
    """The rule from its definition: peaks stand out to both sides, and the ends are the furthest points outside of them."""
    mirrored = [-value for value in values]
    inner = [i for i in range(len(values)) if stands_out(values, i, least) or stands_out(mirrored, i, least)]
    if max(values) - min(values) < least:
        return []
    first = inner[0] if inner else None
    rises = (
        values.index(min(values)) < values.index(max(values))
        if first is None
        else stands_out(values, first, least)
    )
    up = values if rises else mirrored
    first = up.index(max(up)) if first is None else first
    start = max(i for i in range(first + 1) if up[i] == min(up[: first + 1]))
    if not inner:
        return [start, first]
    last = inner[-1]
    rest = values[last:] if stands_out(mirrored, last, least) else mirrored[last:]
    return [start, *inner, last + rest.index(max(rest))]


histories = st.lists(st.integers(-6, 6).map(float), min_size=2, max_size=30)


@SEARCH
@given(values=histories, least=st.integers(1, 9).map(float))
def test_the_peaks_are_those_of_the_definition(values: list[float], least: float) -> None:
    assert places_of(values, least) == by_hand(values, least)


@SEARCH
@given(values=histories, fine=st.integers(1, 9), coarse=st.integers(1, 9))
def test_a_coarser_rule_keeps_some_of_the_peaks_and_adds_none(
    values: list[float], fine: int, coarse: int
) -> None:
    fine, coarse = min(fine, coarse), max(fine, coarse)
    few, many = places_of(values, float(coarse)), places_of(values, float(fine))
    assert len(few) <= len(many)
    assert set(few[1:-1]) <= set(many[1:-1])


accelerations = st.lists(st.floats(-1e3, 1e3).map(lambda value: round(value, 3)), min_size=2, max_size=80)


@SEARCH
@given(values=accelerations, threshold=st.floats(0.01, 1.0))
def test_pulses_go_up_and_down_by_at_least_the_threshold(values: list[float], threshold: float) -> None:
    motion = GroundMotion(np.array(values), 0.01)
    pulses = find_pulses(motion, threshold)
    rises = np.diff(pulses.velocities)
    assert all(one * other < 0.0 for one, other in itertools.pairwise(rises))
    assert (np.abs(rises) >= threshold * motion.peak_velocity).all()
    assert pulses.count == max(pulses.times.size - 2, 0)
