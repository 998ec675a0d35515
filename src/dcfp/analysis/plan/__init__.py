"""Response of an isolated building on many bearings."""

from dcfp.analysis.plan.history import respond_plan as respond_plan
from dcfp.analysis.plan.response import PlanResponse as PlanResponse
