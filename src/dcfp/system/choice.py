"""Makes one of several named models, with parameters by name."""

import dataclasses
import difflib
from collections.abc import Mapping
from typing import Any, TypeVar

from dcfp.errors import InputError

T = TypeVar("T")


def make_named(kind: str, models: Mapping[str, type[T]], name: str, parameters: Mapping[str, Any]) -> T:
    """Return the model of that name with those parameters; `kind` is what to call it in a sentence.

    Raises
    ------
    InputError
        If there is no model of that name, or it has no such parameter, or a value is out of range.
    """
    key = name.strip().lower()
    if key not in models:
        near = difflib.get_close_matches(key, models, n=1)
        hint = f" (did you mean {near[0]!r}?)" if near else ""
        msg = f"There is no {kind} {name!r}{hint}; the choices are {', '.join(models)}."
        raise InputError(msg)
    model: Any = models[key]
    allowed = [item.name for item in dataclasses.fields(model) if item.init]
    for given in parameters:
        if given not in allowed:
            msg = f"The {kind} {key!r} has no parameter {given!r}; it has {', '.join(allowed)}."
            raise InputError(msg)
    return model(**parameters)
