"""Predictions beside response history analyses: ratios, scatter, refitted constants, intervals; and what tests tell of a friction law."""

from dcfp.inference.case import Case as Case
from dcfp.inference.case import compare as compare
from dcfp.methods.prediction import Methods as Methods
