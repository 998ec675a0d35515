"""Studies: from one analysis to a million, over any factors, into a store that survives an interruption.

The names below are imported when they are first used, so that to read a store does not wait for all that makes one.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dcfp.study.plan import Plan as Plan
    from dcfp.study.read import read_study as read_study
    from dcfp.study.results import open_store as open_store
    from dcfp.study.run import run_study as run_study
    from dcfp.study.sampling import Choice as Choice
    from dcfp.study.sampling import Normal as Normal
    from dcfp.study.sampling import Sampling as Sampling
    from dcfp.study.sampling import Uniform as Uniform
    from dcfp.study.study import Study as Study

_HOMES = {
    "Plan": "plan",
    "read_study": "read",
    "open_store": "results",
    "run_study": "run",
    "Choice": "sampling",
    "Normal": "sampling",
    "Sampling": "sampling",
    "Uniform": "sampling",
    "Study": "study",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        msg = f"module {__name__!r} has no attribute {name!r}"
        raise AttributeError(msg)
    value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})
