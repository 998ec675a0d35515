"""The records of a batch as its kernel steps through them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.analysis.respond import halvings
from dcfp.kernels.batch import Ground
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.stepping import LONGEST_TAIL, check_step_and_tail, parts_in, refined


@dataclass(frozen=True, eq=False)
class GroundSet:
    """Records side by side, unscaled.

    Attributes
    ----------
    ground
        As the kernel takes them.
    longest
        Samples of the longest with the rest after it.
    """

    ground: Ground
    longest: int

    @classmethod
    def of(
        cls, motions: Sequence[GroundMotion], *, tail: float | None = None, step: float | None = None
    ) -> "GroundSet":
        """Put records side by side; `tail` and `step` [s] as for `dcfp.respond`.

        Raises
        ------
        InputError
            If the tail or the step is out of range.
        """
        check_step_and_tail(step, tail)
        values = [_stepped(motion, tail, step) for motion in motions]
        sizes = np.array([one.acceleration.size for one in values], dtype=np.intp)
        rests = np.array([one.rest for one in values], dtype=np.intp)
        ground = Ground(
            acceleration=np.concatenate([one.acceleration for one in values]),
            first=np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.intp),
            samples=sizes,
            rest=rests,
            free_from=np.array([one.free_from for one in values], dtype=np.intp),
            interval=np.array([one.interval for one in values]),
            coarsest=np.array([halvings(one.interval) for one in values], dtype=np.intp),
        )
        return cls(ground, int((sizes + rests).max()))

    @property
    def steps(self) -> "np.ndarray[tuple[int], np.dtype[np.intp]]":
        """Samples of each record, a measure of what an analysis under it costs."""
        return self.ground.samples


@dataclass(frozen=True, eq=False)
class _Stepped:
    """One record with the steps that an analysis takes."""

    acceleration: "np.ndarray[tuple[int], np.dtype[np.float64]]"
    rest: int
    free_from: int
    interval: float


def _stepped(motion: GroundMotion, tail: float | None, step: float | None) -> _Stepped:
    """Return what `dcfp.respond` makes of a record, but the zeros after it as their number alone."""
    parts = 1 if step is None else parts_in(motion.time_step, step)
    after = round((LONGEST_TAIL if tail is None else tail) / motion.time_step)
    total = (motion.acceleration.size + after - 1) * parts + 1
    ends_at_rest = np.append(motion.acceleration, 0.0) if after else motion.acceleration
    acceleration = refined(ends_at_rest, parts)
    return _Stepped(
        acceleration=acceleration,
        rest=total - acceleration.size,
        free_from=motion.acceleration.size * parts if tail is None else total,
        interval=motion.time_step / parts,
    )
