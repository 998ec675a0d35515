"""The virtual test machine: a bearing through the tests of a program, and what is measured on every cycle."""

import argparse
import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser, fraction, positive
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.analysis.rig import Loops, Measurement, Program

#: Frames of the plates' temperature that a NetCDF file or a figure holds, about.
FRAMES = 200


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument(
        "program",
        metavar="PROGRAM",
        help="dependency or asce (Li et al. 2020, Tables 1 and 2); asce7-16 or en15129 (prototype tests of a design); or a file: a program as "
        ".toml, a measured displacement as .csv",
    )
    parser.add_argument("--tests", nargs="+", metavar="NAME", help="only these tests of the program")
    parser.add_argument(
        "--compare",
        action="store_true",
        help="precise and simplified heating and the constant nominal coefficient, side by side",
    )
    parser.add_argument(
        "--checks",
        action="store_true",
        help="instead of the cycles: the checks of the program's code and the property modification factors",
    )
    parser.add_argument(
        "--measured",
        nargs="+",
        metavar="TEST=FILE",
        help="measured tests (CSV with time, displacement, force and load) to put beside those of the program",
    )
    parser.add_argument("--tolerance", type=fraction(), metavar="VALUE", help="as for respond; default 0.02")
    _add_design(parser)
    options.add_bearing(parser)
    options.add_output(
        parser,
        "results as NetCDF (.nc) or CSV (.csv): histories of one test; of several a CSV holds the measures of every cycle",
    )
    parser.set_defaults(later_records=[])


def _add_design(parser: Parser) -> None:
    group = parser.add_argument_group("design, for asce7-16 and en15129")
    group.add_argument(
        "--displacement",
        type=positive("mm", 1.0, 1e4),
        metavar="MM",
        help="maximum displacement D_M or d_bd [mm]",
    )
    group.add_argument(
        "--period",
        type=positive("s", 0.1, 100.0),
        metavar="S",
        help="effective period at that displacement [s]",
    )
    group.add_argument(
        "--total-displacement",
        type=positive("mm", 1.0, 1e4),
        metavar="MM",
        help="with torsion [mm]; default 1.15 times the displacement",
    )


def run(chosen: argparse.Namespace) -> int:
    """Run the tests of a program."""
    if chosen.later_records:
        msg = f"{chosen.later_records[0]!r} is one PROGRAM too many; name one."
        raise InputError(msg)
    outputs = Outputs.checked(chosen, _input_files(chosen))
    # late, so that a slip in the command is answered at once
    from dcfp.doors.cli import test_table

    model = inputs.model(chosen)
    program = _program(chosen, model)
    measured = _measured(chosen, program)
    if chosen.checks:
        _refuse_without_checks(program, chosen)
    runs = _run(program, model, chosen)
    _write(runs, measured, program, outputs)
    loops = [test for tests in runs.values() for test in tests]
    if chosen.checks:
        _show_checks(program, runs, as_json=chosen.json)
    elif chosen.json:
        from dcfp.analysis.rig.loops import cycle_rows, measured_rows

        rows = [{**row, "remarks": list(test.remarks)} for test in loops for row in cycle_rows(test)]
        rows += [row for name, test in measured.items() for row in measured_rows(name, test)]
        print(json.dumps(rows, indent=2, allow_nan=False))
    elif len(runs) > 1:
        test_table.print_models(program, runs, measured)
    else:
        test_table.print_tests(program, loops, measured)
    return 0


def _input_files(chosen: argparse.Namespace) -> list[Path]:
    words = [chosen.program, *([chosen.bearing] if chosen.bearing else [])]
    words += [pair.partition("=")[2] or pair for pair in chosen.measured or ()]
    return [Path(word) for word in words]


def _program(chosen: argparse.Namespace, model: "inputs.System") -> "Program":
    from dcfp.analysis.rig import load_program
    from dcfp.analysis.rig.codes import PrototypeDesign, prototype_program, prototype_programs

    name = chosen.program.strip().lower()
    design = {key: getattr(chosen, key) for key in ("displacement", "period", "total_displacement")}
    if name in prototype_programs():
        if chosen.displacement is None or chosen.period is None:
            msg = f"{name} needs --displacement and --period of the design."
            raise InputError(msg)
        program = prototype_program(name, PrototypeDesign(pressure=model.bearing.pressure, **design))
    else:
        for key, value in design.items():
            if value is not None:
                msg = f"--{key.replace('_', '-')} is for {' and '.join(prototype_programs())}; the tests of {chosen.program} have their own."
                raise InputError(msg)
        program = load_program(chosen.program)
        if chosen.pressure is not None and all(test.load is not None for test in program.tests):
            msg = f"--pressure has no effect: the tests of {chosen.program} have their own loads."
            raise InputError(msg)
    return program if chosen.tests is None else program.only(chosen.tests)


def _measured(chosen: argparse.Namespace, program: "Program") -> "dict[str, Measurement]":
    """Return the measured tests by the name of the test that they are put beside."""
    from dcfp.analysis.rig import read_measurement

    names = [test.name for test in program.tests]
    found: dict[str, Measurement] = {}
    for pair in chosen.measured or ():
        name, _, file = pair.partition("=")
        if not file:
            if len(names) > 1:
                msg = f"--measured {pair}: say which test it belongs to, such as {names[0]}={pair}."
                raise InputError(msg)
            name, file = names[0], pair
        if name not in names:
            msg = f"--measured {pair}: {program.name} has no test {name!r}; it has {', '.join(names)}."
            raise InputError(msg)
        if name in found:
            msg = f"--measured gives {name} twice; one measured test belongs to it."
            raise InputError(msg)
        found[name] = read_measurement(file)
        _ = found[name].force, found[name].load  # both are needed
    return found


def _refuse_without_checks(program: "Program", chosen: argparse.Namespace) -> None:
    if chosen.compare or chosen.measured:
        msg = f"--checks is made with one model and without measured tests; leave out {'--compare' if chosen.compare else '--measured'}."
        raise InputError(msg)
    if not program.code:
        msg = f"{program.name} belongs to no code whose checks could be made; asce, asce7-16 and en15129 do."
        raise InputError(msg)
    if not any(test.role for test in program.tests):
        names = ", ".join(test.name for test in program.tests)
        msg = f"The code asks nothing of {names}; the checks need tests with a role, such as those for the increments of displacement."
        raise InputError(msg)


def _run(
    program: "Program", model: "inputs.System", chosen: argparse.Namespace
) -> "dict[str, tuple[Loops, ...]]":
    from dcfp.analysis.rig import run_program
    from dcfp.analysis.rig.run import TOLERANCE, paper_models, run_models
    from dcfp.doors.cli.progress import progress

    finely = TOLERANCE if chosen.tolerance is None else chosen.tolerance
    models = paper_models(model.friction, model.heating) if chosen.compare else ()
    with progress("tests", len(program.tests) * max(len(models), 1)) as advance:
        if models:
            return run_models(program, model.bearing, models, tolerance=finely, report=advance)
        every = None
        wanted = str(chosen.out or "").lower().endswith(".nc") or chosen.plot is not None
        if model.heating.name == "precise" and wanted and len(program.tests) == 1:
            every = max(1, program.tests[0].waveform.travel().lengths.size // FRAMES)
        loops = run_program(
            program,
            model.bearing,
            model.friction,
            model.heating,
            tolerance=finely,
            profile_every=every,
            report=advance,
        )
    return {model.heating.name: loops}


def _write(
    runs: "dict[str, tuple[Loops, ...]]",
    measured: "dict[str, Measurement]",
    program: "Program",
    outputs: Outputs,
) -> None:
    loops = [test for tests in runs.values() for test in tests]

    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables import cycles_csv, write_tests_netcdf  # late: xarray takes long to import

        if kind == ".csv":
            part.write_text(cycles_csv(loops), encoding="utf-8")
        else:
            write_tests_netcdf(part, loops)

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import plot_program, save_figure  # late: Matplotlib takes long to import

        save_figure(plot_program(program, runs, measured), part, form)

    outputs.write_with(data, figure)


def _show_checks(program: "Program", runs: "dict[str, tuple[Loops, ...]]", *, as_json: bool) -> None:
    from dcfp.analysis.rig.codes import CRITERIA, judge_tests, property_factors
    from dcfp.doors.cli.test_table import print_checks
    from dcfp.schema.table import Table

    name, loops = next(iter(runs.items()))
    criteria, factors = judge_tests(program, loops), property_factors(loops)
    if not as_json:
        print_checks(program, loops, criteria, factors)
        return
    rows = Table(CRITERIA, criteria).objects()
    remarks = list(dict.fromkeys(remark for test in loops for remark in test.remarks))
    told = {"heating": name, "criteria": rows, "factors": [asdict(f) for f in factors], "remarks": remarks}
    print(json.dumps(told, indent=2, allow_nan=False))
