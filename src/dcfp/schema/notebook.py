"""Results as HTML, for notebooks: a small table and the remarks, in the colours of the page.

Objects delegate here in ``_repr_html_``. Units come from where the house style writes them: in square brackets in the docstring of a class, or at the end of a key of JSON.
"""

import inspect
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from functools import cache
from html import escape
from typing import Any, cast

import numpy as np

from dcfp.schema.quantities import Quantity

#: Most rows of a table; more are counted.
MOST_ROWS = 30
_TABLE = "border-collapse: collapse; border: 1px solid currentColor; margin: 0.4em 0;"
_CELL = "text-align: {side}; padding: 0.15em 0.6em; border: 0; background: none; color: inherit;"
#: Ends of keys in JSON, the longer ones first.
_UNITS = {
    "mm_s2": "mm/s2", "N_mm2": "N/mm2", "kN_mm": "kN/mm", "kN_m": "kN m", "mm_s": "mm/s", "m_s": "m/s",
    "mm": "mm", "kN": "kN", "degC": "degC", "s": "s",
}  # fmt: skip
#: A parameter in a numpydoc section: its names on one line, words on deeper ones.
_ENTRY = re.compile(r"^(?P<names>\w+(?:, \w+)*)(?: :[^\n]*)?\n(?P<words>(?:    .*(?:\n|$))+)", re.MULTILINE)
_UNIT = re.compile(r"\[([^\[\]]+)\]")


def card(
    title: str,
    facts: Mapping[str, object] | None = None,
    *,
    rows: Sequence[Mapping[str, object]] = (),
    remarks: Iterable[str] = (),
) -> str:
    """Return HTML of a result.

    Parameters
    ----------
    title
        What it is.
    facts
        Values by their labels, which may end with a unit in square brackets.
    rows
        Of a table whose heads are the keys of the first row.
    remarks
        Sentences that a reader must know.
    """
    parts = [f"<div><strong>{escape(title)}</strong>"]
    if facts:
        parts.append(_table([], [[label, shown(value)] for label, value in facts.items()]))
    if rows:
        heads = list(rows[0])
        cells = [[shown(row.get(head)) for head in heads] for row in rows[:MOST_ROWS]]
        parts.append(_table(heads, cells))
    if len(rows) > MOST_ROWS:
        parts.append(f"<div>... and {len(rows) - MOST_ROWS} more rows</div>")
    told = list(dict.fromkeys(remarks))
    if told:
        parts.append(f"<ul>{''.join(f'<li>{escape(one)}</li>' for one in told)}</ul>")
    return "".join([*parts, "</div>"])


def fields_card(
    thing: Any, title: str = "", facts: Mapping[str, object] | None = None, *, remarks: Iterable[str] = ()
) -> str:
    """Return HTML of a dataclass: its fields with their units, then other facts."""
    units = units_of(thing)
    found = {
        _with_unit(item.name, units.get(item.name, "")): getattr(thing, item.name)
        for item in fields(thing)
        if item.repr and not item.name.startswith("_")
    }
    return card(title or type(thing).__name__, {**found, **(facts or {})}, remarks=remarks)


def units_of(thing: object) -> dict[str, str]:
    """Return the units of the fields of an object by their names, from the docstrings of its class and of those above it."""
    return _units_of_class(thing.__class__)


@cache
def _units_of_class(kind: type) -> dict[str, str]:
    found: dict[str, str] = {}
    for one in reversed(kind.__mro__):
        for entry in _ENTRY.finditer(inspect.cleandoc(one.__doc__ or "")):
            names, units = entry["names"].split(", "), _UNIT.findall(entry["words"])
            if units:
                found.update(zip(names, _one_each(units, len(names)), strict=True))
    return found


def _one_each(units: list[str], count: int) -> list[str]:
    """Return a unit for each of several names: each its own, those of one pair of brackets, or the first for all."""
    if len(units) == count:
        return units
    listed = units[0].split(", ")
    return listed if len(listed) == count else [units[0]] * count


def told(quantities: Iterable[Quantity], result: object) -> dict[str, object]:
    """Return what data hold of a result, by names with their units."""
    return {
        f"{one.title} [{one.unit.text}]" if one.unit.has_dimension else one.title: one.datum(result)
        for one in quantities
        if one.stored
    }


def with_units(summary: Mapping[str, object]) -> dict[str, object]:
    """Return JSON's keys as labels: ``"y_max_mm"`` is ``"y_max [mm]"``."""
    return {_label(key): value for key, value in summary.items()}


def shown(value: Any) -> str:
    """Return a value in words or digits, not yet as HTML."""
    if isinstance(value, np.ndarray):
        return _array(cast("np.ndarray[Any, Any]", value))
    if value is None or value == "":
        return "–"
    if isinstance(value, (bool, np.bool_)):
        return "yes" if value else "no"
    if isinstance(value, (float, np.float64)):
        return _number(float(value))
    if isinstance(value, (tuple, list)):
        return ", ".join(shown(one) for one in cast("Sequence[Any]", value)[:MOST_ROWS]) or "–"
    return str(value)


def _number(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.5g}"


def _array(values: np.ndarray[Any, Any]) -> str:
    """Return how many values there are, and from where to where they go."""
    if values.size == 0 or values.dtype.kind not in "biuf":
        return f"{values.size} values"
    return f"{_number(float(values.min()))} to {_number(float(values.max()))}, {values.size} values"


def _label(key: str) -> str:
    for ending, unit in _UNITS.items():
        if key.endswith(f"_{ending}"):
            return f"{key.removesuffix(f'_{ending}')} [{unit}]"
    return key


def _with_unit(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit and unit not in ("-", "1") else name


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    head = "".join(_cell("th", text, column) for column, text in enumerate(heads))
    body = "".join(
        f"<tr>{''.join(_cell('td', text, column) for column, text in enumerate(row))}</tr>" for row in rows
    )
    return f'<table style="{_TABLE}">{f"<tr>{head}</tr>" if heads else ""}{body}</table>'


def _cell(tag: str, text: str, column: int) -> str:
    side = "right" if column else "left"
    return f'<{tag} style="{_CELL.format(side=side)}">{escape(text)}</{tag}>'
