"""
Figure 13: ground velocity, energy and displacement
===================================================

**In the paper**: NCC at 0.25 m/s. The largest change of ground velocity, the largest input of energy and the largest change of displacement come together.

**Here**: they do. The pulse that governs and the half cycle that it causes are marked.
"""

import dcfp
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
(drawn,) = paper_figures(cases, {}, numbers=["13"])
figure = drawn.figure

case = next(case for case in cases if case.record == "NCC" and case.pgv < 300.0)
swing, pulse = case.analysed.swing, case.analysed.pulse
print(
    f"largest half cycle {abs(swing.change):.1f} mm from {swing.start:.2f} to {swing.end:.2f} s"
)
print(
    f"its pulse rises by {abs(case.pulses.changes[pulse]):.0f} mm/s from {case.pulses.starts[pulse]:.2f} to {case.pulses.peaks[pulse]:.2f} s"
)
