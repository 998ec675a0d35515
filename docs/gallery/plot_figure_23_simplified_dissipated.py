r"""
Figure 23: accuracy of the simplified method, dissipated energy
===============================================================

**In the paper**: V\ :sub:`dEhr` by Eq. (27) is 0.7 to 1.6 times that of the analysis.

**Here**: all 16 cases are in that range.
"""

import dcfp
from dcfp.inference.statistics import ratios
from dcfp.methods.li_2020.constants import PRINTED_RANGES, PRINTED_ROUNDING, SIMPLIFIED
from dcfp.methods.method import Information, Variant
from dcfp.methods.pulses import HYSTERETIC
from dcfp.motion.named import VELOCITIES
from dcfp.present.figures.li_2020 import paper_figures

records = [dcfp.load_motion(name) for name in ("NCC", "KNA", "LPG", "IVD")]
cases = [
    dcfp.compare(record.scaled_to_pgv(pgv), keep_response=True)
    for record in records
    for pgv in VELOCITIES
]
(drawn,) = paper_figures(cases, {}, numbers=["23"])
figure = drawn.figure

variant = Variant(SIMPLIFIED, Information.BLIND)
low, high, _ = PRINTED_RANGES[variant, HYSTERETIC]
found = ratios(cases, variant, HYSTERETIC)
inside = ((found >= low - PRINTED_ROUNDING) & (found <= high + PRINTED_ROUNDING)).sum()
print(
    f"paper {low:.1f} to {high:.1f}, ours {found.min():.2f} to {found.max():.2f}; {inside} of {found.size} inside"
)
for case, ratio in zip(cases, found, strict=True):
    if not low - PRINTED_ROUNDING <= ratio <= high + PRINTED_ROUNDING:
        print(f"outside: {case.record} at {case.pgv / 1e3:.2f} m/s, {ratio:.2f}")
