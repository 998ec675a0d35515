"""The lanes of a batch: which record, at which scale, on which model."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray, IntArray
from dcfp.system import Model


@dataclass(frozen=True, eq=False)
class Lanes:
    """Analyses to be made, each one lane.

    Attributes
    ----------
    record
        Number of the record in the `GroundSet`, shape (lanes,).
    scale
        Factor on its acceleration [-], shape (lanes,).
    model
        Number of the model in `models`, shape (lanes,).
    models
        Bearings with their friction laws and heating models.
    """

    record: IntArray
    scale: FloatArray
    model: IntArray
    models: Sequence[Model]

    def __len__(self) -> int:
        return self.record.size

    @classmethod
    def grid(cls, records: int, scales: FloatArray, models: Sequence[Model]) -> "Lanes":
        """Return every record at its scales on every model, the model varying fastest.

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
