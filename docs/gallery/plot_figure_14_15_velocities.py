"""
Figures 14 and 15: velocities of ground and structure
=====================================================

**In the paper**: NCC at 0.25 m/s. The area between the velocities of ground and structure (Figure 14) is that under the relative velocity (Figure 15), and is the change of displacement.

**Here**: the same areas, marked for the largest half cycle. While it slides the structure's velocity is nearly straight: that is what Eq. (19) takes for its slope.
"""

import dcfp
from dcfp.constants import STANDARD_GRAVITY
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
drawn = {one.number: one for one in paper_figures(cases, {}, numbers=["14", "15"])}
both = drawn["14"].figure
relative = drawn["15"].figure

swing = next(
    case.analysed.swing for case in cases if case.record == "NCC" and case.pgv < 300.0
)
mean = swing.hysteretic_velocity**2 / (2.0 * STANDARD_GRAVITY * abs(swing.change))
print(f"mean coefficient in the largest half cycle {mean:.4f}, nominal 0.043")
