"""An argument parser whose complaints are one sentence, and options made from declared parameters."""

import argparse
import re
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from difflib import get_close_matches
from typing import Any, NoReturn

from dcfp.errors import InputError
from dcfp.schema.declared import Declared, parameters
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


# Options: of declared parameters, kept in the package's units; and words.


def add_declared(group: Any, kind: type[Declared], *names: str, more: dict[str, str] | None = None) -> None:
    """Add the parameters of a declared class to a parser or a group: all that are options, or those of the fields that are named.

    Parameters
    ----------
    group
        Parser, or group of options.
    kind
        The class.
    names
        Of fields.
    more
        What else the help of some says, by the names of their fields.
    """
    for name, one in parameters(kind).items():
        if name in names or (one.option and not names):
            said = replace(one, more=more[name], default=None) if more and name in more else one
            add_parameter(group, said)


def add_parameter(
    group: Any,
    *several: Parameter,
    name: str = "",
    words: str = "",
    least: int = 1,
    any_number: bool = False,
    required: bool = False,
    default: bool = False,
) -> None:
    """Add a declared parameter as an option, or one that takes several of them, one after the other.

    Parameters
    ----------
    group
        Parser, or group of options.
    several
        As they are declared.
    name, words
        Of the option, by default the key of the first; of its help, by default those of the parameters.
    least, any_number
        How many of several must be given, and whether any number of values may.
    required
        Whether it must be given.
    default
        Whether its default stands where it is not given; else None does, so that a file may say it.
    """
    first = several[0]
    name = name or first.key
    settings: dict[str, Any] = {
        "dest": name,
        "metavar": metavar(first),
        "help": (words or "; ".join(one.help for one in several)).replace("%", "%%"),
        "required": required,
        "default": first.default if default else None,
    }
    if any_number or first.counts or len(several) > 1:
        settings |= {
            "action": Numbers,
            "read": [_reader(one) for one in several],
            "least": least,
            "most": None if any_number else max(first.counts, default=len(several)),
            "repeat": first.repeat,
            "words": ", ".join(one.words for one in several) if len(several) > 1 else "",
        }
    else:
        settings["type"] = _reader(first)
    group.add_argument(f"--{name.replace('_', '-')}", **settings)


def add_switch(group: Any, name: str, words: str) -> None:
    """Add an option that is given or not."""
    group.add_argument(name, action="store_true", help=words)


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


class Pairs(argparse.Action):
    """Takes words ``NAME=VALUE`` as values by their names; one that stands alone, where it may, has the name ``""``."""

    def __init__(
        self, *args: Any, example: str, read: Callable[[str], Any] = str, alone: bool = False, **kwargs: Any
    ) -> None:
        super().__init__(*args, **{"nargs": "+", "default": {}} | kwargs)
        self.example, self.read, self.alone = example, read, alone

    def __call__(self, parser: Any, namespace: Any, values: Any, option_string: str | None = None) -> None:
        """Add the values to those that are there."""
        found: dict[str, Any] = dict(getattr(namespace, self.dest, {}))
        for word in values or ():
            first, mark, last = (part.strip() for part in str(word).partition("="))
            name, text = (first, last) if mark or not self.alone else ("", first)
            msg = f"write {self.metavar}, for example {self.example}, not {word!r}"
            if name in found:
                msg = f"{name or word} is given twice; give one value"
            elif text and (name or self.alone):
                with suppress(ValueError):
                    found[name] = self.read(text)
                    continue
            raise argparse.ArgumentError(self if option_string else None, msg)
        setattr(namespace, self.dest, found)


class Numbers(argparse.Action):
    """Takes the numbers that follow an option; what follows them and is no number is a record.

    ``--pgv 0.25 0.5 NCC`` means the record NCC at two PGVs.
    """

    def __init__(
        self,
        *args: Any,
        read: Sequence[Callable[[str], float]],
        least: int,
        most: int | None,
        repeat: int,
        words: str,
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, nargs="+", **kwargs)
        self.words, self.read, self.repeat = words, read, repeat
        self.least, self.most = least, most

    def __call__(self, parser: Any, namespace: Any, values: Any, option_string: str | None = None) -> None:
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
        namespace.later_records = [*getattr(namespace, "later_records", ()), *tokens[len(given) :]]


def _is_number(text: str) -> bool:
    """Whether a word is a number, or one with a unit behind a space; ``1994.txt`` is a file."""
    try:
        float(text)
    except ValueError:
        return " " in text.strip() and split_number(text) is not None
    return True
