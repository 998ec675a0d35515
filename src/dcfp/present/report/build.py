"""A report from a calculation: its inputs, and what a reader must know besides the numbers; results, verdicts and formulas have modules of their own."""

from dcfp.errors import InputError
from dcfp.kernels._jit import source_digest
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks
from dcfp.present.report.document import (
    Block,
    Bullets,
    Code,
    Document,
    Equations,
    Listing,
    Maths,
    Parts,
    Section,
    Table,
    Tone,
    cells,
    heads,
    maths_of,
    named_values,
    short,
    words,
    written,
)  # fmt: skip
from dcfp.present.report.references import (
    label_of,
    numbers_of,
    record_citations,
    source_of,
    sources_of,
    versions,
)
from dcfp.present.report.results import methods_section, results_section
from dcfp.present.report.verdicts import checks_section, front_blocks
from dcfp.present.report.worked import worked_out
from dcfp.schema.citations import citation
from dcfp.schema.declared import Declared
from dcfp.schema.units import M_PER_S, M_PER_S2
from dcfp.study.scenario import Calculation
from dcfp.system import LI_2020, FrictionLaw, Heating
from dcfp.system.heating import constant_flux_rise
from dcfp.version import version


def build_report(calculation: Calculation) -> Document:
    """Return the report of a calculation, to be written by `pdf_of` or `page_of`.

    Raises
    ------
    InputError
        If there is no result to report.
    """
    if not calculation.results:
        msg = "there is no analysis to report; the scenario has no ground motion."
        raise InputError(msg)
    scenario = calculation.scenario
    worked = worked_out(calculation)
    return Document(
        title=scenario.title,
        heading=scenario.heading,
        front=front_blocks(calculation),
        sections=(
            inputs_section(calculation),
            results_section(calculation),
            methods_section(calculation),
            checks_section(calculation),
            *worked.sections,
            remarks_section(calculation),
            sources_section(calculation),
            *appendix(calculation),
        ),
        maker=f"dcfp {version()}",
        with_contents=True,
        numbers=numbers_of(calculation, worked.formulas),
    )


# ----- what the calculation starts from, and where each value comes from -----

_ASSUMED = "the scenario file, or the default of Li et al. (2020) where it says nothing (the file is in the appendix)"


def inputs_section(calculation: Calculation) -> Section:
    """Return the section of the inputs."""
    return Section(
        "Inputs",
        (words(f"Values are those of {_ASSUMED}.", tone=Tone.NOTE),),
        (
            Section("Bearing", (_bearing(calculation),)),
            Section("Friction", _friction(calculation)),
            Section("Heating of the contact", _heating(calculation.scenario.model.heating)),
            Section("Ground motions", _motions(calculation)),
            Section("Analysis", (_settings(calculation),)),
        ),
        on_new_page=True,
    )


def _bearing(calculation: Calculation) -> Table:
    bearing = calculation.scenario.model.bearing
    unchanged = "unchanged" if bearing == LI_2020 else ""
    return named_values([*_parameters(bearing), ("Bearing of Li et al. (2020)", unchanged)])


def _parameters(thing: Declared) -> list[tuple[str, str | Parts]]:
    """Return words, symbol and value of every parameter, in its declared unit."""
    rows: list[tuple[str, str | Parts]] = []
    for parameter, value in thing.rows():
        symbol: Parts = (
            (Maths(maths_of(parameter.symbol)), " = ") if parameter.symbol and value is not None else ()
        )
        text = "" if value == "" else parameter.text(value).replace("-", "−")
        rows.append((parameter.words[:1].upper() + parameter.words[1:], (*symbol, text) if text else ""))
    return rows


def _friction(calculation: Calculation) -> tuple[Block, ...]:
    law = calculation.scenario.model.friction
    equations = law.equations()
    speed = (
        "of the slider on one plate"
        if law.speed_is_of_surface
        else "of the upper plate relative to the lower"
    )
    nominal = calculation.nominal
    rows: list[tuple[str, str | Parts]] = [
        ("Law", law.name),
        ("Source", citation(law.citation) if law.citation else ""),
        ("Speed in it", f"{speed}, in mm/s; pressure in N/mm², temperature in °C"),
        *_parameters(law),
        ("Tests behind it", _tests(law)),
        ("Caution", law.caution),
        ("Nominal coefficient", (Maths("mu_n"), f" = {nominal.value:.4f}: {nominal.source}")),
    ]
    origin = source_of(law.citation) + law.equation_numbers
    return (named_values(rows), Equations(equations, origin)) if equations else (named_values(rows),)


def _tests(law: FrictionLaw) -> str:
    tested = law.tests()
    if tested is None:
        return "not known"
    (low, high), (slow, fast) = tested.pressure, tested.speed
    ambient = "" if tested.ambient is None else f", plates of {short(tested.ambient)} °C at the start"
    return (
        f"{tested.source}: {short(low)} to {short(high)} N/mm², {short(slow)} to {short(fast)} mm/s{ambient}"
    )


def _heating(heating: Heating) -> tuple[Block, ...]:
    table = named_values(
        [
            ("Model", f"{heating.name}: {heating.description}"),
            *_parameters(heating),
            ("Rise under 1 N/(mm s) for 1 s", f"{float(constant_flux_rise(heating, 1.0, 1.0)):.4f} °C"),
        ]
    )
    flux = Equations(
        (
            "q = (mu p v) / 2",
            'Delta T = sqrt(D) / (k sqrt(pi)) integral_0^t (q(t - tau)) / sqrt(tau) thin "d" tau',
        ),
        "Li et al. (2020), Eqs (12), (11)",
    )
    shares = "The flux q goes into each of two equal plates while the contact lies on the point; of different plates each has its share of the travel."
    return (table,) if heating.name == "none" else (table, flux, words(shares, tone=Tone.NOTE))


def _motions(calculation: Calculation) -> tuple[Block, ...]:
    blocks: list[Block] = [_record(motion) for motion in calculation.scenario.study.motions]
    rows = [
        cells(
            label_of(one),
            _scale(one.motion),
            written("pga_m_s2", M_PER_S2.shown(one.motion.peak_acceleration)),
            written("pgv_m_s", M_PER_S.shown(one.motion.peak_velocity)),
            f"{one.motion.duration:.2f}",
        )
        for one in calculation.results
    ]
    head = heads("Case", "Scale factor\n[–]", "PGA\n[m/s²]", "PGV\n[m/s]", "Duration\n[s]")
    blocks.append(Table(head, tuple(rows), "lrrrr", (1.0, 0.0, 0.0, 0.0, 0.0), "As they shake the bearing"))
    return tuple(blocks)


def _record(motion: GroundMotion) -> Table:
    origin = motion.origin
    values = motion.acceleration.size
    return named_values(
        [
            ("Record", motion.name),
            ("Earthquake", origin.event or "not given by the source"),
            ("Station, component", ", ".join(word for word in (origin.station, origin.component) if word)),
            ("Source", origin.source),
            ("Format", origin.file_format),
            ("Processing in it", origin.processing or "not given by the source"),
            ("Treatment here", "; ".join(motion.treatment) or "none"),
            (
                "As recorded",
                f"PGA {written('pga_m_s2', M_PER_S2.shown(motion.peak_acceleration))} m/s², PGV {written('pgv_m_s', M_PER_S.shown(motion.peak_velocity))} m/s,"
                f" {values} values, {short(motion.time_step)} s apart",
            ),
            ("SHA-256 before scaling", (Code(motion.digest),)),
        ]
    )


def _scale(motion: GroundMotion) -> str:
    steps = [step for step in motion.treatment if step.startswith("scaled by ")]
    return steps[-1].removeprefix("scaled by ") if steps else "1"


def _settings(calculation: Calculation) -> Table:
    settings = calculation.scenario.study.settings
    constants = calculation.methods.constants
    tail = "until no more sliding can come" if settings.tail is None else f"{short(settings.tail)} s"
    step = (
        "that of the record, at most 0.01 s while sliding"
        if settings.step is None
        else f"{short(settings.step)} s"
    )
    return named_values(
        [
            (
                "Structure",
                "rigid, on one bearing, in one direction; no viscous damping (Li et al. 2020, section 5.1)",
            ),
            (
                "Integration",
                "closed forms from event to event; the ground acceleration is linear between its samples",
            ),
            ("Longest step", step),
            ("Time after the record", tail),
            ("Tolerance of the friction", f"{short(settings.tolerance)} relative, in the middle of a step"),
            (
                "Prediction",
                (
                    f"pulses where the ground velocity turns back by {short(calculation.methods.threshold)} PGV, for the march by"
                    f" {short(calculation.methods.march_threshold)} PGV; ",
                    Maths("epsilon"),
                    f" {short(constants.fall_ratio)}, ",
                    Maths("zeta"),
                    f" {short(constants.change_ratio)}, ",
                    Maths('k_(g,"ave")'),
                    f" {short(constants.average_slope)} mm/s², ",
                    Maths("g"),
                    f" {short(constants.gravity)} mm/s² (Li et al. 2020, section 6)",
                ),
            ),
        ]
    )


# ----- remarks, limits, sources, provenance, and the scenario itself -----

_LIMITS = (
    "One horizontal direction, one bearing with the mass that it carries; the vertical force is constant.",
    "The structure above is rigid and has no viscous damping: forces and accelerations in it are not calculated, nor what its flexibility changes.",
    "The force of the pendulum is linear in the displacement; there is no restrainer, and no impact where the capacity is exceeded.",
    "Properties are the nominal ones: ageing, contamination and scatter of friction (property modification factors) are not in these numbers.",
    "A plate's heat flows at right angles to its surface; two plates share the travel as their radii do.",
    "Records scaled to a PGV keep their durations. A record stands for itself: how likely it is, and what others do, is not part of this report.",
    "Predictions and codes are given beside the analysis for comparison; a verdict on a condition says whether the method may be used, not whether the structure is safe.",
)


def remarks_section(calculation: Calculation) -> Section:
    """Return the remarks of all analyses, each once, and the limits of the model."""
    remarks: list[str] = []
    for one in calculation.results:
        remarks += [*motion_remarks(one.motion, with_scale=False), *one.response.remarks]
    found = tuple((remark,) for remark in dict.fromkeys(remarks))
    blocks: tuple[Block, ...] = (Bullets(found),) if found else (words("None."),)
    limits = Bullets(tuple((limit,) for limit in _LIMITS))
    return Section(
        "Remarks and limits",
        (),
        (Section("Remarks of the analyses", blocks), Section("Limits of the model", (limits,))),
    )


def sources_section(calculation: Calculation) -> Section:
    """Return the bibliography and what the numbers were made with."""
    lines = (*sources_of(calculation), *record_citations(calculation))
    codes = [name for one in calculation.results for name in one.case.codes]
    if codes:
        lines += (
            f"Methods of codes as dcfp has them, with what could not be confirmed marked: {', '.join(dict.fromkeys(codes))}.",
        )
    made = [cells("Program", f"dcfp {version()}"), cells("Kernels, SHA-256", (Code(source_digest()),))]
    made += [cells(name, words) for name, words in versions().items()]
    made += [
        cells(f"Record {motion.name} before scaling, SHA-256", (Code(motion.digest),))
        for motion in calculation.scenario.study.motions
    ]
    # a user's words take what room the digests leave
    table = Table((), tuple(made), "ll", (1.0, 0.0))
    return Section(
        "Sources and provenance",
        (),
        (Section("Sources", (Bullets(tuple((line,) for line in lines)),)), Section("Provenance", (table,))),
    )


def appendix(calculation: Calculation) -> tuple[Section, ...]:
    """Return the scenario file; nothing where the scenario came from none."""
    text = calculation.scenario.study.text
    if not text.strip():
        return ()
    note = words("The same program with this file gives the same numbers.")
    return (Section("Appendix: scenario file", (note, Listing(text.rstrip())), on_new_page=True),)
