r"""
Figure 20: how much energy a pulse puts in
==========================================

**In the paper**: V\ :sub:`dE` over the change of ground velocity, about constant: Eq. (28) with k\ :sub:`g,ave` = 930 mm/s², the mean slope of the governing pulses of eight records at 0.25 m/s.

**Here**: the mean of our four is 716 mm/s², that of the 100 components of FEMA P-695 861 mm/s². The constant is one of a set of records.
"""

import dcfp
from dcfp.inference.refit import average_slope
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
(drawn,) = paper_figures(cases, {}, numbers=["20"])
figure = drawn.figure

print(
    f"kg_ave of our four {average_slope(cases):.0f} mm/s², paper 930 mm/s² of its eight"
)
