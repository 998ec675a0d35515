"""The head of a script for OpenSees of an isolated building: what it is, of what, and what is different from the analysis of this package."""

from collections.abc import Iterator
from dataclasses import dataclass

from dcfp.analysis.plan import PlanResponse
from dcfp.exchange.opensees.element import Element
from dcfp.exchange.opensees.head import comments, difference_in_words, parameters_of, told_of
from dcfp.schema.citations import citations_of
from dcfp.system import System
from dcfp.system.plan import BY_LOAD, Plan
from dcfp.system.storeys import MODAL


@dataclass(frozen=True)
class Exported:
    """A building as OpenSees has it.

    Attributes
    ----------
    elements
        Friction of each bearing.
    response, other
        The analysis of this package, and the one of what the elements are, None where that is the same.
    reasons
        In words, why it is not.
    overturning, vertical
        Whether the loads follow the overturning moment and the vertical motion.
    step
        Of the script [s].
    """

    elements: tuple[Element, ...]
    response: PlanResponse
    other: PlanResponse | None
    reasons: tuple[str, ...]
    overturning: bool
    vertical: bool
    step: float


def plan_head(exported: Exported) -> list[str]:
    """Return the lines of comment at the top of a script."""
    plan, motion = exported.response.plan, exported.response.motion
    return comments(
        f"{plan.name} under {motion.name}: a building on {plan.count} friction pendulum bearings",
        list(_inputs(exported)),
        "In OpenSees every bearing is the element singleFPBearing, with the friction model Coulomb or VelDependent.",
        list(_representation(exported)),
        list(_differences(exported)),
    )


def _inputs(exported: Exported) -> Iterator[tuple[str, str]]:
    response = exported.response
    plan, loads = response.plan, response.plan.static_loads
    yield "Ground motion", told_of(response.motion)
    x, y = plan.mass_centre
    yield (
        "Building",
        (
            f"{plan.total_mass:.6g} t, of which {plan.slab_mass:.6g} t are the slab's, and {len(plan.storeys)} storeys;"
            f" centre of mass at {x:.6g}, {y:.6g} mm; sides {plan.lengths[0]:.6g} and {plan.lengths[1]:.6g} mm"
        ),
    )
    if plan.storeys:
        periods = ", ".join(f"{one:.4g}" for one in plan.structure.periods[:3])
        kind = "the same in every mode" if plan.damping_kind == MODAL else "in proportion to the stiffness"
        yield (
            "Damping",
            (f"ratio {plan.damping:g} on a fixed base, {kind}; first periods on a fixed base {periods} s"),
        )
    spring = "in proportion to its static load" if plan.spring == BY_LOAD else "that of its type"
    yield (
        "Bearings",
        (
            f"static loads from {loads.min() / 1e3:.6g} to {loads.max() / 1e3:.6g} kN; stiffness before sliding of each {spring}"
        ),
    )
    for number, one in enumerate(_types(plan), 1):
        yield f"Type {number}", _told_of_type(one)
    for line in citations_of(*(one.friction.citation for one in plan.systems)):
        yield "Source", line


def _types(plan: Plan) -> list[System]:
    found: list[System] = []
    for one in plan.systems:
        if one not in found:
            found.append(one)
    return found


def _told_of_type(system: System) -> str:
    bearing = system.bearing
    radii = " and ".join(f"{radius:g}" for radius in bearing.radii)
    return (
        f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, stiffness before sliding {bearing.elastic_stiffness:g} N/mm"
        f" at {bearing.vertical_force / 1e3:.6g} kN; friction {parameters_of(system.friction)}; heating {parameters_of(system.heating)}"
    )


def _representation(exported: Exported) -> Iterator[str]:
    plan = exported.response.plan
    double = any(len(one.bearing.radii) == 2 for one in plan.systems)
    if double:
        yield "The two plates are one with the sum of their radii."
    yield "Every bearing has its own static load, as an initial force, and its own friction and stiffness before sliding."
    yield "Slab and floors are rigid bodies whose masses move horizontally; the weight of all is on the slab."
    if plan.storeys:
        yield (
            "A storey is three springs at its centre of stiffness, along its two axes and about the vertical one, with dashpots beside them."
            " Nothing else is damped: not the bearings, and not the building on them as a rigid body."
        )
    if exported.overturning:
        yield (
            "The slab tips on the bearings, which are equally stiff vertically and carry no tension: so the loads follow the overturning moment,"
            " and those of bearings that lift off go to the others. Nothing has a vertical mass, so that landing makes no impact, as in dcfp."
        )
        if double:
            yield (
                "The load presses where the slider is, which stays behind the slab: a bearing is two elements side by side, one with its surface below"
                " and one with it above, which share its load as the plates share the displacement."
            )
    else:
        yield "The slab is kept upright, so that no moment changes the loads."
    if exported.vertical:
        yield "The vertical motion is a force on the slab, for the structure is rigid vertically."


def _differences(exported: Exported) -> Iterator[str]:
    response, other, plan = exported.response, exported.other, exported.response.plan
    if other is not None:
        yield (
            f"It is not what was analysed: {'; '.join(exported.reasons)}."
            f" With that dcfp finds a peak displacement of the centre of mass of {other.peak_displacement:.3f} mm, {difference_in_words(response, other)} analysis,"
            f" and {other.peak_corner_displacement:.3f} mm at the corners instead of {response.peak_corner_displacement:.3f} mm."
            " What follows comes on top."
        )
    away = float((response.peak_bearing_displacement / plan.radii).max())
    shear = response.peak_base_shear / plan.weight
    yield f"The pendulum's force is N u R / (R^2 - u^2), not N u / R: at the peak {100.0 * away**2:.3f} % more."
    yield (
        "The friction is of the force normal to the surface, which is larger than the load by the part of the horizontal force along it:"
        f" at the peak by about {100.0 * away * shear:.3f} %."
    )
    yield (
        "The friction follows the direction of the velocity to the first order of STEP: the displacement of a building on twelve bearings was 0.10 % more"
        " with 1 ms, and 0.04 % with half of it."
    )
    if exported.overturning and any(len(one.bearing.radii) == 2 for one in plan.systems):
        yield (
            "The horizontal force of a bearing acts where its slider is, in dcfp at the bearing's place in the slab, which turns the slab otherwise: on twelve"
            " bearings with 5 % eccentricity the rotation was 0.9 % more for it and the corner 0.15 %; where bearings lift off, 6 % and 0.2 %."
        )
