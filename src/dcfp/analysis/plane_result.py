"""What results in the plane have in common: histories by direction, and their magnitudes under the names of one direction."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from dcfp.analysis.plane_fields import Fields
from dcfp.analysis.result import HistoryResult, Result
from dcfp.arrays import FloatArray, freeze

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PlaneResult(Result):
    """A result in two horizontal directions; what is called as in one direction is the magnitude in the plane.

    Attributes
    ----------
    fields
        Temperature of the plates at some moments, where it was kept.
    """

    fields: Fields | None = None

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories over ``time`` with their units, the temperature of the plates where it was kept, and what is told of it and its provenance as attributes."""
        dataset = super().to_dataset()
        return dataset if self.fields is None else dataset.merge(self.fields.variables())

    def vectors(self, name: str) -> FloatArray:
        """Return both columns that the kernels wrote under a name, shape (n, 2)."""
        return np.column_stack((self.line(f"{name}_x"), self.line(f"{name}_y")))

    @cached_property
    def displacement_vectors(self) -> FloatArray:
        """Displacement of the isolation layer [mm], shape (n, 2)."""
        return freeze(self.vectors("displacement"))

    @cached_property
    def velocity_vectors(self) -> FloatArray:
        """Relative velocity [mm/s], shape (n, 2)."""
        return freeze(self.vectors("velocity"))

    @cached_property
    def force_vectors(self) -> FloatArray:
        """Horizontal force of the bearing [N], shape (n, 2)."""
        bearing = self.bearing
        ratio = (self.load / bearing.vertical_force)[:, np.newaxis]
        pendulum = bearing.restoring_stiffness * ratio * self.displacement_vectors
        return freeze(pendulum + bearing.elastic_stiffness * self.vectors("elongation"))

    @property
    def displacement(self) -> FloatArray:
        """Distance |y| of the isolation layer from the middle [mm]."""
        return np.linalg.norm(self.displacement_vectors, axis=1)

    @property
    def velocity(self) -> FloatArray:
        """Relative speed |v| [mm/s]."""
        return np.linalg.norm(self.velocity_vectors, axis=1)

    @property
    def elongation(self) -> FloatArray:
        """Length of the elongation of spring (b), |y - O_Y| [mm]."""
        return np.linalg.norm(self.vectors("elongation"), axis=1)

    @property
    def force(self) -> FloatArray:
        """Magnitude of the horizontal force [N]."""
        return np.linalg.norm(self.force_vectors, axis=1)

    @property
    def peak_point_temperature(self) -> float:
        """Highest temperature of a point of any plate [degC]; without a field, that of the contact."""
        return (
            max(self.peak_temperature, float(self.line("point_temperature")[-1])) + self.rise_between_points
        )

    @cached_property
    def rise_between_points(self) -> float:
        """By how much a point between those of the grid became hotter than all of these [degC], where that is known."""
        return 0.0


def add_directions(kind: type[HistoryResult], **sources: str) -> None:
    """Give a kind of result the histories ``NAME_x`` and ``NAME_y``, each the column of an attribute of shape (n, 2)."""
    for name, source in sources.items():
        for place, direction in enumerate(("x", "y")):
            setattr(kind, f"{name}_{direction}", _column(source, place))


def _column(source: str, place: int) -> property:
    def one(self: HistoryResult) -> FloatArray:
        values: FloatArray = getattr(self, source)
        return values[:, place]

    return property(one, doc=f"Column {place} of `{source}`.")


add_directions(PlaneResult, displacement="displacement_vectors", velocity="velocity_vectors", force="force_vectors")  # fmt: skip
