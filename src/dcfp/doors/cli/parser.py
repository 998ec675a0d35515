"""An argument parser whose complaints are one sentence, and options made from declared parameters."""

import argparse
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from difflib import get_close_matches
from typing import Any, NoReturn

from dcfp.errors import InputError
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import split_number

_SAID_BETTER = {
    "expected one argument": "needs a value",
    "expected at least one argument": "needs at least one value",
}
#: How much of a word must be right for it to be taken as the one that was meant [-].
_NEAR = 0.7
_SWITCHES = {"yes": True, "true": True, "no": False, "false": False}


class Parser(argparse.ArgumentParser):
    """An `argparse.ArgumentParser` that raises `InputError` with one sentence and prints no usage."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        kwargs.setdefault("allow_abbrev", False)
        super().__init__(*args, **kwargs)

    def error(self, message: str) -> NoReturn:
        """Raise what argparse would have printed."""
        for words, better in _SAID_BETTER.items():
            message = re.sub(rf"^argument (\S+): {words}", rf"\1 {better}", message)
        text = re.sub(r"^argument (\S+): ", r"\1: ", message)
        unknown = re.fullmatch(r"unrecognized arguments: (.*)", text)
        if unknown is not None:
            text = self._unknown(unknown[1].split()[0])
        raise InputError(text if text.endswith((".", "?")) else f"{text}.")

    @property
    def options(self) -> list[str]:
        """Every option, such as ``"--pgv"``."""
        return [option for option in self._option_string_actions if option.startswith("--")]

    def spoken(self, sentence: str) -> str:
        """Return a sentence in which the parameters that it names in parentheses are called as the options are."""

        def named(found: re.Match[str]) -> str:
            option = f"--{found[1].replace('_', '-')}"
            return f"({option}{found[2]})" if option in self.options else found[0]

        return re.sub(r"\((\w+)((?: [\w.]+=[\w.]+)*)\)", named, sentence)

    def _unknown(self, given: str) -> str:
        near = nearest(given.partition("=")[0].lstrip("-"), (one[2:] for one in self.options))
        meant = f"did you mean --{near}?" if near else f"{self.prog} --help lists the options."
        return f"{given} is not an option of {self.prog}; {meant}"


def nearest(given: str, known: Iterable[str]) -> str | None:
    """Return the word that is probably meant: the one that begins so, or one with hardly another letter."""
    words = list(known)
    longer = [one for one in words if one.startswith(given)] if len(given) > 1 else []
    near = longer or get_close_matches(given, words, n=1, cutoff=_NEAR)
    return near[0] if near else None


def add_parameter(
    group: Any,
    parameter: Parameter,
    name: str = "",
    *,
    several: bool = False,
    required: bool = False,
    default: bool = False,
    more: str = "",
) -> None:
    """Add a declared parameter as an option, to be kept in the package's units.

    Parameters
    ----------
    group
        Parser, or group of options.
    parameter
        As it is declared.
    name
        Of the option; by default its key.
    several
        Whether any number of values may be given.
    required
        Whether it must be given.
    default
        Whether its default stands where it is not given; else None does, so that a file may say it.
    more
        What else its help says.
    """
    if more:
        parameter = replace(parameter, more=more)
    settings: dict[str, Any] = {"required": required, **_settings(name or parameter.key, parameter)}
    if default:
        settings["default"] = parameter.default
    if several or parameter.counts:
        group.add_argument(
            *settings.pop("names"),
            action=Numbers,
            read=[_reader(parameter)],
            most=max(parameter.counts, default=None),
            repeat=parameter.repeat,
            **settings,
        )
    else:
        group.add_argument(*settings.pop("names"), type=_reader(parameter), **settings)


def add_parameters(group: Any, parameters: Sequence[Parameter], name: str, least: int) -> None:
    """Add an option that takes several parameters, one after the other, `least` of them at least."""
    settings = _settings(name, *parameters)
    group.add_argument(
        *settings.pop("names"),
        action=Numbers,
        read=[_reader(one) for one in parameters],
        least=least,
        most=len(parameters),
        words=", ".join(one.words for one in parameters),
        **settings,
    )


def _settings(name: str, *parameters: Parameter) -> dict[str, Any]:
    words = "; ".join(one.help for one in parameters)
    return {
        "names": [f"--{name.replace('_', '-')}"],
        "dest": name,
        "metavar": metavar(parameters[0]),
        "help": words.replace("%", "%%"),
    }


def _reader(parameter: Parameter) -> Callable[[str], Any]:
    """Return a type that reads the words behind an option."""
    one = replace(parameter, counts=())

    def read(text: str) -> Any:
        value: Any = _SWITCHES.get(text.lower(), text) if one.kind is bool else text
        try:
            return one.read(value, one.words)
        except InputError as error:
            raise argparse.ArgumentTypeError(str(error)) from None

    return read


def metavar(parameter: Parameter) -> str:
    """Return what stands for the value in the help."""
    if not parameter.is_number:
        return "NAME" if parameter.choices else "YES_OR_NO" if parameter.kind is bool else "TEXT"
    if parameter.kind is int:
        return "N"
    unit = parameter.unit.text if parameter.unit.has_dimension else "value"
    return unit.upper().replace("/", "_PER_").translate(str.maketrans(" ()*", "____")).strip("_")


class Numbers(argparse.Action):
    """Takes the numbers that follow an option; what follows them and is no number is a record.

    ``--pgv 0.25 0.5 NCC`` means the record NCC at two PGVs.
    """

    def __init__(
        self,
        *args: Any,
        read: Sequence[Callable[[str], float]],
        least: int = 1,
        most: int | None = None,
        repeat: int = 1,
        words: str = "",
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, nargs="+", **kwargs)
        self.words = words
        self.read = read
        self.least, self.most = least, most
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
        given = tokens[: max(count, 1)]
        if len(given) < self.least or (self.most is not None and len(given) > self.most):
            few = len(given) < self.least
            wanted = f"at least {self.least} numbers" if few else f"at most {self.most} numbers"
            msg = f"it takes {wanted}{f' ({self.words})' if self.words else ''}, not {len(given)}"
            raise argparse.ArgumentError(self, msg)
        try:
            numbers = [self.read[min(i, len(self.read) - 1)](token) for i, token in enumerate(given)]
        except argparse.ArgumentTypeError as error:
            raise argparse.ArgumentError(self, str(error)) from None
        setattr(namespace, self.dest, numbers * self.repeat if len(numbers) == 1 else numbers)
        later = [*getattr(namespace, "later_records", ()), *tokens[len(given) :]]
        namespace.later_records = later


def _is_number(text: str) -> bool:
    """Whether a word is a number, or one with a unit behind a space; ``1994.txt`` is a file."""
    try:
        float(text)
    except ValueError:
        return " " in text.strip() and split_number(text) is not None
    return True
