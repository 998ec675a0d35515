"""The sources that a calculation rests on."""

from dcfp.methods import aij_2016, asce_2016, eurocode_8, iwan_1980
from dcfp.schema.citations import bibliography, citation
from dcfp.study.scenario import Calculation

#: What the formulas and conditions of each method of a code cite.
_OF_CODES = {
    asce_2016.NAME: ("asce_7_2016",),
    eurocode_8.NAME: ("en_1998_1_2004", "en_1998_2_2005"),
    aij_2016.METHOD_1: ("aij_2016",),
    aij_2016.METHOD_2: ("aij_2016",),
    aij_2016.ENERGY_BALANCE: ("aij_2016", "akiyama_1985"),
    iwan_1980.NAME: ("iwan_1980", "hadjian_1982"),
}
#: What the checks of every analysis cite.
_OF_CHECKS = ("fema_p695_2009",)


def citation_keys(calculation: Calculation) -> tuple[str, ...]:
    """Return the keys of the bibliography that a report cites."""
    used = {name for one in calculation.results for name in one.case.answers}
    codes = [key for name, keys in _OF_CODES.items() if name in used for key in keys]
    law = calculation.scenario.model.friction.citation
    return tuple(dict.fromkeys(key for key in ("li_2020", law, *codes, *_OF_CHECKS) if key))


def sources_of(calculation: Calculation) -> tuple[str, ...]:
    """Return the references that a report cites, each as a line."""
    return tuple(full_citation(key) for key in citation_keys(calculation))


def full_citation(key: str) -> str:
    """Return a reference as a line with its volume, number and pages, as far as the bibliography has them."""
    entry = bibliography()[key]
    number = f"({entry['number']})" if "number" in entry else ""
    places = [f"{entry['volume']}{number}"] if "volume" in entry else []
    places += [entry["pages"].replace("--", "–")] if "pages" in entry else []
    before, mark, doi = citation(key).partition(" doi:")
    return f"{', '.join((before.removesuffix('.'), *places))}.{mark}{doi}"


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
