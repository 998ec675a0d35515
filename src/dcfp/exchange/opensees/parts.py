"""The parts of a script that differ from element to element."""

from dataclasses import dataclass

from dcfp.exchange.opensees.element import Kind

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
