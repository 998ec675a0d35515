"""A script for OpenSeesPy: what is analysed, on which element, with which constants, and by how much that differs."""

import math
from collections.abc import Sequence
from importlib.resources import files
from string import Template

import numpy as np

from dcfp.analysis import respond
from dcfp.analysis.integration import Integration
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.exchange.opensees.element import Analysis, Element, Kind, element_for
from dcfp.exchange.opensees.head import difference_in_words, head
from dcfp.motion.ground_motion import GroundMotion, parts_in
from dcfp.motion.load import Record, record_of
from dcfp.motion.station import Station
from dcfp.system import Bearing, FrictionLaw, Heating, SystemLike

#: Longest step of a script by default [s].
STEP = 0.001
#: The same over the time step of the motion, where the friction turns with the velocity [-].
PART_IN_PLANE = 0.1
#: What the history of a script has for each horizontal direction, with its unit.
_HISTORY = (("displacement", "mm"), ("velocity", "mm/s"), ("force", "N"))
#: Largest displacement over the effective radius for which a pendulum of OpenSees is asked [-].
FURTHEST = 0.9
#: Values of the ground motion in a line.
_IN_A_LINE = 5
#: How often a whole analysis is repeated in half the step, where a step that cannot be divided does not converge.
_HALVINGS = 3
#: Directions of OpenSees.
_NAMES = ("x", "y", "z")
_COLD = {
    Kind.COULOMB: 'ops.frictionModel("Coulomb", 1, FRICTION)',
    Kind.VELOCITY: 'ops.frictionModel("VelDependent", 1, FRICTION_SLOW, FRICTION, RATE)',
}
#: What puts a component of the ground motion on the model, and where one of them is vertical.
_EXCITE = 'ops.pattern("UniformExcitation", tag, direction, "-accel", tag)'
_EXCITE_VERTICALLY = f"""if direction == 3:  # the rigid structure presses at once: its inertia is a force
            ops.pattern("Plain", tag, tag)
            ops.load(STRUCTURE, 0.0, 0.0, -MASS, 0.0, 0.0, 0.0)
        else:
            {_EXCITE}"""


def opensees_script(
    motion: Record,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    vertical: bool = False,
    step: float | None = None,
) -> str:
    """Return a script for OpenSeesPy that analyses a rigid structure on a bearing under a ground motion.

    The script carries the ground motion, needs nothing but Python and openseespy, prints its peaks beside those of this package, and writes its history
    as CSV. Its head says which element stands for the bearing, and what is different; where that is the friction law, by how much.

    Parameters
    ----------
    motion, bearing, friction, heating, vertical
        As for `dcfp.respond`; of a station the script is in the plane.
    step
        Longest step of the script [s]; by default 1 ms, and in the plane at most a tenth of the time step of the motion.

    Raises
    ------
    InputError
        If OpenSees has no element that comes near, or the step is out of range.
    """
    motion = record_of(motion)
    if step is None:
        step = min(STEP, PART_IN_PLANE * motion.time_step) if isinstance(motion, Station) else STEP
    Integration(step=step)  # refuses a step out of range
    interval = motion.time_step / parts_in(motion.time_step, step)
    response = respond(motion, bearing, friction, heating, vertical=vertical)
    _refuse(response)
    element = element_for(motion, response.system, vertical=vertical)
    # the analysis with what the element is, where that is not the model itself
    other = None if element.stand_in is None else respond(motion, element.stand_in, vertical=vertical)
    return "\n".join([*head(response, element, other), "", _body(response, element, other, interval), ""])


def _refuse(response: Analysis) -> None:
    """Refuse what a model of OpenSees does not do as this package does."""
    name, radius = response.motion.name, response.bearing.effective_radius
    if response.peak_displacement > FURTHEST * radius:
        msg = (
            f"{name}: the displacement of {response.peak_displacement:.0f} mm is too near to the effective radius of"
            f" {radius:.0f} mm, at which the pendulum of OpenSees ends."
        )
        raise InputError(msg)
    if not np.all(response.load > 0.0):
        msg = f"{name}: the vertical motion lifts the bearing off, which the element of OpenSees does not do; leave it out, or scale the motion down."
        raise InputError(msg)


def _components(response: Analysis) -> tuple[GroundMotion, ...]:
    """Return what acts in the directions x, y and vertically."""
    motion = response.motion
    if not isinstance(motion, Station):
        return (motion,)
    return motion.components if _is_lifted(response) else (motion.x, motion.y)


def _is_lifted(response: Analysis) -> bool:
    """Whether the vertical force changes."""
    return response.load.size > 1


def _directions(response: Analysis) -> tuple[str, ...]:
    """Return what is put behind the name of a quantity for each horizontal direction."""
    return tuple(f" {name}" for name in _NAMES[:2]) if isinstance(response.motion, Station) else ("",)


def _body(response: Analysis, element: Element, other: Analysis | None, step: float) -> str:
    heated, lifted = element.kind is Kind.HEATED, _is_lifted(response)
    form = "heated" if heated else "cold"
    components, directions = _components(response), _directions(response)
    columns = [f"{name}{one} [{unit}]" for name, unit in _HISTORY for one in directions]
    heads = ["time [s]", *columns, *(["temperature [degC]"] if heated else [])]
    return template("script_body").substitute(
        constants="\n".join(_constants(response, element, step)),
        model=_model(element, plane=len(directions) > 1, lifted=lifted),
        excite=_EXCITE_VERTICALLY if lifted else _EXCITE,
        advance=text_of(f"advance_{form}"),
        state_words=" and temperature" if heated else "",
        state_value="\n        temperature()," if heated else "",
        csv_head=", ".join(f'"{one}"' for one in heads),
        reports="\n".join(_reports(response, element, other)),
        record=text_of("record"),
        ground=ground_of(components),
    )


def model_script(element: Element, bearing: Bearing, heating: Heating, *, plane: bool = False) -> str:
    """Return a module with a function `build`, which builds a rigid structure on a bearing, free in one direction or in the `plane`, and presses it down, in what it imports as `ops`."""
    constants = [f"{name} = {value!r}" for name, value, _ in _of_model(element, bearing, heating)]
    return "\n".join(
        ["import sys", "", "import openseespy.opensees as ops", "", *constants, "", _model(element, plane)]
    )


def _model(element: Element, plane: bool, lifted: bool = False) -> str:
    """Return the functions that build the model and choose its solver; `lifted` where its vertical force changes."""
    form = "heated" if element.kind is Kind.HEATED else "cold"
    return template("model").substitute(
        element=template(f"element_{form}").substitute(model=_COLD.get(element.kind, "")),
        vertical_mass="1e-6" if lifted else "MASS",
        fixed="0, 0, 0" if plane else "0, 1, 0",
        free="in the plane (x, y)" if plane else "along the motion (x)",
    )


def template(name: str) -> Template:
    """Return a part of a script, with names that begin with a dollar where something is to be put in."""
    return Template(text_of(name))


def text_of(name: str) -> str:
    """Return a part of a script as it stands, without the end of its last line."""
    path = files("dcfp.exchange.opensees").joinpath(f"{name}.txt")
    return path.read_text(encoding="utf-8").rstrip("\n")


def ground_of(components: Sequence[GroundMotion]) -> str:
    """Return the components of the ground motion in the directions from 1 on, with their digests."""
    numbered = list(enumerate(components, 1))
    return template("ground").substitute(
        directions=", ".join(f"{number} is {_NAMES[number - 1]}" for number, _ in numbered),
        digests="\n".join(f'    {number}: "{one.digest}",' for number, one in numbered),
        interval=repr(components[0].time_step),
        values="\n".join(f"    {number}: (\n{_values(one)}\n    )," for number, one in numbered),
    )


def _reports(response: Analysis, element: Element, other: Analysis | None) -> list[str]:
    """Return the lines that print the peaks, and the difference that the head states."""
    count = len(_directions(response))
    lines = ['    report("peak displacement", "mm", largest(history, 1), DCFP_PEAK_DISPLACEMENT)']
    if count > 1:
        lines += [
            f'    report("peak displacement {name}", "mm", max(abs(row[{column}]) for row in history), DCFP_PEAK_DISPLACEMENT_{name.upper()})'
            for column, name in enumerate(_NAMES[:count], 1)
        ]
    lines.append(
        f'    report("largest force", "kN", largest(history, {1 + 2 * count}) / 1e3, DCFP_PEAK_FORCE)'
    )
    if element.kind is Kind.HEATED:
        lines.append(
            '    report("highest temperature", "degC", max(row[-1] for row in history), DCFP_PEAK_TEMPERATURE)'
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
    return "\n".join(f"        {', '.join(row)}," for row in rows)


# ----- constants, with their units and where they come from -----


def _constants(response: Analysis, element: Element, step: float) -> list[str]:
    """Return the constants of a script, a line for each."""
    heated = element.kind is Kind.HEATED
    named = _of_model(element, response.bearing, response.heating)
    duration = math.ceil(float(response.time[-1]) / step - 1e-6) * step
    count = len(_directions(response))
    of_directions = [
        f"DCFP_PEAK_DISPLACEMENT_{name.upper()} = {getattr(response, f'peak_displacement_{name}')!r}  # mm"
        for name in (_NAMES[:count] if count > 1 else ())
    ]
    temperature = [f"DCFP_PEAK_TEMPERATURE = {response.peak_temperature!r}  # degC"] if heated else []
    return [
        "# The bearing and what it carries.",
        *(f"{name} = {value!r}  # {words}" for name, value, words in named),
        f"HORIZONTAL = {tuple(range(1, count + 1))}  # directions in which the structure moves: {' and '.join(_NAMES[:count])}",
        "",
        "# How finely and how far.",
        f"STEP = {step!r}  # s, a whole part of the interval of the record",
        f"DURATION = {duration:.9g}  # s, until dcfp finds that it slides no more",
        f"HALVINGS = {_HALVINGS if heated else 0}"
        "  # times that the whole analysis is repeated in half the step if one does not converge",
        "",
        "# Peaks of the analysis that this script repeats, by dcfp.",
        f"DCFP_PEAK_DISPLACEMENT = {response.peak_displacement!r}  # mm",
        *of_directions,
        f"DCFP_PEAK_FORCE = {response.peak_force / 1e3!r}  # kN",
        *temperature,
    ]


def _of_model(element: Element, bearing: Bearing, heating: Heating) -> list[tuple[str, float, str]]:
    """Return name, value and words of what the element and the mass on it are made with."""
    heat = _of_heat(element, bearing, heating) if element.kind is Kind.HEATED else []
    both = bearing.elastic_stiffness + bearing.restoring_stiffness
    return [
        ("RADIUS", bearing.effective_radius, "mm, sum of the effective radii of the plates"),
        ("INITIAL_STIFFNESS", both, "N/mm, before sliding; for OpenSees with that of the pendulum"),
        ("VERTICAL_FORCE", bearing.vertical_force, "N"),
        ("MASS", bearing.mass, f"t, the vertical force over {STANDARD_GRAVITY:g} mm/s2"),
        *_of_friction(element),
        *heat,
    ]


def _of_friction(element: Element) -> list[tuple[str, float, str]]:
    if element.kind is Kind.COULOMB:
        return [("FRICTION", element.friction, "-")]
    rate = ("RATE", element.rate, "s/mm, of how friction rises with the relative speed of the plates")
    if element.kind is Kind.VELOCITY:
        return [
            ("FRICTION_SLOW", element.slow, "-, at no speed"),
            ("FRICTION", element.friction, "-, at high speed"),
            rate,
        ]
    return [
        ("FRICTION", element.friction, "-, at high speed and 20 degC"),
        ("VELOCITY_DEPENDENT", int(element.rate > 0.0), "1 for yes"),
        rate,
    ]


def _of_heat(element: Element, bearing: Bearing, steel: Heating) -> list[tuple[str, float, str]]:
    plates = len(bearing.radii)
    conductivity = steel.conductivity / plates / element.rise_factor
    of_steel = (
        f"N/(s degC); that of the plates is {steel.conductivity:g}, the head says why this is not the same"
    )
    return [
        (
            "CONTACT_RADIUS",
            0.5 * bearing.slider_diameter * plates,
            "mm, of the slider times the number of plates",
        ),
        ("PRESSURE", bearing.pressure / plates**2, "N/mm2, on that radius"),
        ("DIFFUSIVITY", steel.diffusivity, "mm2/s, of the plates"),
        ("AMBIENT", steel.ambient, "degC, where the plates begin"),
        (
            "RISE_FACTOR",
            element.rise_factor,
            "-, rise of the temperature of the element over that of the bearing",
        ),
        (
            "CONDUCTIVITY",
            conductivity,
            "N/(s degC), of the plates" if conductivity == steel.conductivity else of_steel,
        ),
    ]
