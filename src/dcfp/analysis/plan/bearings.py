"""What each bearing under a slab has gone through."""

from functools import cached_property

import numpy as np

from dcfp.analysis.plan.slab import SlabResponse
from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import plan_bearing as b


class BearingsResponse(SlabResponse):
    """Histories and peaks of the bearings."""

    @cached_property
    def bearing_displacement(self) -> FloatArray:
        """Displacement of each bearing [mm], shape (n, bearings, 2)."""
        turn, arms = self.slab_motion[:, 2:3], self.plan.arms
        x = self.slab_motion[:, 0:1] - turn * arms[:, 1]
        y = self.slab_motion[:, 1:2] + turn * arms[:, 0]
        return freeze(np.stack((x, y), axis=-1))

    @property
    def bearing_load(self) -> FloatArray:
        """Vertical force on each bearing [N], shape (n, bearings)."""
        return self.kept[:, :, b.N]

    @property
    def bearing_friction(self) -> FloatArray:
        """Coefficient of friction of each bearing [-], shape (n, bearings)."""
        return self.kept[:, :, b.MU]

    @property
    def bearing_temperature(self) -> FloatArray:
        """Temperature of the contact of each bearing [degC], the mean of its plates by their share of the travel, shape (n, bearings)."""
        table, constants = self.model.kernel.bearings.kinds, self.model.kernel.bearings.constants
        kinds = table[constants[:, b.KIND].astype(int)]
        second = np.where(kinds[:, b.PLATES] == 2.0, kinds[:, b.SHARE + 1], 0.0)
        first = 1.0 - second
        return first * self.kept[:, :, b.TEMPERATURE] + second * self.kept[:, :, b.TEMPERATURE + 1]

    @property
    def bearing_elongation(self) -> FloatArray:
        """Elongation of spring (b) of each bearing [mm], shape (n, bearings, 2)."""
        return self.kept[:, :, [b.E_X, b.E_Y]]

    @cached_property
    def bearing_force(self) -> FloatArray:
        """Horizontal force of each bearing against its displacement [N], shape (n, bearings, 2)."""
        spring = self.plan.elastic_stiffnesses[:, np.newaxis] * self.bearing_elongation
        pendulum = (self.bearing_load / self.plan.radii)[:, :, np.newaxis] * self.bearing_displacement
        return freeze(spring + pendulum)

    def _bearing_peak(self, column: int) -> FloatArray:
        return freeze(self.model.kernel.bearings.state[:, column])

    @property
    def peak_bearing_displacement(self) -> FloatArray:
        """Largest displacement of each bearing [mm], shape (bearings,)."""
        return self._bearing_peak(b.FURTHEST)

    @property
    def least_load(self) -> FloatArray:
        """Smallest load of each bearing [N], shape (bearings,)."""
        return self._bearing_peak(b.LEAST)

    @property
    def largest_load(self) -> FloatArray:
        """Largest load of each bearing [N], shape (bearings,)."""
        return self._bearing_peak(b.LARGEST)

    @property
    def peak_temperature(self) -> FloatArray:
        """Highest temperature of any plate of each bearing [degC], shape (bearings,)."""
        return self._bearing_peak(b.HOTTEST)

    @property
    def hottest(self) -> float:
        """Highest temperature of the contact of any bearing [degC]."""
        return float(self.peak_temperature.max())

    @property
    def least_load_of_all(self) -> float:
        """Smallest load of any bearing [N]."""
        return float(self.least_load.min())

    @property
    def largest_load_of_all(self) -> float:
        """Largest load of any bearing [N]."""
        return float(self.largest_load.max())

    @property
    def travel(self) -> FloatArray:
        """Length of the path over which each bearing has slid [mm], shape (bearings,)."""
        return self._bearing_peak(b.TRAVEL)

    @property
    def uplift_time(self) -> FloatArray:
        """Time for which each bearing has carried nothing [s], shape (bearings,)."""
        return self._bearing_peak(b.LIFTED)

    @property
    def uplift(self) -> bool:
        """Whether a bearing ever lifts off."""
        return bool(self.uplift_time.max() > 0.0)
