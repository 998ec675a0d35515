"""Cases made by hand, without an analysis."""

from collections.abc import Callable

import numpy as np
import pytest

from dcfp.inference import Case
from dcfp.inference.case import Analysed
from dcfp.methods import Prediction, Pulses
from dcfp.methods.li_2020.constants import PULSE
from dcfp.methods.method import Information, Variant

BLIND_PULSE = Variant(PULSE, Information.BLIND)


@pytest.fixture(scope="session")
def a_pulse() -> Callable[..., Pulses]:
    """Make a pulse with a velocity change [mm/s], a slope before the peak and one after it [mm/s2]."""

    def make(change: float, slope: float, next_slope: float = 300.0) -> Pulses:
        return Pulses(np.cumsum([0.0, change / slope, change / next_slope]), np.array([0.0, change, 0.0]))

    return make


@pytest.fixture(scope="session")
def make_case(a_pulse) -> Callable[..., Case]:
    """Make a case from what the analysis is to have given and what the blind pulse method is to have said."""

    def make(
        analysed: Prediction,
        said: Prediction | None = None,
        *,
        event: str = "event",
        pgv: float = 250.0,
        pulses: Pulses | None = None,
        pulse: int | None = 0,
    ) -> Case:
        pulses = a_pulse(300.0, 900.0) if pulses is None else pulses
        found = Analysed(analysed, analysed, None, pulse)
        return Case("record", event, pgv, pulses, found, {} if said is None else {BLIND_PULSE: said})

    return make


@pytest.fixture(scope="session")
def lognormal(make_case) -> Callable[..., list[Case]]:
    """Make cases, one of each event, whose analysis is off the prediction by a factor with a spread of 0.4."""

    def make(number: int, seed: int, said: float = 100.0) -> list[Case]:
        values = said * np.exp(0.4 * np.random.default_rng(seed).standard_normal(number))
        return [
            make_case(Prediction(value, value, value), Prediction(said, said, said), event=str(i))
            for i, value in enumerate(values)
        ]

    return make
