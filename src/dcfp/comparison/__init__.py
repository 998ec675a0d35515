"""Predictions beside response history analyses: ratios, scatter, refitted constants, intervals."""

from dcfp.comparison.case import Case as Case
from dcfp.comparison.case import Setting as Setting
from dcfp.comparison.case import compare as compare
