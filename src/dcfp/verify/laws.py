"""What every response must obey whatever the numbers, rigid structure or shear building, and the default settings against converged ones."""

import math
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np

from dcfp.analysis import respond
from dcfp.analysis.plan.shear_building import respond_in_one_direction, shear_building
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.synthetic import ricker
from dcfp.system import LI_2020, ConstantFriction, NoHeating, PreciseHeating, System
from dcfp.verify.check import Found, hundred_components, scaled_record, sixteen_analyses
from dcfp.verify.explicit import Peaks


def energy(heating: str) -> dict[str, float]:
    """Return the residual of the energy balance over the largest input of 16 analyses [-]."""
    return {
        name: respond(motion, heating=heating).energy.relative_residual for name, motion in sixteen_analyses()
    }


def symmetry(heating: str) -> float:
    """Return the largest sum of the displacements under a motion and its mirror image over the peak [-]."""
    motion = scaled_record("LPG", 500.0)
    there = respond(motion, heating=heating, tail=5.0)
    back = respond(motion.scaled(-1.0), heating=heating, tail=5.0)
    return float(np.abs(there.displacement + back.displacement).max()) / there.peak_displacement


def scale() -> float:
    """Return the largest difference of displacement on a bearing of four times the area over the peak [-]."""
    motion = scaled_record("NCC", 500.0)
    larger = replace(
        LI_2020,
        slider_diameter=2.0 * LI_2020.slider_diameter,
        elastic_stiffness=4.0 * LI_2020.elastic_stiffness,
    )
    here = respond(motion, heating=NoHeating(), tail=5.0)
    there = respond(motion, larger, heating=NoHeating(), tail=5.0)
    return float(np.abs(here.displacement - there.displacement).max()) / here.peak_displacement


def _resampled(parts: int) -> tuple[GroundMotion, GroundMotion]:
    motion = scaled_record("KNA", 500.0)
    samples = motion.acceleration.size
    places = np.arange((samples - 1) * parts + 1) / parts
    finer = np.interp(places, np.arange(samples), motion.acceleration)
    return motion, GroundMotion(finer, motion.time_step / parts, f"{motion.name} at 1/{parts} of its step")


def resampling_without_heat(parts: int) -> float:
    """Return the largest difference of displacement under a motion sampled more finely over the peak [-]."""
    coarse, fine = (
        respond(motion, LI_2020, ConstantFriction(), NoHeating(), tail=0.0) for motion in _resampled(parts)
    )
    gap = np.abs(fine.displacement[::parts] - coarse.displacement).max()
    return float(gap / coarse.peak_displacement)


def resampling_with_heat(parts: int) -> tuple[float, float]:
    """Return the peak displacement under a motion sampled more finely, and that under the motion itself [mm]."""
    coarse, fine = (respond(motion, tail=0.0).peak_displacement for motion in _resampled(parts))
    return fine, coarse


def restart(heating: str) -> float:
    """Return the largest difference of displacement of an analysis in five pieces over the peak [-]."""
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
    return float(np.abs(displacement - whole.displacement).max()) / whole.peak_displacement


def padding() -> float:
    """Return the largest difference of displacement with silence before and after the motion over the peak [-]."""
    motion = scaled_record("IVD", 500.0)
    padded = GroundMotion(np.pad(motion.acceleration, 250), motion.time_step, "padded")
    after = respond(padded, tail=0.0).displacement[250:-250]
    # the first value of a record is seldom zero: between the silence and it the padded motion rises in one step
    first = np.concatenate(([0.0], motion.acceleration))
    before = respond(GroundMotion(first, motion.time_step, "IVD"), tail=0.0)
    return float(np.abs(after - before.displacement[1:]).max()) / before.peak_displacement


# ----- the default settings against converged ones -----


@cache
def converged_and_default(motions: str, heating: str) -> dict[str, tuple[Peaks, Peaks]]:
    """Return the peaks with settings at which nothing changes any more, and those with the default ones."""
    fine = PreciseHeating(cells=200) if heating == "precise" else heating
    return {
        name: (
            Peaks.of(respond(motion, heating=fine, step=motion.time_step / 16.0, tolerance=1e-6)),
            Peaks.of(respond(motion, heating=heating)),
        )
        for name, motion in (sixteen_analyses() if motions == "16 analyses" else hundred_components(500.0))
    }


def default_error(motions: str, heating: str, quantity: str) -> dict[str, float]:
    """Return the errors of a peak with the default settings against settings at which nothing changes any more: of the displacement relative [-], else [degC]."""
    found: dict[str, float] = {}
    for name, peaks in converged_and_default(motions, heating).items():
        best, default = (float(getattr(one, quantity)) for one in peaks)
        found[name] = default / best - 1.0 if quantity == "displacement" else default - best
    return found


@cache
def peaks_by_step() -> list[Peaks]:
    """Return the peaks at each half of a step, and at last those of a very small one."""
    motion = ricker(500.0, 0.5, time_step=0.008)
    settings = [(0.008 / 2.0**level, 0.999) for level in range(4)]
    return [
        Peaks.of(respond(motion, step=step, tolerance=tolerance))
        for step, tolerance in (*settings, (0.008 / 256.0, 1e-9))
    ]


def order(quantity: str) -> Found:
    """Return the slope of the error of a peak against the step, with the step's error control out of the way [-]."""
    *peaks, reference = (float(getattr(one, quantity)) for one in peaks_by_step())
    errors = [abs(peak - reference) for peak in peaks]
    sizes = ", ".join(f"{error:.1e}" for error in errors)
    return Found(math.log2(errors[0] / errors[-1]) / 3, 2.0, words={"sizes": sizes})


# ----- a shear building -----


def stiff_storeys(record: str) -> tuple[float, float]:
    """Return the peak displacement below five storeys of 0.01 s, and that of a rigid structure [mm]."""
    motion = scaled_record(record, 500.0)
    response = respond_in_one_direction(shear_building(5, 0.01, System()), motion)
    return response.peak_displacement, respond(motion).peak_displacement


def building_energy(record: str) -> float:
    """Return the residual of the energy balance of five storeys of 0.5 s over the largest input [-]."""
    motion = scaled_record(record, 500.0)
    response = respond_in_one_direction(shear_building(5, 0.5, System()), motion)
    return response.energy.relative_residual


def building_input_velocity(record: str) -> tuple[float, float]:
    """Return V_E of five storeys of 0.5 s, and that of a rigid structure [mm/s]."""
    motion = scaled_record(record, 1000.0)
    building = respond_in_one_direction(shear_building(5, 0.5, System()), motion)
    return building.input_velocity, respond(motion).input_velocity
