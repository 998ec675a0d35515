"""
Figure 5: the two heating models
================================

**In the paper**: where the temperature of a plate is followed: (a) at many points along the direction of sliding in the precise model, (b) at one in the middle of the plate in the simplified one. The round contact is taken as a square of equal area.

**Here**: a plate from above, to scale, as the analysis has it: NCC at 0.5 m/s at the moment of the largest displacement. In (a) each point has the colour of its temperature then. The circle is the contact, the dashed square that of equal area.
"""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

import dcfp
from dcfp.present.figures.style import INK, PAGE_WIDTH, RED, colours_of, style

motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
precise = dcfp.respond(
    motion, heating=dcfp.PreciseHeating(), keep=dcfp.Keep(profiles=200)
)
simplified = dcfp.respond(motion)
bearing, profiles = precise.bearing, precise.profiles
moment = precise.time[int(np.argmax(np.abs(precise.displacement)))]
which = int(np.argmin(np.abs(profiles.time - moment)))
temperatures = profiles.temperature[which, 0]
at = bearing.shares[0] * float(
    np.interp(profiles.time[which], precise.time, precise.displacement)
)
half = bearing.contact_half_side

with style():
    figure = Figure(figsize=(PAGE_WIDTH, 3.1), layout="constrained")
    several = figure.subplots(1, 2, sharey=True)
    for axes, title in zip(several, ("(a) precise", "(b) simplified"), strict=True):
        axes.add_patch(
            Circle(
                (at, 0.0),
                bearing.slider_diameter / 2.0,
                facecolor="none",
                edgecolor=INK,
            )
        )
        axes.add_patch(
            Rectangle(
                (at - half, -half), 2 * half, 2 * half, fc="none", ec=RED, ls="--"
            )
        )
        axes.set_aspect("equal")
        axes.set(
            xlim=(-290.0, 290.0), ylim=(-230.0, 230.0), xlabel="x on the plate [mm]"
        )
        axes.set_title(title, loc="left")
    several[0].set_ylabel("across [mm]")
    shown = several[0].scatter(
        profiles.position,
        np.zeros_like(profiles.position),
        c=temperatures,
        s=6.0,
        cmap=colours_of("temperature"),
    )
    several[1].plot(0.0, 0.0, "o", color=INK, markersize=4.0)
    figure.colorbar(shown, ax=several, label="T [°C]", shrink=0.8)

print(
    f"half side of the square {half:.1f} mm; slider at {at:.1f} mm, {profiles.time[which]:.2f} s"
)
print(f"points of the precise model: {profiles.position.size}")
