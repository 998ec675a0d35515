"""The report of an isolated building: what is built, what shakes it, and what comes out for centre, corners, bearings and floors."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any

from dcfp.analysis.integration import Integration
from dcfp.analysis.plan import PlanResponse
from dcfp.analysis.plan.beside import BesideOthers, remarks_on
from dcfp.analysis.plan.quantities import bearing_table, level_table, worst_corner
from dcfp.analysis.response import Status
from dcfp.kernels._jit import source_digest
from dcfp.methods.spectra.of_floors import FloorSpectra, floor_spectra
from dcfp.methods.torsion import TORSION, code_torsion
from dcfp.motion.measures import motion_remarks
from dcfp.present.report import document as doc
from dcfp.present.report.build import parameter_rows, peaks_of, record_table, scale_of, versions
from dcfp.schema import table as schema
from dcfp.schema.check import Verdict
from dcfp.schema.citations import full_citation
from dcfp.schema.formulas import true_minus
from dcfp.schema.quantities import Quantity
from dcfp.study.scenario import Heading
from dcfp.system.plan import Plan
from dcfp.version import version

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Characters of a record's name that the head of a figure has room for.
_LONGEST = 40
_LIMITS = (
    "Slab and floors are rigid in their planes and vertically; rotations are small; the force of a pendulum is linear in its displacement, and there is no restrainer.",
    "Every bearing is heated at one point; heat flows at right angles to the surface of a plate.",
    "Bearings carry no tension: one that lifts off passes its load to the others by a rigid slab on equal vertical springs, and lands without an impact. Below 1 % of its load at rest its coefficient is taken to change no more.",
    "With kf in proportion to the load at rest, constant friction turns no building whose loads follow its mass; what turns it then is pressure, heat, overturning and the structure.",
    "Properties are the nominal ones: ageing, contamination and scatter of friction are not in these numbers.",
    "Damping acts on the structure on a fixed base alone. Floor accelerations depend on its kind and on the stiffness of spring (b).",
)


def build_building_report(
    found: Sequence[BesideOthers], heading: Heading, text: str, settings: dict[str, Any]
) -> doc.Document:
    """Return the report of a building, to be written by `pdf_of` or `page_of`.

    Parameters
    ----------
    found
        A response for each ground motion, with what stands beside it.
    heading
        What stands at the top.
    text
        The project, for the appendix.
    settings
        With which it was analysed: those of `respond_plan`.
    """
    responses = [one.response for one in found]
    plan = responses[0].plan
    return doc.Document(
        title=plan.name,
        heading=heading,
        front=(_headline(responses), peaks_table(responses)),
        sections=(
            _inputs(responses, settings),
            doc.Section("Results", (_key(),), tuple(_case(i, one) for i, one in enumerate(found, 1))),
            _remarks(found),
            _sources(responses),
            doc.Section("Appendix: project", (doc.words("The same program with this file gives the same numbers."), doc.Listing(text.rstrip())), on_new_page=True),
        ),
        maker=f"dcfp {version()}",
        numbers={
            "title": plan.name,
            "report": asdict(heading),
            "version": version(),
            "kernels_sha256": source_digest(),
            "versions": versions(),
            "cases": [one.document for one in found],
        },
    )  # fmt: skip


def _label(response: PlanResponse) -> str:
    return f"{response.motion.name}, {doc.written('pgv_m_s', response.motion.peak_velocity / 1e3)} m/s"


def _headline(responses: Sequence[PlanResponse]) -> doc.Block:
    worst = max(responses, key=lambda one: one.peak_corner_displacement)
    count = len(responses)
    among = f", the largest of {count} cases" if count > 1 else ""
    start = f"A corner goes furthest, {worst.peak_corner_displacement:.1f} mm, and the centre of mass {worst.peak_displacement:.1f} mm, under {_label(worst)}{among}. "
    beyond = [one for one in responses if one.status is Status.BEYOND_CAPACITY]
    lifted = [one for one in responses if one.uplift]
    lifts = f" Bearings lift off in {len(lifted)} of {count} cases." if lifted else " No bearing lifts off."
    if any(one.bearing.displacement_capacity is None for one in worst.plan.systems):
        return doc.words(start, "Not every bearing has a capacity given.", lifts, tone=doc.Tone.OPEN)
    if beyond:
        return doc.words(start, f"The capacity of a bearing is exceeded in {len(beyond)} of {count} cases.", lifts, tone=doc.Tone.BAD)  # fmt: skip
    tone = doc.Tone.OPEN if lifted else doc.Tone.GOOD
    return doc.words(start, "The capacity of no bearing is exceeded.", lifts, tone=tone)


def _told() -> list[Quantity]:
    return [one for one in PlanResponse.quantities.values() if one.printed and one.is_number]


def peaks_table(responses: Sequence[PlanResponse]) -> doc.Table:
    """Return the peaks of all cases, one in a row."""
    quantities = _told()
    head = doc.cells("Record", *(one.heading() for one in quantities), "Status")
    rows: list[tuple[doc.Cell, ...]] = []
    for one in responses:
        verdict = Verdict.MET if one.status is Status.OK else Verdict.NOT_MET
        numbers = [true_minus(quantity.text(one)) for quantity in quantities]
        rows.append((*doc.cells(one.motion.name, *numbers), doc.Cell((one.status.value,), verdict)))
    widths = (1.0, *[0.0] * len(quantities), 0.8)
    return doc.Table(head, tuple(rows), f"l{'r' * len(quantities)}l", widths, "Peaks")


def _key() -> doc.Block:
    words = [f"{one.head.replace(chr(10), ' ')}: {one.words}" for one in _told()]
    return doc.note("; ".join(words), ". Numbers are rounded to the digits shown; dcfp building --json prints all of them.")  # fmt: skip


def table_of(table: schema.Table, caption: str = "") -> doc.Table:
    """Return a table of declared columns as a report has it."""
    aligned = "".join("r" if one.is_number else "l" for one in table.printed)
    rows = tuple(doc.cells(*map(true_minus, row)) for row in table.cells())
    widths = tuple(0.0 if one.is_number else 1.0 for one in table.printed)
    return doc.Table(doc.cells(*table.heads()), rows, aligned, widths, caption or table.title)


# ----- inputs -----


def _inputs(responses: Sequence[PlanResponse], settings: dict[str, Any]) -> doc.Section:
    plan = responses[0].plan
    x, y = (one / 1e3 for one in plan.mass_centre)
    loads = plan.static_loads / 1e3
    building = doc.named_values(
        [
            ("Weight", f"{plan.weight / 1e3:.0f} kN, mass {plan.total_mass:.1f} t"),
            ("Centre of mass", f"({x:.3f}, {y:.3f}) m, with an accidental eccentricity of {100.0 * plan.eccentricity[0]:g} and {100.0 * plan.eccentricity[-1]:g} % of the sides"),
            ("Slab", f"{plan.lengths[0] / 1e3:g} x {plan.lengths[1] / 1e3:g} m, rotational inertia {plan.slab_inertia / 1e6:.5g} t m²"),
            ("Bearings", f"{plan.count}, loads at rest {loads.min():.0f} to {loads.max():.0f} kN, {'given' if plan.loads is not None else 'from statics of a rigid slab'}"),
            ("Stiffness before sliding", "in proportion to the load at rest" if plan.spring == "load" else "that of the type"),
            ("Damping of the storeys", responses[0].damping_words),
        ]
    )  # fmt: skip
    sections = [doc.Section("Building", (building, *_storeys(plan)))]
    sections += [doc.Section(f"Bearings {one.bearing.name}", (doc.named_values(_type_rows(one, plan)),)) for one in dict.fromkeys(plan.systems)]  # fmt: skip
    records = {one.motion.name: one.motion for one in responses}
    rows = [doc.cells(_label(one), scale_of(one.motion), *peaks_of(one.motion), f"{one.motion.duration:.2f}") for one in responses]  # fmt: skip
    head = doc.cells("Case", "Scale factor\n[–]", "PGA\n[m/s²]", "PGV\n[m/s]", "Duration\n[s]")
    motions = doc.Table(head, tuple(rows), "lrrrr", (1.0, 0.0, 0.0, 0.0, 0.0), "As they shake the building, PGA and PGV of the resultant")  # fmt: skip
    sections.append(doc.Section("Ground motions", (*map(record_table, records.values()), motions)))
    sections.append(doc.Section("Analysis", (_settings(settings),)))
    return doc.Section("Inputs", (doc.note("Values are those of the project (in the appendix), or the defaults of Li et al. (2020) where it says nothing."),), tuple(sections), on_new_page=True)  # fmt: skip


def _type_rows(system: Any, plan: Plan) -> list[tuple[str, str | doc.Parts]]:
    number = sum(one == system for one in plan.systems)
    return [
        ("Number in the plan", f"{number}"),
        *parameter_rows(system.bearing),
        ("Friction law", system.friction.name),
        *parameter_rows(system.friction),
        ("Heating", f"{system.heating.name}: {system.heating.description}"),
        *parameter_rows(system.heating),
    ]


def _storeys(plan: Plan) -> tuple[doc.Block, ...]:
    if not plan.storeys:
        return ()
    rows = [
        doc.cells(f"{i}", f"{one.height / 1e3:g}", f"{one.mass:.1f}", *(f"{k / 1e3:.5g}" if k else "–" for k in one.stiffnesses))
        for i, one in enumerate(plan.storeys, 1)
    ]  # fmt: skip
    head = doc.cells("Storey", "Height\n[m]", "Mass\n[t]", "Stiffness in x\n[kN/mm]", "in y\n[kN/mm]")
    table = doc.Table(head, tuple(rows), "rrrrr", (0.0,) * 5, "Storeys, from below")
    periods = ", ".join(f"{one:.3f}" for one in plan.structure.periods[:6])
    return table, doc.note(f"First periods on a fixed base: {periods} s.")


def _settings(settings: dict[str, Any]) -> doc.Table:
    tail, step = settings["tail"], settings["step"]
    return doc.named_values(
        [
            ("Directions", "two horizontal ones and the rotation of the slab, with a circular yield surface for each bearing"),
            ("Loads of the bearings", "follow the overturning moment of floors, slab and sliders" if settings["overturning"] else "as at rest"),
            ("Vertical motion", "the weight follows the vertical component" if settings["vertical"] else "none"),
            ("Longest step", "that of the record" if step is None else f"{doc.short(step)} s"),
            ("Time after the record", "until nothing slides any more" if tail is None else f"{doc.short(tail)} s"),
            ("Tolerance", f"{doc.short(settings['tolerance'])} (default {doc.short(Integration().tolerance)})"),
        ]
    )  # fmt: skip


# ----- results -----


def _case(place: int, one: BesideOthers) -> doc.Section:
    response = one.response
    corner, furthest, when = worst_corner(response)
    shown = replace(response.motion, name=doc.shortened(response.motion.name, _LONGEST))

    def draw() -> "Figure":
        return replace(response, motion=shown).plot()

    rows: list[tuple[str, str | doc.Parts]] = [
        ("Centre of mass", f"{response.peak_displacement:.1f} mm, residual {response.residual_displacement:.1f} mm"),
        ("Worst corner", f"({corner[0] / 1e3:g}, {corner[1] / 1e3:g}) m: {furthest:.1f} mm at {when:.2f} s, {furthest / max(response.peak_displacement, 1e-9):.3f} times the centre"),
        ("Rotation, torque", f"{response.peak_rotation:.2e} rad, {abs(response.torque).max() / 1e6:.0f} kN m"),
        ("Base shear", f"{response.peak_base_shear / 1e3:.0f} kN, {response.force_ratio:.4f} of the weight"),
        ("Uplift", f"{int((response.uplift_time > 0.0).sum())} bearings, longest {response.uplift_time.max():.2f} s" if response.uplift else "none"),
        ("Input energy", f"equivalent velocity {response.input_velocity:.0f} mm/s{_akiyama(one)}"),
        ("Energy balance", f"residual over the largest input {doc.powered(response.energy.relative_residual)}"),
    ]  # fmt: skip
    torsion = code_torsion(response.plan, response.peak_displacement)
    words = f"Plan with the paths of the bearings and their temperatures, histories{', and profiles over the height' if response.plan.storeys else ''}, {_label(response)}"
    blocks: list[doc.Block] = [
        doc.named_values(rows),
        *(
            (table_of(schema.Table(TORSION, torsion), "Corner over centre by the torsion formulas of codes"),)
            if torsion
            else ()
        ),
        doc.Drawing(draw, words),
        table_of(bearing_table(response)),
        table_of(level_table(response)),
    ]
    if response.plan.storeys:
        blocks.append(doc.Drawing(_spectra_of(floor_spectra(response)), f"Response spectra of slab and floors, {_label(response)}"))  # fmt: skip
    return doc.Section(f"Case {place}: {_label(response)}", tuple(blocks), on_new_page=True)


def _spectra_of(spectra: FloorSpectra) -> "Callable[[], Figure]":
    def draw() -> "Figure":
        from dcfp.present.figures.plan import plot_floor_spectra  # late: Matplotlib takes long to import

        return plot_floor_spectra(spectra)

    return draw


def _akiyama(one: BesideOthers) -> str:
    if not one.response.plan.storeys or one.velocity_ratio is None:
        return ""
    return f", {one.velocity_ratio:.3f} times that of a rigid structure of the same mass"


def _remarks(found: Sequence[BesideOthers]) -> doc.Section:
    remarks: list[str] = []
    for one, own in zip(found, remarks_on(found), strict=True):
        remarks += [*motion_remarks(one.response.motion, with_scale=False), *own]
    items = tuple((remark,) for remark in dict.fromkeys(remarks))
    return doc.Section(
        "Remarks and limits",
        (),
        (
            doc.Section("Remarks of the analyses", (doc.Bullets(items),) if items else (doc.words("None."),)),
            doc.Section("Limits of the model", (doc.Bullets(tuple((one,) for one in _LIMITS)),)),
        ),
    )


def _sources(responses: Sequence[PlanResponse]) -> doc.Section:
    laws = [one.friction.citation for one in responses[0].plan.systems]
    motions = {one.motion.name: one.motion for one in responses}.values()
    lines = [full_citation(key) for key in dict.fromkeys(("li_2020", *laws)) if key]
    lines += [one for one in dict.fromkeys(motion.origin.citation for motion in motions) if one]
    lines.append("Torsion: ASCE 7-16, Eq. (17.5-3); NTC 2018, (7.10.4) and (7.10.5). Broadening of floor spectra: US NRC Regulatory Guide 1.122 (1978).")  # fmt: skip
    made = [
        doc.cells("Program", f"dcfp {version()}"),
        doc.cells("Kernels, SHA-256", (doc.Code(source_digest()),)),
    ]
    made += [doc.cells(name, words) for name, words in versions().items()]
    made += [
        doc.cells(f"Record {one.name} before scaling, SHA-256", (doc.Code(one.digest),)) for one in motions
    ]
    table = doc.Table((), tuple(made), "ll", (1.0, 0.0))
    return doc.Section("Sources and provenance", (doc.Bullets(tuple((line,) for line in lines)), table))
