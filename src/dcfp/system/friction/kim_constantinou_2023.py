r"""Two more laws of how friction falls with temperature: Kim and Constantinou (2023).

All else is as in `kumar_2015`, whose law leaves half of the coefficient at 200 degC; these leave a third and two thirds.
"""

from typing import ClassVar

from dcfp.schema.parameters import declared
from dcfp.system.friction.kumar_2015 import Kumar2015, TemperatureLaw


@declared
class KimConstantinou2023Third(Kumar2015):
    """The law of Kumar et al. (2015) with a temperature factor that leaves one third at 200 degC."""

    temperature_law: ClassVar[TemperatureLaw] = TemperatureLaw(0.9696, 0.0289, 0.2099)
    name: ClassVar[str] = "kim2023-third"
    words: ClassVar[str] = "Kim and Constantinou (2023), a third at 200 °C"
    citation: ClassVar[str] = "kim_constantinou_2022"


@declared
class KimConstantinou2023TwoThirds(Kumar2015):
    """The law of Kumar et al. (2015) with a temperature factor that leaves two thirds at 200 degC."""

    temperature_law: ClassVar[TemperatureLaw] = TemperatureLaw(0.8383, 0.00851, 0.2099)
    name: ClassVar[str] = "kim2023-two-thirds"
    words: ClassVar[str] = "Kim and Constantinou (2023), two thirds at 200 °C"
    citation: ClassVar[str] = "kim_constantinou_2022"
