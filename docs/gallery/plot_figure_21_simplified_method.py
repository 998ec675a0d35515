r"""
Figure 21: the simplified method
================================

**In the paper**: how the simplified method goes from the change of ground velocity Δv\ :sub:`g` to the energies, as velocities, and on to the displacement.

**Here**: the same steps with the numbers of the program, for NCC at 0.5 m/s, each as a bar to scale: Δv\ :sub:`g` of the governing pulse, V\ :sub:`ΔE` by Eq. (28), V\ :sub:`ΔEhr` by Eq. (27), and Δy, the length over which friction dissipates it; beside them the analysis.
"""

from matplotlib.figure import Figure

import dcfp
from dcfp.methods.li_2020.simplified_method import predict_simplified
from dcfp.present.figures.style import BLUE, GREY, PAGE_WIDTH, style

case = dcfp.compare(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
pulse = case.analysed.pulse
predicted = predict_simplified(case.pulses).of(pulse)
swing = case.analysed.swing
steps = (
    ("|Δ$v_g$|", abs(case.pulses.changes[pulse]), None),
    ("$V_{ΔE}$, Eq. (28)", predicted.input_velocity, swing.input_velocity),
    (
        "$V_{ΔE_{hr}}$, Eq. (27)",
        predicted.hysteretic_velocity,
        swing.hysteretic_velocity,
    ),
)
with style():
    figure = Figure(figsize=(PAGE_WIDTH, 2.2), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(3, 1))
    for place, (_, value, analysed) in enumerate(steps):
        left.bar(place, value, 0.35, color=BLUE, label="" if place else "method")
        if analysed is not None:
            left.bar(
                place + 0.37,
                analysed,
                0.35,
                color=GREY,
                label="analysis" if place == 1 else "",
            )
    left.set_xticks([0.0, 1.18, 2.18], [words for words, _, _ in steps])
    left.set_ylabel("velocity [mm/s]")
    left.legend()
    right.bar(0.0, abs(predicted.displacement_change), 0.35, color=BLUE)
    right.bar(0.37, abs(swing.change), 0.35, color=GREY)
    right.set_xticks([0.18], ["Δy = $V_{ΔE_{hr}}^2 / (2 μ_n g)$"])
    right.set_ylabel("Δy [mm]")

for words, (_, value, analysed) in zip(("dvg", "V_dE", "V_dEhr"), steps, strict=True):
    beside = "" if analysed is None else f", analysis {analysed:.1f}"
    print(f"{words}: {value:.1f}{beside} mm/s")
print(
    f"dy: {abs(predicted.displacement_change):.1f}, analysis {abs(swing.change):.1f} mm"
)
