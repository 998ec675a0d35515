"""A report from a calculation."""

from dcfp.errors import InputError
from dcfp.kernels._jit import source_digest
from dcfp.motion.measures import motion_remarks
from dcfp.present.report.document import Block, Bullets, Code, Document, Listing, Section, Table, cells, words
from dcfp.present.report.inputs import inputs_section
from dcfp.present.report.references import numbers_of, record_citations, sources_of, versions
from dcfp.present.report.results import methods_section, results_section
from dcfp.present.report.verdicts import checks_section, front_blocks
from dcfp.present.report.worked import worked_out
from dcfp.study.scenario import Calculation
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


# What a reader must know besides the numbers: remarks, limits, sources, provenance, and the scenario
# itself.


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
