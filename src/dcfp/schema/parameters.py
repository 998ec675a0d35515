"""What there is to know of a parameter (words, unit, limits, symbol, names), and what every door does with it: read, check, write, ask for another unit."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from typing import Any, cast

from dcfp.errors import InputError
from dcfp.schema.toml_places import at_key
from dcfp.schema.units import HERTZ, M_PER_S, NONE, SECOND, WORDS, Unit, convert, split_number

#: TOML and JSON have whole numbers of any length: from here on they are no numbers to calculate with.
_LARGEST_WHOLE = 10**15


@dataclass(frozen=True)
class Parameter:
    r"""What there is to know of one parameter.

    Attributes
    ----------
    words, symbol
        What it is, in a few words without an article; in LaTeX.
    unit
        In which a plain number is taken at every door but Python, where all is in the package's units.
    least, most, above
        Limits, in that unit: what a wrong unit would pass; whether the least value itself is not allowed.
    key, aliases
        Name in files, options, factors and forms, by default that of the field; further names in files.
    more, step, absent
        What else the help of an option says; by how much the buttons of a form's field change it, and what it says when it is empty.
    choices
        Words of which it must be one.
    counts, repeat
        How many numbers it may be, empty for one number; for how many of several a single one stands.
    option, vary
        Whether it is an option of the command line, and whether a study may vary it.
    difference
        Whether it is a difference, such as a standard deviation: 5 °C are then 9 °F.
    name, kind, default, optional
        Of the field; filled in by `declared`.
    """

    words: str
    unit: Unit = WORDS
    least: float = -math.inf
    most: float = math.inf
    symbol: str = ""
    key: str = ""
    aliases: tuple[str, ...] = ()
    more: str = ""
    step: float | None = None
    choices: tuple[str, ...] = ()
    counts: tuple[int, ...] = ()
    repeat: int = 1
    above: bool = False
    option: bool = True
    vary: bool = True
    absent: str = ""
    difference: bool = False
    name: str = ""
    kind: type = float
    default: Any = None
    optional: bool = False

    @property
    def is_number(self) -> bool:
        """Whether it is one number or several."""
        return self.kind in (float, int)

    @cached_property
    def limits(self) -> tuple[float, float]:
        """Limits in the package's unit."""
        return self.unit.inner(self.least), self.unit.inner(self.most)

    def rule(self, unit: Unit | None = None) -> str:
        """Return what must hold of a value given in `unit`, to stand behind ``must be``."""
        if self.choices:
            return f"one of {', '.join(self.choices)}"
        if self.kind is bool:
            return "true or false"
        if self.kind is str:
            return "a text"
        unit = unit or self.unit
        of_unit = f" of {unit.text}" if unit.has_dimension else ""
        several = f", or {max(self.counts)} of them," if len(self.counts) > 1 else ""
        number = f"{'a whole number' if self.kind is int else 'a number'}{of_unit}{several}"
        if self.counts and 1 not in self.counts:
            number = f"{self.counts[0]} numbers{of_unit}"
        least, most = (unit.shown(limit) for limit in self.limits)
        if math.isfinite(least) and math.isfinite(most):
            number += f" above {least:g} and" if self.above else f" from {least:g}"
            return f"{number} {'up to' if self.above else 'to'} {most:g}"
        if math.isfinite(least):
            return f"{number} {'above' if self.above else 'of at least'} {least:g}"
        return number

    def is_plain(self, value: Any) -> bool:
        """Whether a value in the package's unit is allowed as it is: at a glance, for what is made in every analysis."""
        if value is None:
            return self.optional
        if type(value) is not self.kind or self.choices or self.counts:
            return False
        return self.kind is bool or (self.kind is float and math.isfinite(value) and self._holds(value))

    def checked(self, value: Any, label: str, unit: Unit | None = None, given: object = None) -> Any:
        """Return a value given in `unit` in the package's unit, if it is allowed.

        Parameters
        ----------
        value
            As it was given.
        label
            What it is called at the door where it was given, to begin a complaint with.
        unit
            Of a plain number; by default the package's.
        given
            How it was written, where that is not the value itself.

        Raises
        ------
        InputError
            If it is not allowed.
        """
        unit = unit or self.unit.inner_unit
        given = value if given is None else given
        if self.optional and (value is None or (self.choices and value == "")):
            return None
        if isinstance(value, str) and value in self.choices:
            return value
        if isinstance(value, str) and self.choices:
            known = {one.lower(): one for one in self.choices}
            if value.strip().lower() in known:
                return known[value.strip().lower()]
        if self.choices or (self.kind is bool) != isinstance(value, bool):
            raise self._refusal(value, label, unit, given)
        if self.kind is bool:
            return value
        if self.kind is str:
            if not isinstance(value, str):
                raise self._refusal(value, label, unit, given)
            return value
        if not self.counts:
            return self._number(value, label, unit, given)
        if not isinstance(value, (list, tuple)):
            value = [value] * self.repeat
        values = list(cast("Iterable[Any]", value))
        if len(values) not in self.counts:
            msg = f"{label} must be {self.rule(unit)}, not {len(values)} of them."
            raise InputError(msg)
        return tuple(self._number(one, label, unit, one if len(values) > 1 else given) for one in values)

    def read(self, value: Any, label: str, unit: str | None = None) -> Any:
        """Return a value of a file, an option or a form in the package's unit: a plain number is in `unit` or else in the declared one, a text may name another.

        Raises
        ------
        InputError
            If it is not allowed.
        """
        found = value
        if self.is_number:
            if isinstance(value, (list, tuple)):
                found = [self._with_unit(one, label, unit) for one in cast("Iterable[Any]", value)]
            else:
                found = self._with_unit(value, label, unit)
        return self.checked(found, label, self.unit, cast("object", value))

    def written(self, value: Any) -> Any:
        """Return a value in the declared unit, as a file holds it."""
        if isinstance(value, tuple):
            return [self.written(one) for one in cast("tuple[Any, ...]", value)]
        return self.unit.shown(value) if self.kind is float and value is not None else value

    def text(self, value: Any) -> str:
        """Return a value in words, with its declared unit."""
        if value is None or value == "":
            return self.absent or "not given"
        if isinstance(value, bool):
            return "yes" if value else "no"
        if isinstance(value, tuple):
            numbers = ", ".join(f"{self.unit.shown(one):.6g}" for one in cast("tuple[float, ...]", value))
        else:
            numbers = f"{self.unit.shown(value):.6g}" if self.is_number else str(value)
        return f"{numbers} {self.unit.name}" if self.unit.has_dimension else numbers

    @property
    def sentence(self) -> str:
        """Words for a docstring, with the symbol and the package's unit."""
        symbol = f", :math:`{self.symbol}`" if self.symbol else ""
        unit = f" {self.unit.inner_unit.heading}" if self.is_number else ""
        without = f"; None: {self.absent}" if self.optional and self.absent else ""
        return f"{self.words[:1].upper()}{self.words[1:]}{symbol}{unit}{without}."

    @property
    def help(self) -> str:
        """Words for a list of options, with the unit and the default."""
        parts = [
            f"{self.words} {self.unit.heading}" if self.is_number else self.words,
            *([self.more] if self.more else []),
        ]
        if self.choices:
            parts[0] += f": {', '.join(self.choices)}"
        if self.default is not None and self.default != "":
            default = self.written(self.default)
            values = list(
                dict.fromkeys(cast("list[float]", default) if isinstance(default, list) else [default])
            )
            written = " ".join(f"{one:g}" if self.is_number else str(one) for one in values)
            parts.append(f"default {written.lower() if self.kind is bool else written}")
        return "; ".join(parts)

    def _with_unit(self, value: Any, label: str, unit: str | None) -> Any:
        """Return a number of that unit, or of a text such as ``"4.5 m"``, in the declared unit; what is neither is returned as it is."""
        number, own = value, ""
        if isinstance(value, str):
            number, own = split_number(value) or (value, "")
        named = own or unit
        if named is None or isinstance(number, bool) or not isinstance(number, (int, float)):
            return number
        return convert(number, named, self.unit, label, difference=self.difference)

    def _number(self, value: Any, label: str, unit: Unit, given: object) -> float:
        if hasattr(value, "item") and getattr(value, "ndim", None) == 0:  # a number of NumPy
            value = value.item()
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise self._refusal(value, label, unit, given)
        if isinstance(value, int) and abs(value) >= _LARGEST_WHOLE:
            raise self._refusal(value, label, unit, given)
        inner = unit.inner(value)
        whole = self.kind is not int or float(value).is_integer()
        if not (math.isfinite(inner) and whole and self._holds(inner)):
            raise self._refusal(value, label, unit, given)
        return int(inner) if self.kind is int else float(inner)

    def _holds(self, inner: float) -> bool:
        least, most = self.limits
        return (least < inner if self.above else least <= inner) and inner <= most

    def _refusal(self, value: Any, label: str, unit: Unit, given: object) -> InputError:
        found = f"{given:g}" if isinstance(given, float) else repr(given)[:60]
        return InputError(
            f"{label} must be {self.rule(unit)}, not {found}{self._meant(value, unit)}.".strip()
        )

    def _meant(self, value: Any, unit: Unit) -> str:
        """Return the question whether another unit was meant, if there is one in which the number would be allowed."""
        if isinstance(value, bool) or not isinstance(value, (int, float)) or abs(value) >= _LARGEST_WHOLE:
            return ""
        near = [name for name, size in unit.meant if self._holds(unit.inner(value * size))]
        return f" (were {near[0]} meant?)" if near else ""


def read_values(
    known: Iterable[Parameter],
    table: Mapping[str, Any],
    where: str,
    noun: str,
    *,
    also: tuple[str, ...] = (),
) -> dict[str, Any]:
    """Return the values of a table in the package's units by the names of the parameters.

    Parameters
    ----------
    known
        The parameters that it may hold; `noun` is what one of them is called.
    table
        Values by their keys.
    where
        What to begin a complaint with.
    also
        What else such a file may hold, for the sentence.

    Raises
    ------
    InputError
        If there is an unknown key or a value that is not allowed.
    """
    by_key = {key: one for one in known for key in (one.key, *one.aliases)}
    values: dict[str, Any] = {}
    for key, value in table.items():
        place = at_key(where, key)
        if key not in by_key:
            msg = f"{place}: {unknown(key, [*by_key, *also], noun)}"
            raise InputError(msg)
        one = by_key[key]
        name = one.name or one.key
        if name in values:
            msg = f"{place}: give either {' or '.join((one.key, *one.aliases))}, not both."
            raise InputError(msg)
        values[name] = one.read(value, f"{place}: {key}: {one.words}")
    return values


def table_in(content: Mapping[str, Any], key: str, where: str = "", shown: str = "") -> dict[str, Any]:
    """Return the table of a file, or of a table in it, under a key: empty where there is none.

    Parameters
    ----------
    content
        Of the file, or of a table in it.
    key
        Of the table.
    where
        What to begin a complaint with.
    shown
        How its head is written; by default the key.

    Raises
    ------
    InputError
        If it is no table; the sentence begins with `where`, and writes its head as `shown`, by default as the key.
    """
    table = content.get(key, {})
    if not isinstance(table, Mapping):
        prefix = f"{where}: " if where else ""
        msg = f"{prefix}{key!r} must be a table, written [{shown or key}]."
        raise InputError(msg)
    return dict(cast("Mapping[str, Any]", table))


def refuse_other(
    value: object, kinds: type | tuple[type, ...], name: str, wanted: str, names: Iterable[str] = ()
) -> None:
    """Refuse what is of none of the kinds; `wanted` stands behind ``must be``, and behind it the names that may be given.

    Raises
    ------
    InputError
        If it is not.
    """
    if not isinstance(value, kinds):
        raise InputError(other(value, name, wanted, names))


def other(value: object, name: str, wanted: str, names: Iterable[str] = ()) -> str:
    """Return the sentence that a value is not what is wanted; arguments as for `refuse_other`."""
    known = f" ({', '.join(names)})" if names else ""
    return f"{name} must be {wanted}{known}, not {value!r}."


def unknown(given: object, known: Iterable[str], what: str) -> str:
    """Return the sentence that there is no such thing, `what`, with the name that is probably meant."""
    known = list(known)
    near = get_close_matches(str(given), known, n=1)
    meant = f"did you mean {near[0]!r}?" if near else f"the choices are {', '.join(known)}."
    return f"there is no {what} {given!r}; {meant}"


#: What has no other limit.
POSITIVE = Parameter("positive number", NONE, 0.0, above=True)
#: What a ground motion can be scaled to, at every door.
PGV = Parameter("peak ground velocity", M_PER_S, 0.005, 20.0, symbol=r"\mathrm{PGV}", key="pgv")
#: How a record file is read, and how what it holds may be treated.
TIME_STEP = Parameter("time step of a plain file with one column", SECOND, 0.0, above=True, key="time_step")
HIGH_PASS = Parameter("corner of a zero-phase Butterworth high-pass filter", HERTZ, 0.0, above=True, key="high_pass")  # fmt: skip
