"""
Figure 27: displacement from the PGV alone
==========================================

**In the paper**: the largest change of displacement with the line of Eq. (33).

**Here**: the same line, to the last printed digit. It is not above all analyses: at 0.25 m/s one of four is larger (IVD), from 0.5 m/s on two are (LPG and IVD).
"""

import dcfp
from dcfp.methods.li_2020 import predict_from_pgv
from dcfp.methods.li_2020.constants import DERIVED_DESIGN
from dcfp.methods.pulses import CHANGE
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
(drawn,) = paper_figures(cases, {}, numbers=["27"])
figure = drawn.figure

for pgv, known in DERIVED_DESIGN.items():
    print(
        f"PGV {pgv / 1e3:.2f} m/s: dy {predict_from_pgv(pgv).displacement_change:.1f} mm, derived {known[CHANGE][0]:g} mm"
    )
for pgv in VELOCITIES:
    said = predict_from_pgv(pgv).displacement_change
    below = [
        case.record
        for case in cases
        if abs(case.pgv - pgv) < 1.0 and case.analysed.whole.displacement_change > said
    ]
    print(
        f"PGV {pgv / 1e3:.2f} m/s: {said:.0f} mm; larger in the analysis: {', '.join(below) or 'none'}"
    )
