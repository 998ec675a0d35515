"""A script for OpenSeesPy: what is analysed, on which element, with which constants, and by how much that differs."""

import math
import textwrap
from collections.abc import Iterable
from dataclasses import fields
from importlib.resources import files
from string import Template
from typing import Any

from dcfp.analysis import Response, respond
from dcfp.analysis.integration import Integration
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.exchange.opensees.element import Element, Kind, element_for
from dcfp.motion.ground_motion import GroundMotion, parts_in
from dcfp.motion.load import Motion, motion_of
from dcfp.schema.citations import citations_of
from dcfp.system import Bearing, FrictionLaw, Heating, System, SystemLike
from dcfp.version import version

#: Longest step of the script [s].
STEP = 0.001
#: Largest displacement over the effective radius for which a pendulum of OpenSees is asked [-].
_FURTHEST = 0.9
#: Values of the ground motion in a line.
_IN_A_LINE = 5
#: How often a whole analysis is repeated in half the step, where a step that cannot be divided does not converge.
_HALVINGS = 3
#: Longest line of a comment.
_WIDTH = 110
_COLD = {
    Kind.COULOMB: 'ops.frictionModel("Coulomb", 1, FRICTION)',
    Kind.VELOCITY: 'ops.frictionModel("VelDependent", 1, FRICTION_SLOW, FRICTION, RATE)',
}


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
    # the analysis with what the element is, where that is not the model itself
    other = None if element.stand_in is None else respond(motion, element.stand_in)
    return "\n".join([*_head(response, element, other), "", _body(response, element, other, interval)])


def _body(response: Response, element: Element, other: Response | None, step: float) -> str:
    heated = element.kind is Kind.HEATED
    form = "heated" if heated else "cold"
    return _template("script_body").substitute(
        constants="\n".join(_constants(response, element, step)),
        model=_model(element),
        advance=_template(f"advance_{form}").template.rstrip("\n"),
        state_words=" and temperature" if heated else "",
        state_value=", temperature()" if heated else "",
        csv_head=', "temperature [degC]"' if heated else "",
        reports="\n".join(_reports(response, element, other)),
        digest=response.motion.digest,
        interval=repr(response.motion.time_step),
        values=_values(response.motion),
    )


def model_script(element: Element, bearing: Bearing, heating: Heating) -> str:
    """Return a module with a function `build`, which builds a rigid structure on a bearing and presses it down, in what it imports as `ops`."""
    constants = [f"{name} = {value!r}" for name, value, _ in _of_model(element, bearing, heating)]
    return "\n".join(
        ["import sys", "", "import openseespy.opensees as ops", "", *constants, "", _model(element)]
    )


def _model(element: Element) -> str:
    """Return the functions that build the model and choose its solver."""
    form = "heated" if element.kind is Kind.HEATED else "cold"
    added = _template(f"element_{form}").substitute(model=_COLD.get(element.kind, "")).rstrip("\n")
    return _template("model").substitute(element=added).rstrip("\n")


def _template(name: str) -> Template:
    return Template(files("dcfp.exchange.opensees").joinpath(f"{name}.txt").read_text(encoding="utf-8"))


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
            f" {_difference_in_words(response, other)} analysis."
        )
        lines.append(f"    print({sentence!r})")
    return lines


def _values(motion: GroundMotion) -> str:
    """Return the acceleration to the last bit, some values in a line."""
    values = [repr(value) for value in motion.acceleration.tolist()]
    rows = [values[first : first + _IN_A_LINE] for first in range(0, len(values), _IN_A_LINE)]
    return "\n".join(f"    {', '.join(row)}," for row in rows)


# ----- constants, with their units and where they come from -----


def _constants(response: Response, element: Element, step: float) -> list[str]:
    """Return the constants of a script, a line for each."""
    heated = element.kind is Kind.HEATED
    named = _of_model(element, response.bearing, response.heating)
    duration = math.ceil(float(response.time[-1]) / step - 1e-6) * step
    temperature = [f"DCFP_PEAK_TEMPERATURE = {response.peak_temperature!r}  # degC"] if heated else []
    return [
        "# The bearing and what it carries.",
        *(f"{name} = {value!r}  # {words}" for name, value, words in named),
        "",
        "# How finely and how far.",
        f"STEP = {step!r}  # s, a whole part of the interval of the record",
        f"DURATION = {duration:.9g}  # s, until dcfp finds that it slides no more",
        f"HALVINGS = {_HALVINGS if heated else 0}"
        "  # times that the whole analysis is repeated in half the step if one does not converge",
        "",
        "# Peaks of the analysis that this script repeats, by dcfp.",
        f"DCFP_PEAK_DISPLACEMENT = {response.peak_displacement!r}  # mm",
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


# ----- the head: what it is, of what, and what is different from the analysis of this package -----


def _head(response: Response, element: Element, other: Response | None) -> list[str]:
    """Return the lines of comment at the top of a script."""
    title = f"{response.bearing.name} under {response.motion.name}: a rigid structure on a friction pendulum bearing"
    return [
        *_comment(title),
        "#",
        *_comment(
            f"Written by dcfp {version()}. It needs Python and openseespy (pip install openseespy; on Linux also the libraries"
            " BLAS and LAPACK), and nothing else:"
        ),
        "#",
        "#     python THIS_FILE.py [HISTORY.csv]",
        "#",
        *_comment("Units: N, mm, s and so t, N/mm2, mm/s2; temperatures in degC."),
        "#",
        *(line for label, text in _inputs(response) for line in _comment(text, f"{label:<16}")),
        "#",
        *_comment(f"In OpenSees this is the element {element.kind.value}."),
        *_bullets(_representation(response, element)),
        "#",
        "# What is different from the analysis of dcfp:",
        *_bullets(_differences(response, element, other)),
        *(["#", "# What dcfp remarks on its analysis:"] if response.remarks else []),
        *_bullets(response.remarks),
    ]


def _bullets(sentences: Iterable[str]) -> list[str]:
    return [line for sentence in sentences for line in _comment(sentence, "- ")]


def _inputs(response: Response) -> list[tuple[str, str]]:
    motion, bearing = response.motion, response.bearing
    origin = motion.origin
    source = ", ".join(
        part for part in (origin.event, origin.station, origin.component, origin.source) if part
    )
    treatment = "; ".join(motion.treatment) or "as it is"
    radii = " and ".join(f"{radius:g}" for radius in bearing.radii)
    return [
        (
            "Ground motion",
            f"{motion.name}{f' ({source})' if source else ''}; {treatment}; PGV {motion.peak_velocity:.6g} mm/s,"
            f" PGA {motion.peak_acceleration:.6g} mm/s2; SHA-256 {motion.digest}",
        ),
        (
            "Bearing",
            f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, pressure {bearing.pressure:g} N/mm2,"
            f" stiffness before sliding {bearing.elastic_stiffness:g} N/mm",
        ),
        ("Friction law", _parameters(response.friction_law)),
        ("Heating", _parameters(response.heating)),
        *(("Source", line) for line in citations_of(response.friction_law.citation)),
    ]


def _parameters(thing: Any) -> str:
    """Return a law or a heating model with its constants."""
    known = [f"{item.name} {getattr(thing, item.name)}" for item in fields(thing) if item.init]
    return f"{thing.name}: {', '.join(known)}" if known else thing.name


def _representation(response: Response, element: Element) -> list[str]:
    """Return how the bearing becomes the element."""
    count = len(response.bearing.radii)
    sentences: list[str] = []
    if count == 2:
        sentences.append("The two plates are one with the sum of their radii.")
    if count == 2 and element.rate > 0.0 and response.friction_law.speed_is_of_surface:
        sentences.append(
            "The law means the speed on one plate, half of that of the element, so that RATE is half of the law's."
        )
    if element.kind is Kind.HEATED:
        sentences.append(
            "FRICTION holds the law's factor of the pressure, which stays the same, so that the element's own is switched off."
        )
    if element.kind is Kind.HEATED and count == 2:
        sentences.append(
            "Each plate takes half of the travel. The element, which takes all of it, has the same heat in the same places if its"
            " contact is twice as wide (CONTACT_RADIUS; the pressure on it is a quarter) and its conductivity half."
        )
    if element.rise_factor != 1.0:
        sentences.append(
            f"CONDUCTIVITY is divided by {element.rise_factor:.4f} besides: a rise of the temperature larger by that brings the"
            " friction of the element nearest to the law. Where the script gives a temperature, that is taken out again."
        )
    if element.kind is not Kind.HEATED:
        sentences.append("It knows no temperature.")
    return sentences


def _differences(response: Response, element: Element, other: Response | None) -> list[str]:
    """Return what OpenSees does otherwise, with its size where that is known."""
    sentences: list[str] = []
    if other is not None:
        why = "; ".join(element.reasons)
        sentences.append(
            f"The element cannot be what was analysed: {why}. Its constants are those that come nearest."
            f" With them dcfp finds a peak displacement of {other.peak_displacement:.3f} mm, {_difference_in_words(response, other)} analysis."
            " That is the part of the difference that the law makes; what follows comes on top, and where the element heats, its sum of the heat adds"
            " some tenths of a per cent."
        )
    curved = 0.5 * (response.peak_displacement / response.bearing.effective_radius) ** 2
    sentences.append(
        f"The pendulum's force is N u / sqrt(R^2 - u^2), not N u / R: at the peak {100.0 * curved:.3f} % more."
    )
    if element.kind is Kind.HEATED:
        sentences.append(
            "It heats also where it only deforms elastically, takes the friction of the step before, writes pi as 22/7, and sums its heat in"
            " rectangles, which is low by 1.46 sqrt(STEP) of the present flux: a shorter STEP is nearer, and takes time with its square."
        )
    return sentences


def _comment(text: str, first: str = "") -> list[str]:
    """Return text as lines of comment that begin with `first`, without characters that could end one."""
    plain = "".join(one if one.isprintable() else "?" for one in " ".join(text.split()))
    wrapped = textwrap.wrap(
        plain, _WIDTH - 2, initial_indent=first, subsequent_indent=" " * len(first), break_long_words=False
    )
    return [f"# {line}".rstrip() for line in wrapped]


def _difference_in_words(response: Response, other: Response) -> str:
    """Return by how much the peak displacement of another analysis is more or less."""
    if response.peak_displacement == 0.0:
        return "where nothing moves"
    change = 100.0 * (other.peak_displacement / response.peak_displacement - 1.0)
    return f"{abs(change):.2f} % {'more' if change >= 0.0 else 'less'} than the {response.peak_displacement:.3f} mm of its own"
