"""The monitoring point at the centre of a plate: Eqs (11) and (12) of Li et al. (2020) under a constant flux."""

import numpy as np
import pytest

from dcfp.kernels.heating import surface_temperature
from dcfp.system import LI_2020, SimplifiedHeating, System
from dcfp.system.heating import constant_flux_rise
from dcfp.system.plates import cold_plates, heat_of, system_constants

SPEED, FLUX = 100.0, 200.0


@pytest.mark.parametrize("radii", [(9000.0,), (4500.0, 4500.0), (6000.0, 3000.0)])
@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_the_point_is_heated_while_the_plates_own_travel_is_within_the_contact(
    radii: tuple[float, ...], direction: float
) -> None:
    """Slide away at a constant speed: the point has the heat of a constant flux up to the edge, and none after it."""
    system = System(LI_2020.changed(radii=radii), heating=SimplifiedHeating())
    plates = cold_plates(system)
    lengths = np.full(800, 0.01)
    time = np.concatenate(([0.0], np.cumsum(lengths)))
    found = np.empty((time.size, plates.cells.shape[0]))
    displacement = direction * SPEED * time
    heat = heat_of(plates, system)
    flux = np.full(time.size, FLUX)
    assert surface_temperature(system_constants(system), heat, lengths, displacement, flux, found)
    for plate, share in enumerate(dict.fromkeys(system.bearing.shares)):
        leaves = system.bearing.contact_half_side / share / SPEED
        with_heat = constant_flux_rise(system.heating, share * FLUX, time)
        without = constant_flux_rise(system.heating, share * FLUX, np.maximum(time - leaves, 0.0))
        expected = system.heating.ambient + with_heat - without
        # what is younger than some milliseconds is not yet as the modes have it
        old = np.abs(time - leaves) > 0.05
        assert found[old, plate] == pytest.approx(expected[old], abs=2e-3 * expected.max())
        assert leaves < time[-1]
