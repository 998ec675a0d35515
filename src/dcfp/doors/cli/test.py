"""``dcfp test``: a bearing through the tests of a program on the virtual machine."""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from dcfp.analysis.integration import DEFAULT, NOTHING, PLATES
from dcfp.analysis.rig import Loops, Measurement, Program, load_program, read_measurement, run_program
from dcfp.analysis.rig.codes import (
    CRITERIA,
    PrototypeDesign,
    judge_tests,
    property_factors,
    prototype_program,
    prototype_programs,
)
from dcfp.analysis.rig.codes.prototype import FACTORS
from dcfp.analysis.rig.loops import (
    CYCLES,
    ToldCycle,
    cycle_objects,
    cycles_of_measurement,
    cycles_of_tests,
)
from dcfp.analysis.rig.run import paper_models, run_models
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, grid, grouped
from dcfp.doors.cli.outputs import Answer
from dcfp.doors.cli.progress import progress
from dcfp.errors import InputError
from dcfp.present.tables import write_tests
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE
from dcfp.system import System
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Runs: TypeAlias = Mapping[str, Sequence[Loops]]

#: Of a test with more cycles than this the first few and the last are shown.
_MOST_CYCLES = 4
#: What is shown of every model side by side.
_SIDE_BY_SIDE = ("keff_kN_mm", "beta_eff", "energy_kN_m")
_LEGEND = (
    "k_eff, b_eff: effective stiffness and damping; k_d: post-yield stiffness; Q_d, mu_0: force and coefficient of friction at zero"
    " displacement; E: energy of the cycle"
)


def run(chosen: argparse.Namespace) -> Answer:
    """Run the tests of a program."""
    system = inputs.system(chosen)
    program = _program(chosen, system)
    measured = _measured(chosen, program)
    if chosen.checks:
        _refuse_without_checks(program)
    runs = _run(program, system, chosen)
    loops = [test for tests in runs.values() for test in tests]

    def figure() -> "Figure":
        from dcfp.present.figures import plot_program  # late: Matplotlib takes long to import

        return plot_program(program, runs, measured)

    def document() -> list[dict[str, Any]]:
        beside = [
            one
            for name, test in measured.items()
            for one in cycles_of_measurement(name, test, loops[0].bearing)
        ]
        return cycle_objects([*cycles_of_tests(loops), *beside])

    def data(part: Path, kind: str) -> None:
        write_tests(part, loops, kind)

    if chosen.checks:
        return _checked(program, loops, data, figure)
    page = _page_of_models if len(runs) > 1 else _page
    return Answer(document, lambda: page(program, runs, measured), data, figure)


def _program(chosen: argparse.Namespace, system: System) -> Program:
    name = chosen.program.strip().lower()
    design = inputs.given(chosen, "displacement", "period", "total_displacement")
    if name in prototype_programs():
        if chosen.displacement is None or chosen.period is None:
            msg = f"{name} needs --displacement and --period of the design."
            raise InputError(msg)
        program = prototype_program(name, PrototypeDesign(pressure=system.bearing.pressure, **design))
    else:
        for key in design:
            msg = f"--{key.replace('_', '-')} is for {' and '.join(prototype_programs())}; the tests of {chosen.program} have their own."
            raise InputError(msg)
        program = load_program(chosen.program)
        if chosen.pressure is not None and all(test.load is not None for test in program.tests):
            msg = f"--pressure has no effect: the tests of {chosen.program} have their own loads."
            raise InputError(msg)
    return program if chosen.tests is None else program.only(chosen.tests)


def _measured(chosen: argparse.Namespace, program: Program) -> dict[str, Measurement]:
    """Return the measured tests by the name of the test that they are put beside."""
    names = [test.name for test in program.tests]
    found: dict[str, Measurement] = {}
    for pair in chosen.measured:
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


def _refuse_without_checks(program: Program) -> None:
    if not program.code:
        msg = f"{program.name} belongs to no code whose checks could be made; asce, asce7-16 and en15129 do."
        raise InputError(msg)
    if not any(test.role for test in program.tests):
        names = ", ".join(test.name for test in program.tests)
        msg = f"The code asks nothing of {names}; the checks need tests with a role, such as those for the increments of displacement."
        raise InputError(msg)


def _run(program: Program, system: System, chosen: argparse.Namespace) -> Runs:
    finely = DEFAULT.tolerance if chosen.tolerance is None else chosen.tolerance
    models = paper_models(system) if chosen.compare else {}
    with progress("tests", len(program.tests) * max(len(models), 1)) as advance:
        if models:
            return run_models(program, models, tolerance=finely, report=advance)
        wanted = str(chosen.out or "").lower().endswith(".nc") or chosen.plot is not None
        keep = PLATES if wanted and len(program.tests) == 1 else NOTHING
        loops = run_program(program, system, tolerance=finely, keep=keep, report=advance)
    return {system.heating.name: loops}


def _shown(cycles: Sequence[ToldCycle]) -> list[ToldCycle]:
    return list(cycles) if len(cycles) <= _MOST_CYCLES else [*cycles[: _MOST_CYCLES - 1], cycles[-1]]


def _page(program: Program, runs: Runs, measured: Mapping[str, Measurement]) -> Page:
    """Return the measures of every cycle, those measured in reality below them."""
    loops = next(iter(runs.values()))
    rows: list[ToldCycle] = []
    for test in loops:
        rows += _shown(cycles_of_tests([test]))
        if test.test.name in measured:
            rows += _shown(cycles_of_measurement(test.test.name, measured[test.test.name], test.bearing))
    left_out = any(len(test.cycles) > _MOST_CYCLES for test in loops)
    legend = _LEGEND + ("; cycles between the third and the last are left out" if left_out else "") + "."
    lines = _lines(program, loops[0], loops[0].heating.name)
    table = grid(Table(tuple(CYCLES), rows))
    return Page([lines, table], [legend, *_nominal(program, loops), *_remarks(loops)])


def _page_of_models(program: Program, runs: Runs, measured: Mapping[str, Measurement]) -> Page:
    """Return stiffness, damping and energy of every cycle with each model, and the models' energies over that of the first."""
    names = list(runs)
    rows: list[list[ToldCycle]] = []
    for tests in zip(*runs.values(), strict=True):
        rows += [list(one) for one in zip(*(_shown(cycles_of_tests([test])) for test in tests), strict=True)]
        name = tests[0].test.name
        if name in measured:
            rows += [[one] for one in _shown(cycles_of_measurement(name, measured[name], tests[0].bearing))]
    by_key = {one.key: one for one in CYCLES}

    def of_model(one: Quantity, place: int) -> Quantity:
        head = f"{one.head}\n{names[place][:6]}."
        return Quantity(one.key, one.words, one.unit, one.shown, one.decimals, head=head,
                        get=lambda row: one.of(row[place]) if place < len(row) else None)  # fmt: skip

    def over_first(place: int) -> Quantity:
        head = f"E/E_{names[0][0]}\n{names[place][:6]}."
        return Quantity("ratio", "energy over that of the first model", NONE, decimals=3, head=head,
                        get=lambda row: row[place].cycle.energy / row[0].cycle.energy if place < len(row) else None)  # fmt: skip

    columns = (
        *(Quantity(one.key, one.words, one.unit, head=one.head or one.key, get=lambda row, one=one: one.of(row[0])) for one in (by_key["Test"], by_key["cycle"])),
        *(of_model(by_key[key], place) for key in _SIDE_BY_SIDE for place in range(len(names))),
        *map(over_first, range(1, len(names))),
    )  # fmt: skip
    legend = (
        f"k_eff [kN/mm], b_eff [-] and E [kN m]; E/E_{names[0][0]}: energy over that of the {names[0]} model."
    )
    every = [test for tests in runs.values() for test in tests]
    nominal = [remark for tests in runs.values() for remark in _nominal(program, tests)]
    lines = _lines(program, next(iter(runs.values()))[0], ", ".join(names))
    return Page([lines, grid(Table(columns, rows))], [legend, *nominal, *_remarks(every)])


def _checked(program: Program, loops: Sequence[Loops], data: Any, figure: Any) -> Answer:
    """Return what a code wants and whether it is so, and the property modification factors."""
    criteria = Table(tuple(CRITERIA), judge_tests(program, loops))
    factors = Table(tuple(FACTORS), property_factors(loops))
    heating = loops[0].heating.name

    def page() -> Page:
        blocks: list[Block] = [_lines(program, loops[0], heating)]
        notes: list[str] = []
        if criteria.results:
            blocks.append(grid(criteria))
        if factors.results:
            blocks.append(grid(factors))
            notes.append(
                "lambda_test as the model predicts it: first and last of the first three cycles at the maximum displacement over their mean"
                " (nominal); after all: last cycle of the endurance tests over the mean of their first three."
            )
        if any(not one.confirmed for one in criteria.results):
            notes.append(
                "An unconfirmed limit is from memory of the code, whose text could not be read; look it up before relying on it."
            )
        return Page(blocks, [*notes, *_remarks(loops)])

    def document() -> dict[str, Any]:
        remarks = list(dict.fromkeys(remark for test in loops for remark in test.remarks))
        return {
            "heating": heating,
            "criteria": criteria.objects(),
            "factors": factors.objects(),
            "remarks": remarks,
        }

    return Answer(document, page, data, figure)


def _lines(program: Program, first: Loops, heating: str) -> list[tuple[str, str]]:
    bearing = first.bearing
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    return [
        ("Program", f"{program.name} ({program.source})" if program.source else program.name),
        (
            "Bearing",
            f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, {bearing.elastic_stiffness / 1e3:g} kN/mm",
        ),
        ("Friction", f"{first.friction_law.name}, reference coefficient {first.friction_law.reference:g}"),
        ("Heating", f"{heating}, from {first.heating.ambient:g} °C"),
    ]


def _nominal(program: Program, loops: Sequence[Loops]) -> list[str]:
    """Return how the friction of dependency test T01 compares with the nominal coefficient that was measured in it."""
    test = loops[0]
    if program.citation != "li_2020" or test.test.purpose != "velocity dependency" or len(test.cycles) < 2:
        return []
    found = test.cycles[1].friction
    return [
        f"{test.test.name}, {test.friction_law.name}, {test.heating.name} heating: friction at zero displacement in the second cycle {found:.4f};"
        f" the tests of Li et al. (2020) gave {NOMINAL_COEFFICIENT:g}, from which it is {100.0 * (found / NOMINAL_COEFFICIENT - 1.0):+.0f} % away."
    ]


def _remarks(loops: Sequence[Loops]) -> list[str]:
    return grouped((test.test.name, remark) for test in loops for remark in test.remarks)
