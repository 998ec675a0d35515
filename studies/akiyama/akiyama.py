"""Akiyama's statement in two directions: the input energy of a building on its bearings over that of the rigid structure of the same mass.

    python studies/akiyama/akiyama.py [STATION ...]

Five equal storeys with 2 % damping on a slab as heavy as a floor, four bearings of Li et al. (2020) under a slab of 8 by 8 m, loads by overturning; the 50 stations of FEMA P-695 unless others are named.
"""

import sys

import numpy as np

import dcfp
from dcfp.motion.load import load_records
from dcfp.system.plan import grid

PGVS = (250.0, 500.0, 750.0, 1000.0)
PERIODS = (0.5, 1.0)


def building(period: float) -> dcfp.Plan:
    """Return five equal storeys with a first period on a fixed base [s]."""
    mass = 4.0 * dcfp.LI_2020.mass / 6.0
    storeys = (dcfp.Storey(mass, 1e6, 3500.0),) * 5
    plan = dcfp.Plan(grid([0.0, 8000.0], [0.0, 8000.0]), storeys=storeys, mass=6.0 * mass)
    return plan.with_first_period(period)


def main(names: list[str]) -> None:
    """Print mean, least and largest ratio of V_E, and in brackets of the displacement of the centre."""
    stations = load_records(names or ["P695-stations"])
    print(
        f"{len(stations)} stations; V_E over that of the rigid structure: mean (least to largest); y_max likewise"
    )
    for period in PERIODS:
        plan = building(period)
        for pgv in PGVS:
            found = []
            for station in stations:
                motion = station.scaled_to_pgv(pgv)
                one, rigid = (dcfp.respond_plan(each, motion, tail=0.0) for each in (plan, plan.rigid))
                found.append(
                    (
                        one.input_velocity / rigid.input_velocity,
                        one.peak_displacement / rigid.peak_displacement,
                    )
                )
            ratios = np.array(found).T
            told = [f"{row.mean():.3f} ({row.min():.2f} to {row.max():.2f})" for row in ratios]
            print(f"{period} s, {pgv / 1e3:.2f} m/s: V_E {told[0]}, y_max {told[1]}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
