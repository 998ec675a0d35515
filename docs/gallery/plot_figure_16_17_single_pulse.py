r"""
Figures 16 and 17: a single pulse
=================================

**In the paper**: Figure 16 derives Eq. (20) from straight lines. Near k\ :sub:`u`/k\ :sub:`g` = 1 it gives no motion, where the analysis moves, so from 0.8 on Figure 17 multiplies velocities and slopes by 1.5.

**Here**: the construction, to scale: the governing pulse of NCC at 0.5 m/s, and one of the same rise with k\ :sub:`u`/k\ :sub:`g` = 1, where the ground is multiplied by 1.5. The shaded area is Δy. Then Eq. (20) with and without the factor, beside half-cosine pulses of the same peaks. Half cosines do move beyond 1, up to π/2. The factor of 1.5 overshoots them: from 0.8 to 1 it
would have to be 1.13 to 1.19. The default of the program remains the paper's.
"""

import numpy as np
from matplotlib.figure import Figure

import dcfp
from dcfp.methods.li_2020.pulse_method import displacement_change
from dcfp.methods.prediction import Constants
from dcfp.present.figures.style import BLUE, GREY, PAGE_WIDTH, RED, calm_ticks, style

case = dcfp.compare(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
pulse = case.analysed.pulse
rise = abs(case.pulses.changes[pulse])
slope = abs(case.pulses.mean_accelerations[pulse])
fall = abs(case.pulses.next_mean_accelerations[pulse])
friction = Constants().friction_deceleration


def construction(
    axes, rise: float, slope: float, fall: float, factor: float = 1.0
) -> float:
    """Draw the ground and the structure of one pulse, and return the area between them."""
    peak = rise / slope
    rise, slope, fall = factor * rise, factor * slope, factor * fall
    meet = (rise + fall * peak) / (friction + fall)
    time = np.linspace(0.0, meet, 2001)
    ground = np.minimum(slope * time, rise - fall * (time - peak))
    area = float(np.trapezoid(ground - friction * time, time))
    axes.fill_between(time, friction * time, ground, color="#EAEFF4")
    axes.plot(time, ground, color=BLUE, label="ground")
    axes.plot(time, friction * time, color=RED, ls="--", label="structure")
    axes.set(xlabel="t – t$_{i-1}$ [s]", ylabel="v – v$_{g,i-1}$ [mm/s]")
    axes.text(
        (peak + meet) / 3,
        (rise + friction * meet) / 3,
        f"{area:.0f} mm",
        ha="center",
        va="center",
        fontsize=7,
    )
    return area


with style():
    schematic = Figure(figsize=(PAGE_WIDTH, 2.5), layout="constrained")
    left, right = schematic.subplots(1, 2)
    usual = construction(left, rise, slope, fall)
    near_one = construction(right, rise, friction, fall * friction / slope, 1.5)
    right.plot(
        [0.0, rise / friction],
        [0.0, rise],
        color=GREY,
        lw=0.8,
        label="ground, not times 1.5",
    )
    left.set_title("$k_u/k_g$ below 0.8", loc="left")
    right.set_title("$k_u/k_g$ = 1, times 1.5", loc="left")
    left.legend(fontsize=7)
    right.legend(fontsize=7)

printed = displacement_change(
    *(np.array([one]) for one in (rise, slope, -fall, friction))
)
print(f"area {usual:.2f} mm, Eq. (20) {abs(float(printed[0])):.2f} mm")

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
