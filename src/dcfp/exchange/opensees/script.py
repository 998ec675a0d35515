"""A script for OpenSeesPy: what is analysed, on which element, and by how much that differs."""

from dataclasses import dataclass
from importlib.resources import files
from string import Template

from dcfp.analysis import Response, respond
from dcfp.analysis.integration import Integration
from dcfp.errors import InputError
from dcfp.exchange.opensees.constants import constant_lines
from dcfp.exchange.opensees.element import Element, Kind, element_for
from dcfp.exchange.opensees.head import difference_in_words, head_lines
from dcfp.motion.ground_motion import GroundMotion, parts_in
from dcfp.motion.load import Motion, motion_of
from dcfp.system import FrictionLaw, Heating, System, SystemLike

#: Longest step of the script [s].
STEP = 0.001
#: Largest displacement over the effective radius for which a pendulum of OpenSees is asked [-].
_FURTHEST = 0.9
#: Values of the ground motion in a line.
_IN_A_LINE = 5


def opensees_script(
    motion: Motion,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    step: float = STEP,
) -> str:
    """Return a script for OpenSeesPy that analyses a rigid structure on a bearing under a ground motion.

    The script carries the ground motion, needs nothing but Python and openseespy, prints its peaks beside those of this package, and writes its history
    as CSV. Its head says which element stands for the bearing, and what is different; where that is the friction law, by how much.

    Parameters
    ----------
    motion, bearing, friction, heating
        As for `dcfp.respond`.
    step
        Longest step of the script [s].

    Raises
    ------
    InputError
        If OpenSees has no element that comes near, or the step is out of range.
    """
    motion, model = motion_of(motion), System.of(bearing, friction, heating)
    Integration(step=step)  # refuses a step out of range
    interval = motion.time_step / parts_in(motion.time_step, step)
    element = element_for(motion, model)
    response = respond(motion, model)
    if response.peak_displacement > _FURTHEST * model.bearing.effective_radius:
        msg = (
            f"{motion.name}: the displacement of {response.peak_displacement:.0f} mm is too near to the effective radius of"
            f" {model.bearing.effective_radius:.0f} mm, at which the pendulum of OpenSees ends."
        )
        raise InputError(msg)
    return _text(response, element, _stand_in(motion, element), interval)


def _stand_in(motion: GroundMotion, element: Element) -> Response | None:
    """Return the analysis with what the element is, where that is not the model itself."""
    other = element.stand_in
    return None if other is None else respond(motion, other)


def _text(response: Response, element: Element, other: Response | None, step: float) -> str:
    parts = parts_of(element.kind)
    body = files("dcfp.exchange.opensees").joinpath("script_body.txt").read_text(encoding="utf-8")
    filled = Template(body).substitute(
        constants=constant_lines(response, element, step),
        element=parts.element,
        advance=parts.advance,
        state_words=parts.state_words,
        state_value=parts.state_value,
        csv_head=parts.csv_head,
        reports="\n".join(_reports(response, element, other)),
        digest=response.motion.digest,
        interval=repr(response.motion.time_step),
        values=_values(response.motion),
    )
    return "\n".join([*head_lines(response, element, other), "", filled])


def _reports(response: Response, element: Element, other: Response | None) -> list[str]:
    """Return the lines that print the peaks, and the difference that the head states."""
    lines = [
        '    report("peak displacement", "mm", max(abs(row[1]) for row in history), DCFP_PEAK_DISPLACEMENT)',
        '    report("largest force", "kN", max(abs(row[3]) for row in history) / 1e3, DCFP_PEAK_FORCE)',
    ]
    if element.kind is Kind.HEATED:
        lines.append(
            '    report("highest temperature", "degC", max(row[4] for row in history), DCFP_PEAK_TEMPERATURE)'
        )
    if other is not None:
        sentence = (
            f"With the friction of this element dcfp finds {other.peak_displacement:.3f} mm,"
            f" {difference_in_words(response, other)} analysis."
        )
        lines.append(f"    print({sentence!r})")
    return lines


def _values(motion: GroundMotion) -> str:
    """Return the acceleration to the last bit, some values in a line."""
    values = [repr(value) for value in motion.acceleration.tolist()]
    rows = [values[first : first + _IN_A_LINE] for first in range(0, len(values), _IN_A_LINE)]
    return "\n".join(f"    {', '.join(row)}," for row in rows)


# The parts of a script that differ from element to element.


_SINGLE = '''\
def add_bearing():
    """Add the bearing: one concave surface, friction by a friction model."""
    {model}
    ops.element(
        "singleFPBearing", 1, GROUND, STRUCTURE, 1, RADIUS, INITIAL_STIFFNESS,
        "-P", 1, "-T", 2, "-My", 2, "-Mz", 2,
        "-orient", 0.0, 0.0, 1.0, 1.0, 0.0, 0.0,  # its axis is vertical, its first direction along the motion
        "-iter", 50, 1e-8,
    )'''

_HEATED = '''\
def add_bearing():
    """Add the bearing: one concave surface that heats up."""
    pressure_dependent, temperature_dependent = 0, 1
    shear_distance, rayleigh, element_mass, newton_and_millimetre = 0.0, 0, 0.0, 3
    ops.element(
        "FPBearingPTV", 1, GROUND, STRUCTURE, FRICTION, pressure_dependent, PRESSURE, temperature_dependent,
        DIFFUSIVITY, CONDUCTIVITY, VELOCITY_DEPENDENT, RATE, RADIUS, CONTACT_RADIUS, INITIAL_STIFFNESS,
        1, 2, 2, 2,  # materials: vertical, torsion, and the two rotations
        0.0, 0.0, 1.0, 1.0, 0.0, 0.0,  # its axis is vertical, its first direction along the motion
        shear_distance, rayleigh, element_mass, 50, 1e-3, newton_and_millimetre,
    )'''

_ADVANCE_IN_PARTS = '''\
def advance(step):
    """Go on by a step; where it does not converge, in two of half the length, and so on."""
    if ops.analyze(1, step) == 0:
        return True
    return step > STEP / 100.0 and advance(step / 2.0) and advance(step / 2.0)'''

_TEMPERATURE = '''


def temperature():
    """Return the temperature of the contact of the bearing; the element begins at 20 degC."""
    return AMBIENT + (ops.eleResponse(1, "temperature")[0] - 20.0) / RISE_FACTOR'''

_ADVANCE_AT_ONCE = '''\
def advance(step):
    """Go on by a step; the element sums up its heat in equal steps, so that a single one must not be divided."""
    return ops.analyze(1, step) == 0'''


@dataclass(frozen=True)
class Parts:
    """Text for the places of the script that depend on the element."""

    element: str
    advance: str
    state_words: str = ""
    state_value: str = ""
    csv_head: str = ""


_COLD = {
    Kind.COULOMB: 'ops.frictionModel("Coulomb", 1, FRICTION)',
    Kind.VELOCITY: 'ops.frictionModel("VelDependent", 1, FRICTION_SLOW, FRICTION, RATE)',
}


def parts_of(kind: Kind) -> Parts:
    """Return the text that belongs to an element."""
    if kind is not Kind.HEATED:
        return Parts(_SINGLE.format(model=_COLD[kind]), _ADVANCE_IN_PARTS)
    return Parts(
        _HEATED,
        _ADVANCE_AT_ONCE + _TEMPERATURE,
        " and temperature",
        ", temperature()",
        ', "temperature [degC]"',
    )
