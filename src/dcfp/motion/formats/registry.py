"""Which format a file is in, and its components."""

from collections.abc import Callable

from dcfp.motion.formats import cosmos, csmip, cwb, esm, jma, kyoshin, peer, plain
from dcfp.motion.formats.component import Component, unit_size
from dcfp.motion.formats.source import SourceText

Recogniser = Callable[[SourceText], bool]
Reader = Callable[[SourceText], list[Component]]

#: The formats that state their own unit and time step, the most distinctive headers first.
FORMATS: tuple[tuple[str, Recogniser, Reader], ...] = (
    (cosmos.NAME, cosmos.recognises, cosmos.read),
    (csmip.NAME, csmip.recognises, csmip.read),
    (esm.NAME, esm.recognises, esm.read),
    (jma.NAME, jma.recognises, jma.read),
    (cwb.NAME, cwb.recognises, cwb.read),
    (kyoshin.NAME, kyoshin.recognises, kyoshin.read),
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
    return plain.read(source, units, time_step)


def _check_agreement(
    source: SourceText, name: str, component: Component, units: str | None, time_step: float | None
) -> None:
    if units is not None and unit_size(units) != unit_size(component.unit):
        source.fail(f"the {name} file states its own unit, {component.unit}; leave out units={units!r}.")
    stated = component.motion.time_step
    if time_step is not None and abs(time_step - stated) > 1e-6 * stated:
        source.fail(f"the {name} file states its own time step, {stated:g} s; leave out {time_step!r}.")
