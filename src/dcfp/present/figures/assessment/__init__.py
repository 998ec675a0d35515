"""Figures of what a study says."""

from dcfp.present.figures.assessment.bounds import plot_bounds as plot_bounds
from dcfp.present.figures.assessment.fragility import plot_fragility as plot_fragility
from dcfp.present.figures.assessment.incremental_dynamic_analysis import plot_ida as plot_ida
from dcfp.present.figures.assessment.sensitivity import plot_sensitivity as plot_sensitivity
