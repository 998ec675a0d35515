"""An argument parser whose complaints are one sentence, and the numbers that it accepts."""

import argparse
import math
import re
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from typing import Any, NoReturn

from dcfp.errors import InputError

_SAID_BETTER = {
    "expected one argument": "needs a value",
    "expected at least one argument": "needs at least one value",
}


class Parser(argparse.ArgumentParser):
    """An `argparse.ArgumentParser` that raises `InputError` with one sentence and prints no usage."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        kwargs.setdefault("allow_abbrev", False)
        super().__init__(*args, **kwargs)

    def error(self, message: str) -> NoReturn:
        """Raise what argparse would have printed."""
        text = re.sub(r"^argument (\S+): ", r"\1 ", message)
        for words, better in _SAID_BETTER.items():
            text = text.replace(words, better)
        unknown = re.fullmatch(r"unrecognized arguments: (.*)", text)
        if unknown is not None:
            text = self._unknown(unknown[1].split()[0])
        raise InputError(text if text.endswith((".", "?")) else f"{text}.")

    def _unknown(self, given: str) -> str:
        options = [option for option in self._option_string_actions if option.startswith("--")]
        near = get_close_matches(given.partition("=")[0], options, n=1)
        meant = f"did you mean {near[0]}?" if near else f"{self.prog} --help lists the options."
        return f"{given} is not an option of {self.prog}; {meant}"


class Numbers(argparse.Action):
    """Takes the numbers that follow an option; what follows them and is no number is a record.

    ``--pgv 0.25 0.5 NCC`` means the record NCC at two PGVs.
    """

    def __init__(
        self,
        *args: Any,
        check: Callable[[str], float],
        most: int | None = None,
        repeat: int = 1,
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, nargs="+", **kwargs)
        self.check = check
        self.most = most
        self.repeat = repeat

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> None:
        """Sort the tokens into numbers and records."""
        tokens = [str(value) for value in values or ()]
        count = next((i for i, token in enumerate(tokens) if not _is_number(token)), len(tokens))
        try:
            numbers = [self.check(token) for token in tokens[: max(count, 1)]]
        except argparse.ArgumentTypeError as error:
            raise argparse.ArgumentError(self, str(error)) from None
        if self.most is not None and len(numbers) > self.most:
            msg = f"takes at most {self.most} numbers, not {len(numbers)}"
            raise argparse.ArgumentError(self, msg)
        setattr(namespace, self.dest, numbers * self.repeat if len(numbers) == 1 else numbers)
        later = [*getattr(namespace, "later_records", ()), *tokens[len(numbers) :]]
        namespace.later_records = later


def positive(unit: str, least: float = 0.0, most: float = math.inf) -> Callable[[str], float]:
    """Return a type for a positive number of `unit`, within limits that a wrong unit would pass."""
    limits = f" from {least:g} to {most:g}" if math.isfinite(most) else ""
    return _number(
        f"must be a positive number of {unit}{limits}", lambda value: value > 0.0 and least <= value <= most
    )


def not_negative(unit: str, most: float) -> Callable[[str], float]:
    """Return a type for zero or a positive number of `unit`, up to `most`."""
    return _number(
        f"must be zero or a positive number of {unit} up to {most:g}", lambda value: 0.0 <= value <= most
    )


def any_number(unit: str, least: float, most: float) -> Callable[[str], float]:
    """Return a type for a number of `unit` between limits."""
    return _number(
        f"must be a number of {unit} from {least:g} to {most:g}", lambda value: least <= value <= most
    )


def number_from(least: float, most: float) -> Callable[[str], float]:
    """Return a type for a number without a unit between limits."""
    return _number(f"must be a number from {least:g} to {most:g}", lambda value: least <= value <= most)


def whole_number(least: int, most: int) -> Callable[[str], int]:
    """Return a type for a whole number between limits."""
    rule = f"must be a whole number from {least} to {most}"
    number = _number(rule, lambda value: value.is_integer() and least <= value <= most)
    return lambda text: int(number(text))


def fraction() -> Callable[[str], float]:
    """Return a type for a number above 0 and below 1."""
    return _number("must lie between 0 and 1", lambda value: 0.0 < value < 1.0)


def _number(rule: str, holds: Callable[[float], bool]) -> Callable[[str], float]:
    def check(text: str) -> float:
        value = float(text) if _is_number(text) else math.nan
        if not (math.isfinite(value) and holds(value)):
            msg = f"{rule}, not {text!r}"
            raise argparse.ArgumentTypeError(msg)
        return value

    return check


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
