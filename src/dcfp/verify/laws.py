"""Laws that every response must obey, whatever the numbers: energy, symmetry, scale, resampling, restart, padding."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import LI_2020, ConstantFriction, Heating, NoHeating, PreciseHeating, SimplifiedHeating
from dcfp.verify.check import Finding, Task, scaled_record, sixteen_analyses

GROUP = "Laws"
_EXACT = "Allowed: what rounding may grow to over thousands of steps."


def _energy(heating: Heating) -> Finding:
    residuals = {
        name: respond(motion, heating=heating).energy.relative_residual for name, motion in sixteen_analyses()
    }
    worst = max(residuals, key=residuals.__getitem__)
    note = (
        f"Largest of 16 analyses: {worst}. The energies are sums of closed forms, so only rounding is left."
    )
    source = "Li et al. (2020), Eq. (6): E - Es - Ek - Eh over the largest E"
    return Finding(residuals[worst], 0.0, "-", 1e-9, note, source)


def _difference(one: Response, other: Response) -> float:
    """Largest difference of two displacement histories of the same length over the peak [-]."""
    gap = np.abs(one.displacement - other.displacement).max()
    return float(gap) / one.peak_displacement


def _symmetry(heating: Heating) -> Finding:
    motion = scaled_record("LPG", 500.0)
    there = respond(motion, heating=heating, tail=5.0)
    back = respond(motion.scaled(-1.0), heating=heating, tail=5.0)
    gap = float(np.abs(there.displacement + back.displacement).max()) / there.peak_displacement
    note = "LPG at 0.5 m/s and its mirror image. " + _EXACT
    return Finding(gap, 0.0, "-", 1e-12, note, "odd symmetry: y(-a_g) = -y(a_g)")


def _scale() -> Finding:
    motion = scaled_record("NCC", 500.0)
    larger = replace(
        LI_2020,
        slider_diameter=2.0 * LI_2020.slider_diameter,
        elastic_stiffness=4.0 * LI_2020.elastic_stiffness,
    )
    here = respond(motion, heating=NoHeating(), tail=5.0)
    there = respond(motion, larger, heating=NoHeating(), tail=5.0)
    note = (
        "Twice the slider's diameter at the same pressure and radii: N, m and kra are four times as large, and so is kf."
        " Every force per mass is the same, and so is the motion, without heating; with it, the size of the contact matters. "
        + _EXACT
    )
    return Finding(_difference(here, there), 0.0, "-", 1e-9, note, "m y'' + kra y + Ff = -m ag over m")


def _resampled(parts: int) -> tuple[GroundMotion, GroundMotion]:
    motion = scaled_record("KNA", 500.0)
    samples = motion.acceleration.size
    places = np.arange((samples - 1) * parts + 1) / parts
    finer = np.interp(places, np.arange(samples), motion.acceleration)
    return motion, GroundMotion(finer, motion.time_step / parts, f"{motion.name} at 1/{parts} of its step")


def _resampling_without_heat(parts: int) -> Finding:
    motion, finer = _resampled(parts)
    coarse = respond(motion, LI_2020, ConstantFriction(), NoHeating(), tail=0.0)
    fine = respond(finer, LI_2020, ConstantFriction(), NoHeating(), tail=0.0)
    gap = np.abs(fine.displacement[::parts] - coarse.displacement).max() / coarse.peak_displacement
    note = (
        "KNA at 0.5 m/s: the same piecewise linear motion, constant friction; every phase is a closed form. "
        + _EXACT
    )
    return Finding(float(gap), 0.0, "-", 1e-9, note, "the motion does not depend on where it is sampled")


def _resampling_with_heat(parts: int) -> Finding:
    motion, finer = _resampled(parts)
    note = "KNA at 0.5 m/s; heating is followed to the default tolerance, which promises 0.1 % of the peak."
    source = "the same motion at its own step"
    fine, coarse = respond(finer, tail=0.0).peak_displacement, respond(motion, tail=0.0).peak_displacement
    return Finding(fine, coarse, "mm", 1e-3, note, source, relative=True)


def _restart(heating: Heating) -> Finding:
    motion = scaled_record("NCC", 750.0)
    whole = respond(motion, heating=heating, tail=0.0)
    displacement = np.zeros(whole.displacement.size)
    cuts = [0, 301, 615, 616, 1000, motion.acceleration.size - 1]
    state = None
    for first, last in pairwise(cuts):
        piece = GroundMotion(motion.acceleration[first : last + 1], motion.time_step, "a piece")
        part = respond(piece, heating=heating, tail=0.0, start=state)
        displacement[first : last + 1] = part.displacement
        state = part.final_state
    gap = float(np.abs(displacement - whole.displacement).max()) / whole.peak_displacement
    note = "NCC at 0.75 m/s in five pieces, each from the state in which the one before ended. " + _EXACT
    return Finding(gap, 0.0, "-", 1e-9, note, "the same analysis in one piece")


def _padding() -> Finding:
    motion = scaled_record("IVD", 500.0)
    silence = np.zeros(250)
    padded = GroundMotion(np.concatenate((silence, motion.acceleration, silence)), motion.time_step, "padded")
    after = respond(padded, tail=0.0).displacement[250:-250]
    # the first value of a record is seldom zero: between the silence and it the padded motion rises in one step
    first = np.concatenate(([0.0], motion.acceleration))
    before = respond(GroundMotion(first, motion.time_step, "IVD"), tail=0.0)
    gap = float(np.abs(after - before.displacement[1:]).max()) / before.peak_displacement
    note = "IVD at 0.5 m/s between two stretches of 250 zeros. " + _EXACT
    return Finding(gap, 0.0, "-", 1e-9, note, "the same motion without them")


def _task(name: str, measure: Callable[[], Finding]) -> Task:
    return Task(GROUP, name, measure)


TASKS = (
    *(
        _task(f"energy closes, {heating.name} heating", partial(_energy, heating))
        for heating in (NoHeating(), SimplifiedHeating(), PreciseHeating())
    ),
    *(
        _task(f"mirrored motion, {heating.name} heating", partial(_symmetry, heating))
        for heating in (SimplifiedHeating(), PreciseHeating())
    ),
    _task("all forces and the mass times four", _scale),
    *(
        _task(f"record at 1/{parts} of its step, constant friction", partial(_resampling_without_heat, parts))
        for parts in (2, 5)
    ),
    *(
        _task(f"record at 1/{parts} of its step, peak displacement", partial(_resampling_with_heat, parts))
        for parts in (2, 5)
    ),
    *(
        _task(f"restart in five pieces, {heating.name} heating", partial(_restart, heating))
        for heating in (SimplifiedHeating(), PreciseHeating())
    ),
    _task("zeros before and after", _padding),
)
