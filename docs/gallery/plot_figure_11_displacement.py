"""
Figure 11: largest displacement over the PGV
============================================

**In the paper**: y_max of eight records at four PGVs grows with the PGV and scatters widely, so the PGV alone does not give it.

**Here**: the same with four records. At 1.0 m/s the largest is more than three times the least, which agrees. IVD at 1.0 m/s and LPG at 1.0 m/s go beyond the largest tested amplitude, 440 mm.
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
(drawn,) = paper_figures(cases, {}, numbers=["11"])
figure = drawn.figure

for pgv in VELOCITIES:
    found = [case.analysed.whole.bound for case in cases if abs(case.pgv - pgv) < 1.0]
    print(f"PGV {pgv / 1e3:.2f} m/s: y_max {min(found):.0f} to {max(found):.0f} mm")
