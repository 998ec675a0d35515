"""
Loops by record and PGV
=======================

The sixteen analyses of the paper's four available records, on one sheet with one scale.
"""

import dcfp
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures import plot_overview

responses = [
    dcfp.respond(
        dcfp.load_motion(name).scaled_to_pgv(pgv), heating=dcfp.PreciseHeating()
    )
    for name in ("NCC", "KNA", "LPG", "IVD")
    for pgv in VELOCITIES
]
figure = plot_overview(responses)
