"""How many digits each number of a report has."""

#: Decimals by the key of JSON; what ends in none of these is no number of a table.
DECIMALS = {
    "pgv_m_s": 3,
    "y_max_mm": 1,
    "dy_max_mm": 1,
    "v_max_mm_s": 1,
    "residual_mm": 1,
    "force_max_kN": 1,
    "temperature_max_degC": 1,
    "friction_min": 4,
    "V_E_mm_s": 1,
    "V_Eh_mm_s": 1,
    "dy_mm": 1,
    "y_mm": 1,
    "V_dE_mm_s": 1,
    "V_dEhr_mm_s": 1,
    "displacement_mm": 1,
    "base_shear_over_weight": 4,
    "effective_period_s": 3,
    "effective_damping": 4,
    "energy_kN_m": 2,
    "pga_m_s2": 3,
    "ratio": 2,
}
#: Decimals of a number in the power of ten.
_POWER = 1
#: Where nothing is known.
NONE = "–"


def number(value: float, decimals: int) -> str:
    """Return a number as mathematics has it: with a hyphen for minus, and none before a zero."""
    text = f"{value:.{decimals}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def written(key: str, value: float | None) -> str:
    """Return a number of a key as it stands in the report, with a true minus; a dash for none."""
    return NONE if value is None else number(value, DECIMALS[key]).replace("-", "−")


def powered(value: float) -> str:
    """Return a small number with a power of ten, as in ``1.1e−14``."""
    return f"{value:.{_POWER}e}".replace("-", "−") if value else "0"


def short(value: float) -> str:
    """Return a given number with the digits that it was given with."""
    return f"{value:.10g}".replace("-", "−")
