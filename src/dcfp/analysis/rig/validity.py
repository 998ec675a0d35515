"""Whether a virtual test stayed within what the model assumes."""

from typing import TYPE_CHECKING

from dcfp.kernels.drive import TEMPERATURE
from dcfp.system.plates import memory_of
from dcfp.system.validity import History, assumption_remarks

if TYPE_CHECKING:
    from dcfp.analysis.rig.loops import Loops


def validity_remarks(loops: "Loops") -> list[str]:
    """Return a sentence for each assumption that a test left."""
    duration = loops.begins + float(loops.time[-1])
    return assumption_remarks(
        History(
            name=loops.test.name,
            bearing=loops.bearing,
            friction_law=loops.friction_law,
            heating=loops.heating,
            velocity=loops.velocity,
            friction=loops.friction,
            temperatures=loops.lines[:, TEMPERATURE:],
            slides=bool(loops.sliding.any()),
            load=loops.load,
            duration=duration,
            memory=memory_of(duration) * (1.0 + 1e-9),  # chosen for the whole story, up to a longest
            rests=loops.begins > 0.0,
        )
    )
