"""An isolated building in the plan: bearings with their places and loads, the slab's mass, and the storeys above it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import MM, NONE, TONNE
from dcfp.system.storeys import RATIO, STIFFNESS_PROPORTIONAL, Storey, Superstructure, superstructure
from dcfp.system.system import System

_MASS = Parameter("mass of the building", TONNE, 0.0, above=True)
_HEIGHT = Parameter("height of the slab's centre of mass above the bearings", MM, 0.0, 1e5)
_SIDES = Parameter("sides of the slab", MM, 0.0, 1e6, above=True, counts=(2,))
_PLACE = Parameter("place in the plan", MM, -1e7, 1e7, counts=(2,))
_PART = Parameter("accidental eccentricity in parts of the sides", NONE, -0.5, 0.5, counts=(1, 2), repeat=2)
#: How far the sum of given loads may be from the weight [-].
_WEIGHT_TOLERANCE = 1e-3
#: How kf of a bearing follows from that of its type: in proportion to its static load, or the same for all.
BY_LOAD, EQUAL = "load", "equal"


@dataclass(frozen=True, eq=False)
class Plan:
    """Bearings under a slab that is rigid in its plane, and what stands on it.

    Parameters
    ----------
    places
        Of the bearings [mm], shape (n, 2).
    types
        Bearing with its friction law and heating model at each place; one for all of them.
    mass
        Of the whole building, slab and floors [t]; None for what the types carry at their own pressure.
    centre
        Of mass [mm]; None for that of the loads, or the middle of the bearings.
    sides
        Of the slab in x and y [mm], over which its mass is spread evenly and in whose corners displacements are told; None for those of the rectangle about the bearings.
    eccentricity
        Accidental, by which the centre of mass is moved, in parts of the sides.
    inertia
        Rotational inertia of the slab without the floors about the centre [t mm2]; None for a mass that is spread evenly.
    height
        Of the slab's own centre of mass above the bearings [mm]: of the whole structure where there are no storeys.
    storeys, damping, damping_kind
        Above the slab, from below; damping ratio of the modes on a fixed base, and its kind.
    loads
        Static load of each bearing [N]; None for those of a rigid slab on equal vertical springs under the weight at the centre.
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

    places: FloatArray
    types: tuple[System, ...] | System = field(default_factory=System)
    mass: float | None = None
    centre: tuple[float, float] | None = None
    sides: tuple[float, float] | None = None
    eccentricity: tuple[float, float] = (0.0, 0.0)
    inertia: float | None = None
    height: float = 0.0
    storeys: tuple[Storey, ...] = ()
    damping: float = 0.02
    damping_kind: str = STIFFNESS_PROPORTIONAL
    loads: FloatArray | None = None
    spring: str = BY_LOAD
    angle: float = 0.0
    name: str = "plan"

    def __post_init__(self) -> None:
        places = np.asarray(self.places, dtype=np.float64)
        if places.ndim != 2 or places.shape[1:] != (2,) or not len(places):
            msg = "A plan needs at least one bearing, and two coordinates of each."
            raise InputError(msg)
        rows = [
            _PLACE.checked(tuple(row), f"Plan: place of bearing {i}")
            for i, row in enumerate(places.tolist(), 1)
        ]
        self._set("places", freeze(np.array(rows)))
        types = (self.types,) * len(places) if isinstance(self.types, System) else tuple(self.types)
        if len(types) != len(places):
            msg = f"A plan of {len(places)} bearings needs as many types, not {len(types)}."
            raise InputError(msg)
        self._set("types", types)
        carried = math.fsum(one.bearing.vertical_force for one in types) / STANDARD_GRAVITY
        if self.loads is not None:
            self._check_loads(self.loads)
            carried = float(np.sum(self.loads)) / STANDARD_GRAVITY
        self._set("mass", _MASS.checked(carried if self.mass is None else self.mass, "Plan: mass"))
        self._set(
            "sides", self._rectangle() if self.sides is None else _SIDES.checked(self.sides, "Plan: sides")
        )
        self._set("eccentricity", _PART.checked(self.eccentricity, "Plan: eccentricity"))
        self._set("height", _HEIGHT.checked(self.height, "Plan: height"))
        self._set("damping", RATIO.checked(self.damping, "Plan: damping"))
        self._set("storeys", tuple(self.storeys))
        if self.loads is not None and abs(carried / self.total_mass - 1.0) > _WEIGHT_TOLERANCE:
            msg = f"The loads of the bearings sum to {carried * STANDARD_GRAVITY / 1e3:.0f} kN, and the building weighs {self.weight / 1e3:.0f} kN."
            raise InputError(msg)
        if self.slab_mass <= 0.0:
            msg = f"The floors' masses sum to {self.floor_mass:.6g} t, and the whole building with the slab has only {self.total_mass:.6g} t."
            raise InputError(msg)
        if self.spring not in (BY_LOAD, EQUAL):
            msg = f"Plan: spring must be one of {BY_LOAD}, {EQUAL}, not {self.spring!r}."
            raise InputError(msg)
        if self.centre is not None:
            self._set("centre", _PLACE.checked(self.centre, "Plan: centre"))
        if (lightest := int(self.static_loads.argmin())) >= 0 and self.static_loads[lightest] <= 0.0:
            x, y = self.places[lightest] / 1e3
            msg = f"The centre of mass is so far outside that bearing {lightest + 1} at {x:g}, {y:g} m would lift off at rest."
            raise InputError(msg)

    def _set(self, name: str, value: object) -> None:
        object.__setattr__(self, name, value)

    def _check_loads(self, loads: Sequence[float] | FloatArray) -> None:
        found = np.asarray(loads, dtype=np.float64)
        if found.shape != (len(self.places),) or not (found > 0.0).all():
            msg = f"A plan of {len(self.places)} bearings needs as many loads, all of them above zero."
            raise InputError(msg)
        self._set("loads", freeze(found))

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
        return self.sides or self._rectangle()

    @property
    def middle(self) -> tuple[float, float]:
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
        base = base or self.middle
        x, y = np.array(base) + _turn(self.angle) @ (np.array(self.eccentricity) * np.array(self.lengths))
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
        )

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
            self, places=self.places @ turn.T, centre=there(self.centre), storeys=storeys, angle=self.angle + math.radians(angle)
        )  # fmt: skip


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
