r"""
Figure 25: change of ground velocity over the PGV
=================================================

**In the paper**: \|Δv\ :sub:`g`\| of the governing pulses over the PGV is about ζ = 1.5, Eq. (29).

**Here**: the mean of ours is the same to the printed digit.
"""

import dcfp
from dcfp.inference.refit import change_ratio
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
(drawn,) = paper_figures(cases, {}, numbers=["25"])
figure = drawn.figure

print(f"ζ of our cases {change_ratio(cases):.2f}, paper 1.5")
