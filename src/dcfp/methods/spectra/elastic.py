"""What the methods of codes take of a spectrum, and a spectrum of the user's own from a file of columns."""

import re
from abc import abstractmethod
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.motion.formats.source import SourceText, canonical_unit, read_source, to_number, unit_size
from dcfp.schema.declared import Declared, parameters
from dcfp.schema.notebook import fields_card
from dcfp.schema.parameters import Parameter
from dcfp.schema.registry import Registry
from dcfp.schema.units import MM_PER_S2, SECOND


class ElasticSpectrum(Protocol):
    """An elastic spectrum at a damping of 5 %."""

    @property
    @abstractmethod
    def name(self) -> str:
        """What to call it."""

    @property
    def unconfirmed(self) -> tuple[str, ...]:
        """What in it could not be confirmed in its source; nothing where all could."""
        return ()

    @abstractmethod
    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration S_a [mm/s2] at a period [s]."""


def displacement(spectrum: ElasticSpectrum, period: ArrayLike) -> FloatArray:
    """Spectral displacement S_d = S_a (T / 2 pi)^2 [mm] at a period [s]."""
    return spectrum.acceleration(period) * (np.asarray(period) / (2.0 * np.pi)) ** 2


def velocity(spectrum: ElasticSpectrum, period: ArrayLike) -> FloatArray:
    """Pseudo-velocity S_v = S_a T / 2 pi [mm/s] at a period [s]."""
    return spectrum.acceleration(period) * np.asarray(period) / (2.0 * np.pi)


#: Classes of design spectra by the names of their options.
DESIGN_SPECTRA: "Registry[type[DesignSpectrum]]" = Registry("design spectrum")


class DesignSpectrum(Declared, ElasticSpectrum):
    """An elastic spectrum of a code; a class with an ``option`` of its own registers itself.

    Its first parameters stand behind that option, the others have options of their own.
    """

    option: ClassVar[str]  #: name of the option that chooses it
    words: ClassVar[str]  #: what stands behind the option, for its help
    behind: ClassVar[tuple[int, int]] = (1, 1)  #: how many parameters stand behind it, at least and at most
    doubts: ClassVar[tuple[str, ...]] = ()  #: what in it could not be confirmed in its source

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if "option" in cls.__dict__:
            DESIGN_SPECTRA.add(cls.option, cls)

    @classmethod
    def own_options(cls) -> dict[str, Parameter]:
        """Return the parameters that have options of their own, by their keys."""
        behind = list(parameters(cls).values())[cls.behind[1] :]
        return {one.key: one for one in behind if one.option}

    @property
    def unconfirmed(self) -> tuple[str, ...]:
        """What in it could not be confirmed in its source."""
        return self.doubts


@dataclass(frozen=True, eq=False)
class TabulatedSpectrum:
    """Pseudo-accelerations at periods, with straight lines between their logarithms.

    Below the first period the acceleration is that of the first, beyond the last the displacement is that of the last.

    Raises
    ------
    InputError
        If there are fewer than two periods, or a value is not positive, or the periods do not increase.
    """

    periods: FloatArray = field(metadata={"unit": SECOND})  #: [s], increasing, shape (n,)
    accelerations: FloatArray = field(metadata={"unit": MM_PER_S2})  #: positive [mm/s2], shape (n,)
    name: str = "spectrum"  #: what to call it
    unconfirmed: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        periods = np.asarray(self.periods, dtype=np.float64)
        values = np.asarray(self.accelerations, dtype=np.float64)
        if periods.ndim != 1 or periods.size < 2 or periods.shape != values.shape:
            msg = f"{self.name}: a spectrum needs at least two periods, and an acceleration for each."
            raise InputError(msg)
        good = np.isfinite(periods).all() and np.isfinite(values).all()
        if not (good and (periods > 0.0).all() and (values > 0.0).all() and (np.diff(periods) > 0.0).all()):
            msg = f"{self.name}: periods and accelerations of a spectrum must be positive, and the periods increase."
            raise InputError(msg)
        object.__setattr__(self, "periods", freeze(periods))
        object.__setattr__(self, "accelerations", freeze(values))

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration [mm/s2] at a period [s]."""
        wanted = np.asarray(period, dtype=np.float64)
        within = np.clip(wanted, self.periods[0], self.periods[-1])
        found = np.exp(np.interp(np.log(within), np.log(self.periods), np.log(self.accelerations)))
        beyond = np.maximum(wanted / self.periods[-1], 1.0)
        return np.asarray(found / beyond**2)

    def _repr_html_(self) -> str:
        return fields_card(self, f"Spectrum {self.name}")


_EXAMPLE = "'period [s], acceleration [g]'"
_PERIOD, _ACCELERATION = "period", "acceleration"
#: Spellings of the two columns, without blanks and underscores.
_NAMES = {
    _PERIOD: {"period", "naturalperiod", "t"},
    _ACCELERATION: {"acceleration", "spectralacceleration", "pseudoacceleration", "sa", "psa", "se"},
}
_SECONDS = {"s", "sec", "second", "seconds"}
#: A comment: from a hash on, or a whole line that begins with another mark.
_COMMENT = re.compile(r"#.*|^\s*(?:%|//|!).*")
#: Name and unit of a column; what else a name may carry, as in "Sa (5 %) [g]".
_COLUMN = re.compile(r"(.*)[\[(]([^\[\]()]*)[\])]\s*")
_EXTRAS = re.compile(r"\(.*?\)|\d+\s*%|[\s_\-\"']")


def read_spectrum(path: str | Path, name: str | None = None) -> TabulatedSpectrum:
    """Return the spectrum of a file: periods and pseudo-accelerations at a damping of 5 %.

    The first line names the columns with their units, ``period [s]`` and ``acceleration [g]`` (or m/s2, cm/s2, gal, mm/s2), in any
    order and beside any others. Columns are parted by commas, semicolons, tabs or blanks; where it is semicolons or tabs, a decimal
    comma is understood. Blank lines, what follows a ``#``, and lines that begin with ``%``, ``//`` or ``!`` do not count.

    Parameters
    ----------
    path
        Name of the file.
    name
        What to call the spectrum; the file's name by default.

    Raises
    ------
    InputError
        If the file cannot be read, has no such header or fewer than two rows, or a value is not a positive number, or the periods do not increase.
    """
    source = read_source(Path(path), what=f"a spectrum with a header such as {_EXAMPLE}")
    bare = ((number, _COMMENT.sub("", line).rstrip()) for number, line in enumerate(source.lines, 1))
    lines = [(number, line) for number, line in bare if line.strip(" \t,;")]
    if not lines:
        source.fail(f"the file is empty; it must begin with a header such as {_EXAMPLE}.")
    number, header = lines[0]
    separator = next(
        (mark for mark in ("\t", ";", ",") if mark in header), None
    )  # blanks, where there is none
    heads = _split(header, separator, is_header=True)
    (first, time), (second, unit) = (_column(source, number, heads, what) for what in _NAMES)
    if time.lower() not in _SECONDS:
        source.fail(f"the periods are in {time!r}, and must be in s.", line=number)
    if canonical_unit(unit) is None:
        source.fail(f"the accelerations are in {unit!r}; use one of g, m/s2, cm/s2, gal, mm/s2.", line=number)
    periods: list[float] = []
    values: list[float] = []
    for number, line in lines[1:]:
        words = _split(line, separator)
        if len(words) != len(heads):
            source.fail(
                f"{len(words)} values stand where the header names {len(heads)} columns.", line=number
            )
        period = _value(source, number, words[first], _PERIOD, separator)
        if periods and period <= periods[-1]:
            what = f"the period of {period:g} s follows that of {periods[-1]:g} s; they must increase."
            source.fail(what, line=number)
        periods.append(period)
        values.append(_value(source, number, words[second], _ACCELERATION, separator) * unit_size(unit))
    if len(periods) < 2:
        source.fail(f"a spectrum needs at least two rows below its header, and this one has {len(periods)}.")
    return TabulatedSpectrum(np.array(periods), np.array(values), Path(path).stem if name is None else name)


def _split(line: str, separator: str | None, *, is_header: bool = False) -> list[str]:
    if separator is not None:
        words = line.split(separator)
    elif is_header:  # a blank before a unit parts nothing
        words = re.split(r"(?<=[\])])\s+(?![\[(])", line.strip())
    else:
        words = line.split()
    while len(words) > 1 and not words[-1].strip():  # a separator at the end of the line
        words.pop()
    return words


def _column(source: SourceText, number: int, heads: list[str], what: str) -> tuple[int, str]:
    """Return the place of a column and its unit."""
    found = [
        (place, parts[2].strip() if parts else "", word.strip())
        for place, word in enumerate(heads)
        for parts in [_COLUMN.fullmatch(word.strip().strip("\"'"))]
        if _EXTRAS.sub("", parts[1] if parts else word).lower() in _NAMES[what]
    ]
    if not found:
        source.fail(f"the header names no column of {what}; it must be such as {_EXAMPLE}.", line=number)
    if len(found) > 1:
        source.fail(f"the header names two columns of {what}, and only one can count.", line=number)
    place, unit, word = found[0]
    if not unit:
        source.fail(f"the column {word!r} has no unit; write it in brackets, as in {_EXAMPLE}.", line=number)
    return place, unit


def _value(source: SourceText, number: int, word: str, what: str, separator: str | None) -> float:
    plain = word.strip().strip("\"'")
    if separator in {";", "\t"}:
        plain = plain.replace(",", ".")
    value = to_number(plain)
    if value is None:
        source.fail(f"the {what} is {word.strip()[:30]!r}, not a number.", line=number)
    if value <= 0.0:
        is_ground = what == _PERIOD and value == 0.0
        hint = "; leave out the row of the ground's own acceleration" if is_ground else ""
        source.fail(f"the {what} is {value:g}, and must be positive{hint}.", line=number)
    return value
