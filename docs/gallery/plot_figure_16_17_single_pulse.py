r"""
Figures 16 and 17: a single pulse
=================================

**In the paper**: Figure 16 derives Eq. (20) from straight lines. Near k\ :sub:`u`/k\ :sub:`g` = 1 it gives no motion, where the analysis moves, so from 0.8 on Figure 17 multiplies velocities and slopes by 1.5.

**Here**: Eq. (20) with and without the factor, beside half-cosine pulses of the same peaks. Half cosines do move beyond 1, up to π/2. The factor of 1.5 overshoots them: from 0.8 to 1 it
would have to be 1.13 to 1.19. The default of the program remains the paper's.
"""

import numpy as np
from matplotlib.figure import Figure

from dcfp.methods.li_2020.pulse_method import displacement_change
from dcfp.present.figures.style import BLUE, GREY, PAGE_WIDTH, RED, calm_ticks, style

ratio = np.linspace(0.02, 1.0, 200)
one = np.ones(200)
straight = displacement_change(one, one, -one, ratio)  # in dvg²/kg
factor = 1.5 * one
amplified = displacement_change(factor, factor, -factor, ratio)


def half_cosine(ratio: float, steps: int = 4000) -> float:
    """Change of displacement under a half-cosine rise and fall, by small steps."""
    time = (np.arange(2 * steps) + 0.5) / steps
    step = 1.0 / steps
    ground = 0.5 * np.pi * np.sin(np.pi * time)  # slope over kg, rise then fall
    velocity = change = 0.0
    for slope in ground:
        if velocity > 0.0 or slope > ratio:
            velocity = max(velocity + (slope - ratio) * step, 0.0)
            change += velocity * step
    return change


some = np.array([0.2, 0.4, 0.6, 0.8, 0.9, 1.0, 1.2, 1.4])
cosine = np.array([half_cosine(float(value)) for value in some])

with style():
    figure = Figure(figsize=(PAGE_WIDTH / 1.6, 2.8), layout="constrained")
    axes = figure.add_subplot()
    axes.plot(ratio, straight, color=BLUE, label="Eq. (20)")
    axes.plot(ratio, amplified, color=RED, linestyle="--", label="Eq. (20), times 1.5")
    axes.plot(some, cosine, "o-", color=GREY, markersize=3.0, label="half cosines")
    axes.axvspan(0.8, 1.0, color="#EAEFF4", zorder=0)
    axes.set(
        xlabel="$k_u/k_g$ [–]",
        ylabel="$\\Delta y$ over $\\Delta v_g^2 / k_g$ [–]",
        xlim=(0.0, 1.6),
        ylim=(0.0, 1.4),
    )
    axes.legend()
    calm_ticks(axes)

for value, change in zip(some, cosine, strict=True):
    print(f"ku/kg {value:.1f}: half cosines {change:.3f}")
