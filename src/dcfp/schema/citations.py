"""The bibliography, ``references.bib``, and one line for each entry of it."""

import re
from functools import cache
from importlib.resources import files

_ENTRY = re.compile(r"@\w+\{(?P<key>[^,]+),(?P<body>.*?)\n\}", re.DOTALL)
_FIELD = re.compile(r"(?P<name>\w+)\s*=\s*\{(?P<value>.*)\},?\s*$", re.MULTILINE)


@cache
def bibliography() -> dict[str, dict[str, str]]:
    """Return every reference by its key."""
    text = files("dcfp.schema").joinpath("references.bib").read_text(encoding="utf-8")
    return {
        entry["key"]: {
            field["name"]: re.sub(r"[{}]", "", field["value"]) for field in _FIELD.finditer(entry["body"])
        }
        for entry in _ENTRY.finditer(text)
    }


def citation(key: str) -> str:
    """Return one reference as a line: authors, year, title, journal or publisher, and its DOI if it has one."""
    entry = bibliography()[key]
    place = entry.get("journal", entry.get("howpublished"))
    authors = " & ".join(name.split(",")[0].strip() for name in entry["author"].split(" and "))
    line = f"{authors} ({entry['year']}). {entry['title']}. {place}."
    return f"{line} doi:{entry['doi']}" if "doi" in entry else line


def citations_of(*keys: str) -> tuple[str, ...]:
    """Return the references of those keys that are not empty, each once."""
    return tuple(citation(key) for key in dict.fromkeys(keys) if key)


def full_citation(key: str) -> str:
    """Return a reference as a line with its volume, number and pages, as far as the bibliography has them."""
    entry = bibliography()[key]
    number = f"({entry['number']})" if "number" in entry else ""
    places = [f"{entry['volume']}{number}"] if "volume" in entry else []
    places += [entry["pages"].replace("--", "–")] if "pages" in entry else []
    before, mark, doi = citation(key).partition(" doi:")
    return f"{', '.join((before.removesuffix('.'), *places))}.{mark}{doi}"


def source_of(key: str) -> str:
    """Return authors and year of an entry of the bibliography, as they stand beside a formula."""
    if key not in bibliography():
        return "law of the scenario"
    entry = bibliography()[key]
    authors = [name.split(",")[0].strip() for name in entry["author"].split(" and ")]
    who = f"{authors[0]} et al." if len(authors) > 2 else " and ".join(authors)
    return f"{who} ({entry['year']})"
