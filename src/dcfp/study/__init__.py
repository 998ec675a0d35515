"""Studies: from one analysis to a million, over any factors, into a store that survives an interruption."""

from dcfp.study.plan import Plan as Plan
from dcfp.study.read import read_study as read_study
from dcfp.study.run import run_study as run_study
from dcfp.study.sampling import Choice as Choice
from dcfp.study.sampling import Normal as Normal
from dcfp.study.sampling import Sampling as Sampling
from dcfp.study.sampling import Uniform as Uniform
from dcfp.study.store import open_store as open_store
from dcfp.study.study import Settings as Settings
from dcfp.study.study import Study as Study
