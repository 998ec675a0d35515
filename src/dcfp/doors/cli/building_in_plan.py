"""``dcfp building PROJECT.toml``: an isolated building in plan."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.analysis.integration import Integration
from dcfp.analysis.plan import PlanResponse, respond_plan
from dcfp.analysis.plan.beside import BesideOthers, Cause, remarks_on, separate_causes
from dcfp.analysis.plan.quantities import bearing_table, level_table, worst_corner
from dcfp.doors.cli import inputs
from dcfp.doors.cli.building_command import LINKS
from dcfp.doors.cli.commands import REPORTS
from dcfp.doors.cli.console import Block, Page, each_that_can, grid, grouped, progress
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.doors.cli.respond import SCRIPT
from dcfp.errors import AnalysisError, InputError
from dcfp.methods.spectra.of_floors import FLOOR_ORDINATES, floor_ordinates, floor_spectra
from dcfp.methods.torsion import TORSION, code_torsion
from dcfp.motion.measures import motion_remarks
from dcfp.motion.station import Station, in_plane
from dcfp.present.tables import write_responses
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.study.scenario import read_heading
from dcfp.system.plan import Plan
from dcfp.system.project import read_plan

if TYPE_CHECKING:
    from dcfp.system import System

#: Periods of a floor's spectrum that are printed.
_SHOWN = 12


def run(chosen: argparse.Namespace) -> Answer:
    """Analyse the building of a project under every station at every PGV."""
    plan = _changed(read_plan(chosen.project), chosen)
    stations = [in_plane(one) for one in inputs.load_records(chosen)]
    if chosen.rotate is not None:
        stations = [one.rotated(chosen.rotate) for one in stations]
    motions = inputs.scaled(stations, chosen.pgv, allow_drift=True)
    settings: dict[str, Any] = {
        **vars(Integration(**inputs.given(chosen, Integration))),
        "overturning": not chosen.no_overturning,
    }
    if chosen.causes:
        return _causes(plan, motions, chosen.vertical, settings)
    settings["vertical"] = chosen.vertical
    if Path(chosen.out or "").suffix.lower() == SCRIPT and len(motions) != 1:
        msg = (
            f"{chosen.out}: a script is of one station at one PGV, not of {len(motions)} analyses; give one."
        )
        raise InputError(msg)
    if Path(chosen.out or "").suffix.lower() == REPORTS[0]:
        from dcfp.present.report import check_typst  # late: few commands need it

        check_typst()

    def analysed(motion: Station) -> BesideOthers:
        def analyse(one: Plan) -> PlanResponse:
            return respond_plan(one, motion, **settings)

        return BesideOthers(analyse(plan), analyse)

    found, failures = each_that_can("analyses", motions, analysed)
    responses = [one.response for one in found]
    if chosen.floor_spectra:
        return _floor_spectra(responses, chosen, failures)
    alone = len(motions) == 1
    figure = drawn("plan.plot_plan_response", responses[0]) if alone else drawn("plan.plot_plans", responses)
    return Answer(
        lambda: [_document(*one) for one in zip(found, _remarks(found), strict=True)],
        lambda: _page(found),
        lambda part, kind: _write(part, kind, found, chosen, settings, alone=alone),
        figure,
        failures=failures,
    )


def _changed(plan: Plan, chosen: argparse.Namespace) -> Plan:
    """Return the plan with the options of bearings put before what its types say."""
    types: dict[System, System] = {}
    for one in plan.systems:
        if one not in types:
            types[one] = inputs.changed_system(one, chosen)
    return (
        plan
        if all(one is types[one] for one in types)
        else replace(plan, types=tuple(types[one] for one in plan.systems))
    )


def _write(
    part: Path,
    kind: str,
    found: Sequence[BesideOthers],
    chosen: argparse.Namespace,
    settings: dict[str, Any],
    *,
    alone: bool,
) -> str | None:
    """Write analyses as data, a script for OpenSees, links for SAP2000, or a report."""
    if kind == LINKS:
        from dcfp.exchange import sap2000_text  # late: links are rare

        furthest = max(one.response.peak_displacement for one in found)
        return sap2000_text(found[0].response.plan, chosen.link_temperature, furthest)
    if kind == SCRIPT:
        from dcfp.exchange import plan_script  # late: scripts are rare

        given = {key: value for key, value in settings.items() if key in ("vertical", "overturning", "tail")}
        return plan_script(found[0].response.plan, found[0].response.motion, **given)
    if kind not in REPORTS:
        write_responses(part, [one.response for one in found], kind, alone=alone)
        return None
    from dcfp.present.report import page_of, pdf_of  # late: it draws figures
    from dcfp.present.report.building import build_building_report

    text = Path(chosen.project).read_text(encoding="utf-8")
    document = build_building_report(found, read_heading(chosen.project), text, settings)
    with progress("figures", 2 * len(found)) as advance:
        if kind != REPORTS[0]:
            return page_of(document, advance)
        part.write_bytes(pdf_of(document, advance))
    return None


def _document(one: BesideOthers, remarks: list[str]) -> dict[str, Any]:
    response = one.response
    torsion = Table(TORSION, code_torsion(response.plan, response.peak_displacement)).objects()
    return {**one.document, "torsion": torsion, "remarks": remarks}


def _remarks(found: Sequence[BesideOthers]) -> list[list[str]]:
    """Return the remarks on each analysis and its motion."""
    return [
        [*motion_remarks(one.response.motion, with_scale=False), *remarks]
        for one, remarks in zip(found, remarks_on(found), strict=True)
    ]


def _page(found: Sequence[BesideOthers]) -> Page:
    first = found[0].response
    blocks: list[Block] = [_lines(first.plan, first)]
    blocks.append(grid(Table(tuple(first.quantities.values()), [one.response for one in found])))
    if len(found) == 1:
        blocks += _details(found[0])
    remarks = grouped(
        (one.response.name, remark) for one, own in zip(found, _remarks(found), strict=True) for remark in own
    )
    return Page(blocks, remarks)


def _lines(plan: Plan, response: PlanResponse) -> list[tuple[str, str]]:
    x, y = (one / 1e3 for one in plan.mass_centre)
    types = {one.bearing.name: one for one in plan.systems}
    counts = {name: sum(one.bearing.name == name for one in plan.systems) for name in types}
    loads = plan.static_loads / 1e3
    lines = [
        ("Building", f"{plan.name}: {plan.weight / 1e3:.0f} kN on {plan.count} bearings, loads at rest {loads.min():.0f} to {loads.max():.0f} kN"),
        ("Mass", f"centre at ({x:.2f}, {y:.2f}) m of a slab of {plan.lengths[0] / 1e3:g} x {plan.lengths[1] / 1e3:g} m"),
    ]  # fmt: skip
    lines += [(f"Bearing {name}", f"{counts[name]} of {one.bearing}; {one.friction.name}, heating {one.heating.name}") for name, one in types.items()]  # fmt: skip
    if plan.storeys:
        periods = ", ".join(f"{one:.2f}" for one in plan.structure.periods[:3])
        lines.append(("Storeys", f"{len(plan.storeys)}, first periods on a fixed base {periods} s"))
        lines.append(
            ("Damping", f"{response.damping_words}: every result of storeys and floors is with this")
        )
    return lines


def _details(one: BesideOthers) -> list[Block]:
    response, plan = one.response, one.response.plan
    corner, furthest, when = worst_corner(response)
    ratio = response.corner_ratio
    lines = [
        ("Corner", f"({corner[0] / 1e3:g}, {corner[1] / 1e3:g}) m goes furthest, {furthest:.1f} mm at {when:.2f} s; {'' if ratio is None else f'{ratio:.3f} times the centre'}"),
        ("Torque", f"{abs(response.torque).max() / 1e6:.0f} kN m, rotation {response.peak_rotation:.2g} rad"),
        ("Energy", f"V_E {response.input_velocity / 1e3:.3f} m/s{_akiyama(one)}; residual of the balance {response.energy.relative_residual:.1e}"),
    ]  # fmt: skip
    blocks: list[Block] = [lines]
    torsion = code_torsion(plan, response.peak_displacement)
    if torsion:
        blocks.append(("Torsion by codes, corner over centre", grid(Table(TORSION, torsion))))
    blocks.append(("Bearings", grid(bearing_table(response))))
    blocks.append(("Slab and floors" if plan.storeys else "Slab", grid(level_table(response))))
    return blocks


def _akiyama(one: BesideOthers) -> str:
    if not one.response.plan.storeys or one.velocity_ratio is None:
        return ""
    return f", {one.velocity_ratio:.3f} times that of a rigid structure (Akiyama 1985 takes one)"


def _of_response(quantity: Quantity) -> Quantity:
    def get(cause: Cause) -> Any:
        return quantity.of(cause.response)

    return replace(quantity, get=get, printed=True)


_CAUSES = (
    Quantity("causes", "causes of torsion so far", head="Building", get="words"),
    *(
        _of_response(PlanResponse.quantities[name])
        for name in ("record", "peak_ground_velocity", "peak_displacement", "corner_max", "corner_ratio", "rotation_max", "base_shear", "peak_temperature", "least_load", "largest_load")
    ),
)  # fmt: skip


def _causes(plan: Plan, motions: Sequence[Station], vertical: bool, settings: dict[str, Any]) -> Answer:
    """Return what is told of the causes, for every motion."""
    without = {key: value for key, value in settings.items() if key != "overturning"}
    found: list[Cause] = [
        cause for motion in motions for cause in separate_causes(plan, motion, vertical=vertical, **without)
    ]
    return Answer.of_table(Table(_CAUSES, found))


def _floor_spectra(
    responses: Sequence[PlanResponse], chosen: argparse.Namespace, failures: Sequence[AnalysisError]
) -> Answer:
    """Return the response spectra of slab and floors, at chosen periods or at a few where they are printed."""
    several = len(responses) > 1
    if several and chosen.plot is not None:
        msg = "A figure of floor spectra is of one analysis; give one station and one PGV."
        raise InputError(msg)
    spectra = [floor_spectra(one) for one in responses]
    rows = [row for one, own in zip(responses, spectra, strict=True) for row in floor_ordinates(one, own)]
    table = Table(FLOOR_ORDINATES, rows)
    shown = spectra[0].periods[:: len(spectra[0].periods) // _SHOWN]
    few = Table(FLOOR_ORDINATES, [row for row in rows if row.period in shown])
    damping = responses[0].damping_words
    remarks = [
        f"Oscillators with {100.0 * spectra[0].damping:g} % of critical damping at the centre of mass; the larger direction is broadened by {100.0 * spectra[0].broadening:g} % of the frequency to either side. --out writes all periods.",
        f"Damping of the storeys {damping}: every spectrum is with this.",
        *grouped((one.name, remark) for one in responses for remark in one.remarks),
    ]
    return Answer(
        table.objects,
        lambda: Page([grid(few, 3)], remarks),
        lambda part, kind: table.csv(),
        drawn("plan.plot_floor_spectra", spectra[0]),
        failures=failures,
    )
