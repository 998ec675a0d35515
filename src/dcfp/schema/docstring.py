"""Sections of parameters in docstrings, completed from the declarations: by hand stands only what these do not say."""

import inspect
import re
from collections.abc import Mapping

#: The section, and where else it would stand: before the first section of another name, or at the end.
_SECTION = re.compile(r"\n\nParameters\n-+\n(?P<body>.*?)(?=\n\n[A-Z]\w*\n-+\n|\Z)", re.DOTALL)
_OTHER = re.compile(r"\n\n[A-Z]\w*\n-+\n")
#: A parameter: its names on one line, words on deeper ones.
_ENTRY = re.compile(r"^(?P<names>\w+(?:, \w+)*)(?: :[^\n]*)?\n(?P<words>(?:    .*(?:\n|$))+)", re.MULTILINE)


def with_parameters(doc: str, known: Mapping[str, str | None]) -> str:
    """Return a docstring with an entry for each parameter.

    Parameters
    ----------
    doc
        As it is written.
    known
        All fields in their order, each with a sentence that stands where the docstring has no entry of its own; None for none.
    """
    text = inspect.cleandoc(doc)
    section = _SECTION.search(text)
    written = {
        name: entry
        for entry in _ENTRY.finditer(section["body"] if section else "")
        for name in entry["names"].split(", ")
    }
    lines = [one.group().rstrip() for name, one in written.items() if name not in known]
    for name, sentence in known.items():
        if name in written:
            entry = written[name].group().rstrip()
            lines += [entry] if entry not in lines else []
        elif sentence is not None:
            lines.append(f"{name}\n    {sentence}")
    if not lines:
        return text
    whole = "\n\nParameters\n----------\n" + "\n".join(lines)
    if section is not None:
        return text[: section.start()] + whole + text[section.end() :]
    place = min((found.start() for found in _OTHER.finditer(text)), default=len(text))
    return text[:place] + whole + text[place:]
