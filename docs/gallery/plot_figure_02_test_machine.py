"""
Figure 2: the test machine
==========================

**In the paper**: the test facility in San Diego, with a bearing between a loading table that four horizontal actuators move and a beam that takes the axial force.

**Here**: the virtual machine at the moment of the largest horizontal force of test T01, the bearing and the displacements to scale, and the force over the displacement with that moment. Table, beam and actuators stand for any: the virtual machine has no mass and no friction
of its own, and tells the bearing where its plates are and how much it carries.
"""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

import dcfp
from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, RED, style
from dcfp.system import PreciseHeating, System

program = dcfp.load_program("asce").only(["T01"])
(loops,) = dcfp.run_program(program, System(heating=PreciseHeating()))
bearing = loops.bearing
i = int(np.abs(loops.force).argmax())
displacement, force = float(loops.displacement[i]), float(loops.force[i]) / 1e3
weight = bearing.vertical_force / 1e3

TABLE, HALF_PLATE, PLATE, SLIDER = (
    1500.0,
    520.0,
    80.0,
    110.0,
)  # of the drawing alone [mm]
heights = np.cumsum([0.0, 160.0, PLATE, SLIDER, PLATE, 160.0])


def block(axes, middle: float, width: float, layer: int, colour: str) -> None:
    """Draw a layer of the machine, counted from below."""
    bottom, top = heights[layer], heights[layer + 1]
    axes.add_patch(
        Rectangle(
            (middle - width / 2.0, bottom),
            width,
            top - bottom,
            facecolor=colour,
            edgecolor=INK,
            lw=0.8,
        )
    )


def arrow(axes, start: tuple, end: tuple, colour: str) -> None:
    """Draw an arrow."""
    axes.annotate(
        "",
        end,
        start,
        arrowprops={"arrowstyle": "->", "color": colour, "shrinkA": 0, "shrinkB": 0},
    )


with style():
    figure = Figure(figsize=(PAGE_WIDTH, 2.3), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1.7, 1.0))
    # the lower plate goes with the table, and the slider half as far
    block(left, -displacement, TABLE, 0, "#D9D9D9")
    block(left, -displacement, 2.0 * HALF_PLATE, 1, "#C9D3DF")
    block(left, -displacement / 2.0, bearing.slider_diameter, 2, OCHRE)
    block(left, 0.0, 2.0 * HALF_PLATE, 3, "#C9D3DF")
    block(left, 0.0, TABLE, 4, "#D9D9D9")
    for side in (-1.0, 1.0):
        end = -displacement + side * TABLE / 2.0
        left.plot(
            [end, side * 1250.0],
            [80.0, 80.0],
            color=GREY,
            lw=4.0,
            solid_capstyle="butt",
            zorder=0.0,
        )
        left.plot([side * 1250.0] * 2, [-20.0, 180.0], color=INK, lw=2.0)
    arrow(left, (0.0, heights[-1] + 190.0), (0.0, heights[-1]), RED)
    left.text(
        30.0,
        heights[-1] + 100.0,
        f"axial force {weight:.0f} kN",
        color=RED,
        va="center",
        fontsize=7,
    )
    left.plot([0.0, 0.0], [-150.0, heights[-1]], color=GREY, lw=0.6, ls="-.")
    arrow(left, (0.0, -110.0), (-displacement, -110.0), BLUE)
    left.text(
        40.0 if displacement > 0.0 else -40.0,
        -110.0,
        f"table {abs(displacement):.0f} mm",
        color=BLUE,
        va="center",
        ha="left" if displacement > 0.0 else "right",
        fontsize=7,
    )
    for layer, words in (
        (0, "loading table"),
        (1, "lower plate"),
        (3, "upper plate"),
        (4, "fixed beam"),
    ):
        middle = -displacement if layer < 2 else 0.0
        left.text(
            middle - HALF_PLATE + 20.0,
            (heights[layer] + heights[layer + 1]) / 2.0,
            words,
            va="center",
            fontsize=7,
        )
    left.text(1250.0, 215.0, "actuators", ha="right", fontsize=7, color=GREY)
    left.set(xlim=(-1330.0, 1330.0), ylim=(-170.0, heights[-1] + 210.0))
    left.set_aspect("equal")
    left.axis("off")
    right.plot(loops.displacement, loops.force / 1e3, color=BLUE, lw=0.6)
    right.plot([displacement], [force], "o", color=RED, ms=4.0)
    right.set(xlabel="displacement [mm]", ylabel="horizontal force [kN]")

print(
    f"{program.tests[0].name}: {force:.0f} kN at {displacement:.0f} mm, {abs(force) / weight:.3f} of the axial force of {weight:.0f} kN"
)
