"""``dcfp building``: a project in plan, or a shear building on the bearing, beside the rigid structure."""

import argparse
from pathlib import Path

from dcfp.analysis import respond
from dcfp.analysis.plan.shear_building import (
    BESIDE_RIGID,
    BesideRigid,
    respond_in_one_direction,
    shear_building,
)
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import each
from dcfp.doors.cli.outputs import Answer
from dcfp.errors import InputError
from dcfp.schema.table import Table
from dcfp.system.project import example_project

_LEGEND = (
    "rigid: the rigid structure of the same mass; V_E: equivalent velocity of the relative input energy at the end, which Akiyama (1985) takes to be the same"
    " for both; drift and floor acceleration: the largest of all storeys, and of the base and all floors (absolute)."
)


def run(chosen: argparse.Namespace) -> Answer:
    """Analyse the building under every record at every PGV."""
    if chosen.example is not None:
        return Answer.of_file(chosen.example, lambda part, kind: example_project())
    if chosen.project is not None:
        from dcfp.doors.cli import building_in_plan  # late: the other one needs none of it

        return building_in_plan.run(chosen)
    kind = Path(chosen.out or "").suffix.lower()
    if kind not in ("", ".csv"):
        msg = f"{chosen.out}: without a project the lines of all analyses are written, as .csv."
        raise InputError(msg)
    system = inputs.system(chosen)
    building = shear_building(chosen.storeys, chosen.fixed_base_period, system, chosen.damping)
    found = each(
        "analyses",
        inputs.motions(chosen),
        lambda motion: BesideRigid(respond_in_one_direction(building, motion), respond(motion, system)),
    )
    periods = ", ".join(f"{period:.2f}" for period in building.periods[:3])
    lines = [
        ("Bearing", str(system.bearing)),
        ("Friction", f"{system.friction.name}, heating {system.heating.name}"),
        ("Building", f"{chosen.storeys} equal storeys; first periods on a fixed base {periods} s"),
    ]
    remarks = [*(remark for one in found for remark in one.remarks), _LEGEND]
    return Answer.of_table(Table(BESIDE_RIGID, found), lines, remarks)
