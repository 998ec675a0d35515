r"""
Figure 26: energies from the PGV alone
======================================

**In the paper**: the largest V\ :sub:`dE` and V\ :sub:`dEhr` with the lines of Eqs (31) and (32).

**Here**: the same lines, to the last printed digit, with our analyses. They run through the points, not above them.
"""

import dcfp
from dcfp.methods.li_2020 import predict_from_pgv
from dcfp.methods.li_2020.constants import DERIVED_DESIGN
from dcfp.methods.pulses import HYSTERETIC, INPUT
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
(drawn,) = paper_figures(cases, {}, numbers=["26"])
figure = drawn.figure

for pgv, known in DERIVED_DESIGN.items():
    said = predict_from_pgv(pgv)
    print(
        f"PGV {pgv / 1e3:.2f} m/s: V_dE {said.input_velocity:.1f} (derived {known[INPUT][0]:.1f}),"
        f" V_dEhr {said.hysteretic_velocity:.1f} (derived {known[HYSTERETIC][0]:.1f}) mm/s"
    )
