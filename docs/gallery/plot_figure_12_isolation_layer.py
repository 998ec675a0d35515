"""
Figure 12: the movement of the isolation layer
==============================================

**In the paper**: a sketch of ground and structure during a strong pulse, with the velocity of the ground, that of the structure, and the displacement of the isolation layer between them.

**Here**: three moments of the analysis of NCC at 0.5 m/s, to scale: the swing of the largest displacement begins, the isolation layer is at its fastest, and the structure is furthest from the ground. Ground and structure stand where they are then; the
arrows are their velocities, and y is the displacement of the structure beyond the ground.
"""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

import dcfp
from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, RED, style

motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
response = dcfp.respond(motion)
last = int(np.abs(response.displacement).argmax())
# the swing to it begins where the layer stood still before, or turned
before = np.flatnonzero(response.velocity[:last] * response.velocity[last - 1] <= 0.0)
first = int(before[-1]) if before.size else 0
fastest = first + int(np.abs(response.velocity[first:last]).argmax())
ground = np.interp(response.time, motion.time, motion.displacement)

WIDTH, HEIGHT, SLAB, GAP = 900.0, 420.0, 110.0, 90.0  # of the drawing alone [mm]
PER_VELOCITY = 0.9  # length of an arrow [mm] for 1 mm/s


def arrow(axes, start, end, height, colour) -> None:
    """Draw an arrow along a height."""
    axes.annotate(
        "",
        (end, height),
        (start, height),
        arrowprops={"arrowstyle": "->", "color": colour, "shrinkA": 0, "shrinkB": 0},
    )


def moment(axes, i: int, words: str) -> None:
    """Draw ground, bearing and structure at a sample."""
    at, y = float(ground[i]), float(response.displacement[i])
    for x, bottom, height, colour in (
        (at, -SLAB, SLAB, "#D9D9D9"),
        (at + y, GAP, HEIGHT, "#C9D3DF"),
    ):
        axes.add_patch(
            Rectangle(
                (x - WIDTH / 2.0, bottom),
                WIDTH,
                height,
                facecolor=colour,
                edgecolor=INK,
                lw=0.8,
            )
        )
    for side in (-0.35, 0.35):
        middle = at + y / 2.0 + side * WIDTH
        axes.add_patch(
            Rectangle(
                (middle - 45.0, 0.0), 90.0, GAP, facecolor=OCHRE, edgecolor=INK, lw=0.6
            )
        )
    for x, velocity, height, name, colour in (
        (at, response.ground_velocity[i], -SLAB / 2.0, "$v_g$", INK),
        (at + y, response.structure_velocity[i], GAP + HEIGHT / 2.0, "$v_u$", BLUE),
    ):
        if abs(velocity) > 20.0:
            arrow(axes, x, x + PER_VELOCITY * velocity, height, colour)
        axes.text(
            x,
            -SLAB - 75.0 if x == at else height + 25.0,
            f"{name} {round(velocity / 1e3, 2) + 0.0:.2f} m/s",
            color=colour,
            ha="center",
            fontsize=7,
        )
    for x, ends in ((at, (-SLAB, 640.0)), (at + y, (GAP + HEIGHT, 640.0))):
        axes.plot([x, x], ends, color=GREY, lw=0.5, ls="-.", zorder=0.0)
    if abs(y) > 15.0:
        arrow(axes, at, at + y, 590.0, RED)
    axes.text(at + y / 2.0, 660.0, f"y {y:.0f} mm", color=RED, ha="center", fontsize=7)
    axes.set_title(f"{words}, {response.time[i]:.2f} s", fontsize=8)
    axes.set(xlim=(-720.0, 720.0), ylim=(-210.0, 730.0))
    axes.set_aspect("equal")
    axes.axis("off")


with style():
    figure = Figure(figsize=(PAGE_WIDTH, 1.9), layout="constrained")
    for axes, (i, words) in zip(
        figure.subplots(1, 3),
        ((first, "the swing begins"), (fastest, "fastest"), (last, "furthest")),
        strict=True,
    ):
        moment(axes, i, words)

travel = np.trapezoid(
    response.structure_velocity[first : last + 1]
    - response.ground_velocity[first : last + 1],
    response.time[first : last + 1],
)
print(
    f"integral of v = vu - vg over the swing: {travel:.1f} mm; change of y: {response.displacement[last] - response.displacement[first]:.1f} mm"
)
