"""The peaks of an analysis with their units in their names."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dcfp.analysis.response import Response


def summary(response: "Response") -> dict[str, float | str]:
    """Return what the command line's JSON holds for one analysis."""
    return {
        "record": response.motion.name,
        "pgv_m_s": response.motion.peak_velocity / 1e3,
        "friction": response.friction_law.name,
        "heating": response.heating.name,
        "y_max_mm": response.peak_displacement,
        "dy_max_mm": response.peak_change,
        "v_max_mm_s": response.peak_velocity,
        "residual_mm": response.residual_displacement,
        "force_max_kN": response.peak_force / 1e3,
        "temperature_max_degC": response.peak_temperature,
        "friction_min": response.least_friction,
        "V_E_mm_s": response.input_velocity,
        "V_Eh_mm_s": response.hysteretic_velocity,
        "energy_residual": response.energy.relative_residual,
        "status": response.status.value,
        "elapsed_s": response.elapsed,
    }
