r"""
Figure 9: the mechanical model
==============================

**In the paper**: a rigid structure on springs (a), the pendulum, and (b), elastic, with the sliding element (c) behind it, and the yield surface of radius r\ :sub:`f` about O\ :sub:`Y`.

**Here**: what these elements do in the program, from the analysis of NCC at 0.5 m/s with constant friction, for which r\ :sub:`f` = μN/k\ :sub:`f` does not change. Left: the force is that of spring (a), a straight line, and of (b) and (c), a band about it. Right:
the yield surface about the largest displacement; O\ :sub:`Y` is dragged along while the slider slides, and stays while it sticks.
"""

import numpy as np
from matplotlib.figure import Figure

import dcfp
from dcfp.present.figures.style import BLUE, GREY, OCHRE, PAGE_WIDTH, RED, style

law = dcfp.ConstantFriction(0.043)
response = dcfp.respond(
    dcfp.load_motion("NCC").scaled_to_pgv(500.0), friction=law, heating=dcfp.NoHeating()
)
bearing = response.bearing
pendulum = bearing.restoring_stiffness * response.displacement
yield_force = 0.043 * bearing.vertical_force
radius = yield_force / bearing.elastic_stiffness  # rf
centre = response.displacement - (response.force - pendulum) / bearing.elastic_stiffness

turn = int(np.argmax(np.abs(response.displacement)))
near = slice(turn - 17, turn + 6)

with style():
    figure = Figure(figsize=(PAGE_WIDTH, 2.9), layout="constrained")
    left, right = figure.subplots(1, 2)
    ends = np.array([response.displacement.min(), response.displacement.max()])
    spring = bearing.restoring_stiffness * ends / 1e3
    left.plot(
        response.displacement,
        response.force / 1e3,
        color=BLUE,
        lw=0.7,
        label="analysis",
    )
    left.plot(ends, spring, color=RED, label="spring (a)")
    for side in (-1.0, 1.0):
        left.plot(
            ends,
            spring + side * yield_force / 1e3,
            color=OCHRE,
            ls="--",
            label="(a) ± μN of (c)" if side > 0.0 else None,
        )
    left.set(xlabel="y [mm]", ylabel="F [kN]")
    left.set_ylim(-560.0, 430.0)
    left.legend(fontsize=6.5, loc="lower right", ncols=3)
    time = response.time[near]
    right.fill_between(
        time,
        centre[near] - radius,
        centre[near] + radius,
        color="#C9D3DF",
        label="$O_Y ± r_f$",
    )
    right.plot(time, centre[near], color=GREY, label="$O_Y$")
    right.plot(time, response.displacement[near], color=BLUE, label="y")
    peak = response.displacement[turn]
    right.set(xlabel="t [s]", ylabel="y [mm]", ylim=(peak - 0.2, peak + 1.0))
    right.legend(fontsize=6.5, loc="lower left")

print(f"spring (a): {bearing.restoring_stiffness / 1e3:.3f} kN/mm")
print(f"spring (b): {bearing.elastic_stiffness / 1e3:g} kN/mm")
print(f"r_f {radius:.4f} mm at a coefficient of 0.043")
print(
    f"furthest from O_Y {np.abs(response.displacement - centre).max() / radius:.6f} r_f"
)
