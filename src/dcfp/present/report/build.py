"""A report from a calculation: its inputs, what a reader must know besides the numbers, its sources, and every number ready for JSON."""

import platform
from dataclasses import asdict
from importlib import metadata
from typing import Any

from dcfp.analysis.integration import Integration
from dcfp.analysis.plane_history import TOLERANCE as LARGEST_DEFECT
from dcfp.errors import InputError
from dcfp.inference.told import case_objects
from dcfp.kernels._jit import source_digest
from dcfp.methods.code import code_methods
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks
from dcfp.motion.station import Station
from dcfp.present.report import document as doc
from dcfp.present.report import results
from dcfp.present.report.worked import worked_out
from dcfp.schema.check import COLUMNS
from dcfp.schema.citations import citation, full_citation, source_of
from dcfp.schema.declared import Declared
from dcfp.schema.formulas import Formula, true_minus
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, M_PER_S2
from dcfp.study.scenario import OF_ONE_DIRECTION, Calculation, ScenarioResult
from dcfp.system import LI_2020, FrictionLaw, PreciseHeating
from dcfp.system.heating import constant_flux_rise
from dcfp.version import version


def build_report(calculation: Calculation) -> doc.Document:
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
    worked, formulas = worked_out(calculation)
    return doc.Document(
        title=scenario.title,
        heading=scenario.heading,
        front=results.front_blocks(calculation),
        sections=(
            inputs_section(calculation),
            results.results_section(calculation),
            results.methods_section(calculation),
            results.checks_section(calculation),
            worked,
            remarks_section(calculation),
            sources_section(calculation),
            *appendix(calculation),
        ),
        maker=f"dcfp {version()}",
        numbers=numbers_of(calculation, formulas),
    )


# ----- what the calculation starts from, and where each value comes from -----

_ASSUMED = "the scenario file, or the default of Li et al. (2020) where it says nothing (the file is in the appendix)"


def inputs_section(calculation: Calculation) -> doc.Section:
    """Return the section of the inputs."""
    return doc.Section(
        "Inputs",
        (doc.note(f"Values are those of {_ASSUMED}."),),
        (
            doc.Section("Bearing", (_bearing(calculation),)),
            doc.Section("Friction", _friction(calculation)),
            doc.Section("Heating of the contact", _heating(calculation)),
            doc.Section("Ground motions", _motions(calculation)),
            doc.Section("Analysis", (_settings(calculation),)),
        ),
        on_new_page=True,
    )


def _bearing(calculation: Calculation) -> doc.Table:
    bearing = calculation.scenario.model.bearing
    unchanged = "unchanged" if bearing == LI_2020 else ""
    return doc.named_values([*parameter_rows(bearing), ("Bearing of Li et al. (2020)", unchanged)])


def parameter_rows(thing: Declared) -> list[tuple[str, str | doc.Parts]]:
    """Return words, symbol and value of every parameter, in its declared unit."""
    rows: list[tuple[str, str | doc.Parts]] = []
    for parameter, value in thing.rows():
        text = "" if value == "" else true_minus(parameter.text(value))
        symbol = doc.maths_of(parameter.symbol) if value is not None else ""
        shown = (doc.Maths(symbol), " = ", text) if symbol and text else text
        rows.append((parameter.words[:1].upper() + parameter.words[1:], shown))
    return rows


def _friction(calculation: Calculation) -> tuple[doc.Block, ...]:
    law = calculation.scenario.model.friction
    equations = law.equations()
    speed = (
        "of the slider on one plate"
        if law.speed_is_of_surface
        else "of the upper plate relative to the lower"
    )
    nominal = calculation.nominal
    rows: list[tuple[str, str | doc.Parts]] = [
        ("Law", law.name),
        ("Source", citation(law.citation) if law.citation else ""),
        ("Speed in it", f"{speed}, in mm/s; pressure in N/mm², temperature in °C"),
        *parameter_rows(law),
        ("Tests behind it", _tests(law)),
        ("Caution", law.caution),
        ("Nominal coefficient", (doc.Maths("mu_n"), f" = {nominal.value:.4f}: {nominal.source}")),
    ]
    origin = source_of(law.citation) + law.equation_numbers
    table = doc.named_values(rows)
    return (table, doc.Equations(equations, origin)) if equations else (table,)


def _tests(law: FrictionLaw) -> str:
    tested = law.tests()
    if tested is None:
        return "not known"
    (low, high), (slow, fast) = tested.pressure, tested.speed
    ambient = "" if tested.ambient is None else f", plates of {doc.short(tested.ambient)} °C at the start"
    return f"{tested.source}: {doc.short(low)} to {doc.short(high)} N/mm², {doc.short(slow)} to {doc.short(fast)} mm/s{ambient}"


def _heating(calculation: Calculation) -> tuple[doc.Block, ...]:
    heating = calculation.scenario.model.heating
    table = doc.named_values(
        [
            ("Model", f"{heating.name}: {heating.description}"),
            *parameter_rows(heating),
            ("Rise under 1 N/(mm s) for 1 s", f"{float(constant_flux_rise(heating, 1.0, 1.0)):.4f} °C"),
        ]
    )
    flux = doc.Equations(
        (
            "q = (mu p v) / 2",
            'Delta T = sqrt(D) / (k sqrt(pi)) integral_0^t (q(t - tau)) / sqrt(tau) thin "d" tau',
        ),
        "Li et al. (2020), Eqs (12), (11)",
    )
    shares = "The flux q goes into each of two equal plates while the contact lies on the point; of different plates each has its share of the travel."
    disc = " In two directions the points are a grid over the plate, and the contact has the mean of those under a disc, of the diameter of the slider."
    in_field = calculation.in_plane and isinstance(heating, PreciseHeating)
    return (
        (table,) if heating.name == "none" else (table, flux, doc.note(shares + (disc if in_field else "")))
    )


def _motions(calculation: Calculation) -> tuple[doc.Block, ...]:
    records = [record_table(motion) for motion in calculation.scenario.study.motions]
    rows = [
        doc.cells(
            results.label_of(one),
            scale_of(one.motion),
            *peaks_of(one.motion),
            f"{one.motion.duration:.2f}",
        )
        for one in calculation.results
    ]
    head = doc.cells("Case", "Scale factor\n[–]", "PGA\n[m/s²]", "PGV\n[m/s]", "Duration\n[s]")
    widths = (1.0, 0.0, 0.0, 0.0, 0.0)
    title = f"As they shake the bearing{', PGA and PGV of the resultant' if calculation.in_plane else ''}"
    return (*records, doc.Table(head, tuple(rows), "lrrrr", widths, title))


def peaks_of(motion: GroundMotion | Station) -> tuple[str, str]:
    """Return PGA and PGV."""
    pga, pgv = M_PER_S2.shown(motion.peak_acceleration), M_PER_S.shown(motion.peak_velocity)
    return doc.written("pga_m_s2", pga), doc.written("pgv_m_s", pgv)


def record_table(motion: GroundMotion | Station) -> doc.Table:
    """Return where a ground motion came from, and what it was before it was scaled."""
    origin, values = motion.origin, len(motion.acceleration)
    of_station = isinstance(motion, Station)

    def strength(one: GroundMotion | Station) -> str:
        pga, pgv = peaks_of(one)
        return f"PGA {pga} m/s², PGV {pgv} m/s"

    components = motion.components if of_station else ()
    return doc.named_values(
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
                f"{'resultant of x and y: ' if of_station else ''}{strength(motion)}, {values} values, {doc.short(motion.time_step)} s apart",
            ),
            *(
                (f"Direction {name}", f"{one.name}: {strength(one)}")
                for name, one in zip(("x", "y", "up"), components, strict=False)
            ),
            ("SHA-256 before scaling", (doc.Code(motion.digest),)),
        ]
    )


def scale_of(motion: GroundMotion | Station) -> str:
    """Return the factor by which a ground motion was scaled."""
    steps = [step for step in motion.treatment if step.startswith("scaled by ")]
    return steps[-1].removeprefix("scaled by ") if steps else "1"


def _settings(calculation: Calculation) -> doc.Table:
    settings = calculation.scenario.study.settings
    tail = "until no more sliding can come" if settings.tail is None else f"{doc.short(settings.tail)} s"
    step = (
        "that of the record, at most 0.01 s while sliding"
        if settings.step is None
        else f"{doc.short(settings.step)} s"
    )
    directions, integration = "one direction", "closed forms from event to event"
    tolerance = f"{doc.short(settings.tolerance)} relative, in the middle of a step"
    if calculation.in_plane:
        directions = "two horizontal directions, with a circular yield surface"
        integration = "the pendulum exactly, the friction turned with the velocity, in steps that are halved where it is off its chord"
        distance = LARGEST_DEFECT * settings.tolerance / Integration().tolerance
        tolerance = f"{doc.short(distance)} of the friction, off its chord in the middle of a step"
    return doc.named_values(
        [
            (
                "Structure",
                f"rigid, on one bearing, in {directions}; no viscous damping (Li et al. 2020, section 5.1)",
            ),
            ("Vertical force", calculation.vertical_force),
            ("Integration", f"{integration}; the ground acceleration is linear between its samples"),
            ("Longest step", step),
            ("Time after the record", tail),
            ("Tolerance of the friction", tolerance),
            *(() if calculation.in_plane else (_prediction(calculation),)),
        ]
    )


def _prediction(calculation: Calculation) -> tuple[str, doc.Parts]:
    constants = calculation.methods.constants
    parts = (
        f"pulses where the ground velocity turns back by {doc.short(calculation.methods.threshold)} PGV, for the march straight"
        f" legs that it leaves by {doc.short(calculation.methods.march_tolerance)} PGV; ",
        doc.Maths("epsilon"),
        f" {doc.short(constants.fall_ratio)}, ",
        doc.Maths("zeta"),
        f" {doc.short(constants.change_ratio)}, ",
        doc.Maths('k_(g,"ave")'),
        f" {doc.short(constants.average_slope)} mm/s², ",
        doc.Maths("g"),
        f" {doc.short(constants.gravity)} mm/s² (Li et al. 2020, section 6)",
    )
    return "Prediction", parts


# ----- remarks, limits, sources, provenance, and the scenario itself -----

_LIMITS = (
    "The structure above is rigid and has no viscous damping: forces and accelerations in it are not calculated, nor what its flexibility changes.",
    "The force of the pendulum is linear in the displacement; there is no restrainer, and no impact where the capacity is exceeded.",
    "Properties are the nominal ones: ageing, contamination and scatter of friction (property modification factors) are not in these numbers.",
    "A plate's heat flows at right angles to its surface; two plates share the travel as their radii do.",
    "Records scaled to a PGV keep their durations. A record stands for itself: how likely it is, and what others do, is not part of this report.",
)
_LIMITS_OF_LINE = (
    "One horizontal direction, one bearing with the mass that it carries; the vertical force is constant.",
    "Predictions and codes are given beside the analysis for comparison; a verdict on a condition says whether the method may be used, not whether the structure is safe.",
)


_LIMITS_OF_PLANE = (
    "Two horizontal directions, one bearing with the mass that it carries, which does not turn about the vertical axis. The structure is rigid upwards too,"
    " so that a vertical force that changes is that of the ground, without what columns and floors add.",
    "A record scaled to a PGV has that PGV in the resultant of its two components, which both have the same factor. Their directions are those of the record:"
    " how they lie to a fault or to the structure is not part of this report.",
    OF_ONE_DIRECTION,
)


def remarks_section(calculation: Calculation) -> doc.Section:
    """Return the remarks of all analyses, each once, and the limits of the model."""
    remarks: list[str] = []
    for one in calculation.results:
        remarks += [*motion_remarks(one.motion, with_scale=False), *one.response.remarks]
    found = tuple((remark,) for remark in dict.fromkeys(remarks))
    blocks: tuple[doc.Block, ...] = (doc.Bullets(found),) if found else (doc.words("None."),)
    first, *last = _LIMITS_OF_PLANE if calculation.in_plane else _LIMITS_OF_LINE
    limits = doc.Bullets(tuple((limit,) for limit in (first, *_LIMITS, *last)))
    return doc.Section(
        "Remarks and limits",
        (),
        (doc.Section("Remarks of the analyses", blocks), doc.Section("Limits of the model", (limits,))),
    )


def sources_section(calculation: Calculation) -> doc.Section:
    """Return the bibliography and what the numbers were made with."""
    asked = dict.fromkeys(motion.origin.citation for motion in calculation.scenario.study.motions)
    lines = (*sources_of(calculation), *filter(None, asked))
    codes = [name for one in calculation.results for name in one.codes]
    if codes:
        lines += (
            f"Methods of codes as dcfp has them, with what could not be confirmed marked: {', '.join(dict.fromkeys(codes))}.",
        )
    made = [
        doc.cells("Program", f"dcfp {version()}"),
        doc.cells("Kernels, SHA-256", (doc.Code(source_digest()),)),
    ]
    made += [doc.cells(name, words) for name, words in versions().items()]
    made += [
        doc.cells(f"Record {motion.name} before scaling, SHA-256", (doc.Code(motion.digest),))
        for motion in calculation.scenario.study.motions
    ]
    # a user's words take what room the digests leave
    table = doc.Table((), tuple(made), "ll", (1.0, 0.0))
    return doc.Section(
        "Sources and provenance",
        (),
        (
            doc.Section("Sources", (doc.Bullets(tuple((line,) for line in lines)),)),
            doc.Section("Provenance", (table,)),
        ),
    )


def appendix(calculation: Calculation) -> tuple[doc.Section, ...]:
    """Return the scenario file; nothing where the scenario came from none."""
    text = calculation.scenario.study.text
    if not text.strip():
        return ()
    note = doc.words("The same program with this file gives the same numbers.")
    return (doc.Section("Appendix: scenario file", (note, doc.Listing(text.rstrip())), on_new_page=True),)


#: What the checks of every analysis cite.
_OF_CHECKS = "fema_p695_2009"
#: Packages by their names in the report; Typst is there only where a PDF can be made.
_PACKAGES = {"NumPy": "numpy", "SciPy": "scipy", "Numba": "numba", "Typst (of the PDF)": "typst"}


def sources_of(calculation: Calculation) -> tuple[str, ...]:
    """Return the references that a report cites, each as a line."""
    used = {name for one in calculation.results for name in one.codes}
    codes = [key for name, method in code_methods().items() if name in used for key in method.citations]
    law = calculation.scenario.model.friction.citation
    keys = dict.fromkeys(("li_2020", law, *codes, _OF_CHECKS))
    return tuple(full_citation(key) for key in keys if key)


def versions() -> dict[str, str]:
    """Return the versions of Python and of the packages that are installed, by their names."""
    found = {"Python": platform.python_version()}
    for name, package in _PACKAGES.items():
        try:
            found[name] = metadata.version(package)
        except metadata.PackageNotFoundError:  # a page is made without it
            continue
    return found


def numbers_of(calculation: Calculation, formulas: tuple[Formula, ...]) -> dict[str, Any]:
    """Return the numbers of a report.

    Parameters
    ----------
    calculation
        The results; ``cases`` has an object for each, with the keys of ``dcfp respond --json`` and of ``dcfp compare --json``.
    formulas
        Those that are worked out in the report.
    """
    scenario = calculation.scenario
    model = scenario.model
    digests = {motion.name: motion.digest for motion in scenario.study.motions}
    cases = [one.case for one in calculation.results if one.case is not None]
    of_nothing: list[dict[str, Any]] = [{} for _ in calculation.results]
    compared = case_objects(cases, calculation.methods) if cases else of_nothing
    return {
        "title": scenario.title,
        "report": asdict(scenario.heading),
        "version": version(),
        "kernels_sha256": source_digest(),
        "versions": versions(),
        "decimals": doc.DECIMALS,
        "bearing": asdict(model.bearing)
        | {
            "vertical_force_N": model.bearing.vertical_force,
            "mass_t": model.bearing.mass,
            "restoring_stiffness_N_mm": model.bearing.restoring_stiffness,
            "period_s": model.bearing.period,
        },
        "friction_law": repr(model.friction),
        "heating_model": repr(model.heating),
        "settings": asdict(scenario.study.settings),
        "nominal_friction": calculation.nominal.value,
        "nominal_friction_source": calculation.nominal.source,
        "cases": [
            _case(one, row, found) | {"record_sha256": digests[one.motion.name]}
            for one, row, found in zip(calculation.results, calculation.summary, compared, strict=True)
        ],
        "formulas": [one.as_numbers() for one in formulas],
        "references": list(sources_of(calculation)),
    }


def _case(one: ScenarioResult, row: dict[str, Any], compared: dict[str, Any]) -> dict[str, Any]:
    motion = one.motion
    return {
        **compared,
        **row,
        "remarks": one.response.all_remarks,
        "pga_m_s2": M_PER_S2.shown(motion.peak_acceleration),
        "scaled_record_sha256": motion.digest,
        "record_origin": asdict(motion.origin),
        "record_treatment": list(motion.treatment),
        "energies": Table(tuple(results.ENERGIES), [one.response.energy]).objects()[0],
        "checks": [
            {"of": check.of, **{one.key: one.datum(check) for one in COLUMNS if one.stored}}
            for check in results.checks_of(one)
        ],
    }
