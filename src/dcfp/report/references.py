"""The sources that a calculation rests on."""

from dcfp.citations import bibliography
from dcfp.scenario import Calculation

#: Of the codes, as far as the bibliography has them.
_OF_CODES = ("asce_7_2016",)


def citation_keys(calculation: Calculation) -> tuple[str, ...]:
    """Return the keys of the bibliography that a report cites."""
    codes = _OF_CODES if any(one.case.answers for one in calculation.results) else ()
    return tuple(dict.fromkeys(("li_2020", calculation.scenario.model.friction.citation, *codes)))


def record_citations(calculation: Calculation) -> tuple[str, ...]:
    """Return how the data of the records ask to be cited, each once."""
    asked = (motion.origin.citation for motion in calculation.scenario.study.motions)
    return tuple(dict.fromkeys(words for words in asked if words))


def source_of(key: str) -> str:
    """Return authors and year of an entry of the bibliography, as they stand beside a formula."""
    if key not in bibliography():
        return "law of the scenario"
    entry = bibliography()[key]
    authors = [name.split(",")[0].strip() for name in entry["author"].split(" and ")]
    who = f"{authors[0]} et al." if len(authors) > 2 else " and ".join(authors)
    return f"{who} ({entry['year']})"
