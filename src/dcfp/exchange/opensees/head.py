"""The head of a script for OpenSees: what it is, of what, and what is different from the analysis of this package."""

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import fields
from typing import Any, Protocol

from dcfp.exchange.opensees.element import Analysis, Element, Kind
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.citations import citations_of
from dcfp.version import version

#: Longest line of a comment.
_WIDTH = 110


class HasPeak(Protocol):
    """An analysis that has a peak displacement."""

    @property
    def peak_displacement(self) -> float:
        """The peak displacement [mm]."""
        ...


def head(response: Analysis, element: Element, other: Analysis | None) -> list[str]:
    """Return the lines of comment at the top of a script."""
    return comments(
        f"{response.bearing.name} under {response.motion.name}: a rigid structure on a friction pendulum bearing",
        _inputs(response),
        f"In OpenSees this is the element {element.kind.value}.",
        _representation(response, element),
        _differences(response, element, other),
        response.remarks,
    )


def comments(
    title: str,
    inputs: Iterable[tuple[str, str]],
    element: str,
    representation: Iterable[str],
    differences: Iterable[str],
    remarks: Sequence[str] = (),
) -> list[str]:
    """Return the comment at the top of a script.

    Parameters
    ----------
    title, inputs
        What is analysed, and what it is given by, each under a label.
    element, representation
        What it is in OpenSees, in one sentence and in several.
    differences, remarks
        From the analysis of this package, and what that remarks itself.
    """
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
        *(line for label, text in inputs for line in _comment(text, f"{label:<16}")),
        "#",
        *_comment(element),
        *_bullets(representation),
        "#",
        "# What is different from the analysis of dcfp:",
        *_bullets(differences),
        *(["#", "# What dcfp remarks on its analysis:"] if remarks else []),
        *_bullets(remarks),
    ]


def _bullets(sentences: Iterable[str]) -> list[str]:
    return [line for sentence in sentences for line in _comment(sentence, "- ")]


def _inputs(response: Analysis) -> list[tuple[str, str]]:
    bearing = response.bearing
    radii = " and ".join(f"{radius:g}" for radius in bearing.radii)
    return [
        ("Ground motion", told_of(response.motion)),
        (
            "Bearing",
            f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, pressure {bearing.pressure:g} N/mm2,"
            f" stiffness before sliding {bearing.elastic_stiffness:g} N/mm",
        ),
        ("Friction law", parameters_of(response.friction_law)),
        ("Heating", parameters_of(response.heating)),
        *(("Source", line) for line in citations_of(response.friction_law.citation)),
    ]


def told_of(motion: GroundMotion | Station) -> str:
    """Return where a ground motion comes from, what was done to it, its peaks and its digest."""
    origin = motion.origin
    source = ", ".join(
        part for part in (origin.event, origin.station, origin.component, origin.source) if part
    )
    treatment = "; ".join(motion.treatment) or "as it is"
    return (
        f"{motion.name}{f' ({source})' if source else ''}; {treatment}; PGV {motion.peak_velocity:.6g} mm/s,"
        f" PGA {motion.peak_acceleration:.6g} mm/s2; SHA-256 {motion.digest}"
    )


def parameters_of(thing: Any) -> str:
    """Return a law or a heating model with its constants."""
    known = [f"{item.name} {getattr(thing, item.name)}" for item in fields(thing) if item.init]
    return f"{thing.name}: {', '.join(known)}" if known else thing.name


def _representation(response: Analysis, element: Element) -> list[str]:
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


def _differences(response: Analysis, element: Element, other: Analysis | None) -> list[str]:
    """Return what OpenSees does otherwise, with its size where that is known."""
    sentences: list[str] = []
    if other is not None:
        why = "; ".join(element.reasons)
        sentences.append(
            f"The element cannot be what was analysed: {why}. Its constants are those that come nearest."
            f" With them dcfp finds a peak displacement of {other.peak_displacement:.3f} mm, {difference_in_words(response, other)} analysis."
            " That is the part of the difference that the law makes; what follows comes on top, and where the element heats, its sum of the heat adds"
            " some tenths of a per cent."
        )
    away = (response.peak_displacement / response.bearing.effective_radius) ** 2
    form, more = (
        ("N u / sqrt(R^2 - u^2)", 0.5) if element.kind is Kind.HEATED else ("N u R / (R^2 - u^2)", 1.0)
    )
    sentences.append(
        f"The pendulum's force is {form}, not N u / R: at the peak {100.0 * more * away:.3f} % more."
    )
    plane = isinstance(response.motion, Station)
    if plane:
        sentences.append(
            "Its friction follows the direction of the velocity to the first order of STEP: with 1 ms the peak of records was 0.04 to 0.21 % more, with half"
            " of it half as much."
        )
    if response.load.size > 1:
        sentences.append(
            "The inertia of the vertical motion is put on as a force, for the structure is rigid."
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


def difference_in_words(response: HasPeak, other: HasPeak) -> str:
    """Return by how much the peak displacement of another analysis is more or less."""
    if response.peak_displacement == 0.0:
        return "where nothing moves"
    change = 100.0 * (other.peak_displacement / response.peak_displacement - 1.0)
    return f"{abs(change):.2f} % {'more' if change >= 0.0 else 'less'} than the {response.peak_displacement:.3f} mm of its own"
