"""The same tests with several models, side by side."""

from collections.abc import Callable
from dataclasses import dataclass

from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.program import Program
from dcfp.analysis.rig.run import TOLERANCE, run_program
from dcfp.system import (
    Bearing,
    ConstantFriction,
    FrictionLaw,
    Heating,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    plates_of,
)


@dataclass(frozen=True)
class Model:
    """A friction law and a heating model under a short name."""

    name: str
    friction: FrictionLaw
    heating: Heating


def paper_models(friction: FrictionLaw, heating: Heating) -> tuple[Model, ...]:
    """Return the three models that Li et al. (2020), section 4, compare.

    A law with precise and with simplified heating, and the constant nominal coefficient without any.

    Parameters
    ----------
    friction
        Law of the first two.
    heating
        From which the plates are taken; if it is the precise model, its cells too.
    """
    plates = plates_of(heating)
    precise = heating if isinstance(heating, PreciseHeating) else PreciseHeating(**plates)
    return (
        Model("precise", friction, precise),
        Model("simplified", friction, SimplifiedHeating(**plates)),
        Model("constant", ConstantFriction(), NoHeating(**plates)),
    )


def run_models(
    program: Program,
    bearing: Bearing,
    models: tuple[Model, ...],
    *,
    tolerance: float = TOLERANCE,
    report: Callable[[], None] | None = None,
) -> dict[str, tuple[Loops, ...]]:
    """Run a program with every model; return the tests by the name of the model. Arguments as in `run_program`."""
    return {
        model.name: run_program(
            program, bearing, model.friction, model.heating, tolerance=tolerance, report=report
        )
        for model in models
    }
