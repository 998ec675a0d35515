"""What is told of the analysis of a building: as a whole, of each bearing, and of each level."""

from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dcfp.analysis.plane_response import PLANE_HISTORIES, PLANE_PEAKS
from dcfp.analysis.response import PEAKS
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import (
    DEGC,
    KN,
    KN_M,
    M_PER_S2,
    METRE,
    MM,
    MM_PER_S2,
    N_MM,
    N_PER_MM2,
    NEWTON,
    NONE,
    SECOND,
    Unit,
)

if TYPE_CHECKING:
    from dcfp.analysis.plan.response import PlanResponse
    from dcfp.arrays import FloatArray

RADIAN = Unit("rad", udunits="radian", typed="rad")


class BearingPeaks(NamedTuple):
    """Peaks of one bearing of a building, in the units of the package."""

    number: int
    type: str
    x: float
    y: float
    static_load: float
    least_load: float
    largest_load: float
    largest_pressure: float
    displacement: float
    force: float
    temperature: float
    travel: float
    uplift_time: float


class LevelPeaks(NamedTuple):
    """Peaks of the slab, number 0, or of a floor and the storey below it, in the units of the package; None for what a slab has not."""

    number: int
    height: float
    acceleration: float
    corner_acceleration: float
    drift: float | None
    drift_ratio: float | None
    corner_drift_ratio: float | None
    shear: float
    shear_ratio: float
    overturning: float


def bearing_peaks(response: "PlanResponse") -> list[BearingPeaks]:
    """Return the peaks of every bearing."""
    plan, systems = response.plan, response.plan.systems
    forces = np.hypot(response.bearing_force[..., 0], response.bearing_force[..., 1]).max(axis=0)
    areas = np.array([one.bearing.slider_area for one in systems])
    columns = np.column_stack(
        (
            plan.places,
            plan.static_loads,
            response.least_load,
            response.largest_load,
            response.largest_load / areas,
            response.peak_bearing_displacement,
            forces,
            response.peak_temperature,
            response.travel,
            response.uplift_time,
        )
    ).tolist()
    return [BearingPeaks(i + 1, systems[i].bearing.name, *row) for i, row in enumerate(columns)]


def level_peaks(response: "PlanResponse") -> list[LevelPeaks]:
    """Return the peaks of the slab and of every floor, from below."""
    plan = response.plan
    heights = np.concatenate(([0.0], plan.structure.heights))
    shears, tipping = _storey_forces(response)
    storeys = np.array([one.height for one in plan.storeys])
    drifts, corners = response.peak_drift, _at_corners(response, response.drift)
    accelerations = _accelerations(response)
    slab = LevelPeaks(
        0, 0.0, *accelerations[0], None, None, None, shears[0], shears[0] / plan.weight, tipping[0]
    )  # fmt: skip
    floors = [
        LevelPeaks(
            i + 1,
            float(heights[i + 1]),
            *accelerations[i + 1],
            float(drifts[i]),
            _over(float(drifts[i]), float(storeys[i])),
            _over(float(corners[i]), float(storeys[i])),
            shears[i + 1],
            shears[i + 1] / plan.weight,
            tipping[i + 1],
        )
        for i in range(len(plan.storeys))
    ]
    return [slab, *floors]


def _over(drift: float, height: float) -> float | None:
    return drift / height if height > 0.0 else None


def _accelerations(response: "PlanResponse") -> list[tuple[float, float]]:
    """Return the largest acceleration of each level on the axis of the centre of mass and in any corner [mm/s2]."""
    own = response.peak_floor_acceleration
    corners = np.maximum(_at_corners(response, response.floor_acceleration), own)
    return list(zip(own.tolist(), corners.tolist(), strict=True))


def _at_corners(response: "PlanResponse", values: "FloatArray") -> "FloatArray":
    """Return the largest resultant at any corner of what is x, y and rotation on the axis of the centre of mass, shape (levels,)."""
    arms = response.plan.corners - np.array(response.plan.mass_centre)
    found = np.zeros(values.shape[1])
    for x, y in arms.tolist():
        there = np.hypot(values[..., 0] - y * values[..., 2], values[..., 1] + x * values[..., 2])
        found = np.maximum(found, there.max(axis=0))
    return found


def _storey_forces(response: "PlanResponse") -> tuple[list[float], list[float]]:
    """Return the largest shear below each level [N], that of the slab the base shear, and the largest overturning moment there [N mm]."""
    plan = response.plan
    base = float(response.peak_base_shear)
    tipping = float(np.hypot(*response.overturning.T).max())
    if not plan.storeys:
        return [base], [tipping]
    forces = response.floor_force[..., :2]
    above = np.cumsum(forces[:, ::-1], axis=1)[:, ::-1]
    shears = np.hypot(above[..., 0], above[..., 1]).max(axis=0)
    storeys = np.array([one.height for one in plan.storeys])
    moments = np.cumsum((above * storeys[:, np.newaxis])[:, ::-1], axis=1)[:, ::-1]
    largest = np.hypot(moments[..., 0], moments[..., 1]).max(axis=0)
    return [base, *shears.tolist()], [tipping, *largest.tolist()]


#: Columns of bearings.
BEARINGS = (
    Quantity("number", "number of the bearing", NONE, decimals=0, head="No.", get="number"),
    Quantity("type", "type of the bearing", head="Type", get="type"),
    Quantity("x_m", "place in x", METRE, decimals=2, places=9, head="x", get="x"),
    Quantity("y_m", "place in y", METRE, decimals=2, places=9, head="y", get="y"),
    Quantity("load_static_kN", "static load", KN, decimals=0, head="N_0", get="static_load"),
    Quantity("load_min_kN", "smallest load", KN, decimals=0, head="N_min", get="least_load"),
    Quantity("load_max_kN", "largest load", KN, decimals=0, head="N_max", get="largest_load"),
    Quantity("pressure_max_N_mm2", "largest pressure", N_PER_MM2, decimals=0, head="p_max", get="largest_pressure"),
    Quantity("y_max_mm", "largest displacement", MM, decimals=1, head="y_max", get="displacement"),
    Quantity("force_max_kN", "largest horizontal force", KN, decimals=0, head="F_max", get="force"),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, decimals=0, head="T_max", get="temperature"),
    Quantity("travel_mm", "length of the path of sliding", MM, METRE, 2, head="Travel", get="travel"),
    Quantity("uplift_s", "time without contact", SECOND, decimals=2, head="Uplift", get="uplift_time"),
)  # fmt: skip

#: Columns of slab and floors.
LEVELS = (
    Quantity("level", "level: 0 is the slab", NONE, decimals=0, head="Level", get="number"),
    Quantity("height_m", "height above the slab", METRE, decimals=2, head="Height", get="height"),
    Quantity("acceleration_max_m_s2", "largest absolute acceleration at the centre of mass", M_PER_S2, decimals=2, head="a_max", get="acceleration"),
    Quantity("acceleration_corner_m_s2", "largest absolute acceleration in a corner", M_PER_S2, decimals=2, head="a corner", get="corner_acceleration"),
    Quantity("drift_max_mm", "largest drift of the storey below", MM, decimals=2, head="drift", get="drift"),
    Quantity("drift_ratio", "largest drift over the height of the storey", NONE, digits=3, head="drift/h", get="drift_ratio"),
    Quantity("drift_ratio_corner", "largest drift in a corner over the height of the storey", NONE, digits=3, head="corner\ndrift/h", get="corner_drift_ratio"),
    Quantity("shear_max_kN", "largest shear below the level", KN, decimals=0, head="V_max", get="shear"),
    Quantity("shear_ratio", "that over the weight of the building", NONE, decimals=4, head="V/W", get="shear_ratio"),
    Quantity("overturning_max_kN_m", "largest overturning moment below the level", KN_M, decimals=0, head="M_max", get="overturning"),
)  # fmt: skip


def bearing_table(response: "PlanResponse") -> Table:
    """Return the peaks of every bearing as a table."""
    return Table(BEARINGS, bearing_peaks(response), "Bearings")


def level_table(response: "PlanResponse") -> Table:
    """Return the peaks of slab and floors as a table."""
    return Table(LEVELS, level_peaks(response), "Slab and floors")


#: What is told of the analysis of a building: the keys of a response in the plane at the centre of mass, and those of a building.
PLAN_PEAKS = Quantities("peak of a building's response")
PLAN_PEAKS.take(PLANE_PEAKS, "record", "peak_ground_velocity")
for _name, _words in (("law", "friction laws"), ("heating", "heating models")):
    PLAN_PEAKS.add(
        _name, Quantity(PEAKS.defined[_name].key, f"{_words} of the bearings", printed=False, get=f"{_name}s")
    )
PLAN_PEAKS.take(PLANE_PEAKS, "peak_displacement")
PLAN_PEAKS.take(
    PLANE_PEAKS, "peak_displacement_x", "peak_displacement_y", "peak_change", "peak_velocity", printed=False
)
for _one in (
    Quantity("corner_max_mm", "largest displacement of a corner of the slab", MM, decimals=1, symbol=r"y_{\mathrm{corner}}", name="corner_max", head="corner", get="peak_corner_displacement"),
    Quantity("corner_ratio", "largest displacement of a corner over that of the centre of mass", NONE, decimals=3, head="corner/\ny_max", get="corner_ratio"),
    Quantity("rotation_max_rad", "largest rotation of the slab", RADIAN, digits=2, symbol=r"\theta_{\mathrm{max}}", name="rotation_max", head="rotation", printed=False, get="peak_rotation"),
):  # fmt: skip
    PLAN_PEAKS.add(_one.title, _one)
PLAN_PEAKS.take(PLANE_PEAKS, "residual_displacement")
PLAN_PEAKS.add("base_shear", Quantity("base_shear_kN", "largest base shear", KN, decimals=0, symbol=r"V_{\mathrm{max}}", name="base_shear", head="V_base", printed=False, get="peak_base_shear"))  # fmt: skip
PLAN_PEAKS.take(PLANE_PEAKS, "peak_force", printed=False, get=attrgetter("peak_base_shear"))
PLAN_PEAKS.take(PLANE_PEAKS, "force_ratio", head="V/W")
PLAN_PEAKS.take(PLANE_PEAKS, "peak_temperature", get=attrgetter("hottest"))
for _name, _head, _source in (
    ("least_load", "N_min", "least_load_of_all"),
    ("largest_load", "N_max", "largest_load_of_all"),
):
    PLAN_PEAKS.take(PLANE_PEAKS, _name, printed=True, head=_head, get=attrgetter(_source))
for _one in (
    Quantity("uplift", "whether a bearing ever lifts off", printed=False),
    Quantity("uplift_max_s", "longest time of a bearing without contact", SECOND, decimals=2, name="uplift_max", printed=False, get=lambda one: float(one.uplift_time.max())),
    Quantity("drift_ratio_largest", "largest drift of a storey over its height", NONE, digits=3, head="drift/h", stored=False, get=lambda one: max((ratio for ratio in one.drift_ratios if ratio is not None), default=None)),
    Quantity("floor_acceleration_largest", "largest acceleration of slab and floors", M_PER_S2, decimals=2, head="a_max", stored=False, get=lambda one: float(one.peak_floor_acceleration.max())),
    Quantity("drift_ratio_max", "largest drift of each storey over its height, from below", NONE, printed=False, flat=False, get="drift_ratios"),
    Quantity("floor_acceleration_max_m_s2", "largest acceleration of the slab and of each floor, from below", M_PER_S2, printed=False, flat=False, get="peak_floor_acceleration"),
):  # fmt: skip
    PLAN_PEAKS.add(_one.title, _one)
PLAN_PEAKS.take(PLANE_PEAKS, "input_velocity")
PLAN_PEAKS.take(PLANE_PEAKS, "hysteretic_velocity", "relative_energy_residual", printed=False)
PLAN_PEAKS.take(PLANE_PEAKS, "status", printed=False)
for _one in (
    Quantity("storeys", "number of storeys", NONE, decimals=0, printed=False, get=lambda one: len(one.plan.storeys)),
    Quantity("damping", "kind of damping of the storeys and its ratio", printed=False, get="damping_words"),
    Quantity("bearings", "peaks of every bearing", printed=False, flat=False, get=lambda one: bearing_table(one).objects()),
    Quantity("levels", "peaks of slab and floors", printed=False, flat=False, get=lambda one: level_table(one).objects()),
):  # fmt: skip
    PLAN_PEAKS.add(_one.key, _one)
PLAN_PEAKS.take(PLANE_PEAKS, "elapsed")

#: Its histories: of the centre of mass, and with one more dimension of bearings and levels.
PLAN_HISTORIES = Quantities("history of a building's response")
PLAN_HISTORIES.take(
    PLANE_HISTORIES,
    "ground_acceleration_x",
    "ground_acceleration_y",
    "displacement_x",
    "displacement_y",
    "displacement",
)
PLAN_HISTORIES.add("rotation", Quantity("rotation", "rotation of the slab", RADIAN, symbol=r"\theta"))
PLAN_HISTORIES.take(PLANE_HISTORIES, "velocity_x", "velocity_y", "force_x", "force_y")
for _one in (
    Quantity("torque", "torque of the bearings about the centre of mass", N_MM, KN_M, symbol="M_z"),
    Quantity("overturning_x", "moment on the loads of bearings far in x", N_MM, KN_M, symbol="M_x"),
    Quantity("overturning_y", "moment on the loads of bearings far in y", N_MM, KN_M, symbol="M_y"),
):  # fmt: skip
    PLAN_HISTORIES.add(_one.key, _one)
PLAN_HISTORIES.take(
    PLANE_HISTORIES,
    "input_energy",
    "absolute_input_energy",
    "kinetic_energy",
    "strain_energy",
    "hysteretic_energy",
)
PLAN_HISTORIES.add("damping_energy", Quantity("damping_energy", "energy taken by the damping of the storeys", N_MM, KN_M, symbol=r"E_\xi", get="energy.damping"))  # fmt: skip
PLAN_HISTORIES.take(PLANE_HISTORIES, "energy_residual")
_OF_BEARINGS = (
    ("load", "vertical force", NEWTON, KN, "N"),
    ("friction", "coefficient of friction", NONE, NONE, r"\mu"),
    ("temperature", "temperature of the contact", DEGC, DEGC, "T"),
)
_OF_LEVELS = (
    ("floor_displacement", "displacement of slab and floors at the centre of mass", MM, MM, "u"),
    (
        "floor_acceleration",
        "absolute acceleration of slab and floors at the centre of mass",
        MM_PER_S2,
        M_PER_S2,
        "a",
    ),
    ("drift", "drift of each storey at the centre of mass", MM, MM, r"\delta"),
)
#: Second dimension of histories that have one.
DIMENSIONS: dict[str, str] = {}
for _key, _words, _unit, _shown, _symbol in _OF_BEARINGS:
    DIMENSIONS[f"bearing_{_key}"] = "bearing"
    PLAN_HISTORIES.add(
        f"bearing_{_key}",
        Quantity(f"bearing_{_key}", f"{_words} of each bearing", _unit, _shown, symbol=_symbol),
    )
for _key, _words, _unit, _shown, _symbol in (
    ("bearing_displacement", "displacement of each bearing", MM, MM, "y"),
    ("bearing_force", "horizontal force of each bearing", NEWTON, KN, "F"),
    *_OF_LEVELS,
):
    for _place, _name in enumerate(("x", "y")):
        DIMENSIONS[f"{_key}_{_name}"] = (
            "bearing" if "bearing" in _key else "storey" if _key == "drift" else "level"
        )
        PLAN_HISTORIES.add(
            f"{_key}_{_name}",
            Quantity(
                f"{_key}_{_name}", f"{_words} in direction {_name}", _unit, _shown, symbol=f"{_symbol}_{{{_name}}}",
                get=lambda one, key=_key, place=_place: getattr(one, key)[..., place],
            ),
        )  # fmt: skip


def residual_displacement(response: "PlanResponse") -> "FloatArray":
    """Return where the centre of mass stays when the last elastic oscillation has died away, x and y [mm]."""
    plan, kernel = response.plan, response.model.kernel
    stiffness, pull = kernel.stiffness.copy(), np.zeros(3)
    anchors = response.bearing_displacement[-1] - response.bearing_elongation[-1]
    for (x, y), kf, anchor in zip(plan.arms, plan.elastic_stiffnesses, anchors, strict=True):
        own = np.array([[1.0, 0.0, -y], [0.0, 1.0, x]])
        stiffness = stiffness + kf * own.T @ own
        pull = pull + kf * own.T @ anchor
    scale = np.diag([1.0, 1.0, 1.0 / max(float(np.abs(plan.arms).max()), 1.0)])  # millimetres for radians
    found = scale @ np.linalg.lstsq(scale @ stiffness @ scale, scale @ pull, rcond=1e-12)[0]
    return np.asarray(found[:2], dtype=np.float64)


def axial_ratio(response: "PlanResponse") -> tuple[float, float]:
    """Return the smallest and the largest load of any bearing over its static one [-]."""
    static = response.plan.static_loads
    return float((response.least_load / static).min()), float((response.largest_load / static).max())


def worst_corner(response: "PlanResponse") -> tuple["FloatArray", float, float]:
    """Return the corner that goes furthest [mm], its largest displacement [mm] and the time of that [s]."""
    place = int(response.corner_displacements.argmax())
    corner = response.plan.corners[place]
    path = response.displacement_at((float(corner[0]), float(corner[1])))
    when = float(response.time[int(np.hypot(*path.T).argmax())])
    return corner, float(response.corner_displacements[place]), when
