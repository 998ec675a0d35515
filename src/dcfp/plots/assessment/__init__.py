"""Figures of what a study says."""

from dcfp.plots.assessment.bounds import plot_bounds as plot_bounds
from dcfp.plots.assessment.fragility import plot_fragility as plot_fragility
from dcfp.plots.assessment.incremental_dynamic_analysis import plot_ida as plot_ida
from dcfp.plots.assessment.sensitivity import plot_sensitivity as plot_sensitivity
