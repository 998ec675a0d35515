"""What a method predicts."""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.methods.pulses import Pulses
from dcfp.schema.notebook import fields_card


@dataclass(frozen=True)
class Prediction:
    """Largest change of displacement between two of its peaks, and the energies that go with it.

    Attributes
    ----------
    displacement_change
        dy [mm].
    input_velocity
        Equivalent velocity V_dE of the energy put in on the way [mm/s].
    hysteretic_velocity
        Equivalent velocity V_dEhr of the energy dissipated on the way [mm/s].
    displacement
        Largest displacement y_max [mm], or None where the method has none of its own: dy then stands for it.
    total_velocity
        Equivalent velocity V_E of all the energy put in [mm/s], or None where the method does not say.
    """

    displacement_change: float
    input_velocity: float
    hysteretic_velocity: float
    displacement: float | None = None
    total_velocity: float | None = None

    @property
    def bound(self) -> float:
        """What the method offers for y_max [mm]: its own, or dy, which Li et al. (2020), section 6.1.2, take as conservative."""
        return self.displacement_change if self.displacement is None else self.displacement

    def _repr_html_(self) -> str:
        return fields_card(self, "Prediction")


#: What is said where there is nothing to say it of.
NOTHING = Prediction(math.nan, math.nan, math.nan)


@dataclass(frozen=True, eq=False)
class PulsePrediction:
    """What a method predicts of every pulse of a record.

    Attributes
    ----------
    pulses
        The pulses.
    displacement_change, input_velocity, hysteretic_velocity
        As in `Prediction` [mm, mm/s, mm/s], shape (count,).
    """

    pulses: Pulses
    displacement_change: FloatArray
    input_velocity: FloatArray
    hysteretic_velocity: FloatArray

    @property
    def governing(self) -> int | None:
        """Number of the pulse with the largest displacement, counted from zero; None where nothing moves."""
        if self.pulses.count == 0 or self.displacement_change.max() == 0.0:
            return None
        return int(np.argmax(self.displacement_change))

    @property
    def largest(self) -> Prediction:
        """Largest displacement and energies of all pulses, each by itself; zero where there is no pulse. This is blind: it knows the record only."""
        return Prediction(
            *(
                float(values.max(initial=0.0))
                for values in (self.displacement_change, self.input_velocity, self.hysteretic_velocity)
            )
        )

    def of(self, pulse: int | None) -> Prediction:
        """Return what one pulse does, counted from zero; not a number where it is None.

        With the pulse that the analysis shows to have caused the largest displacement, this is informed.
        """
        if pulse is None:
            return NOTHING
        return Prediction(
            float(self.displacement_change[pulse]),
            float(self.input_velocity[pulse]),
            float(self.hysteretic_velocity[pulse]),
        )

    def _repr_html_(self) -> str:
        facts = {"pulses": self.pulses.count, "governing pulse": self.governing}
        return fields_card(self.largest, "Prediction from pulses, the largest of all", facts)
