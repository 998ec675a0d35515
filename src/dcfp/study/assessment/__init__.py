"""What a study says: incremental dynamic analysis, fragility, property bounds, sensitivity and design charts.

Each takes the data set of a study, refuses what it cannot use with one sentence, and returns its result with
remarks in its attributes.
"""

from dcfp.study.assessment.bounds import bounds as bounds
from dcfp.study.assessment.design_chart import design_space as design_space
from dcfp.study.assessment.fragility import fragility as fragility
from dcfp.study.assessment.fragility import ida as ida
from dcfp.study.assessment.selection import select as select
from dcfp.study.assessment.sensitivity import sensitivity as sensitivity
