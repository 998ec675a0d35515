"""The files that the frozen commands read: written by formulas that need nothing of the package."""

import math
import random
from pathlib import Path

BEARING = """
name = "Own bearing"
radii = [3000, 2500]
slider = 350
pressure = 45
stiffness = 1500
capacity = 300
[friction]
law = "li2020"
mu_0 = 0.06
[heating]
model = "precise"
thickness = 40
ambient = 5
"""
PROGRAM = """
name = "two tests"
[[test]]
name = "slow"
amplitude = 200
peak_velocity = 20
cycles = 2
load = 7540
[[test]]
name = "fast"
amplitude = 200
peak_velocity = 300
cycles = 2
load = 7540
"""
SCENARIO = """
title = "A tower"
[factors]
record = ["NCC", "LPG"]
pgv = { values = [0.5, 1.0], unit = "m/s" }
[bearing]
radius = 3000
capacity = 300
[report]
project = "A tower"
"""
STUDIES = {
    "few": """
title = "Records, intensities, bearings"
[factors]
record = ["P695-NF"]
pgv = { values = [0.25, 0.5, 1.0, 1.5], unit = "m/s" }
""",
    "bounds": """
title = "Property factors and ambient temperatures"
[bearing]
capacity = 440
[factors]
record = ["NCC", "KNA", "LPG", "IVD"]
pgv = { values = [0.25, 0.5, 1.0], unit = "m/s" }
lambda = [0.85, 1.0, 1.3]
ambient = { values = [-10, 20, 40], unit = "degC" }
""",
    "sampled": """
title = "Sampled"
[factors]
record = ["NCC", "LPG"]
pgv = { values = [0.5, 1.0], unit = "m/s" }
[sampling]
method = "saltelli"
count = 64
seed = 1
[sampling.factors]
radius = { from = 3.0, to = 6.0, unit = "m" }
mu = { distribution = "lognormal", median = 0.075, dispersion = 0.2 }
pressure = { from = 30, to = 90, unit = "N/mm**2" }
ambient = { from = -10, to = 40, unit = "degC" }
""",
    "chart": """
title = "Bearings"
[factors]
record = ["P695-FF"]
pgv = { values = [0.5], unit = "m/s" }
radius = { values = [2.0, 3.0, 4.5], unit = "m" }
mu = [0.04, 0.06, 0.09]
""",
    "kinds": """
title = "Laws, heating and procedures"
[bearing.heating]
thickness = 40
[factors]
record = ["NCC", "IVD"]
pgv = { values = [0.5, 1.0], unit = "m/s" }
law = ["li2020", "constant", "constantinou1990", "kumar2015", "kim2023-third", "lomiento2013", "fitted"]
heating = ["simplified", "precise", "none"]
stiffness = { values = [1000, 1900], unit = "kN/mm" }
""",
    "procedures": """
title = "Procedures"
[factors]
record = ["NCC", "IVD"]
pgv = { values = [0.5, 1.0], unit = "m/s" }
procedure = ["analysis", "pulse", "simplified", "design", "march", "asce7", "eurocode8", "aij1", "aij2", "aij-energy", "iwan"]
""",
}  # fmt: skip


def write_inputs(folder: Path) -> None:
    """Write them all into a folder."""
    for name, text in {"own": BEARING, "program": PROGRAM, "scenario": SCENARIO, **STUDIES}.items():
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    (folder / "pulse.txt").write_text(_pulse(0.0), encoding="utf-8")
    (folder / "drifting.txt").write_text(_pulse(0.4), encoding="utf-8")
    for name, speed, pressure in (
        ("slow", 20.0, 60.0), ("middle", 80.0, 60.0), ("fast", 300.0, 60.0), ("light", 20.0, 35.0),
    ):  # fmt: skip
        (folder / f"{name}.csv").write_text(_measured(speed, pressure), encoding="utf-8")


def _pulse(offset: float) -> str:
    """Time [s] and acceleration [m/s2]: two seconds of a sine wave and two of rest."""
    rows = []
    for index in range(401):
        time = index * 0.01
        wave = 3.0 * math.sin(2.0 * math.pi * time) if time <= 2.0 else 0.0
        rows.append(f"{time:.6f} {wave + offset:.6f}\n")
    return "".join(rows)


def _measured(speed: float, pressure: float, amplitude: float = 200.0, cycles: int = 2) -> str:
    """A test on plates of 4500 mm whose friction falls with the speed and the path, with noise on the force."""
    numbers = random.Random(speed + pressure)
    load = pressure * math.pi * 200.0**2 / 1e3
    angle = speed / amplitude
    count = 200 * cycles
    rows, path, before = ["time [s],displacement [mm],force [kN],load [kN]\n"], 0.0, 0.0
    for index in range(count + 1):
        time = 2.0 * math.pi * cycles / angle * index / count
        y, v = amplitude * math.sin(angle * time), speed * math.cos(angle * time)
        path, before = path + abs(y - before), y
        mu = 0.075 * (pressure / 60.0) ** -0.3 * (1.0 - 0.4 * (1.0 - math.exp(-0.02 * abs(v))))
        mu *= 0.6 + 0.4 * math.exp(-1e-5 * path * math.sqrt(speed))
        force = load * (y / 9000.0 + mu * math.tanh(v / (0.02 * speed))) + 0.002 * load * numbers.gauss(0, 1)
        rows.append(f"{time:.6f},{y:.6f},{force:.6f},{load:.3f}\n")
    return "".join(rows)
