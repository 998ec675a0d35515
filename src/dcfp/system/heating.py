"""How the contact heats up: Li et al. (2020), section 4.2."""

import math
from dataclasses import field, fields
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.heat_state import LINE, NO_HEATING, POINT
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.registry import Registry
from dcfp.schema.units import CONDUCTIVITY as CONDUCTIVITY_UNIT
from dcfp.schema.units import DEGC, DIFFUSIVITY, MM, NONE

INSULATED = "insulated"

#: Heating models by name.
HEATINGS: "Registry[type[Heating]]" = Registry("heating model")


@declared
class Heating(Declared):
    """What every heating model knows of the plates. A class with a ``name`` of its own registers itself; its ``kind`` is that of the kernels.

    Parameters
    ----------
    conductivity
        Thermal conductivity k of the plates [N/(s degC)]; 16 is 0.016 W/(mm degC), and 1 W is 1000 N mm/s: steel, section 4.2.
    back
        What the back of a plate of finite thickness does: ``"insulated"`` lets no heat through, ``"ambient"`` stays at the ambient
        temperature. A real one is in between.
    """

    noun = "the heating model"
    name: ClassVar[str]
    words: ClassVar[str]
    description: ClassVar[str]
    kind: ClassVar[int]

    conductivity: Annotated[
        float,
        Parameter("thermal conductivity of the plates", CONDUCTIVITY_UNIT, 0.1, 1000.0, symbol="k", step=1.0),
    ] = 16.0
    diffusivity: Annotated[
        float, Parameter("thermal diffusivity of the plates", DIFFUSIVITY, 0.01, 1000.0, symbol="D", step=0.1)
    ] = 4.07
    ambient: Annotated[
        float, Parameter("temperature at the start", DEGC, -60.0, 200.0, symbol="T_0", step=5.0)
    ] = 20.0
    # in a thinner plate the fit of the modes is not checked, in a thicker one the fastest becomes too slow
    thickness: Annotated[
        float | None,
        Parameter("thickness of the plates", MM, 10.0, 200.0, symbol="h", step=5.0, absent="endlessly thick"),
    ] = field(default=None, kw_only=True)
    back: Annotated[
        str, Parameter("back of plates of finite thickness", choices=(INSULATED, "ambient"), vary=False)
    ] = field(default=INSULATED, kw_only=True)

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if "name" in cls.__dict__:
            HEATINGS.add(cls.name, cls)

    def check_relations(self) -> None:
        """Refuse a back without a thickness."""
        if self.thickness is None and self.back != INSULATED:
            msg = f"A back that is {self.back!r} needs the thickness of the plate."
            raise InputError(msg)

    @property
    def rise_factor(self) -> float:
        """Factor before the integral of Eq. (11), sqrt(D) / (k sqrt(pi)) [degC mm s^(1/2) / N]."""
        return math.sqrt(self.diffusivity / math.pi) / self.conductivity


@declared
class SimplifiedHeating(Heating):
    """One monitoring point at the centre of each plate (Figure 5b)."""

    name: ClassVar[str] = "simplified"
    words: ClassVar[str] = "one point at the centre (simplified)"
    description: ClassVar[str] = (
        "one point at the centre of each plate, Li et al. (2020), section 4.2, Figure 5b"
    )
    kind: ClassVar[int] = POINT


@declared
class PreciseHeating(Heating):
    """Many points along the sliding direction; the contact has their mean temperature (Figure 5a).

    Parameters
    ----------
    cells
        Number of cells that the length of the contact is divided into. 64 is within 0.02 degC and
        0.01 % of the peak displacement of 200.
    points
        In two directions: number of spacings of the grid of points that the diameter of the slider is long. 50 is within 0.3 degC of 100.
    """

    name: ClassVar[str] = "precise"
    words: ClassVar[str] = "the whole line of the plate (precise)"
    description: ClassVar[str] = (
        "points along the path of the slider, their mean in the contact, Li et al. (2020), section 4.2, Figure 5a"
    )
    kind: ClassVar[int] = LINE

    cells: Annotated[
        int, Parameter("number of cells across the contact", NONE, 2, 10_000, step=16, vary=False)
    ] = 64
    points: Annotated[
        int, Parameter("number of points across the slider, in the plane", NONE, 4, 1000, step=10, vary=False)
    ] = 50


@declared
class NoHeating(Heating):
    """The contact stays at the ambient temperature."""

    name: ClassVar[str] = "none"
    words: ClassVar[str] = "none"
    description: ClassVar[str] = "the contact stays at the temperature of the start"
    kind: ClassVar[int] = NO_HEATING


def plates_of(heating: Heating) -> dict[str, Any]:
    """Return what every heating model knows of the plates, to make another model of the same plates with."""
    return {item.name: getattr(heating, item.name) for item in fields(Heating)}


def constant_flux_rise(heating: Heating, flux: ArrayLike, time: ArrayLike) -> FloatArray:
    r"""Temperature rise of a half-space's surface under a constant flux [degC].

    .. math:: \Delta T = \frac{2 q}{k} \sqrt{\frac{D t}{\pi}}

    `flux` [N/(mm s)] from time zero on, `time` [s]. Carslaw and Jaeger (1959), section 2.9.
    """
    return np.asarray(2.0 * np.asarray(flux) * heating.rise_factor * np.sqrt(time))
