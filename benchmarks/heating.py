"""What each heating model costs."""

from figure import Figure
from stopwatch import Seconds, in_turn, microseconds, ratio

import dcfp
from analysis import RECORDS, motion_at

ROUNDS = 60
MODELS = (dcfp.SimplifiedHeating(), dcfp.PreciseHeating(), dcfp.NoHeating())


def times(record: str) -> Seconds:
    """Return the times [s] of the analyses with each of the `MODELS` at the default settings."""
    motion = motion_at(record)
    return in_turn(
        [lambda heating=heating: dcfp.respond(motion, heating=heating).elapsed for heating in MODELS], ROUNDS
    )


def figures() -> list[Figure]:
    """Return the ratios of the models' times for each record."""
    found = []
    for record in RECORDS:
        simplified, precise, none = times(record)
        cost = f"{microseconds(precise):.0f} us over {microseconds(simplified):.0f} us"
        found.append(
            Figure(f"precise over simplified, {record}", ratio(precise, simplified), at_most=2.0, note=cost)
        )
        cost = f"{microseconds(none):.0f} us over {microseconds(simplified):.0f} us"
        found.append(Figure(f"none over simplified, {record}", ratio(none, simplified), note=cost))
    return found
