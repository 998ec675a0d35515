"""Quantities that are predicted, as figures name them."""

#: Names in the nomenclature, by those in tables, which are those of `dcfp.inference.case`.
ENTRIES = {
    "dy": "displacement_change",
    "y": "peak_displacement",
    "V_dE": "swing_input_velocity",
    "V_dEhr": "swing_hysteretic_velocity",
}
