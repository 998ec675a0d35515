"""What slides over the plate: the two sine tests, and earthquakes from dcfp; and the march over them."""

from dataclasses import dataclass

import numpy as np
from plate_fe import Array, Patch, Plate

import dcfp

PRESSURE = 60.0  # [N/mm2]
RADIUS = 200.0  # of the slider [mm]
HALF_SIDE = np.sqrt(np.pi) * RADIUS / 2.0  # of the square of the same area [mm]
AMBIENT = 20.0  # [degC]


@dataclass(frozen=True)
class Motion:
    """A slider's way over one plate, in equal steps.

    Attributes
    ----------
    name
        For tables and figures.
    step
        [s].
    position
        Of the contact's centre on the plate, y/2, at the ends of the steps [mm], shape (n + 1,).
    slip
        Mean relative speed |v| of the plates in each step [mm/s], shape (n,).
    flux
        Mean heat flux into the plate in each step [N/(mm s)], shape (n,); None where friction has to tell.
    modelled
        Contact temperature according to dcfp [degC], shape (n + 1,); None where there is none.
    """

    name: str
    step: float
    position: Array
    slip: Array
    flux: Array | None
    modelled: Array | None = None

    @property
    def time(self) -> Array:
        """Ends of the steps [s]."""
        return self.step * np.arange(self.position.size)


def sine(
    name: str, amplitude: float, speed: float, cycles: int, per_cycle: int, friction: float | None
) -> Motion:
    """Return a sine test, started in the middle at full speed, with constant friction or without a flux."""
    period = 2.0 * np.pi * amplitude / speed
    phase = 2.0 * np.pi * np.arange(cycles * per_cycle + 1) / per_cycle
    step = period / per_cycle
    slip = np.abs(np.diff(amplitude * np.sin(phase))) / step
    flux = None if friction is None else 0.5 * friction * PRESSURE * slip
    return Motion(name, step, 0.5 * amplitude * np.sin(phase), slip, flux)


def earthquake(record: str, velocity: float) -> Motion:
    """Return dcfp's response with precise heating; flux is half the work of friction per area and time."""
    motion = dcfp.load_motion(record).scaled_to_pgv(velocity)
    response = dcfp.respond(motion, heating=dcfp.PreciseHeating())
    step = float(response.time[1] - response.time[0])
    area = np.pi * response.bearing.slider_diameter**2 / 4.0
    flux = np.diff(response.energy.hysteretic) / step / area / 2.0
    slip = np.abs(np.diff(response.displacement)) / step
    name = f"{record} at {velocity / 10.0:.0f} cm/s"
    return Motion(name, step, 0.5 * response.displacement, slip, flux, response.temperature)


def friction_at(slip: Array | float, temperature: Array | float) -> Array:
    """Coefficient of friction of the paper at 60 N/mm2 [-]."""
    return np.asarray(0.075 * (1.0 - 0.55 * np.exp(-0.019 * slip)) * 1.13 * np.exp(-0.007 * temperature))


@dataclass(frozen=True)
class Outcome:
    """What a march left.

    Attributes
    ----------
    contact, centre
        Mean temperature of the contact and temperature of the plate's centre at the ends of the steps [degC],
        shape (n + 1,).
    friction
        Of each step, mean over the contact [-], shape (n,); zero where the flux was given.
    """

    contact: Array
    centre: Array
    friction: Array


def march(motion: Motion, plate: Plate, patch: Patch, feedback: str = "none") -> Outcome:
    """Drive a plate by a motion.

    Parameters
    ----------
    feedback
        "none": the motion's flux. "mean": friction at the mean temperature of the contact. "centre": at that
        of the plate's centre. "local": at each point's own. Temperatures are those at the start of a step.
    """
    count = motion.slip.size
    contact, centre, friction = np.empty(count + 1), np.empty(count + 1), np.zeros(count)
    contact[0] = centre[0] = AMBIENT
    middle = int(np.argmin(np.abs(plate.x.nodes)))
    rises = np.zeros((plate.x.nodes.size, plate.y.nodes.size))
    covered = patch.at(motion.position[0])
    area = covered.sum()
    for n in range(count):
        ahead = patch.at(motion.position[n + 1])
        load = 0.5 * (covered + ahead)
        if feedback == "none" and motion.flux is not None:
            load *= motion.flux[n]
        else:
            at = {"mean": contact[n], "centre": centre[n], "local": AMBIENT + rises}[feedback]
            coefficient = friction_at(motion.slip[n], at)
            friction[n] = (coefficient * load).sum() / load.sum()
            load *= 0.5 * coefficient * PRESSURE * motion.slip[n]
        plate.heat(load, motion.step)
        rises, covered = plate.surface(), ahead
        contact[n + 1] = AMBIENT + (rises * covered).sum() / area
        centre[n + 1] = AMBIENT + rises[middle, 0]
    return Outcome(contact, centre, friction)
