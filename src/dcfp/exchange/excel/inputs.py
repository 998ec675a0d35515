"""The sheet of inputs: bearing, friction law, heating model, ground motions."""

from typing import TYPE_CHECKING, cast

from dcfp.exchange.excel.sheet import COUNT, Head, Sheet
from dcfp.schema.citations import citations_of
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.schema.parameters import Declared
    from dcfp.study.scenario import Calculation
    from dcfp.system import Bearing


_HEADS = (Head("Quantity", width=40), Head("Value", width=22), Head("Unit", width=12))
_MOTIONS = (
    Head("Case", width=18),
    Head("Record", width=16),
    Head("PGV", "mm/s"),
    Head("PGA", "mm/s2"),
    Head("Time step", "s", number_format="0.0000"),
    Head("Values", number_format=COUNT),
    Head("Event", width=22),
    Head("Station", width=22),
    Head("Component", width=14),
    Head("Source", width=26),
    Head("Format", width=14),
    Head("Processing in the source", width=26),
    Head("Treatment", width=26),
    Head("SHA-256 of time step and acceleration", width=34),
)


def write_inputs(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write everything that the results come from."""
    model = calculation.scenario.model
    sheet.heading("Bearing")
    sheet.table(_HEADS, [*_constants(model.bearing), *_derived(model.bearing)])
    for title, part in (("Friction law", model.friction), ("Heating model", model.heating)):
        sheet.skip()
        sheet.heading(f"{title}: {part.name}")
        sheet.table(_HEADS, _constants(part))
    sheet.skip()
    nominal = calculation.nominal
    sheet.heading("Nominal coefficient for predictions and codes")
    sheet.table(_HEADS, [["mu_n", nominal.value, "–"]])
    sheet.note(f"From: {nominal.source}.")
    sheet.skip()
    sheet.heading("Ground motions as they shake the bearing")
    motions = [one.motion for one in calculation.results]
    rows = [[case, *_motion(motion)] for case, motion in zip(cases, motions, strict=True)]
    sheet.table(_MOTIONS, rows)
    for column, head in enumerate(_HEADS):  # the tables above need more room than that of the motions
        sheet.page.set_column(column, column, head.width)


def _constants(thing: "Declared") -> list[list[object]]:
    """Return words, value and unit of every parameter, in its declared unit."""
    rows: list[list[object]] = []
    for parameter, value in thing.rows():
        written = "not given" if value is None or value == "" else parameter.written(value)
        several = cast("list[object]", written) if isinstance(written, list) else [written]
        for number, one in enumerate(several, 1):
            label = f"{parameter.words} {number}" if len(several) > 1 else parameter.words
            rows.append([label, one, parameter.unit.name])
    return rows


def _derived(bearing: "Bearing") -> list[list[object]]:
    return [
        ["effective radius", bearing.effective_radius, "mm"],
        ["vertical force", bearing.vertical_force, "N"],
        ["mass", bearing.mass, "t"],
        ["restoring stiffness", bearing.restoring_stiffness, "N/mm"],
        ["period of the pendulum", bearing.period, "s"],
    ]


def _motion(motion: "GroundMotion") -> list[object]:
    origin = motion.origin
    return [
        motion.name,
        motion.peak_velocity,
        motion.peak_acceleration,
        motion.time_step,
        motion.acceleration.size,
        origin.event,
        origin.station,
        origin.component,
        origin.source,
        origin.file_format,
        origin.processing,
        "; ".join(motion.treatment) or "none",
        motion.digest,
    ]


# The sheet that says what made the workbook, and whom to cite.


_PROVENANCE_HEADS = (Head("What", width=26), Head("Which", width=100))


def write_provenance(sheet: Sheet, calculation: "Calculation") -> None:
    """Write version, settings, sources and the scenario itself."""
    study, model = calculation.scenario.study, calculation.scenario.model
    settings = study.settings
    records = {
        motion.origin.citation: None for motion in calculation.scenario.motions if motion.origin.citation
    }
    rows: list[list[object]] = [
        ["Made with", f"dcfp {version()}"],
        ["Longest step", "that of the record" if settings.step is None else f"{settings.step:g} s"],
        ["Tail", "until no more sliding can come" if settings.tail is None else f"{settings.tail:g} s"],
        ["Tolerance of the friction", settings.tolerance],
        *(["Citation", line] for line in citations_of(model.friction.citation, "li_2020")),
        *(["Citation of records", line] for line in records),
        *([["Scenario", study.text]] if study.text else []),
    ]
    sheet.heading("Provenance")
    sheet.skip()
    sheet.table(_PROVENANCE_HEADS, rows)
    sheet.skip()
    sheet.note(
        "Every number is as it was calculated; formats only say how many digits are shown. There are no formulas."
    )
