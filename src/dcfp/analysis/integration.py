"""How finely and how far an analysis goes, and what it keeps beside its histories."""

import math
from collections.abc import Sequence
from typing import Annotated

from dcfp.errors import InputError
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station, stations_of
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import FRACTION, NONE, SECOND
from dcfp.system import Heating, PreciseHeating, SimplifiedHeating


@declared
class Integration(Declared):
    """How finely and how far an analysis goes.

    Parameters
    ----------
    step
        Longest step [s]; by default the record's own, and for sliding at most 0.01 s.
    tail
        Time after the record in which the ground keeps its velocity [s]. By default the analysis goes on until no more
        sliding can come, for at most 120 s.
    tolerance
        How far the coefficient of friction in the middle of a step may be from the mean of its ends, relative to it [-];
        looked at where the ends differ by more than that.
    """

    noun = "an analysis"

    step: Annotated[
        float | None,
        Parameter(
            "longest step", SECOND, 1e-6, 10.0, key="step",
            more="by default the record's, at most 0.01 while sliding", absent="that of the record",
        ),
    ] = None  # fmt: skip
    tail: Annotated[
        float | None,
        Parameter(
            "time after the record", SECOND, 0.0, 3600.0,
            more="by default until it rests", absent="until no more sliding can come",
        ),
    ] = None  # fmt: skip
    tolerance: Annotated[
        float,
        Parameter(
            "largest relative change of the friction coefficient off its chord in a step",
            FRACTION, 0.0, 0.9999, above=True,
        ),
    ] = 0.02  # fmt: skip


def usual_heating(records: Sequence[GroundMotion | Station]) -> str:
    """Return the name of the heating model of analyses for which none is said: that of Li et al. (2020) in one direction, of stations the precise one."""
    return (PreciseHeating if stations_of(records) else SimplifiedHeating).name


#: Longest step of sliding [s], whatever the record's own: peaks are looked for at the ends of steps.
LONGEST_STEP = 0.01
#: How an analysis goes unless something else is said.
DEFAULT = Integration()


@declared
class Keep(Declared):
    """What an analysis keeps beside its histories, its peaks and its last state.

    Parameters
    ----------
    profiles
        About how many times over the motion the temperature along the plates is kept; heating models without it have none.
    every
        After how many samples it is kept, instead.
    """

    noun = "what is kept"

    profiles: Annotated[
        int, Parameter("number of profiles of the temperature along the plates", NONE, 0, 1e6)
    ] = 0
    every: Annotated[
        int | None, Parameter("number of samples from one of these profiles to the next", NONE, 1, 1e9)
    ] = None

    def interval(self, samples: int, heating: Heating) -> int | None:
        """Return after how many of the `samples` of a motion a profile is kept; None for no profiles.

        Raises
        ------
        InputError
            If they are asked for at intervals, and the heating model has none.
        """
        precise = isinstance(heating, PreciseHeating)
        if self.every is not None and not precise:
            msg = "The temperature along the plates needs the precise heating model."
            raise InputError(msg)
        if not precise or not (self.every or self.profiles):
            return None
        return self.every or max(1, round(samples / self.profiles))


#: The temperature along the plates as often as a figure shows it.
PLATES = Keep(profiles=200)
#: Nothing but histories, peaks and the last state.
NOTHING = Keep()


def halvings(interval: float, longest: float = LONGEST_STEP) -> int:
    """Return how often a sample interval [s] must be halved not to exceed the `longest` step [s]."""
    return min(max(0, math.ceil(math.log2(interval / longest * (1.0 - 1e-9)))), MOST_HALVINGS)
