"""A building on twelve bearings with three storeys: the script that is exported, run by OpenSees, beside the analysis that it repeats.

Both have one friction coefficient and the same steps for what is looked at from sample to sample. What is different, and what that amounts to, measured on these buildings:

* the friction of OpenSees follows the direction of the velocity to the first order of its step: the displacement is 0.10 % more with 1 ms, 0.04 % with half of it;
* its pendulum's force is (u/R)^2 more, and its friction is that of the force normal to the surface, 0.1 % more at the peak;
* its friction acts where the slider is, which stays behind the slab where the loads follow the overturning moment, and here at the bearing's place in the slab: the rotation is
  0.9 % more for it, and 6 % where bearings lift off. Loads that follow the sliders' place without that turn a building that constant friction does not turn. With sliders
  that stay under the slab, the plate of a single concave bearing being below, neither is there, and the rotation is the same to 0.1 %;
* springs that stand for what is rigid let a tall building rock, in 14 ms where they have 1e10 N/mm, which takes 5 % from the largest load; with 1e12 N/mm it is the same to 0.1 %.
"""

import csv
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path

import numpy as np

from dcfp.analysis.plan import PlanResponse, respond_plan
from dcfp.arrays import FloatArray
from dcfp.exchange.opensees import plan_script
from dcfp.motion.station import Station
from dcfp.system import LI_2020, Bearing, ConstantFriction, NoHeating, System
from dcfp.system.plan import Plan, grid
from dcfp.system.storeys import Storey
from dcfp.verify.check import Found, scaled_station
from dcfp.verify.opensees import require, run_apart

#: Seconds of the station that hold its peaks.
_STRONG = 6.0
_DOUBLE = System(LI_2020, ConstantFriction(), NoHeating())
_SINGLE = System(
    Bearing(
        (LI_2020.effective_radius,), LI_2020.slider_diameter, LI_2020.pressure, LI_2020.elastic_stiffness
    ),
    ConstantFriction(),
    NoHeating(),
)


@dataclass(frozen=True)
class Case:
    """A building and how it is shaken: PGV [mm/s], and whether the loads follow the overturning moment."""

    plan: Plan
    velocity: float = 500.0
    overturning: bool = True

    @property
    def motion(self) -> Station:
        """The part of the ground motion that holds its peaks."""
        whole = scaled_station("P695-FF-2", self.velocity)
        count = round(_STRONG / whole.time_step) + 1
        x, y = (replace(one, acceleration=one.acceleration[:count]) for one in (whole.x, whole.y))
        return replace(whole, x=x, y=y, vertical=None)


def _building(system: System, spacing: float, height: float, stiffness: tuple[float, float]) -> Plan:
    """Return three storeys on four by three bearings whose mass is 5 % of the sides off the middle."""
    floor = 12 * LI_2020.mass / 4
    return Plan(
        grid([spacing * i for i in range(4)], [spacing * i for i in range(3)]),
        system,
        eccentricity=(0.05, 0.05),
        height=0.2 * height,
        storeys=(Storey(floor, stiffness, height),) * 3,
    )


_STIFFNESS = (1.4e6, 1.1e6)
CASES = {
    "even loads": Case(_building(_DOUBLE, 6000.0, 3500.0, _STIFFNESS), overturning=False),
    "overturning": Case(_building(_SINGLE, 6000.0, 3500.0, _STIFFNESS)),
    "uplift": Case(_building(_DOUBLE, 3000.0, 12000.0, (2.0e6, 1.6e6)), velocity=600.0),
}


@dataclass(frozen=True)
class Both:
    """An analysis, and the history of OpenSees by the heads of its columns."""

    own: PlanResponse
    theirs: dict[str, FloatArray]

    def of_vector(self, name: str) -> float:
        """Return the largest magnitude of a vector whose columns are called by the name with x and y in it."""
        return float(np.hypot(*(self.theirs[name.format(axis)] for axis in "xy")).max())

    @cached_property
    def loads(self) -> FloatArray:
        """Loads of the bearings by OpenSees [N], shape (n, bearings)."""
        return np.column_stack([self.theirs[f"load {i} [N]"] for i in range(1, 1 + self.own.plan.count)])


@cache
def _both(case: str) -> Both:
    require()
    one = CASES[case]
    motion = one.motion
    with tempfile.TemporaryDirectory() as folder:
        script, history = Path(folder, "building.py"), Path(folder, "history.csv")
        script.write_text(
            plan_script(one.plan, motion, overturning=one.overturning, tail=0.0), encoding="utf-8"
        )
        run_apart(script, history)
        with history.open(encoding="utf-8", newline="") as file:
            head, *rows = csv.reader(file)
    theirs = dict(zip(head, np.array(rows, dtype=np.float64).T, strict=True))
    step = float(theirs["time [s]"][1])
    own = respond_plan(one.plan, motion, overturning=one.overturning, tail=0.0, step=step)
    return Both(own, theirs)


def peak(case: str, quantity: str) -> Found:
    """Return a peak displacement [mm] or rotation [mrad], and that of OpenSees."""
    both = _both(case)
    own, theirs = both.own, both.theirs
    if quantity == "rotation":
        turn = float(np.abs(theirs["rotation [rad]"]).max())
        return Found(1e3 * own.peak_rotation, 1e3 * turn, unit="mrad")
    if quantity == "corner displacement":
        corners = max(both.of_vector(f"corner {i} {{}} [mm]") for i in range(1, 5))
        return Found(own.peak_corner_displacement, corners, unit="mm")
    return Found(own.peak_displacement, both.of_vector("displacement {} [mm]"), unit="mm")


def floors(case: str, quantity: str) -> Found:
    """Return the peak drift [mm] or acceleration [m/s2] of the floor whose peak differs most, and that of OpenSees."""
    both = _both(case)
    if quantity == "drift":
        own, unit, name = both.own.peak_drift, "mm", "drift {} {{}} [mm]"
    else:
        own, unit, name = both.own.peak_floor_acceleration[1:] / 1e3, "m/s2", "acceleration {} {{}} [mm/s2]"
    theirs = np.array([both.of_vector(name.format(j)) for j in range(1, 1 + own.size)])
    theirs = theirs if quantity == "drift" else theirs / 1e3
    worst = int(np.abs(own / theirs - 1.0).argmax())
    return Found(float(own[worst]), float(theirs[worst]), unit=unit, words={"floor": worst + 1})


def largest_load(case: str) -> Found:
    """Return the largest load of any bearing, and that of OpenSees [kN]."""
    both = _both(case)
    return Found(float(both.own.largest_load.max()) / 1e3, float(both.loads.max()) / 1e3)


def balance(case: str) -> Found:
    """Return how far the loads of all bearings are from the weight at the worst step of OpenSees, over the weight [-]."""
    both = _both(case)
    sums = both.loads.sum(axis=1)
    worst = float(sums[np.abs(sums - both.own.plan.weight).argmax()])
    own = float(np.abs(both.own.bearing_load.sum(axis=1) / both.own.plan.weight - 1.0).max())
    return Found(worst / 1e3, both.own.plan.weight / 1e3, words={"steps": sums.size - 1, "own": own})


def number_of_uplifts(case: str) -> Found:
    """Return how often bearings lift off, and how often by OpenSees [-]."""
    own, theirs = _uplifts_of_both(case)
    return Found(float(len(own)), float(len(theirs)), words=_told(case))


def times_of_uplifts(case: str) -> Found:
    """Return the moment at which a bearing lifts off or lands that differs most, and that of OpenSees [s]."""
    own, theirs = _uplifts_of_both(case)
    if [one[0] for one in own] != [one[0] for one in theirs] or not own:
        return Found(float("nan"), 0.0, words=_told(case))
    found, expected = (np.array([one[1:] for one in each]).ravel() for each in (own, theirs))
    worst = int(np.abs(found - expected).argmax())
    return Found(float(found[worst]), float(expected[worst]), words=_told(case))


def _uplifts_of_both(case: str) -> tuple[list[tuple[int, float, float]], list[tuple[int, float, float]]]:
    both = _both(case)
    return sorted(_uplifts(both.own.time, both.own.bearing_load)), sorted(
        _uplifts(both.theirs["time [s]"], both.loads)
    )


def _uplifts(time: FloatArray, loads: FloatArray) -> Iterator[tuple[int, float, float]]:
    """Yield bearing, and when it lifts off and lands [s], of loads [N] by time and bearing."""
    for i, load in enumerate(loads.T):
        off = np.concatenate(([False], load <= 0.0, [False])).astype(int)
        (starts,), (ends,) = np.nonzero(np.diff(off) == 1), np.nonzero(np.diff(off) == -1)
        for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
            yield i, float(time[start]), float(time[end - 1])


def _told(case: str) -> dict[str, object]:
    """Return what notes say of uplifts: how many bearings, how many at once, and for how long the longest."""
    both = _both(case)
    off = both.own.bearing_load <= 0.0
    return {
        "bearings": int(off.any(axis=0).sum()),
        "at_once": int(off.sum(axis=1).max()),
        "longest": 1e3 * float(both.own.uplift_time.max()),
        "step": 1e3 * float(both.theirs["time [s]"][1]),
    }
