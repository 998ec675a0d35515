"""An isolated building in the plan: bearings with their places and loads, the slab's mass, and the storeys above it."""

import math
from collections.abc import Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import Annotated

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import FRACTION, METRE, TONNE, TONNE_M2
from dcfp.system.modes import ModeShapes
from dcfp.system.storeys import (
    DAMPING_KINDS,
    PLACE,
    STIFFNESS_PROPORTIONAL,
    Storey,
    Superstructure,
    place_parameter,
    superstructure,
)
from dcfp.system.system import System

#: How far the sum of given loads may be from the weight [-].
_WEIGHT_TOLERANCE = 1e-3
#: How far outside the slab rounding may put a place [mm].
_ROUNDING = 1.0
#: Distance of places and of the centre of mass from a point or a line, over the size of the plan, up to which they lie on it [-].
_ON_IT = 1e-6
#: How kf of a bearing follows from that of its type: in proportion to its static load, or the same for all.
BY_LOAD, EQUAL = "load", "equal"


@declared
class Plan(Declared):
    """Bearings under a slab that is rigid in its plane, and what stands on it.

    Parameters
    ----------
    places
        Of the bearings [mm], shape (n, 2).
    types
        Bearing with its friction law and heating model at each place; one for all of them.
    eccentricity
        Accidental, by which the centre of mass is moved, in parts of the sides.
    inertia
        Rotational inertia of the slab without the floors about the centre of mass [t mm2].
    height
        Of the slab's own centre of mass above the bearings [mm]: of the whole structure where there are no storeys.
    storeys
        Above the slab, from below.
    modes
        On a fixed base, in place of the storeys' stiffnesses, with the masses where they are without accidental eccentricity.
    damping_kind
        ``"stiffness"``: in proportion to the stiffness, with the ratio in the first mode; ``"modal"``: the same ratio in every mode.
    loads
        Static load of each bearing [N]; None for those of a rigid slab on equal vertical springs under the weight at the centre of mass.
    spring
        ``"load"``: kf of a bearing is that of its type times its static load over that of the type, so that constant friction turns no building; ``"equal"``: that of its type.
    angle
        From x to the first side [rad].
    name
        For tables and figures.

    Raises
    ------
    InputError
        If a value is out of range, or the values do not go together.
    """

    noun = "a building"

    places: FloatArray
    types: tuple[System, ...] | System = field(default_factory=System)
    mass: Annotated[
        float | None,
        Parameter("mass of slab and floors", TONNE, 0.0, above=True, absent="what the bearings carry"),
    ] = None
    centre: Annotated[
        tuple[float, float] | None,
        place_parameter("centre of mass", "that of the given loads, or the middle of the bearings"),
    ] = None
    sides: Annotated[
        tuple[float, float] | None,
        Parameter("sides of the slab in x and y", METRE, 0.0, 1000.0, above=True, absent="those of the rectangle about the bearings"),
    ] = None  # fmt: skip
    slab_centre: Annotated[
        tuple[float, float] | None, place_parameter("middle of the slab", "the middle of the bearings")
    ] = None
    eccentricity: Annotated[
        tuple[float, ...],
        Parameter("accidental eccentricity in parts of the sides", FRACTION, -0.5, 0.5, counts=(1, 2), repeat=2),
    ] = (0.0, 0.0)  # fmt: skip
    inertia: Annotated[
        float | None,
        Parameter("rotational inertia of the slab", TONNE_M2, 0.0, above=True, absent="its mass is spread evenly over the sides"),
    ] = None  # fmt: skip
    height: Annotated[
        float, Parameter("height of the slab's own centre of mass above the bearings", METRE, 0.0, 1000.0)
    ] = 0.0
    storeys: tuple[Storey, ...] = ()
    modes: ModeShapes | None = None
    damping: Annotated[
        float, Parameter("damping ratio of the storeys on a fixed base", FRACTION, 0.0, 0.9999, symbol=r"\xi")
    ] = 0.02
    damping_kind: Annotated[
        str, Parameter("kind of damping of the storeys", choices=DAMPING_KINDS)
    ] = STIFFNESS_PROPORTIONAL  # fmt: skip
    loads: FloatArray | None = None
    spring: Annotated[
        str, Parameter("how kf follows from the type", choices=(BY_LOAD, EQUAL))
    ] = BY_LOAD  # fmt: skip
    angle: float = 0.0
    name: Annotated[str, Parameter("name of the building", option=False, vary=False)] = "building"

    # plans hold arrays, and are the same only where they are one
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __post_init__(self) -> None:
        self._set("places", _places(self.places))
        types = (self.types,) * self.count if isinstance(self.types, System) else tuple(self.types)
        if len(types) != self.count:
            msg = f"A plan of {self.count} bearings needs as many types, not {len(types)}."
            raise InputError(msg)
        self._set("types", types)
        self._set("storeys", tuple(self.storeys))
        if self.loads is not None:
            self._set("loads", self._checked_loads(self.loads))
        super().__post_init__()

    def check_relations(self) -> None:
        """Refuse masses, loads and places that do not go together."""
        if self.mass is None:
            carried = (
                [one.bearing.vertical_force for one in self.systems] if self.loads is None else self.loads
            )
            self._set("mass", math.fsum(carried) / STANDARD_GRAVITY)
        if self.loads is not None and abs(self.loads.sum() / self.weight - 1.0) > _WEIGHT_TOLERANCE:
            msg = f"The loads of the bearings sum to {self.loads.sum() / 1e3:.0f} kN, and the building weighs {self.weight / 1e3:.0f} kN."
            raise InputError(msg, at="mass")
        if self.slab_mass <= 0.0:
            msg = f"The floors' masses sum to {self.floor_mass:.6g} t, and the whole building with the slab has only {self.total_mass:.6g} t."
            raise InputError(msg, at="mass")
        self._check_stiffnesses()
        far = np.hypot(*(self.places - self.places.mean(axis=0)).T)
        outside = [i for i, place in enumerate(self.places) if not self._holds(place)]
        if outside:
            i = max(outside, key=lambda one: far[one])
            msg = f"Bearing {i + 1} at {_metres(self.places[i])} stands outside the slab, which reaches {self._extent}."
            raise InputError(msg, at=f"places {i}")
        if not self._holds(self.mass_centre):
            msg = f"The centre of mass, {_metres(self.mass_centre)}, lies outside the slab, which reaches {self._extent}."
            raise InputError(msg, at="centre")
        for i, storey in enumerate(self.storeys, 1):
            if storey.centre is not None and not self._holds(storey.centre):
                msg = f"The centre of mass of storey {i}, {_metres(storey.centre)}, lies outside the slab, which reaches {self._extent}."
                raise InputError(msg)
        lightest = int(self.static_loads.argmin())
        if self.static_loads[lightest] <= 0.0:
            msg = f"With the centre of mass at {_metres(self.mass_centre)} bearing {lightest + 1} at {_metres(self.places[lightest])} would lift off at rest."
            raise InputError(msg, at="centre")
        self._check_equilibrium()

    def _check_equilibrium(self) -> None:
        """Refuse bearings on one line or in one point that do not hold what stands on them."""
        size = max(float(np.abs(self.arms).max()), 1.0)
        off = np.abs(self.static_loads @ self.arms).max() > _ON_IT * self.weight * size
        if self.loads is None and self.needed_contacts < 3 and off:
            under = "one line" if self.needed_contacts == 2 else "one point"
            msg = f"The bearings stand on {under}, and the centre of mass, {_metres(self.mass_centre)}, is not above it; move it there, or add bearings."
            raise InputError(msg, at="centre")
        if self.needed_contacts == 1 and self.structure.twists:
            msg = "A bearing alone holds no building against rotation, and mass and stiffness of the storeys are not all centred above it; centre them, or add bearings."
            raise InputError(msg, at="places")

    def _check_stiffnesses(self) -> None:
        """Refuse storeys without a stiffness, and modes of other storeys."""
        without = [i for i, one in enumerate(self.storeys, 1) if one.stiffness is None]
        if self.modes is None and without:
            msg = f"Storey {without[0]} has no stiffness; give it, or the modes of the building."
            raise InputError(msg)
        if self.modes is not None and len(without) < len(self.storeys):
            msg = "The stiffness of the storeys follows from the modes; leave one of the two out."
            raise InputError(msg, at="modes")
        if self.modes is not None and self.modes.floors != len(self.storeys):
            msg = f"The modes are of {self.modes.floors} floors, and the building has {len(self.storeys)} storeys."
            raise InputError(msg, at="modes")

    def _set(self, name: str, value: object) -> None:
        object.__setattr__(self, name, value)

    def _checked_loads(self, loads: Sequence[float] | FloatArray) -> FloatArray:
        found = np.asarray(loads, dtype=np.float64)
        if found.shape != (self.count,) or not (found > 0.0).all():
            msg = f"A plan of {self.count} bearings needs as many loads, all of them above zero."
            raise InputError(msg)
        return freeze(found)

    def _holds(self, place: Sequence[float] | FloatArray) -> bool:
        """Whether a place is on the slab."""
        away = np.abs(self._own_axes(np.subtract(place, self.middle)))
        return bool((away <= 0.5 * np.array(self.lengths) + _ROUNDING).all())

    @property
    def _extent(self) -> str:
        """From where to where the slab reaches, in words."""
        least, most = self.corners.min(axis=0), self.corners.max(axis=0)
        return f"from {_metres(least)} to {_metres(most)}"

    def _rectangle(self) -> tuple[float, float]:
        across = np.ptp(self._own_axes(self.places), axis=0)
        largest = max(float(across.max()), 1.0)
        return (float(across[0]) or largest, float(across[1]) or largest)

    def _own_axes(self, points: FloatArray) -> FloatArray:
        return points @ _turn(self.angle)

    @property
    def count(self) -> int:
        """Number of bearings."""
        return len(self.places)

    @property
    def systems(self) -> tuple[System, ...]:
        """Bearing with its law and heating at each place."""
        return self.types if isinstance(self.types, tuple) else (self.types,) * self.count

    @property
    def total_mass(self) -> float:
        """Mass of the whole building [t]."""
        return float(self.mass or 0.0)

    @property
    def weight(self) -> float:
        """Weight of the whole building [N]."""
        return self.total_mass * STANDARD_GRAVITY

    @property
    def floor_mass(self) -> float:
        """Mass of the floors above the slab [t]."""
        return math.fsum(one.mass for one in self.storeys)

    @property
    def slab_mass(self) -> float:
        """Mass of the slab, or of the whole structure where there are no storeys [t]."""
        return self.total_mass - self.floor_mass

    @property
    def lengths(self) -> tuple[float, float]:
        """Sides of the slab [mm]."""
        return self._rectangle() if self.sides is None else self.sides

    @property
    def middle(self) -> tuple[float, float]:
        """Middle of the slab [mm]."""
        return self.middle_of_bearings if self.slab_centre is None else self.slab_centre

    @property
    def middle_of_bearings(self) -> tuple[float, float]:
        """Middle of the rectangle about the bearings [mm]."""
        own = self._own_axes(self.places)
        x, y = 0.5 * (own.min(axis=0) + own.max(axis=0)) @ _turn(self.angle).T
        return float(x), float(y)

    @cached_property
    def mass_centre(self) -> tuple[float, float]:
        """Centre of mass with the accidental eccentricity [mm]."""
        base = self.centre
        if base is None and self.loads is not None:
            x, y = self.loads @ self.places / self.loads.sum()
            base = float(x), float(y)
        base = base or self.middle_of_bearings
        return base[0] + self._accident[0], base[1] + self._accident[1]

    @property
    def _accident(self) -> tuple[float, float]:
        """By how much the centre of mass is moved by accident [mm]."""
        x, y = _turn(self.angle) @ (np.array(self.eccentricity) * np.array(self.lengths))
        return float(x), float(y)

    @property
    def corners(self) -> FloatArray:
        """Corners of the slab [mm], shape (4, 2)."""
        half = 0.5 * np.array(self.lengths)
        signs = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        return np.array(self.middle) + (signs * half) @ _turn(self.angle).T

    @property
    def arms(self) -> FloatArray:
        """Places of the bearings from the centre of mass [mm], shape (n, 2)."""
        return self.places - np.array(self.mass_centre)

    @property
    def needed_contacts(self) -> int:
        """Number of bearings that must press for equilibrium: 3, or 2 of bearings on one line, or 1 where all stand in one point."""
        away = self.places - self.places.mean(axis=0)
        return 1 + int(np.linalg.matrix_rank(away, tol=_ON_IT * max(float(np.abs(away).max()), 1.0)))

    @property
    def slab_inertia(self) -> float:
        """Rotational inertia of the slab about the centre of mass [t mm2]."""
        if self.inertia is not None:
            return self.inertia
        return self.slab_mass * (self.lengths[0] ** 2 + self.lengths[1] ** 2) / 12.0

    @cached_property
    def static_loads(self) -> FloatArray:
        """Static loads of the bearings [N]: given, or from a plane through the loads that balances the weight at the centre of mass."""
        if self.loads is not None:
            return self.loads
        across = np.column_stack((np.ones(self.count), self.arms))
        return freeze(across @ balancing_plane(self.arms, np.array([self.weight, 0.0, 0.0])))

    @property
    def elastic_stiffnesses(self) -> FloatArray:
        """Stiffness kf of each bearing [N/mm]."""
        of_type = np.array([one.bearing.elastic_stiffness for one in self.systems])
        if self.spring == EQUAL:
            return of_type
        return of_type * self.static_loads / np.array([one.bearing.vertical_force for one in self.systems])

    @property
    def radii(self) -> FloatArray:
        """Sum of the radii of each bearing [mm]."""
        return np.array([one.bearing.effective_radius for one in self.systems])

    @cached_property
    def structure(self) -> Superstructure:
        """Floors above the slab."""
        return superstructure(
            self.storeys,
            self.lengths,
            self.mass_centre,
            self.middle,
            self.angle,
            self.damping,
            self.damping_kind,
            self.modes,
            self._accident,
        )

    @property
    def periods(self) -> FloatArray:
        """Periods on a fixed base [s], longest first."""
        return self.structure.periods

    @property
    def without_accident(self) -> "Plan":
        """The plan without accidental eccentricity; given loads stay as they are."""
        return replace(self, eccentricity=(0.0, 0.0))

    @property
    def rigid(self) -> "Plan":
        """The plan with a rigid structure of the same mass, inertia and height of its centre of mass."""
        if not self.storeys:
            return self
        structure = self.structure
        floors = structure.rigid.T @ structure.mass @ structure.rigid
        above = math.fsum(one.mass * h for one, h in zip(self.storeys, structure.heights, strict=True))
        return replace(
            self,
            storeys=(),
            modes=None,
            inertia=self.slab_inertia + float(floors[2, 2]),
            height=(self.slab_mass * self.height + above) / self.total_mass,
        )

    def with_softer_springs(self, factor: float) -> "Plan":
        """Return the plan with kf of every type over a factor."""
        types = tuple(
            replace(
                one, bearing=one.bearing.changed(elastic_stiffness=one.bearing.elastic_stiffness / factor)
            )
            for one in self.systems
        )
        return replace(self, types=types)

    def with_first_period(self, period: float) -> "Plan":
        """Return the plan with all storeys' stiffnesses times one factor, so that the first period on a fixed base is this [s]."""
        if self.modes is not None:
            msg = "The periods are those of the modes; leave the first period out."
            raise InputError(msg, at="fixed_base_period")
        factor = (float(self.structure.periods[0]) / period) ** 2
        return replace(self, storeys=tuple(one.stiffened(factor) for one in self.storeys))

    def turned(self, angle: float) -> "Plan":
        """Return the plan turned about the origin by an `angle` [degrees], from x towards y."""
        turn = _turn(math.radians(angle))

        def there(point: tuple[float, float] | None) -> tuple[float, float] | None:
            if point is None:
                return None
            x, y = turn @ np.array(point)
            return float(x), float(y)

        storeys = tuple(
            replace(one, centre=there(one.centre), stiffness_centre=there(one.stiffness_centre))
            for one in self.storeys
        )
        return replace(
            self, modes=None if self.modes is None else self.modes.turned(turn), places=self.places @ turn.T, centre=there(self.centre), slab_centre=there(self.slab_centre), storeys=storeys,
            angle=self.angle + math.radians(angle),
        )  # fmt: skip


def _places(places: Sequence[Sequence[float]] | FloatArray) -> FloatArray:
    found = np.asarray(places, dtype=np.float64)
    if found.ndim != 2 or found.shape[1:] != (2,) or not len(found):
        msg = "A building needs at least one bearing, and two coordinates of each."
        raise InputError(msg)
    rows = [PLACE.checked(tuple(row), f"place of bearing {i}") for i, row in enumerate(found.tolist(), 1)]
    return freeze(np.array(rows))


def _metres(place: Sequence[float] | FloatArray) -> str:
    return f"({place[0] / 1e3:g}, {place[1] / 1e3:g}) m"


def balancing_plane(arms: FloatArray, wanted: FloatArray) -> FloatArray:
    """Return a, b, c of loads a + b X + c Y with a sum [N] and sums of the loads times X and Y [N mm] as `wanted`; of bearings on a line or in a point the smallest."""
    return _compliance(arms) @ wanted


def _compliance(arms: FloatArray) -> FloatArray:
    size = max(float(np.abs(arms).max()), 1.0)
    scaled = np.column_stack((np.ones(len(arms)), arms / size))
    scale = np.array([1.0, 1.0 / size, 1.0 / size])
    inverse = np.asarray(np.linalg.pinv(scaled.T @ scaled, rcond=1e-12), dtype=np.float64)
    return inverse * np.outer(scale, scale)


def load_compliance(plan: Plan) -> FloatArray:
    """Return the matrix from a force [N] and two moments [N mm] to a, b, c of the loads a + b X + c Y that balance them, shape (3, 3)."""
    return _compliance(plan.arms)


def _turn(angle: float) -> FloatArray:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine], [sine, cosine]])


def grid(x: Sequence[float], y: Sequence[float]) -> FloatArray:
    """Return the places of bearings on the lines of a grid [mm], shape (n, 2), along x first."""
    return np.array([(one, other) for other in y for one in x], dtype=np.float64)
