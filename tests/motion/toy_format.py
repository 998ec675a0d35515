"""A record format of one's own: a line that says so with the rate, then whole numbers in mm/s2."""

from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import SourceText, free_numbers


def _recognises(source: SourceText) -> bool:
    return source.lines[0].startswith("TOY ")


def _read(source: SourceText) -> list[Series]:
    rate, count = (int(word) for word in source.lines[0].split()[1:3])
    values = free_numbers(source, 1, count)
    return [Series(values, "mm/s2", 1.0 / rate, component="X", processing="none")]


TOY = RecordFormat("TOY", "nobody's: made for a test", _recognises, _read, "Toys Inc.")
