"""Formulas with their numbers put in, as a law or a method of prediction brings them; whoever writes them down says in what.

The mathematics is in the small part of Typst's syntax that `dcfp.present.report.maths` reads.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Formula:
    """A formula with its numbers put in.

    Attributes
    ----------
    name
        What it gives, in words.
    symbols, numbers
        Mathematics: in symbols from the left side on, and the right side in numbers; `numbers` is empty for a value that is taken as it is.
    value, decimals, unit
        Its result, how many decimals of it are written, and its unit; empty for none.
    source, confirmed
        Paper and equation, code and clause; whether that could be confirmed there.
    """

    name: str
    symbols: str
    numbers: str
    value: float
    decimals: int
    unit: str
    source: str
    confirmed: bool = True

    @property
    def result(self) -> str:
        """The result as mathematics, with its unit."""
        return number(self.value, self.decimals) + (f' thin "{self.unit}"' if self.unit else "")

    @property
    def lines(self) -> tuple[str, ...]:
        """Parts of the mathematics between which a line may be broken."""
        return (
            self.symbols,
            *((f"= {self.numbers}",) if self.numbers else ()),
            f"= {self.result}",
        )

    @property
    def origin(self) -> str:
        """Where it is from, as it is printed beside it."""
        return self.source if self.confirmed else f"{self.source}, unconfirmed"

    def as_numbers(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        told = ("name", "value", "unit", "decimals", "source", "confirmed")
        return {name: getattr(self, name) for name in told}


@dataclass(frozen=True)
class Expression:
    """The right side of an equation of one variable, to be written in symbols and in numbers.

    Attributes
    ----------
    form
        Mathematics with ``{x}`` for the variable, ``{dot}`` for a multiplication that has a sign in numbers only, and names of `constants` in braces.
    variable
        Symbol of the variable.
    constants
        Symbol and digits of constants by their names in `form`; one that is a number in both stands in `form` itself.
    """

    form: str
    variable: str
    constants: Mapping[str, tuple[str, str]] = field(default_factory=dict[str, tuple[str, str]])

    @property
    def symbols(self) -> str:
        """The expression in symbols."""
        names = {name: symbol for name, (symbol, _) in self.constants.items()}
        return self.form.format(x=self.variable, dot=" ", **names)

    def numbers(self, digits: str) -> str:
        """Return the expression in numbers, at a variable in digits."""
        values = {name: value for name, (_, value) in self.constants.items()}
        return self.form.format(x=digits, dot=" times ", **values)


def number(value: float, decimals: int) -> str:
    """Return a number as mathematics has it: with a hyphen for minus, and none before a zero."""
    text = f"{value:.{decimals}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def true_minus(text: str) -> str:
    """Return a number, or words with numbers, with true minus signs for hyphens."""
    return text.replace("-", "−")


def typeset(value: float, decimals: int = 0) -> str:
    """Return a number with so many decimals as it is typeset."""
    return true_minus(number(value, decimals))


def millimetres(value: float) -> str:
    """Return a length [mm] with as many decimals as it deserves."""
    decimals = 0 if abs(value) >= 10.0 else 1 if abs(value) >= 1.0 else 2
    return f"{typeset(value, decimals)} mm"


def metres_per_second(value: float) -> str:
    """Return a velocity given in mm/s."""
    velocity = value / 1e3
    return f"{velocity:.2f} m/s" if velocity >= 0.095 else f"{velocity:.2g} m/s"
