"""A friction law as a user adds one, in a module of its own: it falls with the speed, by a parameter that no other law has."""

from hashlib import sha256
from inspect import getsource
from typing import Annotated, ClassVar

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, law_by_address
from dcfp.kernels.user_law import compile_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Expression
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import FRACTION, MM_PER_S
from dcfp.system.friction.law import Factor, FrictionLaw


def _coefficient(constants, pressure: float, speed: float, temperature: float, dose: float) -> float:
    return constants[0] / (1.0 + speed / constants[1])


@declared
class Toy(FrictionLaw):
    """A coefficient that is halved at one speed."""

    name: ClassVar[str] = "toy"
    words: ClassVar[str] = "law of the toy works"
    reference_parameter: ClassVar[str] = "slow"
    equation_numbers: ClassVar[str] = ""

    slow: Annotated[float, Parameter("coefficient of friction at rest", FRACTION, 0.001, 0.5)] = 0.06
    halving_speed: Annotated[
        float, Parameter("speed that halves the toy's friction", MM_PER_S, 10.0, 1e5, symbol="v_h")
    ] = 800.0

    def factors(self) -> tuple[Factor, ...]:
        """The fall with the speed."""
        fall = Expression("1 / (1 + {x} / {halving})", "v", {"halving": ("v_h", f"{self.halving_speed:g}")})
        return (Factor("speed", "k_v", fall, self._fall),)

    def _fall(self, speed: FloatArray) -> FloatArray:
        return 1.0 / (1.0 + np.abs(speed) / self.halving_speed)

    def at_pressure(self, pressure: float) -> Law:
        """What the kernels take."""
        constants = (self.slow, self.halving_speed, 0.0, 0.0, 0.0, 0.0)
        # compiled once, however often a test imports this module
        identity = sha256(getsource(_coefficient).encode()).hexdigest()
        return law_by_address(compile_law(_coefficient, identity).address, constants)
