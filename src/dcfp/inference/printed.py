"""What Li et al. (2020), section 6, print of their methods; the constants are in `dcfp.methods.li_2020.LI_2020`."""

from dcfp.inference.case import CHANGE, HYSTERETIC, INPUT, Basis, Method, Quantity, View

#: Ranges of prediction over analysis [-], and where they are printed. The pulse method: sections 6.1.2 and 6.1.3, Figure 18; the simplified
#: method: section 6.2.3, Figures 22 to 24.
RANGES: dict[tuple[View, Quantity], tuple[float, float, str]] = {
    ((Method.PULSE, Basis.BLIND), CHANGE): (1.0, 2.1, "Figure 18"),
    ((Method.PULSE, Basis.BLIND), INPUT): (0.8, 1.9, "section 6.1.3"),
    ((Method.PULSE, Basis.BLIND), HYSTERETIC): (0.8, 1.6, "section 6.1.3"),
    ((Method.SIMPLIFIED, Basis.BLIND), INPUT): (0.8, 1.5, "Figure 22"),
    ((Method.SIMPLIFIED, Basis.BLIND), HYSTERETIC): (0.7, 1.6, "Figure 23"),
    ((Method.SIMPLIFIED, Basis.BLIND), CHANGE): (0.7, 1.8, "Figure 24"),
}
#: Half of the last printed digit of a range [-].
ROUNDING = 0.05

#: The design method at PGV [mm/s]: each quantity with its last printed digit [mm/s, mm], from Eqs (31)-(33) with mu_n g = 421.8 mm/s2.
DESIGN: dict[float, dict[Quantity, tuple[float, float]]] = {
    250.0: {INPUT: (277.2, 0.1), HYSTERETIC: (248.8, 0.1), CHANGE: (73.4, 0.1)},
    1000.0: {INPUT: (1108.8, 0.1), HYSTERETIC: (692.5, 0.1), CHANGE: (568.0, 1.0)},
}
