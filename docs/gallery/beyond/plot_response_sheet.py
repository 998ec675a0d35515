"""
An analysis on a sheet
======================

Loop, histories and key numbers of one analysis. Colour is the temperature of the contact.
"""

import dcfp
from dcfp.present.figures import plot_response

response = dcfp.respond(
    dcfp.load_motion("NCC").scaled_to_pgv(500.0), heating=dcfp.PreciseHeating()
)
figure = plot_response(response)

print(
    f"y_max {response.peak_displacement:.1f} mm, T_max {response.peak_temperature:.0f} °C, energy closes to {response.energy.relative_residual:.0e}"
)
