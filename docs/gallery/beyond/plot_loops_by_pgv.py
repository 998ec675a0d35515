"""
Loops by record and PGV
=======================

The sixteen analyses of the paper's four records at hand, on one sheet with one scale.
"""

import dcfp
from dcfp.plots import plot_overview
from dcfp.record.named import VELOCITIES

responses = [
    dcfp.respond(
        dcfp.load_motion(name).scaled_to_pgv(pgv), heating=dcfp.PreciseHeating()
    )
    for name in ("NCC", "KNA", "LPG", "IVD")
    for pgv in VELOCITIES
]
figure = plot_overview(responses)
