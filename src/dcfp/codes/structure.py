"""What the conditions of codes ask of the building and its site."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Structure:
    """A building on the isolation layer; what is None is not known, and the conditions that ask for it say so.

    Parameters
    ----------
    fixed_base_period
        Of the structure without isolation [s]; 0 for a rigid one.
    height
        Above the isolation [mm].
    site_class
        After ASCE/SEI 7, ``"A"`` to ``"F"``.
    plan
        Larger dimension of the plan [mm].
    fault_distance
        To the nearest fault of a magnitude of 6.5 or more [mm].
    weight_above
        Weight of the structure above the base level over the whole weight, W_s / W [-].
    """

    fixed_base_period: float = 0.0
    height: float | None = None
    site_class: str | None = None
    plan: float | None = None
    fault_distance: float | None = None
    weight_above: float | None = None
