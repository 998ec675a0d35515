"""Which format a file is in, and its components."""

from collections.abc import Callable

from dcfp.record.formats import peer
from dcfp.record.formats.component import Component
from dcfp.record.formats.source import SourceText
from dcfp.record.formats.units import unit_size

Recogniser = Callable[[SourceText], bool]
Reader = Callable[[SourceText], list[Component]]

#: The formats that state their own unit and time step, the most distinctive headers first.
FORMATS: tuple[tuple[str, Recogniser, Reader], ...] = (
    (peer.NAME, peer.recognises, peer.read),
)


def read_components(
    source: SourceText, *, units: str | None = None, time_step: float | None = None
) -> list[Component]:
    """Return every component of a record file.

    Raises
    ------
    InputError
        If the file is in no known format or damaged, or `units` or `time_step` contradict it.
    """
    for name, recognises, read in FORMATS:
        if recognises(source):
            components = read(source)
            for component in components:
                _check_agreement(source, name, component, units, time_step)
            return components
    return source.fail("the file is in none of the known record formats.")


def _check_agreement(
    source: SourceText, name: str, component: Component, units: str | None, time_step: float | None
) -> None:
    if units is not None and unit_size(units) != unit_size(component.unit):
        source.fail(f"the file is {name} and states its own unit, {component.unit}; leave out units={units!r}.")
    stated = component.motion.time_step
    if time_step is not None and abs(time_step - stated) > 1e-6 * stated:
        source.fail(
            f"the file is {name} and states its own time step, {stated:g} s; leave out time_step={time_step!r}."
        )
