"""
Figure 3: pressure and velocity dependency
==========================================

**In the paper**: measured coefficients of the dependency test over those at the reference, with Eqs (7) and (8), for sliders of 300 and 400 mm.

**Here**: the same equations, and the virtual machine in the same tests (T01 to T04 of Table 1). At 60 N/mm² and 400 mm/s both factors are one, as in the paper. The measured points are not printed, so
they are not shown here.
"""

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import BLUE, PAGE_WIDTH, calm_ticks, style
from dcfp.system.friction.li_2020 import (
    pressure_factor,
    temperature_factor,
    velocity_factor,
)

curves = (
    (
        "(a) pressure, Eq. (7)",
        "pressure [N/mm²]",
        "γ [–]",
        np.linspace(20.0, 100.0),
        pressure_factor,
        60.0,
    ),
    (
        "(b) velocity, Eq. (8)",
        "relative velocity [mm/s]",
        "α [–]",
        np.linspace(0.0, 650.0),
        velocity_factor,
        400.0,
    ),
    (
        "temperature, Eq. (9)",
        "temperature [°C]",
        "β [–]",
        np.linspace(0.0, 250.0),
        temperature_factor,
        17.5,
    ),
)
with style():
    figure = Figure(figsize=(PAGE_WIDTH, 2.3), layout="constrained")
    for axes, (title, across, up, values, factor, reference) in zip(
        figure.subplots(1, 3), curves, strict=True
    ):
        axes.plot(values, factor(values), color=BLUE)
        axes.plot(reference, factor(reference), "o", color=BLUE, markersize=3.5)
        axes.set(xlabel=across, ylabel=up, ylim=(0.0, None))
        axes.set_title(title, loc="left")
        calm_ticks(axes)

print(f"γ(60 N/mm²) = {float(pressure_factor(60.0)):.4f}, paper 1.000")
print(f"α(400 mm/s) = {float(velocity_factor(400.0)):.4f}, paper 0.9997")
print(f"β(17.5 °C)  = {float(temperature_factor(17.5)):.4f}, paper 1")
