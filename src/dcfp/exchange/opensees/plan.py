"""A script for OpenSeesPy of an isolated building: every bearing of its plan, the slab and the storeys on them."""

from dcfp.analysis.integration import Integration
from dcfp.analysis.plan import PlanResponse, respond_plan
from dcfp.analysis.plan.model import left_behind
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.exchange.opensees.plan_friction import as_exported, elements_of, reasons_of
from dcfp.exchange.opensees.plan_head import Exported, plan_head
from dcfp.exchange.opensees.script import FURTHEST, PART_IN_PLANE, STEP, ground_of, template, text_of
from dcfp.kernels import plan_end as e
from dcfp.motion.ground_motion import parts_in
from dcfp.motion.station import Station
from dcfp.system.plan import Plan


def plan_script(
    plan: Plan,
    motion: Station,
    *,
    vertical: bool = False,
    overturning: bool = True,
    step: float | None = None,
    tail: float | None = None,
) -> str:
    """Return a script for OpenSeesPy that analyses an isolated building under the ground motion of a station.

    The script carries the ground motion, needs nothing but Python and openseespy, prints its peaks beside those of this package, and writes its history
    as CSV. Its head says what stands for bearings, slab and storeys, and what is different; where that is friction or damping, by how much.

    Parameters
    ----------
    plan, motion, vertical, overturning, tail
        As for `dcfp.analysis.plan.respond_plan`.
    step
        Longest step of the script [s]; by default 1 ms and at most a tenth of the time step of the motion.

    Raises
    ------
    InputError
        If OpenSees has no element that comes near, modes stand in place of storeys, a bearing goes too far for it, all bearings lift off at once, or a value is out of range.
    """
    if plan.modes is not None:
        msg = f"{plan.name}: modes in place of storeys are no springs between floors, of which a model of OpenSees is made; give the stiffnesses of the storeys."
        raise InputError(msg)
    if step is None:
        step = min(STEP, PART_IN_PLANE * motion.time_step)
    Integration(step=step)  # refuses a step out of range
    interval = motion.time_step / parts_in(motion.time_step, step)

    def analyse(building: Plan) -> PlanResponse:
        return respond_plan(building, motion, vertical=vertical, overturning=overturning, tail=tail)

    response = analyse(plan)
    _refuse(response)
    elements = elements_of(response)
    reasons = reasons_of(plan, elements, changes=vertical or overturning)
    other = analyse(as_exported(plan, elements)) if reasons else None
    exported = Exported(elements, response, other, reasons, overturning, vertical, interval)
    return "\n".join([*plan_head(exported), "", _body(exported), ""])


def _refuse(response: PlanResponse) -> None:
    """Refuse what a model of OpenSees does not do as this package does."""
    name, reach = response.motion.name, response.peak_bearing_displacement / response.plan.radii
    if reach.max() > FURTHEST:
        worst = int(reach.argmax())
        msg = (
            f"{name}: the displacement of bearing {worst + 1}, {response.peak_bearing_displacement[worst]:.0f} mm, is too near to its effective radius of"
            f" {response.plan.radii[worst]:.0f} mm, at which the pendulum of OpenSees ends."
        )
        raise InputError(msg)
    if response.tallies[e.ALL_LIFTED] > 0.0:
        msg = f"{name}: all bearings lift off at once, where OpenSees has nothing that holds the building; scale the motion down, or leave its vertical part out."
        raise InputError(msg)


def _body(exported: Exported) -> str:
    response = exported.response
    motion = response.motion
    components = (motion.x, motion.y, *([motion.require_vertical()] if exported.vertical else []))
    return template("plan_body").substitute(
        constants="\n".join(_constants(exported)),
        model=text_of("plan_model"),
        advance=text_of("advance_cold"),
        record=text_of("record"),
        ground=ground_of(components),
    )


def _constants(exported: Exported) -> list[str]:
    """Return the constants of a script, with their units and where they come from."""
    response = exported.response
    plan = response.plan
    time_of_damping = 2.0 * plan.damping / float(plan.structure.modes[0][0]) if plan.storeys else 0.0
    # of the axis through the centre of mass, on which results are told
    x, y = map(float, plan.mass_centre)
    return [
        "# The building: slab and floors, and the storeys between them, from below.",
        "SLAB_BODY = " + _row((x, y, plan.height, plan.slab_mass, plan.slab_inertia)) + "  # of its mass x, y, z [mm]; mass [t], inertia about it [t mm2]",
        "FLOORS = [",
        *(f"    {_row(one)}," for one in _floors(plan)),
        "]",
        "STOREYS = [  # centre of stiffness x, y [mm]; angle of the axes [rad]; stiffness along them [N/mm], about the vertical axis [N mm]",
        *(f"    {_row(one)}," for one in _storeys(plan)),
        "]",
        f"DAMPING = {time_of_damping!r}  # s, of the dashpots of a storey over its springs: 2 ratio / circular frequency of the first mode on a fixed base",
        f"CORNERS = [{', '.join(_row(one) for one in plan.corners.tolist())}]  # mm, of the slab",
        "",
        "# The bearings: x, y [mm], static load [N], sum of the radii [mm], stiffness before sliding without the pendulum [N/mm],",
        "# friction at high speed and at none [-], rate of its rise with the relative speed of the plates [s/mm; 0 for none],",
        "# part of the load that presses where the bearing stood under the slab at rest, for the slider stays behind [-].",
        "BEARINGS = [",
        *(f"    {_row(one)}," for one in _bearings(exported)),
        "]",
        f"OVERTURNING = {exported.overturning}  # whether the loads follow the overturning moment",
        f"GRAVITY = {STANDARD_GRAVITY!r}  # mm/s2",
        "",
        "# How finely and how far.",
        f"STEP = {exported.step!r}  # s, a whole part of the interval of the record",
        f"DURATION = {float(response.time[-1]):.9g}  # s",
        "",
        "# Peaks by dcfp: with the friction and damping of this script, and of the building itself; motions on the vertical axis through the",
        "# centre of mass.",
        "PEAKS = [",
        *(f"    {(*same, own[-1])!r}," for same, own in zip(_peaks(exported.other or response), _peaks(response), strict=True)),
        "]",
        "COLUMNS = [",
        *(f"    {one!r}," for one in _columns(plan)),
        "]",
    ]  # fmt: skip


def _row(values: tuple[float, ...] | list[float]) -> str:
    return f"({', '.join(repr(float(value)) for value in values)})"


def _floors(plan: Plan) -> list[tuple[float, ...]]:
    heights = plan.height + plan.structure.heights
    return [
        (*(one.centre or plan.mass_centre), float(heights[j]), one.mass, one.inertia_over(plan.lengths))
        for j, one in enumerate(plan.storeys)
    ]


def _storeys(plan: Plan) -> list[tuple[float, ...]]:
    return [
        (*(one.stiffness_centre or plan.middle), plan.angle, *one.stiffnesses, one.twist_over(plan.lengths))
        for one in plan.storeys
    ]


def _bearings(exported: Exported) -> list[tuple[float, ...]]:
    plan = exported.response.plan
    rows: list[tuple[float, ...]] = []
    for i, (system, element) in enumerate(zip(plan.systems, exported.elements, strict=True)):
        above = left_behind(system) if exported.overturning else 0.0
        x, y = plan.places[i].tolist()
        stiffness, radius = float(plan.elastic_stiffnesses[i]), float(plan.radii[i])
        slow = element.slow if element.rate > 0.0 else element.friction
        rows.append((x, y, float(plan.static_loads[i]), radius, stiffness, element.friction, slow, element.rate, above))  # fmt: skip
    return rows


def _peaks(response: PlanResponse) -> list[tuple[str, str, float]]:
    """Return name, unit and value of each peak."""
    drifts, accelerations = response.peak_drift, response.peak_floor_acceleration / 1e3
    return [
        ("peak displacement", "mm", response.peak_displacement),
        ("corner displacement", "mm", response.peak_corner_displacement),
        ("rotation", "mrad", 1e3 * response.peak_rotation),
        *((f"drift of storey {j}", "mm", float(one)) for j, one in enumerate(drifts, 1)),
        *((f"acceleration {_level(j)}", "m/s2", float(one)) for j, one in enumerate(accelerations)),
        ("least load", "kN", float(response.least_load.min()) / 1e3),
        ("largest load", "kN", float(response.largest_load.max()) / 1e3),
        ("time without load", "s", float(response.uplift_time.max())),
    ]


def _level(j: int) -> str:
    return f"of floor {j}" if j else "of the slab"


def _columns(plan: Plan) -> list[str]:
    storeys = len(plan.storeys)
    return [
        "time [s]", "displacement x [mm]", "displacement y [mm]", "rotation [rad]",
        *(f"corner {i} {axis} [mm]" for i in range(1, 5) for axis in "xy"),
        *(f"drift {j} {axis} [mm]" for j in range(1, 1 + storeys) for axis in "xy"),
        *(f"acceleration {j} {axis} [mm/s2]" for j in range(1 + storeys) for axis in "xy"),
        *(f"load {i} [N]" for i in range(1, 1 + plan.count)),
    ]  # fmt: skip
