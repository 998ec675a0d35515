"""Figures of analyses: each takes axes and returns them, or makes its own.

Matplotlib's objects are used without its state, so there is no window, no backend and nothing to close.
"""

from dcfp.present.figures.checks import plot_checks as plot_checks
from dcfp.present.figures.drawing import figure_of as figure_of
from dcfp.present.figures.drawing import plot_displacement as plot_displacement
from dcfp.present.figures.drawing import plot_energies as plot_energies
from dcfp.present.figures.drawing import plot_friction as plot_friction
from dcfp.present.figures.drawing import plot_loop as plot_loop
from dcfp.present.figures.drawing import plot_profile as plot_profile
from dcfp.present.figures.drawing import plot_response as plot_response
from dcfp.present.figures.drawing import plot_temperature as plot_temperature
from dcfp.present.figures.drawing import plot_velocities as plot_velocities
from dcfp.present.figures.identification import plot_identification as plot_identification
from dcfp.present.figures.motions import plot_motions as plot_motions
from dcfp.present.figures.overviews import plot_overview as plot_overview
from dcfp.present.figures.overviews import plot_program as plot_program
from dcfp.present.figures.plane import plot_orbit as plot_orbit
from dcfp.present.figures.plane import plot_orbits as plot_orbits
from dcfp.present.figures.plane import plot_plane_response as plot_plane_response
from dcfp.present.figures.plane_field import plot_field as plot_field
from dcfp.present.figures.plane_tests import plot_plane_program as plot_plane_program
from dcfp.present.figures.plane_tests import plot_plane_test as plot_plane_test
from dcfp.present.figures.predictions import plot_comparison as plot_comparison
from dcfp.present.figures.pulses import plot_pulses as plot_pulses
from dcfp.present.figures.stations import plot_station_spectra as plot_station_spectra
from dcfp.present.figures.stations import plot_stations as plot_stations
from dcfp.present.figures.style import save_figure as save_figure
