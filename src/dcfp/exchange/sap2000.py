"""Bearings of a building as link properties of SAP2000 and ETABS: a table, and the text of database tables that SAP2000 imports."""

import math
import re
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from scipy import optimize

from dcfp.analysis.plan.model import left_behind
from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import DEGC, KN, KN_PER_MM, KN_S_PER_MM, MM, N_PER_MM2, NONE, S_PER_MM
from dcfp.system import System
from dcfp.system.plan import BY_LOAD, Plan
from dcfp.version import version

_TEMPERATURE = Parameter("temperature of the contact", DEGC, -100.0, 1000.0)
_DISPLACEMENT = Parameter("design displacement", MM, 0.0, 1e5, above=True)
#: Speeds at which the law of the program is brought near to another [mm/s].
_SPEEDS = np.linspace(0.0, 1000.0, 501)
#: By how much a bearing is squeezed by its design load, for want of a vertical stiffness [mm].
_SQUEEZED = 0.5
#: How much hotter, to say what friction does then [degC]; longest line of the head; longest name of a link.
_HOTTER, _WIDTH, _LONGEST = 50.0, 110, 31


@dataclass(frozen=True)
class LinkProperty:
    """A type of bearing as a link of the kind Friction Isolator, at its design load and temperature.

    Attributes
    ----------
    name, system
        Of the link; what it stands for.
    count, load, least_load, largest_load
        Number of its bearings in the plan; mean, least and largest static load of them [N].
    temperature, displacement
        At which friction is taken [degC], and for the linear properties [mm], None where it is not known.
    stiffness
        Before sliding, without the pendulum, of a bearing under the design load [N/mm].
    slow, fast, rate
        Of the friction fast - (fast - slow) exp(-rate v) [-, -, s/mm], v being the relative speed of the plates.
    misfit
        Largest difference of that to the law from 0 to 1 m/s [-].
    """

    name: str
    system: System
    count: int
    load: float
    least_load: float
    largest_load: float
    temperature: float
    displacement: float | None
    stiffness: float
    slow: float
    fast: float
    rate: float
    misfit: float

    @property
    def pressure(self) -> float:
        """Pressure on the slider under the design load [N/mm2]."""
        return self.load / self.system.bearing.slider_area

    @property
    def radius(self) -> float:
        """Sum of the radii of the plates [mm]."""
        return self.system.bearing.effective_radius

    @property
    def effective_stiffness(self) -> float:
        """Secant stiffness at the design displacement, N/R + mu N/D; that of the pendulum where none is known [N/mm]."""
        of_friction = 0.0 if self.displacement is None else self.fast * self.load / self.displacement
        return self.load / self.radius + of_friction

    @property
    def damping_ratio(self) -> float | None:
        """Equivalent damping ratio at the design displacement, 2/pi mu / (mu + D/R) [-]."""
        if self.displacement is None:
            return None
        return 2.0 / math.pi * self.fast / (self.fast + self.displacement / self.radius)

    @property
    def effective_damping(self) -> float:
        """Coefficient of a dashpot with that ratio under the mass of the design load; zero where it is not known [N s/mm]."""
        ratio = self.damping_ratio or 0.0
        return 2.0 * ratio * math.sqrt(self.effective_stiffness * self.load / STANDARD_GRAVITY)


#: What is told of a link property.
LINKS = (
    Quantity("link", "name of the link property", get="name", head="Link"),
    Quantity("bearings", "number of bearings in the plan", NONE, decimals=0, get="count", head="Bearings"),
    Quantity("load_kN", "mean static load, at which the properties are", KN, decimals=0, get="load", head="Load"),
    Quantity("pressure_N_mm2", "pressure under that load", N_PER_MM2, decimals=1, get="pressure", head="Pressure"),
    Quantity("temperature_degC", "temperature at which the friction is", DEGC, decimals=0, get="temperature", head="Temperature"),
    Quantity("radius_mm", "sum of the radii", MM, decimals=0, get="radius", head="Radius"),
    Quantity("stiffness_kN_mm", "stiffness before sliding, without the pendulum", KN_PER_MM, digits=4, get="stiffness", head="Stiffness"),
    Quantity("friction_slow", "coefficient of friction at no speed", NONE, decimals=4, get="slow", head="Slow"),
    Quantity("friction_fast", "coefficient of friction at high speed", NONE, decimals=4, get="fast", head="Fast"),
    Quantity("rate_s_mm", "rate of its rise with the relative speed of the plates", S_PER_MM, digits=4, get="rate", head="Rate"),
    Quantity("misfit", "largest difference of the friction to the law from 0 to 1 m/s", NONE, digits=2, get="misfit", head="Misfit"),
    Quantity("effective_stiffness_kN_mm", "effective stiffness", KN_PER_MM, digits=4, get="effective_stiffness", head="Effective\nstiffness [kN/mm]"),
    Quantity("damping_ratio", "equivalent damping ratio", NONE, decimals=3, get="damping_ratio", head="Damping\nratio [-]"),
    Quantity("effective_damping_kN_s_mm", "coefficient of a dashpot with that ratio", KN_S_PER_MM, digits=4, get="effective_damping", head="Effective\ndamping [kN s/mm]"),
)  # fmt: skip


def link_table(plan: Plan, temperature: float | None = None, displacement: float | None = None) -> Table:
    """Return the link properties of the types of bearings of a plan as a table; parameters and errors as of `sap2000_text`."""
    return Table(LINKS, link_properties(plan, temperature, displacement))


def link_properties(
    plan: Plan, temperature: float | None = None, displacement: float | None = None
) -> list[LinkProperty]:
    """Return the link property of each type of bearing of a plan; parameters and errors as of `sap2000_text`."""
    if temperature is not None:
        temperature = _TEMPERATURE.checked(temperature, "SAP2000: temperature")
    if displacement is not None:
        displacement = _DISPLACEMENT.checked(displacement, "SAP2000: displacement")
    found: list[LinkProperty] = []
    for system in dict.fromkeys(plan.systems):
        own = np.array([one == system for one in plan.systems])
        loads = plan.static_loads[own]
        load = float(loads.mean())
        at = system.heating.ambient if temperature is None else temperature
        coefficients = _coefficients(system, load, at)
        slow, fast, rate = _fitted(coefficients)
        misfit = float(np.abs(_of_program(slow, fast, rate) - coefficients).max())
        name = _link_name(system.bearing.name, [one.name for one in found])
        stiffness = float(plan.elastic_stiffnesses[own].mean())
        found.append(
            LinkProperty(
                name, system, int(own.sum()), load, float(loads.min()), float(loads.max()),
                at, displacement, stiffness, slow, fast, rate, misfit,
            )
        )  # fmt: skip
    return found


def _coefficients(
    system: System, load: float, temperature: float, speeds: FloatArray = _SPEEDS
) -> FloatArray:
    """Return the coefficient of a bearing at relative speeds of its plates, the mean of both by their shares [-]."""
    law, bearing = system.friction, system.bearing
    pressure = load / bearing.slider_area
    each = [
        share * law.coefficient(pressure, speeds * (share if law.speed_is_of_surface else 1.0), temperature)
        for share in bearing.shares
    ]
    return np.asarray(sum(np.broadcast_to(one, speeds.shape) for one in each), dtype=np.float64)


def _of_program(slow: float, fast: float, rate: float) -> FloatArray:
    return fast - (fast - slow) * np.exp(-rate * _SPEEDS)


def _fitted(coefficients: FloatArray) -> tuple[float, float, float]:
    """Return slow, fast and rate of the program's law that come nearest to coefficients at `_SPEEDS`; rate zero where there is no rise."""
    slow, fast = float(coefficients[0]), float(coefficients[-1])
    if np.ptp(coefficients) <= 1e-9 * fast:
        return fast, fast, 0.0
    half = int(np.abs(coefficients - 0.5 * (slow + fast)).argmin())
    scale = np.array([slow, fast, math.log(2.0) / _SPEEDS[max(half, 1)]])

    def misfit(factors: FloatArray) -> FloatArray:
        return (_of_program(*(scale * factors)) - coefficients) / fast

    result = cast("Any", optimize).least_squares(misfit, np.ones(3), bounds=(0.0, 100.0), xtol=1e-14, ftol=1e-14, gtol=1e-14)  # fmt: skip
    slow, fast, rate = (float(one) for one in scale * result.x)
    return slow, fast, rate


def _link_name(name: str, others: list[str]) -> str:
    """Return a name of a link that is not one of the `others`, of characters that stand in a table."""
    plain = re.sub(r"[^A-Za-z0-9 _.()+-]+", "_", name).strip(" _") or "bearing"
    found, number = plain[:_LONGEST], 2
    while found in others:
        found = f"{plain[: _LONGEST - 4]} {number}"
        number += 1
    return found


# ----- the text -----


def sap2000_text(plan: Plan, temperature: float | None = None, displacement: float | None = None) -> str:
    """Return database tables that SAP2000 imports, with the link property of each type of bearing of a plan.

    Parameters
    ----------
    plan
        The building; each type is taken at the mean static load of its bearings.
    temperature
        Of the contacts, at which friction is taken [degC]; by default that at the start.
    displacement
        For the linear properties [mm]; without one the stiffness is that of the pendulum, and there is no damping.

    Raises
    ------
    InputError
        If a value is out of range.

    Notes
    -----
    The friction is that of the programs' own law, fast - (fast - slow) exp(-rate v), CSI Analysis Reference Manual, brought near to the law of the bearing from 0 to 1 m/s.
    The fields of the shear directions are those of exported tables; what was not found so is marked in the head.
    """
    links = link_properties(plan, temperature, displacement)
    head = [line for sentence in _head(plan, links) for line in _comment(sentence)]
    tables = [
        ("PROGRAM CONTROL", [_row(ProgramName="SAP2000", CurrUnits="N, mm, C")]),
        ("LINK PROPERTY DEFINITIONS 01 - GENERAL", [_general(one) for one in links]),
        (
            "LINK PROPERTY DEFINITIONS 08 - SLIDING ISOLATOR",
            [row for one in links for row in _directions(one)],
        ),
    ]
    lines = [line for name, rows in tables for line in ("", f'TABLE:  "{name}"', *rows)]
    return "\n".join([*head, *lines, "", "END TABLE DATA", ""])


def _comment(sentence: str) -> list[str]:
    plain = "".join(one if one.isprintable() else "?" for one in " ".join(sentence.split()))
    return [f"$ {line}" for line in textwrap.wrap(plain, _WIDTH, break_long_words=False)]


def _row(**fields: str | float) -> str:
    return "   " + "   ".join(f"{name}={_value(value)}" for name, value in fields.items())


def _value(value: str | float) -> str:
    if isinstance(value, str):
        return value if re.fullmatch(r"[A-Za-z0-9_.+-]+", value) else f'"{value}"'
    return f"{value:.9g}"


def _general(link: LinkProperty) -> str:
    above = left_behind(link.system)
    parts = {"PDM2I": 1.0 - above, "PDM2J": above, "PDM3I": 1.0 - above, "PDM3J": above}
    inertia = dict.fromkeys(("Mass", "Weight", "RotInert1", "RotInert2", "RotInert3"), 0.0)
    return _row(Link=link.name, LinkType="Friction Isolator", **inertia, DefLength=1.0, DefArea=1.0, **parts)


def _directions(link: LinkProperty) -> Iterator[str]:
    vertical = link.load / _SQUEEZED
    yield _row(
        Link=link.name, DOF="U1", Fixed="No", NonLinear="Yes", TransKE=vertical, TransCE=0.0, TransK=vertical
    )
    for direction in ("U2", "U3"):
        yield _row(
            Link=link.name, DOF=direction, Fixed="No", NonLinear="Yes",
            TransKE=link.effective_stiffness, TransCE=link.effective_damping, DJ=0.0, TransK=link.stiffness,
            Slow=link.slow, Fast=link.fast, Rate=link.rate, Radius=link.radius,
        )  # fmt: skip


def _head(plan: Plan, links: list[LinkProperty]) -> Iterator[str]:
    yield f"{plan.name}: link properties of the kind Friction Isolator for its bearings, written by dcfp {version()}. Units: N, mm, s, degC."
    yield (
        "Direction 1 is vertical, from the ground (end I) to the slab (end J). Import it into a model (File > Import > SAP2000 .s2k Text File), and draw a link with"
        " its property at each bearing. ETABS has the same fields in the form of a link property, in which to type them; how they stand in its .e2k file was found in no source."
    )
    for link in links:
        yield from _told(plan, link)
    yield (
        "What the links cannot be: their friction knows neither heat nor pressure, but follows the vertical force at once; two plates are one with the sum of their radii, whose"
        " speed is the relative speed of the plates; friction in two directions is a rule of two coupled hysteretic variables (Park, Wen and Ang 1986), which is not quite the"
        " same in every direction; displacement has no end."
    )
    yield (
        "PDM2I to PDM3J share the moment of the load on its displacement between the ends as the sliders do, which stay behind the slab by the share of the upper plate."
    )
    yield (
        f"The vertical stiffness is no property of a bearing in dcfp: TransK of U1 is that by which the design load squeezes it by {_SQUEEZED:g} mm; put the manufacturer's in its place."
    )
    yield (
        "Confirmed by lines that SAP2000 has written, as readers of its files quote them: the names of both tables and their fields, those of U2 and U3 with Slow, Fast, Rate and"
        " Radius, and the units in PROGRAM CONTROL; by its manual: what these mean. Unconfirmed: the word of LinkType, the fields of U1 (taken from those of the Triple"
        " Pendulum), PROGRAM CONTROL without a version, and that lines with a dollar before the first table are passed over; delete them if they are not."
    )


def _told(plan: Plan, link: LinkProperty) -> Iterator[str]:
    """Yield sentences about one type: what it is, and how far from it the law is elsewhere."""
    system = link.system
    yield (
        f"{link.name}: {link.count} bearing{'s' if link.count > 1 else ''} under {link.least_load / 1e3:.0f} to {link.largest_load / 1e3:.0f} kN, taken at the mean of {link.load / 1e3:.0f} kN"
        f" ({link.pressure:.1f} N/mm2) and {link.temperature:g} degC. Friction {system.friction.name}: Slow {link.slow:.4f}, Fast {link.fast:.4f}, Rate {link.rate:.4g} s/mm;"
        f" the largest difference to the law from 0 to 1 m/s is {link.misfit:.2g}."
    )

    def fast(load: float, temperature: float) -> float:
        return float(_coefficients(system, load, temperature, _SPEEDS[-1:])[0])

    elsewhere = [
        (f"under {link.least_load / 1e3:.0f} kN", fast(link.least_load, link.temperature)),
        (f"under {link.largest_load / 1e3:.0f} kN", fast(link.largest_load, link.temperature)),
        (f"at {link.temperature + _HOTTER:g} degC", fast(link.load, link.temperature + _HOTTER)),
    ]
    differs = [f"{one:.4f} {where}" for where, one in elsewhere if abs(one / link.fast - 1.0) > 1e-3]
    if differs:
        yield f"The law of {link.name} gives at 1 m/s {', '.join(differs)}."
    if plan.spring == BY_LOAD and link.largest_load > link.least_load:
        yield f"TransK of {link.name} is that of the mean load; in dcfp it goes with the static load of each bearing."
    if link.displacement is None:
        yield f"No design displacement of {link.name} was given: TransKE of U2 and U3 is the stiffness of the pendulum alone, and TransCE zero."
    else:
        yield (
            f"TransKE and TransCE of U2 and U3 are for linear analyses at {link.displacement:g} mm: N/R + mu N/D, and a dashpot with"
            f" {100.0 * (link.damping_ratio or 0.0):.1f} % of critical damping under the mass of the load."
        )
