"""A friction law as compiled code takes it: its form and six constants. Nothing here needs the compiler."""

import ctypes
from typing import NamedTuple

# forms in line; a larger number is an address
EXPONENTIAL, CYCLING = 0, 1


class Law(NamedTuple):
    """A friction law at a given pressure: its form and six constants, which the form or the function gives a meaning."""

    form: int
    reference: float
    speed_drop: float
    speed_rate: float
    heat_scale: float
    heat_rate: float
    heat_floor: float


#: As a compiled function sees them: constants, pressure [N/mm2], speed [mm/s], temperature [degC], cycling parameter [N/s].
LAW_ARGUMENTS = (ctypes.POINTER(ctypes.c_double), *(ctypes.c_double,) * 4)


def exponential_law(
    reference: float,
    speed_drop: float,
    speed_rate: float,
    heat_scale: float,
    heat_rate: float,
    heat_floor: float,
) -> Law:
    """Return a law of the form above, with a = `speed_drop`, b = `speed_rate`, A, B, C = `heat_scale`, `heat_rate`, `heat_floor`."""
    return Law(EXPONENTIAL, reference, speed_drop, speed_rate, heat_scale, heat_rate, heat_floor)


def cycling_law(
    reference: float, speed_drop: float, speed_rate: float, cycling_rate: float, cycling_power: float
) -> Law:
    """Return a law whose second factor is exp(-(`cycling_rate` c)^`cycling_power`), with the cycling parameter c [N/s]."""
    return Law(CYCLING, reference, speed_drop, speed_rate, cycling_power, cycling_rate, 0.0)


def law_by_address(address: int, constants: tuple[float, ...] = ()) -> Law:
    """Return a law that is a compiled function, with up to six constants of its own."""
    return Law(address, *constants, *(0.0,) * (6 - len(constants)))
