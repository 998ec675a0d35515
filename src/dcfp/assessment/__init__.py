"""What a study says: incremental dynamic analysis, fragility, property bounds, sensitivity and design charts.

Each takes the data set of a study, refuses what it cannot use with one sentence, and returns its result with remarks in its attributes.
"""

from dcfp.assessment.bounds import bounds as bounds
from dcfp.assessment.design_chart import design_space as design_space
from dcfp.assessment.fragility import fragility as fragility
from dcfp.assessment.incremental_dynamic_analysis import ida as ida
from dcfp.assessment.selection import select as select
from dcfp.assessment.sensitivity import sensitivity as sensitivity
