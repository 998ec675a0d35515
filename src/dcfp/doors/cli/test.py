"""``dcfp test``: a bearing through the tests of a program on the virtual machine."""

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias

from dcfp.analysis.integration import DEFAULT, NOTHING, PLATES
from dcfp.analysis.result import Result
from dcfp.analysis.rig import Loops, Measurement, Program, codes, load_program, read_measurement, run_program
from dcfp.analysis.rig.loops import CYCLES, cycles_of_measurement
from dcfp.analysis.rig.run import paper_models
from dcfp.analysis.rig.virtual_test import ToldRound, VirtualTest, objects_of, rounds_of
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, grid, grouped, progress
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.errors import InputError
from dcfp.present.tables import write_tests
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE
from dcfp.system import System
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

Runs: TypeAlias = Mapping[str, Sequence[Loops]]
#: A cycle with each model, or one that was measured.
Row: TypeAlias = tuple[ToldRound, ...]

#: Of a test with more cycles or laps than this the first few and the last are shown.
_MOST_ROUNDS = 4
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
    if program.plane:
        from dcfp.doors.cli import test_plane  # late: most programs go in one direction

        return test_plane.run(chosen, program, system)
    measured = _measured(chosen, program)
    if chosen.checks:
        _refuse_without_checks(program)
    runs = _run(program, system, chosen)
    loops = [test for tests in runs.values() for test in tests]
    told = rounds_of(loops)
    for name, test in measured.items():
        told += cycles_of_measurement(name, test, loops[0].bearing)
    answer = Answer(
        lambda: objects_of(told, CYCLES),
        lambda: _page(program, runs, measured),
        lambda part, kind: write_tests(part, loops, kind),
        drawn("plot_program", program, runs, measured),
    )
    return _checked(program, loops, answer) if chosen.checks else answer


def _program(chosen: argparse.Namespace, system: System) -> Program:
    name = chosen.program.strip().lower()
    design = inputs.given(chosen, codes.PrototypeDesign)
    design.pop("pressure", None)
    if name in codes.PROTOTYPE_TESTS:
        if chosen.displacement is None or chosen.period is None:
            msg = f"{name} needs --displacement and --period of the design."
            raise InputError(msg)
        program = codes.prototype_program(
            name, codes.PrototypeDesign(pressure=system.bearing.pressure, **design)
        )
    else:
        for key in design:
            msg = f"--{key.replace('_', '-')} is for {' and '.join(codes.PROTOTYPE_TESTS)}; the tests of {chosen.program} have their own."
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
    for given, file in chosen.measured.items():
        name = given or names[0]
        if not given and len(names) > 1:
            msg = f"--measured {file}: say which test it belongs to, such as {name}={file}."
            raise InputError(msg)
        if name not in names:
            msg = f"--measured {name}={file}: {program.name} has no test {name!r}; it has {', '.join(names)}."
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
    models = paper_models(system) if chosen.compare else {system.heating.name: system}
    wanted = str(chosen.out or "").lower().endswith(".nc") or chosen.plot is not None
    keep = PLATES if wanted and len(program.tests) == len(models) == 1 else NOTHING
    with progress("tests", len(program.tests) * len(models)) as advance:
        return {
            name: run_program(program, model, tolerance=finely, keep=keep, report=advance)
            for name, model in models.items()
        }


def shown_of(rounds: Sequence[ToldRound]) -> list[ToldRound]:
    """Return the cycles or laps of a test that are shown: where there are many, the first few and the last."""
    return list(rounds) if len(rounds) <= _MOST_ROUNDS else [*rounds[: _MOST_ROUNDS - 1], rounds[-1]]


def legend_of(words: str, tests: Sequence[VirtualTest]) -> str:
    """Return what is said below the measures of tests, and whether any of them are left out."""
    left_out = any(len(test.rounds) > _MOST_ROUNDS for test in tests)
    return f"{words}{f'; {tests[0].round_name}s between the third and the last are left out' if left_out else ''}."


def _page(program: Program, runs: Runs, measured: Mapping[str, Measurement]) -> Page:
    """Return the measures of every cycle, of several models side by side, those measured in reality below them."""
    rows: list[Row] = []
    for tests in zip(*runs.values(), strict=True):
        rows += zip(*(shown_of(rounds_of([test])) for test in tests), strict=True)
        name = tests[0].test.name
        if name in measured:
            rows += [
                (one,) for one in shown_of(cycles_of_measurement(name, measured[name], tests[0].bearing))
            ]
    every = [test for tests in runs.values() for test in tests]
    if len(runs) == 1:
        legend = legend_of(_LEGEND, every)
        table = Table(tuple(CYCLES), [row[0] for row in rows])
    else:
        first = next(iter(runs))
        legend = (
            f"k_eff [kN/mm], b_eff [-] and E [kN m]; E/E_{first[0]}: energy over that of the {first} model."
        )
        table = Table(_side_by_side(list(runs)), rows)
    nominal = [remark for tests in runs.values() for remark in _nominal(program, tests)]
    return Page(
        [head_lines(program, every[0], ", ".join(runs)), grid(table)], [legend, *nominal, *remarks_of(every)]
    )


def _side_by_side(names: Sequence[str]) -> tuple[Quantity, ...]:
    """Return stiffness, damping and energy of a cycle with each model, and the models' energies over that of the first."""

    def of_model(key: str, place: int = 0, name: str = "") -> Quantity:
        one = next(one for one in CYCLES if one.key == key)

        def get(row: Row) -> object:
            return one.of(row[place]) if place < len(row) else None

        return replace(one, head=f"{one.head}\n{name[:6]}." if name else one.head, get=get)

    def over_first(place: int) -> Quantity:
        def get(row: Row) -> float | None:
            return row[place].cycle.energy / row[0].cycle.energy if place < len(row) else None

        head = f"E/E_{names[0][0]}\n{names[place][:6]}."
        words = "energy over that of the first model"
        return Quantity("ratio", words, NONE, decimals=3, head=head, get=get)

    return (
        of_model("Test"),
        of_model("cycle"),
        *(of_model(key, place, name) for key in _SIDE_BY_SIDE for place, name in enumerate(names)),
        *map(over_first, range(1, len(names))),
    )


def _checked(program: Program, loops: Sequence[Loops], answer: Answer) -> Answer:
    """Return what a code wants and whether it is so, and the property modification factors, in place of the cycles."""
    criteria = Table(tuple(codes.CRITERIA), codes.judge_tests(program, loops))
    factors = Table(tuple(codes.FACTORS), codes.property_factors(loops))
    heating = loops[0].heating.name

    def page() -> Page:
        blocks: list[Block] = [head_lines(program, loops[0], heating)]
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
        return Page(blocks, [*notes, *remarks_of(loops)])

    document = {
        "heating": heating,
        "criteria": criteria.objects(),
        "factors": factors.objects(),
        "remarks": list(dict.fromkeys(remark for test in loops for remark in test.remarks)),
    }
    return replace(answer, document=lambda: document, page=page)


def head_lines(program: Program, first: Result, heating: str) -> list[tuple[str, str]]:
    """Return what is said above the measures of tests: what was tested, and with which models."""
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


def remarks_of(loops: Sequence[VirtualTest]) -> list[str]:
    """Return the remarks of tests, each with the names of those that it is of."""
    return grouped((test.test.name, remark) for test in loops for remark in test.remarks)
