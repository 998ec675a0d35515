"""How the contact heats up: Li et al. (2020), section 4.2."""

import math
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.heat_state import LINE, NO_HEATING, POINT
from dcfp.schema.notebook import fields_card
from dcfp.system.checks import finite, make_named, positive

#: Thermal conductivity k of steel [N/(s degC)]: 0.016 W/(mm degC), and 1 W is 1000 N mm/s; section 4.2.
CONDUCTIVITY = 16.0
#: Thermal diffusivity D of steel [mm2/s]; section 4.2.
DIFFUSIVITY = 4.07
#: Temperature at the start [degC].
AMBIENT = 20.0

#: What the back of a plate can do.
INSULATED = "insulated"
BACKS = (INSULATED, "ambient")
#: Limits of a plate's thickness [mm]: in a thinner one the modes' fit is not checked, in a thicker one the fastest becomes too slow.
LEAST_THICKNESS, LARGEST_THICKNESS = 10.0, 200.0


@dataclass(frozen=True)
class _Steel:
    """What every heating model knows.

    Parameters
    ----------
    conductivity
        Thermal conductivity k of the plates [N/(s degC)]; 16 is 0.016 W/(mm degC).
    diffusivity
        Thermal diffusivity D of the plates [mm2/s].
    ambient
        Temperature at the start [degC].
    thickness
        Of the plates [mm]; None for the half-space of the paper.
    back
        What the back of a plate of finite thickness does: ``"insulated"`` lets no heat through, ``"ambient"`` stays at the ambient
        temperature. A real one is in between.
    """

    conductivity: float = CONDUCTIVITY
    diffusivity: float = DIFFUSIVITY
    ambient: float = AMBIENT
    thickness: float | None = field(default=None, kw_only=True)
    back: str = field(default=INSULATED, kw_only=True)
    name: ClassVar[str]
    kind: ClassVar[int]

    def __post_init__(self) -> None:
        positive(self.conductivity, "thermal conductivity", "N/(s degC)")
        positive(self.diffusivity, "thermal diffusivity", "mm2/s")
        finite(self.ambient, "ambient temperature", "degC")
        if self.back not in BACKS:
            msg = f"The back of a plate must be one of {', '.join(BACKS)}, not {self.back!r}."
            raise InputError(msg)
        if self.thickness is None:
            if self.back != INSULATED:
                msg = f"A back that is {self.back!r} needs the thickness of the plate."
                raise InputError(msg)
        elif (
            not LEAST_THICKNESS <= positive(self.thickness, "thickness of a plate", "mm") <= LARGEST_THICKNESS
        ):
            msg = f"The thickness of a plate must be from {LEAST_THICKNESS:g} to {LARGEST_THICKNESS:g} mm, not {self.thickness!r}."
            raise InputError(msg)

    @property
    def rise_factor(self) -> float:
        """Factor before the integral of Eq. (11), sqrt(D) / (k sqrt(pi)) [degC mm s^(1/2) / N]."""
        return math.sqrt(self.diffusivity / math.pi) / self.conductivity

    def _repr_html_(self) -> str:
        return fields_card(self, f"Heating model {self.name}")


@dataclass(frozen=True)
class NoHeating(_Steel):
    """The contact stays at the ambient temperature."""

    name: ClassVar[str] = "none"
    kind: ClassVar[int] = NO_HEATING


@dataclass(frozen=True)
class SimplifiedHeating(_Steel):
    """One monitoring point at the centre of each plate (Figure 5b)."""

    name: ClassVar[str] = "simplified"
    kind: ClassVar[int] = POINT


@dataclass(frozen=True)
class PreciseHeating(_Steel):
    """Many points along the sliding direction; the contact has their mean temperature (Figure 5a).

    Parameters
    ----------
    cells
        Number of cells that the length of the contact is divided into. 64 is within 0.02 degC and
        0.01 % of the peak displacement of 200.
    """

    cells: int = 64
    name: ClassVar[str] = "precise"
    kind: ClassVar[int] = LINE

    def __post_init__(self) -> None:
        super().__post_init__()
        if type(self.cells) is not int or not 2 <= self.cells <= 10_000:
            msg = f"The number of cells across the contact must be a whole number from 2 to 10000, not {self.cells!r}."
            raise InputError(msg)


Heating: TypeAlias = NoHeating | SimplifiedHeating | PreciseHeating

_MODELS: dict[str, type[Heating]] = {
    model.name: model for model in (SimplifiedHeating, PreciseHeating, NoHeating)
}


def heating_names() -> tuple[str, ...]:
    """Return the names of the heating models."""
    return tuple(_MODELS)


def heating_model(name: str, **parameters: Any) -> Heating:
    """Return a heating model by name.

    Raises
    ------
    InputError
        If there is no model of that name, or it has no such parameter, or a value is out of range.
    """
    return make_named("heating model", _MODELS, name, parameters)


def plates_of(heating: Heating) -> dict[str, Any]:
    """Return what every heating model knows of the plates, to make another model of the same plates with."""
    return {item.name: getattr(heating, item.name) for item in fields(_Steel)}


def constant_flux_rise(heating: Heating, flux: ArrayLike, time: ArrayLike) -> FloatArray:
    r"""Temperature rise of a half-space's surface under a constant flux [degC].

    .. math:: \Delta T = \frac{2 q}{k} \sqrt{\frac{D t}{\pi}}

    `flux` [N/(mm s)] from time zero on, `time` [s]. Carslaw and Jaeger (1959), section 2.9.
    """
    return np.asarray(2.0 * np.asarray(flux) * heating.rise_factor * np.sqrt(time))
