"""A study of radius and friction as the space of bearings that a design chart is drawn from."""

import numpy as np
import xarray

from dcfp.errors import InputError
from dcfp.inference.design_space import DesignSpace
from dcfp.study.assessment.selection import (
    events_of,
    is_number,
    only,
    select,
    shown_values,
    usable,
    values_of,
)

_RESULTS = ("peak_displacement", "force_ratio")
_AXES = ("radius", "mu")


def design_space(
    dataset: xarray.Dataset, pgv: float | None = None, *, unfinished: bool = False
) -> DesignSpace:
    """Return displacement and force of every record over radius and friction, at one PGV.

    A record with an analysis that is missing is left out for all bearings, so that every bearing bears the
    same records.

    Parameters
    ----------
    dataset, pgv
        A study of which at most ``radius``, ``mu``, ``record`` and ``pgv`` have several values, and one of
        its PGVs [mm/s].
    unfinished
        Whether records with analyses that have not been run are left out rather than the study refused.

    Raises
    ------
    InputError
        If another factor has several values, radius or friction has one only, or the study is not finished.
    """
    chosen = only(at_pgv(dataset, pgv), (*_AXES, "record"), "A design chart")
    for name in _AXES:
        if chosen.sizes[name] < 2 or not is_number(chosen[name]):
            msg = f"A design chart needs several values of {name}, and here is {shown_values(chosen[name])}."
            raise InputError(msg)
    found = usable(chosen.sortby(list(_AXES)), _RESULTS, unfinished=unfinished)
    displacement, force = (values_of(found, name) for name in _RESULTS)
    whole = np.isfinite(displacement).all(axis=(0, 1))
    if not whole.any():
        msg = "No record has been analysed on every bearing."
        raise InputError(msg)
    return DesignSpace(
        float(found["pgv"]),
        values_of(found, "radius"),
        values_of(found, "mu"),
        displacement[:, :, whole],
        force[:, :, whole],
        tuple(events_of(found)[whole].tolist()),
    )


def at_pgv(dataset: xarray.Dataset, pgv: float | None = None) -> xarray.Dataset:
    """Return a study at one PGV [mm/s], which need not be said where it has only one.

    Raises
    ------
    InputError
        If it has none, or several of which none is said.
    """
    chosen = select(
        dataset, {} if pgv is None or "pgv" not in dataset.coords else {"pgv": pgv}, keep=(*_AXES, "record")
    )
    if "pgv" not in chosen.coords:
        msg = "A design chart is for records of one PGV, and pgv is no factor of this study."
        raise InputError(msg)
    if chosen["pgv"].ndim > 0:
        msg = f"A design chart is for one PGV; choose one of {shown_values(chosen['pgv'])}."
        raise InputError(msg)
    return chosen
