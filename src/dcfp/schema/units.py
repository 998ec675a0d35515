"""Units that numbers are given and shown in; inside, all is in N, mm, s and degC, and so in t, N/mm2 and mm/s2."""

import re
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import Any

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError

#: What the text of a unit is written with, and how many powers it may have.
_UNIT = re.compile(r"[A-Za-z0-9_*/^. ()°µ²³%-]{0,60}")
_MOST_POWERS = 4
#: A number with its unit behind it.
_NUMBER_WITH_UNIT = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")


@dataclass(frozen=True)
class Unit:
    """A unit that numbers are given or shown in.

    Attributes
    ----------
    name, udunits, typed
        As it is shown; as UDUNITS writes it, for data sets; as it is typed in files and sentences, empty where that is its name.
    size, zero
        One of this unit in the units of the package; what zero of the package's unit is in this one.
    meant
        Units that are probably meant where a number is out of range, with the size of one of them in this unit.
    base
        The package's own unit for the same quantity; None where it is this one.
    """

    name: str
    size: float = 1.0
    udunits: str = ""
    typed: str = ""
    meant: tuple[tuple[str, float], ...] = ()
    base: "Unit | None" = None
    zero: float = 0.0

    @property
    def text(self) -> str:
        """The unit as it is typed."""
        return self.typed or self.name

    @property
    def has_dimension(self) -> bool:
        """Whether there is a unit to write at all."""
        return self.udunits not in ("", "1")

    @property
    def heading(self) -> str:
        """The unit in square brackets, as it stands in ASCII in the head of a column; ``[-]`` where there is none."""
        return f"[{self.text if self.has_dimension else '-'}]"

    @property
    def inner_unit(self) -> "Unit":
        """The package's own unit for the same quantity."""
        return self if self.base is None else self.base

    def shown(self, value: Any) -> Any:
        """Return a number or an array of the package's unit in this one."""
        return value if self.size == 1.0 else value / self.size + self.zero

    def inner(self, value: Any) -> Any:
        """Return a number or an array of this unit in that of the package."""
        return value if self.size == 1.0 else (value - self.zero) * self.size


#: Neither number nor unit: words.
WORDS = Unit("")
#: A number without a dimension.
NONE = Unit("–", udunits="1", typed="1")
FRACTION = Unit("–", udunits="1", typed="1", meant=(("%", 0.01),))
MM = Unit("mm", 1.0, "mm", meant=(("m", 1000.0),))
CM = Unit("cm", 10.0, "cm", base=MM)
INCH = Unit("in", 25.4, "inch", base=MM)
METRE = Unit("m", 1e3, "m", meant=(("mm", 1e-3),), base=MM)
KM = Unit("km", 1e6, "km", meant=(("m", 1e-3),), base=MM)
SECOND = Unit("s", 1.0, "s", meant=(("ms", 1e-3),))
MILLISECOND = Unit("ms", 1e-3, "ms", base=SECOND)
HERTZ = Unit("Hz", 1.0, "Hz")
MM_PER_S = Unit("mm/s", 1.0, "mm s-1", meant=(("m/s", 1000.0),))
M_PER_S = Unit("m/s", 1e3, "m s-1", meant=(("mm/s", 1e-3), ("cm/s", 1e-2)), base=MM_PER_S)
CM_PER_S = Unit("cm/s", 10.0, "cm s-1", base=MM_PER_S)
INCH_PER_S = Unit("in/s", 25.4, "inch s-1", base=MM_PER_S)
MM_PER_S2 = Unit("mm/s²", 1.0, "mm s-2", "mm/s2", meant=(("m/s2", 1000.0), ("g_0", 9806.65)))
MM2_PER_S2 = Unit("mm²/s²", 1.0, "mm2 s-2", "mm2/s2")
M_PER_S2 = Unit("m/s²", 1e3, "m s-2", "m/s2", base=MM_PER_S2)
GRAVITY = Unit("g", STANDARD_GRAVITY, "9.80665 m s-2", "g_0", base=MM_PER_S2)
NEWTON = Unit("N", 1.0, "N", meant=(("kN", 1e3),))
KN = Unit("kN", 1e3, "kN", meant=(("N", 1e-3), ("MN", 1e3)), base=NEWTON)
MEGANEWTON = Unit("MN", 1e6, "MN", base=NEWTON)
KIP = Unit("kip", 4448.2216152605, "1000 lbf", base=NEWTON)
N_PER_MM = Unit("N/mm", 1.0, "N mm-1", meant=(("kN/mm", 1e3),))
KN_PER_MM = Unit("kN/mm", 1e3, "kN mm-1", meant=(("MN/mm", 1e3), ("N/mm", 1e-3)), base=N_PER_MM)
N_S_PER_MM = Unit("N s/mm", 1.0, "N s mm-1")
KN_S_PER_MM = Unit("kN s/mm", 1e3, "kN s mm-1", base=N_S_PER_MM)
N_PER_MM2 = Unit("N/mm²", 1.0, "N mm-2", "N/mm2", meant=(("kN/mm2", 1e3), ("kPa", 1e-3), ("Pa", 1e-6)))
N_MM = Unit("N mm", 1.0, "N mm")
KN_M = Unit("kN m", 1e6, "kN m", base=N_MM)
KIP_FT = Unit("kip ft", KIP.size * 12.0 * INCH.size, "1000 lbf ft", base=N_MM)
TONNE = Unit("t", 1.0, "t", meant=(("kg", 1e-3),))
TONNE_MM2 = Unit("t mm²", 1.0, "t mm2", "t*mm2")
TONNE_M2 = Unit("t m²", 1e6, "t m2", "t*m2", base=TONNE_MM2)
DEGC = Unit("°C", 1.0, "degC", "degC")
DEGF = Unit("°F", 1.0 / 1.8, "degF", "degF", base=DEGC, zero=32.0)
PER_DEGC = Unit("1/°C", 1.0, "degC-1", "1/degC")
CONDUCTIVITY = Unit("N/(s °C)", 1.0, "N s-1 K-1", "N/(s*K)")
DIFFUSIVITY = Unit("mm²/s", 1.0, "mm2 s-1", "mm2/s", meant=(("m2/s", 1e6),))
S_PER_MM = Unit("s/mm", 1.0, "s mm-1", meant=(("s/m", 1e-3),))
N_PER_S = Unit("N/s", 1.0, "N s-1")
DEGREE = Unit("°", 1.0, "degree", "deg")
PERCENT = Unit("%", 0.01, "%", base=NONE)


def split_number(text: str) -> tuple[float, str] | None:
    """Return the number and the unit of a text such as ``"4.5 m"``; None where it does not begin with a number."""
    found = _NUMBER_WITH_UNIT.fullmatch(text)
    return None if found is None else (float(found[1]), found[2])


def convert(value: float, unit: str, wanted: Unit, label: str, *, difference: bool = False) -> float:
    """Return a number with a unit in another one.

    Parameters
    ----------
    value, unit
        The number and its unit, as a user has written them.
    wanted
        The unit to return it in.
    label
        What the number is of, to begin a complaint with.
    difference
        Whether it is a difference, such as a standard deviation: 5 degC then are 5 K.

    Raises
    ------
    InputError
        If the unit is not known, or one of something else.
    """
    try:
        given, own = _parsed(unit), _parsed(wanted.text if wanted.has_dimension else "")
        same_kind = given.is_compatible_with(own) and "bel" not in str(given)
    except Exception as error:  # pint lets through whatever the parser below it raises
        msg = f"{label}: {unit!r} is not a unit; write for example {wanted.text!r}."
        raise InputError(msg) from error
    if not same_kind:
        hint = "; the acceleration of gravity is 'g_0', and 'g' the gram" if unit == "g" else ""
        msg = f"{label} is in {wanted.text if wanted.has_dimension else 'no unit'}, with which {unit!r} is not compatible{hint}."
        raise InputError(msg)
    if given == own:
        return value
    zero = _converted(0.0, given, own) if difference else 0.0
    # 68 degF are 20 degC, not 20.000000000000057
    return float(f"{_converted(value, given, own) - zero:.13g}")


@cache
def _registry() -> Any:
    pint: Any = import_module("pint")  # late: it takes a fifth of a second to import
    return pint.UnitRegistry(autoconvert_offset_to_baseunit=True)


def _parsed(unit: str) -> Any:
    if not _UNIT.fullmatch(unit) or unit.count("**") + unit.count("^") > _MOST_POWERS or "**" in unit[:1]:
        raise ValueError(unit)
    if re.search(r"\*\*\s*[0-9.]+\s*\*\*", unit):  # a tower of powers takes for ever
        raise ValueError(unit)
    # N/mm2 is how tables write N/mm**2
    return _registry().Unit(re.sub(r"(?<=[A-Za-z])(?=[2-4]\b)", "**", unit))


def _converted(value: float, given: Any, own: Any) -> float:
    return float(_registry().Quantity(value, given).to(own).magnitude)
