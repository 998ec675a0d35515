"""Surveys of bearings for the design chart, each made once.

A survey rests on named records and on the numbers of a bearing, and on nothing else of a visitor; so that one that is at hand may be
shown to anyone who asks for the same.
"""

import asyncio
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from dcfp.errors import InputError
from dcfp.inference.design_space import RADII, DesignSpace, survey
from dcfp.motion.named import record_set
from dcfp.system import System

#: PGVs that the chart has [m/s].
PGVS = tuple(np.round(np.arange(0.1, 1.55, 0.1), 2).tolist())
SETS = {
    "P695-FF": "far-field set of FEMA P-695, 44 components",
    "P695-NF": "near-field set of FEMA P-695, 56 components",
    "P695": "both sets of FEMA P-695, 100 components",
}
#: Surveys that are kept.
_MOST = 200


@dataclass(frozen=True)
class Question:
    """What a survey is made for.

    Attributes
    ----------
    model
        The bearing; its radii and its coefficient are those of no bearing in particular.
    records
        Name of a set.
    pgv
        [m/s].
    """

    model: System
    records: str
    pgv: float

    @classmethod
    def of(cls, model: System, records: str, pgv: float) -> "Question":
        """Leave out of a bearing what a survey varies, so that the same question is known as such."""
        bearing = replace(
            model.bearing, radii=(RADII[0],) * 2, displacement_capacity=None, capacity_note="", name="bearing"
        )
        law = model.friction
        if law.reference_parameter:
            law = law.with_reference(0.05)
        return cls(System(bearing, law, model.heating), records, pgv)


class Surveys:
    """Surveys by question; the latest ones are kept."""

    def __init__(self) -> None:
        self._found: OrderedDict[Question, DesignSpace] = OrderedDict()
        self._lock = asyncio.Lock()

    def at_hand(self, question: Question) -> DesignSpace | None:
        """Return a survey that was made before."""
        return self._found.get(question)

    async def find(self, question: Question, report: Callable[[], None]) -> DesignSpace:
        """Return a survey, made in other threads where it is not at hand; `report` is called after each radius.

        Raises
        ------
        DcfpError
            If it cannot be made.
        """
        async with self._lock:  # one survey takes every core
            found = self._found.get(question)
            if found is None:
                found = await asyncio.to_thread(_make, question, report)
                self._found[question] = found
                while len(self._found) > _MOST:
                    self._found.popitem(last=False)
            return found


def _make(question: Question, report: Callable[[], None]) -> DesignSpace:
    motions = record_set(question.records)
    if motions is None:
        msg = f"There is no record set {question.records!r}."
        raise InputError(msg)
    return survey(motions, question.pgv * 1e3, question.model, report=report)
