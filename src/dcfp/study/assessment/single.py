"""One case of a study: its response history analysis, made again with its histories."""

from collections.abc import Mapping

import numpy as np
import xarray

from dcfp.analysis import Response
from dcfp.errors import InputError
from dcfp.study import Plan
from dcfp.study.assessment.selection import only, select
from dcfp.study.plan import Block
from dcfp.study.procedures import ANALYSIS
from dcfp.study.store import coordinates
from dcfp.study.work import response_of


def numbered_cases(plan: Plan) -> xarray.Dataset:
    """Return the number of every case of a plan over its factors."""
    numbers = np.arange(plan.count).reshape(plan.shape)
    return xarray.Dataset({"number": (list(plan.sizes), numbers)}, coords=coordinates(plan))


def response_at(plan: Plan, at: Mapping[str, float | str]) -> Response:
    """Return the response history analysis of one case.

    Parameters
    ----------
    plan
        The plan of the study.
    at
        A value of every factor that has several, in the units of the results; a sample is named by its number.

    Raises
    ------
    InputError
        If there is no such case, or more than one, or it is one of another procedure.
    """
    chosen = only(select(numbered_cases(plan), at), (), "A response history analysis")
    places = np.unravel_index(int(chosen["number"].item()), plan.shape)
    cases = plan.cases(Block(0, tuple(slice(int(place), int(place) + 1) for place in places)))
    procedure = plan.procedures[int(cases.procedures[0])]
    if procedure != ANALYSIS:
        msg = f"The case is one of the procedure {procedure!r}, which has no histories; choose procedure={ANALYSIS}."
        raise InputError(msg)
    return response_of(plan, cases.lanes, 0)
