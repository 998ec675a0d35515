"""The formats of record files, each registered by its module; and which of them a file is in."""

from collections.abc import Callable
from dataclasses import dataclass

from dcfp.motion.formats.component import Component, Series, component_of
from dcfp.motion.formats.numbers import unit_size
from dcfp.motion.formats.source import SourceText
from dcfp.schema.registry import Registry


@dataclass(frozen=True)
class RecordFormat:
    """A format of record files.

    Attributes
    ----------
    words
        Whose files are in it, and what is in them.
    recognises
        Whether a file is in it, from its content.
    read
        Returns every component of such a file. It raises an `InputError` where the file is damaged: where its header is incomplete, or
        does not agree with the values.
    citation
        How its data ask to be cited; empty when nothing is asked.
    one_of_several
        Whether the components of a record may be in files of the same stem, so that the name of a motion says which it is.
    """

    words: str
    recognises: Callable[[SourceText], bool]
    read: Callable[[SourceText], list[Series]]
    citation: str = ""
    one_of_several: bool = False


#: The formats by their names.
FORMATS: Registry[RecordFormat] = Registry("record format")
#: What a file is in that no format recognises.
PLAIN = "plain columns"


def read_components(source: SourceText) -> list[Component]:
    """Return every component of a record file.

    Raises
    ------
    InputError
        If the file is in no known format or damaged, or contradicts what the user says of it.
    """
    name = next((name for name, one in FORMATS.items() if one.recognises(source)), PLAIN)
    form = FORMATS[name]
    found = form.read(source)
    for series in found:
        _check_agreement(source, name, series)
    several = form.one_of_several or len(found) > 1
    return [
        component_of(source, series, name, series.citation or form.citation, several=several)
        for series in found
    ]


def _check_agreement(source: SourceText, name: str, series: Series) -> None:
    if source.units is not None and unit_size(source.units) != unit_size(series.unit):
        source.fail(f"the {name} file states its own unit, {series.unit}; leave out units={source.units!r}.")
    stated, given = series.time_step, source.time_step
    if given is not None and abs(given - stated) > 1e-6 * stated:
        source.fail(f"the {name} file states its own time step, {stated:g} s; leave out {given!r}.")
