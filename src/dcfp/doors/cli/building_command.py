"""The command ``dcfp building`` and its options; the modules that carry it out are imported when it is run."""

import argparse
from pathlib import Path

from dcfp.doors.cli import options
from dcfp.doors.cli.commands import RECORD_OR_SET, REPORTS, ROTATE, STATION, command
from dcfp.doors.cli.parser import Parser, add_declared, add_parameter, add_switch
from dcfp.errors import InputError
from dcfp.files import DATA_EXTENSIONS
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import DEGC, FRACTION, NONE, SECOND

#: A building of equal storeys.
BUILDING = (
    Parameter("number of storeys", NONE, 1, 60, key="storeys", kind=int, default=5),
    Parameter("first period on a fixed base", SECOND, 0.01, 10.0, key="fixed_base_period", default=0.5),
    Parameter(
        "damping ratio of the first mode on a fixed base, proportional to the stiffness",
        FRACTION, 0.0, 0.5, key="damping", default=0.02,
    ),
)  # fmt: skip
LINK_TEMPERATURE = Parameter("temperature of the contact at which links for SAP2000 take the friction", DEGC, -100.0, 1000.0, key="link_temperature", more="default that of the start")  # fmt: skip
#: Endings of the names of a project, and of link properties for SAP2000.
PROJECT, LINKS = ".toml", ".s2k"


def _check_building(chosen: argparse.Namespace) -> None:
    if chosen.example is not None:
        if chosen.records or chosen.out is not None:
            msg = "--example writes a project to start from, and analyses nothing; give it alone."
            raise InputError(msg)
        chosen.out, chosen.kinds, chosen.noun, chosen.needs_records = (
            chosen.example,
            (PROJECT,),
            "a project",
            False,
        )
    projects = [one for one in chosen.records if Path(one).suffix.lower() == PROJECT]
    chosen.project = projects[0] if projects else None
    chosen.records = [one for one in chosen.records if one not in projects]
    if len(projects) > 1:
        msg = f"name one project, not {' and '.join(projects)}."
        raise InputError(msg)
    of_project = (
        "rotate",
        "vertical",
        "no_overturning",
        "causes",
        "floor_spectra",
        "plot",
        "step",
        "tail",
        "tolerance",
    )
    for name in () if projects else of_project:
        if getattr(chosen, name) not in (None, False):
            msg = f"--{name.replace('_', '-')} is for a building in plan; name its PROJECT.toml before the records."
            raise InputError(msg)
    for one in BUILDING:
        if projects and getattr(chosen, one.key) is not None:
            msg = f"--{one.key.replace('_', '-')} is for a building of equal storeys; {projects[0]} says what stands on the bearings."
            raise InputError(msg)
        if getattr(chosen, one.key) is None:
            setattr(chosen, one.key, one.default)
    for name in ("bearing", "pressure") if projects else ():
        if getattr(chosen, name) is not None:
            msg = f"--{name}: the types of bearings and their loads are those of {projects[0]}; leave the option out."
            raise InputError(msg)
    if chosen.link_temperature is not None and Path(chosen.out or "").suffix.lower() != LINKS:
        msg = f"--link-temperature is for links of SAP2000; write them with --out FILE{LINKS}."
        raise InputError(msg)
    if chosen.causes and chosen.no_overturning:
        msg = "--causes adds overturning as one of them; leave out --no-overturning."
        raise InputError(msg)
    if chosen.causes and chosen.floor_spectra:
        msg = "--causes and --floor-spectra answer different questions; give one of the two."
        raise InputError(msg)


@command("building", check=_check_building)
def building(parser: Parser) -> None:
    """Isolated building: PROJECT.toml with its bearings in plan and storeys, or equal storeys on the bearing of the paper, beside the rigid structure."""
    from dcfp.analysis.integration import Integration  # late: other commands analyse nothing

    words = f"PROJECT.toml, then stations: {STATION}; or without a project {RECORD_OR_SET}"
    options.add_records(parser, "+", words)
    group = parser.add_argument_group("without a project: equal storeys on a base as heavy as a floor")
    for one in BUILDING:
        add_parameter(group, one)
    group = parser.add_argument_group("with a project")
    words = "instead of an analysis: write a project to start from"
    group.add_argument("--example", metavar="FILE.toml", help=words)
    add_parameter(group, ROTATE)
    add_switch(group, "--vertical", "let the weight follow the vertical component of the station")
    add_switch(group, "--no-overturning", "keep the loads of the bearings as they are at rest")
    add_parameter(group, LINK_TEMPERATURE)
    add_switch(group, "--causes", "instead: the causes of torsion and of changing loads one by one")
    add_switch(group, "--floor-spectra", "instead: response spectra of slab and floors, also broadened")
    options.add_treatment(parser)
    options.add_bearing(parser)
    add_declared(parser.add_argument_group("integration, with a project"), Integration)
    options.add_output(
        parser,
        "a line for each analysis as CSV (.csv); with a project histories as NetCDF (.nc) or CSV (.csv; of several the peaks), the report of all (.pdf, .html), one analysis as a script that runs with openseespy alone (.py), or the bearings as links for SAP2000 and ETABS (.s2k)",
        "with a project: the plan with the paths of its bearings, and the profiles over the height,",
        (*DATA_EXTENSIONS, *REPORTS, ".py", LINKS),
    )
