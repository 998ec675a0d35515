"""Declared classes: dataclasses whose fields are parameters, checked where they are made, read from files and written to them.

A class says what its fields are with ``Annotated[float, Parameter(...)]`` under `declared`. Its constructor, files, options, study factors,
forms, reports and documentation all loop over the same declarations, so that they have the same names, limits and sentences.
"""

import dataclasses
import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import (
    Annotated,
    Any,
    ClassVar,
    Self,
    TypeVar,
    Union,
    cast,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

from dcfp.errors import InputError
from dcfp.schema.parameters import Parameter, read_values

T = TypeVar("T")

#: The section, and where else it would stand: before the first section of another name, or at the end.
_SECTION = re.compile(r"\n\nParameters\n-+\n(?P<body>.*?)(?=\n\n[A-Z]\w*\n-+\n|\Z)", re.DOTALL)
_OTHER = re.compile(r"\n\n[A-Z]\w*\n-+\n")
#: A parameter: its names on one line, words on deeper ones.
_ENTRY = re.compile(r"^(?P<names>\w+(?:, \w+)*)(?: :[^\n]*)?\n(?P<words>(?:    .*(?:\n|$))+)", re.MULTILINE)


class Declared:
    """A class whose fields are declared parameters."""

    #: What the class is called in a sentence.
    noun: ClassVar[str] = ""
    _parameters: ClassVar[dict[str, Parameter]] = {}

    def __post_init__(self) -> None:
        for one in parameters(type(self)).values():
            value = getattr(self, one.name)
            if not one.is_plain(value):
                label = f"{type(self).__name__}: {one.words} ({one.name})"
                object.__setattr__(self, one.name, one.checked(value, label))
        self.check_relations()

    def check_relations(self) -> None:
        """Refuse values that are allowed each, but not together."""

    def card_facts(self) -> dict[str, Any]:
        """Return what its card in a notebook says besides the parameters, by labels with units."""
        return {}

    def _repr_html_(self) -> str:
        from dcfp.schema.notebook import fields_card  # late: it knows the parameters

        words = f"{(self.noun or type(self).__name__).removeprefix('the ').removeprefix('a ')} {getattr(self, 'name', '')}"
        return fields_card(self, words[0].upper() + words[1:].strip(), self.card_facts())

    @classmethod
    def from_table(cls, table: Mapping[str, Any], where: str, base: Self | None = None) -> Self:
        """Return what a table of a file says, with the rest from `base` or from the defaults.

        Parameters
        ----------
        table
            Values by their keys, each in its declared unit or a text with a number and a unit.
        where
            What to begin a complaint with: the file, and the table in it.
        base
            Where what the table leaves out comes from; by default the defaults.

        Raises
        ------
        InputError
            If there is an unknown key or a value that is not allowed.
        """
        values = read_table(cls, table, where)
        for one in parameters(cls).values() if base is None else ():
            if one.default is None and not one.optional and one.name not in values:
                msg = f"{where}: {one.key} is missing: {one.words}, {one.rule()}."
                raise InputError(msg)
        return build(cls, values, where, base)

    def to_table(self) -> dict[str, Any]:
        """Return what a file would hold of it: every value that is given, by its key, in its declared unit."""
        return {
            one.key: one.written(value)
            for one in parameters(type(self)).values()
            if (value := getattr(self, one.name)) is not None and value != ""
        }

    def rows(self) -> Iterator[tuple[Parameter, Any]]:
        """Give every parameter with its value."""
        for one in parameters(type(self)).values():
            yield one, getattr(self, one.name)

    def unchecked(self, **values: Any) -> Self:
        """Return a copy with values that may lie beyond the limits: a limit case of the mathematics, which no door takes."""
        copy = object.__new__(type(self))
        for one in parameters(type(self)).values():
            object.__setattr__(copy, one.name, values.get(one.name, getattr(self, one.name)))
        return copy


def read_table(
    kind: type[Declared], table: Mapping[str, Any], where: str, *, also: tuple[str, ...] = ()
) -> dict[str, Any]:
    """Return the values of a table as `Declared.from_table` takes them, by the names of the fields.

    Parameters
    ----------
    kind
        The declared class.
    table, where, also
        As for `read_values`.

    Raises
    ------
    InputError
        If there is an unknown key or a value that is not allowed.
    """
    return read_values(parameters(kind).values(), table, where, f"parameter of {described(kind)}", also=also)


def described(kind: type[Declared]) -> str:
    """Return what a declared class is called in a sentence, such as ``"the friction law li2020"``."""
    name = "" if "name" in parameters(kind) else getattr(kind, "name", "")
    return f"{kind.noun or kind.__name__} {name}".strip()


def build(kind: Callable[..., T], values: Mapping[str, Any], where: str, base: T | None = None) -> T:
    """Return an object with those values; a complaint about how they go together begins with `where`."""
    try:
        return kind(**values) if base is None else replace(cast("Any", base), **values)
    except InputError as error:
        msg = f"{where}: {error}" if where else str(error)
        raise InputError(msg) from error


def parameters(kind: type) -> dict[str, Parameter]:
    """Return the parameters of a declared class by the names of their fields, in their order."""
    if "_parameters" not in kind.__dict__:
        msg = f"{kind.__name__} is not declared."
        raise TypeError(msg)
    return cast("Any", kind)._parameters


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def declared(kind: type[T]) -> type[T]:
    """Make a frozen dataclass of declared parameters; fields without `Parameter` are fields like any other."""
    hints = get_type_hints(kind, include_extras=True)
    marks = {name: hint for name, hint in hints.items() if get_origin(hint) is Annotated}
    # without this every signature prints the whole declaration
    for name in inspect.get_annotations(kind).keys() & marks.keys():
        kind.__annotations__[name] = get_args(marks[name])[0]
    inherited = {
        name: one
        for base in reversed(kind.__mro__[1:])
        for name, one in base.__dict__.get("_parameters", {}).items()
    }
    made = dataclass(frozen=True)(kind)
    defaults: dict[str, Any] = {
        one.name: None if one.default is dataclasses.MISSING else one.default
        for one in dataclasses.fields(cast("Any", made))
    }
    found: dict[str, Parameter] = {}
    for name, default in defaults.items():
        if name in marks:
            found[name] = _bound(name, marks[name], default)
        elif name in inherited:
            found[name] = replace(inherited[name], default=default)
    cast("Any", made)._parameters = found
    sentences = {name: found[name].sentence if name in found else None for name in defaults}
    made.__doc__ = with_parameters(kind.__doc__ or "", sentences)
    return made


def _bound(name: str, hint: Any, default: Any) -> Parameter:
    """Return a parameter that knows its field."""
    inside, *marks = get_args(hint)
    mark = next(mark for mark in marks if isinstance(mark, Parameter))
    options = get_args(inside) if get_origin(inside) in (Union, type(int | str)) else (inside,)
    inner = next(one for one in options if one is not type(None))
    kind = get_args(inner)[0] if get_origin(inner) is tuple else inner
    counts = mark.counts
    if get_origin(inner) is tuple and not counts:
        counts = (len([one for one in get_args(inner) if one is not Ellipsis]),)
    return replace(
        mark,
        name=name,
        key=mark.key or name,
        kind=cast("type", kind),
        default=default,
        optional=type(None) in options,
        counts=counts,
    )


def with_parameters(doc: str, known: Mapping[str, str | None]) -> str:
    """Return a docstring whose section of parameters has all fields: by hand stands there only what the declarations do not say.

    Parameters
    ----------
    doc
        As it is written.
    known
        All fields in their order, each with a sentence that stands where the docstring has no entry of its own; None for none.
    """
    text = inspect.cleandoc(doc)
    section = _SECTION.search(text)
    written = {
        name: entry
        for entry in _ENTRY.finditer(section["body"] if section else "")
        for name in entry["names"].split(", ")
    }
    lines = [one.group().rstrip() for name, one in written.items() if name not in known]
    for name, sentence in known.items():
        if name in written:
            entry = written[name].group().rstrip()
            lines += [entry] if entry not in lines else []
        elif sentence is not None:
            lines.append(f"{name}\n    {sentence}")
    if not lines:
        return text
    whole = "\n\nParameters\n----------\n" + "\n".join(lines)
    if section is not None:
        return text[: section.start()] + whole + text[section.end() :]
    place = min((found.start() for found in _OTHER.finditer(text)), default=len(text))
    return text[:place] + whole + text[place:]
