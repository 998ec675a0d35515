"""What the conditions of codes ask of the building and its site."""

from dataclasses import dataclass

from dcfp.errors import InputError
from dcfp.methods.result import Verdict, at_least

#: Site classes of ASCE/SEI 7.
SITE_CLASSES = ("A", "B", "C", "D", "E", "F")


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

    Raises
    ------
    InputError
        If there is no such site class.
    """

    fixed_base_period: float | None = None
    height: float | None = None
    site_class: str | None = None
    plan: float | None = None
    fault_distance: float | None = None
    weight_above: float | None = None

    def __post_init__(self) -> None:
        if self.site_class is not None and self.site_class not in SITE_CLASSES:
            msg = f"The site classes of ASCE 7 are {', '.join(SITE_CLASSES)}, not {self.site_class!r}."
            raise InputError(msg)

    def over_fixed_base(self, period: float, least: float) -> tuple[Verdict, str]:
        """Return whether a period [s] is at least so many times that of the fixed base, and what it is, in words."""
        fixed = self.fixed_base_period
        if fixed is None:
            return Verdict.NOT_KNOWN, "not given"
        if fixed == 0.0:
            return Verdict.MET, "rigid structure"
        return at_least(period, least * fixed), f"{period / fixed:.1f}"
