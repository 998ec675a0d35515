"""The measures of each cycle with their units in their names."""

import math
from typing import TYPE_CHECKING

from dcfp.analysis.rig.measures import Cycle

if TYPE_CHECKING:
    from dcfp.analysis.rig.loops import Loops
    from dcfp.analysis.rig.measurement import Measurement


def cycle_rows(loops: "Loops") -> list[dict[str, float | str | None]]:
    """Return what the command line's JSON holds for each cycle of a test."""
    shared = {
        "test": loops.test.name,
        "friction": loops.friction_law.name,
        "heating": loops.heating.name,
        "waveform": loops.test.waveform.kind,
        "peak_velocity_mm_s": loops.test.waveform.peak_velocity,
        "period_s": loops.test.waveform.period,
    }
    pressure = 1.0 / loops.bearing.slider_area
    return [
        {**shared, **measures(cycle), "pressure_N_mm2": cycle.load * pressure, "elapsed_s": loops.elapsed}
        for cycle in loops.cycles
    ]


def measured_rows(name: str, measurement: "Measurement") -> list[dict[str, float | str | None]]:
    """Return the same for each cycle of a measured test beside the test `name`; there is no model, which is said in place of its names."""
    shared = {
        "test": name,
        "friction": "measured",
        "heating": "measured",
        "waveform": "recorded",
        "file": measurement.name,
    }
    return [{**shared, **measures(cycle)} for cycle in measurement.cycles]


def measures(cycle: Cycle) -> dict[str, float | None]:
    """Return the measures of one cycle; None where one does not exist."""
    return {
        "cycle": cycle.number,
        "displacement_max_mm": cycle.largest,
        "displacement_min_mm": cycle.least,
        "force_at_displacement_max_kN": cycle.force_at_largest / 1e3,
        "force_at_displacement_min_kN": cycle.force_at_least / 1e3,
        "load_kN": cycle.load / 1e3,
        "keff_kN_mm": _known(cycle.effective_stiffness / 1e3),
        "beta_eff": _known(cycle.effective_damping),
        "post_yield_stiffness_kN_mm": _known(cycle.post_yield_stiffness / 1e3),
        "strength_kN": _known(cycle.strength / 1e3),
        "energy_kN_m": cycle.energy / 1e6,
        "friction_of_loop": _known(cycle.loop_friction),
        "friction_at_zero": _known(cycle.friction),
        "friction_at_zero_first": cycle.crossings[0] if cycle.crossings else None,
        "friction_at_zero_second": cycle.crossings[1] if len(cycle.crossings) > 1 else None,
        "temperature_max_degC": _known(cycle.peak_temperature),
    }


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value
