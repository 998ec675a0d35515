"""Figures of analyses: each takes axes and returns them, or makes its own.

Matplotlib's objects are used without its state, so there is no window, no backend and nothing to close.
"""

from dcfp.plots.checks import plot_checks as plot_checks
from dcfp.plots.comparison import plot_comparison as plot_comparison
from dcfp.plots.energies import plot_energies as plot_energies
from dcfp.plots.histories import plot_displacement as plot_displacement
from dcfp.plots.histories import plot_friction as plot_friction
from dcfp.plots.histories import plot_temperature as plot_temperature
from dcfp.plots.histories import plot_velocities as plot_velocities
from dcfp.plots.identification import plot_identification as plot_identification
from dcfp.plots.loop import plot_loop as plot_loop
from dcfp.plots.motions import plot_motions as plot_motions
from dcfp.plots.overview import plot_overview as plot_overview
from dcfp.plots.profile import plot_profile as plot_profile
from dcfp.plots.program import plot_program as plot_program
from dcfp.plots.pulses import plot_pulses as plot_pulses
from dcfp.plots.sheet import plot_response as plot_response
from dcfp.plots.style import save_figure as save_figure
