r"""Property modification factors that tests show: lambda_test of ASCE/SEI 7-16, section 17.2.8.4.

A prototype test gives first-cycle properties that are higher than the three-cycle average, on which nominal design properties rest, and later ones
that are lower, since the plates heat up. With a heated model both follow from the sequence of tests, before any is made:

.. math:: \lambda_{test,max} = \frac{first\ cycle}{mean\ of\ three}, \qquad \lambda_{test,min} = \frac{last\ cycle}{mean\ of\ three}

at the maximum displacement; the endurance test gives a lower one after many cycles. Which cycle counts as the last is
*unconfirmed*, so both are given.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.measures import Cycle

#: Cycles on which nominal properties rest.
NOMINAL_CYCLES = 3


@dataclass(frozen=True)
class PropertyFactor:
    """How much one property of the bearing changes in the tests.

    Attributes
    ----------
    name
        Of the property, in words.
    nominal
        Mean over the first three cycles at the maximum displacement, in `unit`.
    unit
        Its unit.
    upper
        lambda_test,max: the first of these cycles over the nominal value [-].
    lower
        lambda_test,min: the last of these cycles over the nominal value [-].
    first_over_third
        The first over the third of these cycles [-].
    enduring
        The last cycle of the endurance tests over their own first three's mean [-]; None where there are none.
    tests
        Names of the tests that it comes from.
    """

    name: str
    nominal: float
    unit: str
    upper: float
    lower: float
    first_over_third: float
    enduring: float | None
    tests: tuple[str, ...]


_PROPERTIES: tuple[tuple[str, str, Callable[[Cycle], float]], ...] = (
    ("friction of the loop", "-", lambda cycle: cycle.loop_friction),
    ("effective stiffness", "kN/mm", lambda cycle: cycle.effective_stiffness / 1e3),
    ("effective damping", "-", lambda cycle: cycle.effective_damping),
    ("energy per cycle", "kN m", lambda cycle: cycle.energy / 1e6),
)


def property_factors(loops: Sequence[Loops]) -> list[PropertyFactor]:
    """Return the factors of the tests; an empty list where none has the role of the maximum with three cycles or more."""
    largest = [t for t in loops if t.test.role == "maximum" and len(t.cycles) >= NOMINAL_CYCLES]
    if not largest:
        return []
    first = largest[0]
    enduring = [t for t in loops if t.test.role == "endurance"]
    many = [cycle for test in enduring for cycle in test.cycles]
    names = (first.test.name, *(test.test.name for test in enduring))
    factors: list[PropertyFactor] = []
    for name, unit, of in _PROPERTIES:
        values = [of(cycle) for cycle in first.cycles[:NOMINAL_CYCLES]]
        nominal = sum(values) / len(values)
        late = None
        if len(many) > NOMINAL_CYCLES:
            early = many[:NOMINAL_CYCLES]
            late = of(many[-1]) * len(early) / sum(of(cycle) for cycle in early)
        factors.append(
            PropertyFactor(
                name=name,
                nominal=nominal,
                unit=unit,
                upper=values[0] / nominal,
                lower=values[-1] / nominal,
                first_over_third=values[0] / values[-1],
                enduring=late,
                tests=names,
            )
        )
    return factors
