"""
Figure 10: both heating models in an earthquake
===============================================

**In the paper**: force against displacement under JKB at 0.25 and 1.0 m/s; the simplified model is as good as the precise one under both.

**Here**: KNA, the other record of that earthquake, since JKB does not come with the package (``dcfp reproduce --records FOLDER`` takes it from a file). The two are within 6 % there. They are not everywhere: under IVD at 1.0 m/s the slider leaves the one monitoring point behind, and the simplified
model moves 31 % further.
"""

import dcfp
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases, loops = [], {}
for record in records:
    for pgv in VELOCITIES:
        motion = record.scaled_to_pgv(pgv)
        case = dcfp.compare(motion, keep_response=True)
        cases.append(case)
        loops[record.name, pgv] = (
            case.response,
            dcfp.respond(motion, heating=dcfp.PreciseHeating()),
        )

(drawn,) = paper_figures(cases, loops, numbers=["10"])
figure = drawn.figure

for (name, pgv), (simplified, precise) in loops.items():
    ratio = simplified.peak_displacement / precise.peak_displacement
    print(
        f"{name} at {pgv / 1e3:.2f} m/s: y_max {simplified.peak_displacement:5.0f} and {precise.peak_displacement:5.0f} mm, ratio {ratio:.2f}"
    )
