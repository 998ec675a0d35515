"""Lanes of a batch: which record at which scale on which model."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray, IntArray
from dcfp.system import System


@dataclass(frozen=True, eq=False)
class Lanes:
    """Analyses to be made, each one lane.

    Attributes
    ----------
    record, scale, model
        Number of its record in the `GroundSet`, factor on the acceleration [-], and number of its model, shape (lanes,).
    """

    record: IntArray
    scale: FloatArray
    model: IntArray
    models: Sequence[System]

    def __len__(self) -> int:
        return self.record.size

    @classmethod
    def grid(cls, records: int, scales: FloatArray, models: Sequence[System]) -> "Lanes":
        """Return every one of so many records at its scales [-], shape (records, scales), on every model, which varies fastest.

        Parameters
        ----------
        records
            Number of records.
        scales
            Of each record, shape (records, scales) [-].
        models
            As in `Lanes`.
        """
        shape = (records, scales.shape[1], len(models))
        record, _, model = (axis.ravel() for axis in np.indices(shape, dtype=np.intp))
        return cls(record, np.repeat(scales.ravel(), len(models)), model, models)
