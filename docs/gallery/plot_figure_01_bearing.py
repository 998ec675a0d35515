"""
Figure 1: the bearing
=====================

**In the paper**: a photograph and a section of a double concave friction pendulum bearing: two concave plates and a slider between them.

**Here**: a section of the bearing of the program, to scale, both across and up: centred, and displaced as far as it goes under NCC at 0.5 m/s. Each plate takes half of the displacement, the slider turns with both. Plates and slider are of the radii and of the
diameter of the `Bearing`; their thicknesses and the width of the plates are not known to it and stand for any.
"""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

import dcfp
from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, RED, style

bearing = dcfp.Bearing()
peak = dcfp.respond(
    dcfp.load_motion("NCC").scaled_to_pgv(500.0), heating=dcfp.PreciseHeating()
).peak_displacement
(radius, _), half_slider = bearing.radii, bearing.slider_diameter / 2.0
HALF_WIDTH, THICKNESS, HEIGHT = 520.0, 60.0, 110.0  # of the drawing alone [mm]


def lower_surface(x: np.ndarray) -> np.ndarray:
    """Height of the lower plate above its lowest point [mm]."""
    return radius - np.sqrt(radius**2 - x**2)


def section(axes, displacement: float) -> None:
    """Draw the bearing with its upper plate displaced [mm]."""
    across = np.linspace(-HALF_WIDTH, HALF_WIDTH, 121)
    at = displacement * bearing.shares[0]  # of the slider on the lower plate
    tilt = np.arcsin(at / radius)
    turn = np.array([[np.cos(tilt), -np.sin(tilt)], [np.sin(tilt), np.cos(tilt)]])
    foot = np.array([at, lower_surface(np.array(at))])
    # the slider: along the lower surface, and along the upper one the other way up
    local = np.linspace(-half_slider, half_slider, 41)
    bottom = np.column_stack((local, lower_surface(local)))
    top = np.column_stack((local[::-1], HEIGHT - lower_surface(local)))
    slider = np.vstack((bottom, top)) @ turn.T + foot
    middle = np.array([0.0, HEIGHT]) @ turn.T + foot  # on the upper plate
    # the upper plate's vertex: its surface passes through `middle` at the same slope
    vertex = np.array([displacement, middle[1] + lower_surface(np.array(at))])
    lower = np.column_stack((across, lower_surface(across)))
    upper = np.column_stack((across + vertex[0], vertex[1] - lower_surface(across)))
    for surface, far in ((lower, -THICKNESS), (upper, vertex[1] + THICKNESS)):
        ends = np.array([[surface[-1, 0], far], [surface[0, 0], far]])
        axes.add_patch(
            Polygon(
                np.vstack((surface, ends)), facecolor="#C9D3DF", edgecolor=INK, lw=0.8
            )
        )
    axes.add_patch(Polygon(slider, facecolor=OCHRE, edgecolor=INK, lw=0.8))
    for ends in ((-90.0, -60.0), (170.0, 260.0)):
        axes.plot([0.0, 0.0], ends, color=GREY, lw=0.7, ls="-.")
    if displacement:
        axes.plot([displacement] * 2, [vertex[1], 275.0], color=RED, lw=0.7, ls="-.")
        for end, height, words in ((at, -85.0, "y/2"), (displacement, 250.0, "y")):
            axes.annotate(
                "",
                (end, height),
                (0.0, height),
                arrowprops={
                    "arrowstyle": "->",
                    "color": RED,
                    "shrinkA": 0,
                    "shrinkB": 0,
                },
            )
            axes.text(end + 12.0, height, words, color=RED, va="center")
    axes.set_aspect("equal")
    axes.set(xlim=(-640.0, 720.0), ylim=(-110.0, 290.0))
    axes.axis("off")


with style():
    figure = Figure(figsize=(PAGE_WIDTH, 1.6), layout="constrained")
    left, right = figure.subplots(1, 2)
    section(left, 0.0)
    section(right, peak)
    left.text(
        0.0,
        52.0,
        f"slider, φ {bearing.slider_diameter:g} mm",
        va="center",
        ha="center",
        fontsize=7,
    )
    left.text(
        -505.0, 149.0, f"upper plate, $R_s$ {radius:g} mm", va="center", fontsize=7
    )
    left.text(
        -500.0, -35.0, f"lower plate, $R_s$ {radius:g} mm", va="center", fontsize=7
    )
    left.plot([260.0, 460.0], [-95.0, -95.0], color=BLUE, lw=2.0)
    left.text(480.0, -95.0, "200 mm", color=BLUE, va="center", fontsize=7)
    right.set_title(f"y = {peak:.0f} mm", fontsize=8)
    left.set_title("centred", fontsize=8)

print(
    f"rise of the structure at {peak:.0f} mm: {peak**2 / (2.0 * bearing.effective_radius):.2f} mm"
)
