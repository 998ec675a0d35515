"""How much further the corner of a slab goes than its centre, by the torsion formulas of the codes."""

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dcfp.methods.asce_2016 import total_displacement
from dcfp.methods.eurocode_8 import torsion_factors
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import NONE

if TYPE_CHECKING:
    from dcfp.arrays import FloatArray
    from dcfp.system.plan import Plan

#: Accidental eccentricity of both codes, in parts of a side.
ACCIDENTAL = 0.05
#: Distance up to which bearings stand in one place and hold nothing against rotation [mm].
_ONE_PLACE = 1.0


class CodeTorsion(NamedTuple):
    """Displacement of the worst corner over that of the centre by a code, for shaking along x, along y, and the larger of both [-]."""

    code: str
    formula: str
    along_x: float
    along_y: float

    @property
    def largest(self) -> float:
        """The larger one [-]."""
        return max(self.along_x, self.along_y)


#: What is told of it.
TORSION = (
    Quantity("code", "code", head="Code", get="code"),
    Quantity("formula", "formula", head="Formula", get="formula"),
    Quantity("corner_ratio_x", "corner over centre, shaking along x", NONE, decimals=3, head="along x", get="along_x"),
    Quantity("corner_ratio_y", "corner over centre, shaking along y", NONE, decimals=3, head="along y", get="along_y"),
    Quantity("corner_ratio", "the larger one", NONE, decimals=3, head="larger", get="largest"),
)  # fmt: skip


def code_torsion(plan: "Plan", displacement: float) -> tuple[CodeTorsion, ...]:
    """Return what the codes say of the corners of a building that is displaced so far [mm].

    The stiffness of a bearing is the effective one at that displacement under its static load, with the centre of mass where it is without accidental eccentricity;
    to what is left of an eccentricity 5 % of a side is added, as both codes prescribe: ASCE 7 of the longer side, NTC 2018 (whose formulas Eurocode 8 has too) of the side across the shaking. They say nothing of bearings in one place.
    """
    nominal = plan.without_accident
    stiffness = _effective_stiffnesses(nominal, max(displacement, 1.0))
    turn = np.array(
        [[math.cos(plan.angle), -math.sin(plan.angle)], [math.sin(plan.angle), math.cos(plan.angle)]]
    )
    rigidity = stiffness @ nominal.places / stiffness.sum()
    places = (nominal.places - rigidity) @ turn
    if not np.abs(places).max() > _ONE_PLACE:
        return ()
    corners = (nominal.corners - rigidity) @ turn
    own = np.abs((np.array(nominal.mass_centre) - rigidity) @ turn)
    return _asce(plan, places, corners, own), _ntc(plan, places, corners, own, stiffness)


def _effective_stiffnesses(plan: "Plan", displacement: float) -> "FloatArray":
    """Return N / R + mu N / D of every bearing [N/mm]."""
    loads = plan.static_loads
    coefficients = np.array(
        [
            one.friction.at_pressure(float(load) / one.bearing.slider_area).reference
            for one, load in zip(plan.systems, loads, strict=True)
        ]
    )
    return loads / plan.radii + coefficients * loads / displacement


def period_ratio(places: "FloatArray", sides: tuple[float, float]) -> float:
    """Return P_T of ASCE 7-16, 17.5.3.3 [-]: sqrt(sum(x^2 + y^2) / N) over the radius of gyration, and at least 1; `places` from the centre of rigidity [mm], shape (n, 2)."""
    gyration = math.hypot(*sides) / math.sqrt(12.0)
    return max(math.sqrt(float((places**2).sum()) / len(places)) / gyration, 1.0)


def _asce(plan: "Plan", places: "FloatArray", corners: "FloatArray", own: "FloatArray") -> CodeTorsion:
    b, d = plan.lengths
    ratio = period_ratio(places, (b, d))
    found = [
        total_displacement(1.0, float(own[1 - axis]) + ACCIDENTAL * max(b, d), float(np.abs(corners[:, 1 - axis]).max()), b, d, ratio)
        for axis in range(2)
    ]  # fmt: skip
    return CodeTorsion("ASCE 7-16", "D_TM / D_M, Eq. (17.5-3)", *found)


def _ntc(
    plan: "Plan", places: "FloatArray", corners: "FloatArray", own: "FloatArray", stiffness: "FloatArray"
) -> CodeTorsion:
    eccentricity = own + ACCIDENTAL * np.array(plan.lengths)
    both = np.column_stack((stiffness, stiffness))
    # a corner is no device: it has a place, and no stiffness
    everything = np.vstack((places, np.abs(corners)))
    weights = np.vstack((both, np.zeros((len(corners), 2))))
    along_x, along_y = torsion_factors(everything, weights, (float(eccentricity[0]), float(eccentricity[1])))
    last = slice(len(places), None)
    return CodeTorsion(
        "NTC 2018", "delta, (7.10.4), (7.10.5)", float(along_x[last].max()), float(along_y[last].max())
    )
