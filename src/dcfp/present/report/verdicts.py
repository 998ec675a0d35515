"""Verdicts: all of them in tables, and what they come to on the first page."""

from collections.abc import Sequence

from dcfp.present.report.document import (
    Block,
    Cell,
    Maths,
    Section,
    Table,
    Tone,
    cells,
    heads,
    short,
    words,
    written,
)
from dcfp.present.report.references import ANALYSIS, checks_of, label_of
from dcfp.present.report.results import peaks_table
from dcfp.present.report.worked import governing
from dcfp.schema.check import Check, Verdict
from dcfp.study.scenario import Calculation

#: Cases beside each other in a table.
_BESIDE = 4
#: Cases that are named in a line of the first page.
_NAMED = 3
#: Cases whose peaks stand on the first page.
_FEW = 4


def checks_section(calculation: Calculation) -> Section:
    """Return every check of every case, in a section for the analyses and one for each code."""
    labels = [label_of(one) for one in calculation.results]
    every = [checks_of(one) for one in calculation.results]
    groups = list(dict.fromkeys(check.of for checks in every for check in checks))
    parts: list[Section] = []
    for group in groups:
        rows = _rows(every, group)
        title = "Analyses" if group == ANALYSIS else f"Conditions of {group}"
        tables = [_table(rows, [labels[i] for i in places], list(places)) for places in _batches(len(labels))]
        parts.append(Section(title, tuple(tables)))
    note = words(
        "Met, not met, or not known where the scenario does not say what a condition asks for. A clause that is called unconfirmed could not be read in the code"
        " itself and stands as other sources have it.",
        tone=Tone.NOTE,
    )
    return Section("Checks", (note,), tuple(parts), on_new_page=True)


def _batches(count: int) -> list[tuple[int, ...]]:
    return [tuple(range(first, min(first + _BESIDE, count))) for first in range(0, count, _BESIDE)]


def _rows(every: Sequence[Sequence[Check]], group: str) -> dict[str, list[Check | None]]:
    """Return the conditions of a group by their names, one for each case."""
    of_case = [{one.name: one for one in checks if one.of == group} for checks in every]
    names = list(dict.fromkeys(name for known in of_case for name in known))
    return {name: [known.get(name) for known in of_case] for name in names}


def _table(rows: dict[str, list[Check | None]], labels: list[str], places: list[int]) -> Table:
    made: list[tuple[Cell, ...]] = []
    for name, of_case in rows.items():
        here = [of_case[place] for place in places]
        first = next((one for one in here if one is not None), None)
        if first is None:
            continue
        if len({one.limit for one in here if one}) > 1:
            msg = f"the limit of {name!r} depends on the case; it belongs to what was found."
            raise ValueError(msg)
        source = first.source if first.confirmed else f"{first.source} (unconfirmed)"
        same = len({(one.found, one.verdict) if one else None for one in here}) == 1
        found = (_found(first, len(here)),) if same else tuple(_found(one) for one in here)
        made.append((*cells(name, first.limit_words, source), *found))
    head = heads("Check", "Limit", "Source or clause", *labels)
    count = len(places)
    return Table(
        head, tuple(made), "lll" + "l" * count, (2.2, 2.0, 1.6, *[1.15 if count > 1 else 1.8] * count)
    )


def _found(one: Check | None, span: int = 1) -> Cell:
    if one is None:
        return Cell(("no answer",), Verdict.NOT_KNOWN, span)
    return Cell((f"{one.found_words}: {one.verdict}",), one.verdict, span)


def front_blocks(calculation: Calculation) -> tuple[Block, ...]:
    """Return the verdicts in short: the displacement, and a line for each check of the analyses and for each code."""
    few = len(calculation.results) <= _FEW
    peaks = (peaks_table(calculation),) if few else ()
    return (_headline(calculation), *peaks, _summary(calculation), _codes_summary(calculation))


def _headline(calculation: Calculation) -> Block:
    worst = governing(calculation)
    found = worst.response.peak_displacement
    capacity = calculation.scenario.model.bearing.displacement_capacity
    count = len(calculation.results)
    among = f", the largest displacement of {count} cases" if count > 1 else ""
    start = ("Largest displacement ", Maths('y_"max"'), f" = {written('y_max_mm', found)} mm under {label_of(worst)}{among}. ")  # fmt: skip
    if capacity is None:
        return words(*start, "No capacity is given.", tone=Tone.OPEN)
    beyond = sum(one.response.peak_displacement > capacity for one in calculation.results)
    if beyond:
        where = f" in {beyond} of them" if count > 1 else ""
        end = f"The capacity of {short(capacity)} mm is exceeded{where}."
        return words(*start, end, tone=Tone.BAD)
    return words(*start, f"The capacity of {short(capacity)} mm is not exceeded.", tone=Tone.GOOD)


def _summary(calculation: Calculation) -> Table:
    labels = [label_of(one) for one in calculation.results]
    rows: list[tuple[Cell, ...]] = []
    for name, of_case in _rows([checks_of(one) for one in calculation.results], ANALYSIS).items():
        known = [(label, one) for label, one in zip(labels, of_case, strict=True) if one is not None]
        verdict = _worst([one for _, one in known])
        rows.append((*cells(name), Cell((_count(known, verdict),), verdict), *cells(_where(known, verdict))))
    return Table(heads("Check of the analyses", "Verdict", "Where, and what is allowed"), tuple(rows), "lll", (2.2, 1.3, 2.8), "Verdicts")  # fmt: skip


def _worst(conditions: Sequence[Check]) -> Verdict:
    verdicts = {one.verdict for one in conditions}
    return next(one for one in (Verdict.NOT_MET, Verdict.NOT_KNOWN, Verdict.MET) if one in verdicts)


def _count(known: list[tuple[str, Check]], verdict: Verdict) -> str:
    count = sum(one.verdict is verdict for _, one in known)
    return verdict.value if count == len(known) else f"{verdict} in {count} of {len(known)}"


def _where(known: list[tuple[str, Check]], verdict: Verdict) -> str:
    concerned = [(label, one) for label, one in known if one.verdict is verdict]
    limit = concerned[0][1].limit_words
    if verdict is not Verdict.NOT_MET:
        return limit
    named = "; ".join(f"{label}: {one.found_words}" for label, one in concerned[:_NAMED])
    more = len(concerned) - _NAMED
    return f"{named}{f'; and {more} more' if more > 0 else ''} ({limit})"


def _codes_summary(calculation: Calculation) -> Block:
    rows: list[tuple[Cell, ...]] = []
    answers = [one.case.codes for one in calculation.results]
    for name in dict.fromkeys(name for known in answers for name in known):
        said = [known[name] for known in answers if name in known]
        inside, outside = sum(one.valid is True for one in said), sum(one.valid is False for one in said)
        broken: dict[str, int] = {}
        for one in said:
            for condition in one.conditions:
                if condition.verdict is Verdict.NOT_MET:
                    broken[condition.name] = broken.get(condition.name, 0) + 1
        if not any(one.conditions for one in said):
            verdict, text = Verdict.NOT_KNOWN, "no limits known"
        elif outside:
            verdict, text = Verdict.NOT_MET, f"no, in {outside} of {len(said)}"
        else:
            verdict = Verdict.MET if inside == len(said) else Verdict.NOT_KNOWN
            text = "yes" if verdict is Verdict.MET else "conditions not known"
        below = sum(
            one.response.peak_displacement > known[name].displacement
            for one, known in zip(calculation.results, answers, strict=True)
            if name in known
        )
        why = ", ".join(f"{condition} ({count})" for condition, count in broken.items()) or "–"
        rows.append(
            (
                *cells(name),
                Cell((text,), verdict),
                *cells(f"{below} of {len(said)}", why),
            )
        )
    if not rows:
        return words("No method of a code has an answer.", tone=Tone.NOTE)
    return Table(heads("Code", "May be used", "Below the analysis", "Conditions not met (cases)"), tuple(rows), "llll", (1.4, 1.3, 1.0, 2.6))  # fmt: skip
