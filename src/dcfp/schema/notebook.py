"""Results as HTML, for notebooks: a small table and the remarks, in the colours of the page.

Objects delegate here in ``_repr_html_``. Units come from declarations: of parameters, of quantities, or from the metadata of a field, as in ``field(metadata={"unit": MM})``.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import Field, fields
from html import escape
from typing import Any, cast

import numpy as np

from dcfp.schema.declared import parameters
from dcfp.schema.quantities import NOMENCLATURE, Quantity
from dcfp.schema.units import WORDS, Unit

#: Most rows of a table; more are counted.
MOST_ROWS = 30
_TABLE = "border-collapse: collapse; border: 1px solid currentColor; margin: 0.4em 0;"
_CELL = "text-align: {side}; padding: 0.15em 0.6em; border: 0; background: none; color: inherit;"


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
    found = {
        _with_unit(item.name, _unit_of(thing, item)): getattr(thing, item.name)
        for item in fields(thing)
        if item.repr and not item.name.startswith("_")
    }
    return card(title or type(thing).__name__, {**found, **(facts or {})}, remarks=remarks)


def _unit_of(thing: object, item: "Field[Any]") -> Unit:
    """Return the unit of a field: of its parameter, as its metadata say, or of the quantity of that name if it is one."""
    if "_parameters" in type(thing).__dict__ and item.name in parameters(type(thing)):
        return parameters(type(thing))[item.name].unit.inner_unit
    is_number = isinstance(getattr(thing, item.name), (int, float, np.ndarray))
    usual = NOMENCLATURE[item.name].unit if is_number and item.name in NOMENCLATURE else WORDS
    return item.metadata.get("unit", usual)


def told(quantities: Iterable[Quantity], result: object) -> dict[str, object]:
    """Return what data hold of a result, by names with their units; but for lists, which no cell holds."""
    found = {
        _with_unit(one.title, one.unit): one.datum(result) for one in quantities if one.stored and one.flat
    }
    return {name: value for name, value in found.items() if not isinstance(value, list)}


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


def _with_unit(name: str, unit: Unit) -> str:
    return f"{name} [{unit.text}]" if unit.has_dimension else name


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    head = "".join(_cell("th", text, column) for column, text in enumerate(heads))
    body = "".join(
        f"<tr>{''.join(_cell('td', text, column) for column, text in enumerate(row))}</tr>" for row in rows
    )
    return f'<table style="{_TABLE}">{f"<tr>{head}</tr>" if heads else ""}{body}</table>'


def _cell(tag: str, text: str, column: int) -> str:
    side = "right" if column else "left"
    return f'<{tag} style="{_CELL.format(side=side)}">{escape(text)}</{tag}>'
