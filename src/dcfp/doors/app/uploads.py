"""Records that a visitor sends: read from memory, within limits."""

import re
from dataclasses import dataclass
from pathlib import PurePosixPath

from dcfp.errors import InputError
from dcfp.motion.ground_motion import LONGEST_TAIL, GroundMotion
from dcfp.motion.load import motions_of

#: Largest file [bytes], most files and most components that one visitor can have.
LARGEST_FILE, MOST_FILES, MOST_COMPONENTS = 20_000_000, 12, 36
#: Most time steps of an analysis with the rest after the record: what a page can be kept waiting for.
MOST_STEPS = 1_000_000
_LONGEST_NAME = 80


@dataclass(frozen=True, eq=False)
class Upload:
    """One component of a file.

    Attributes
    ----------
    motion
        As it is in the file.
    file
        Name by which a scenario finds it beside itself, with ``::COMPONENT`` where the file holds several.
    options
        How a plain file is read, for the scenario.
    """

    motion: GroundMotion
    file: str
    options: dict[str, str | float]


def read_upload(
    content: bytes, name: str, *, units: str | None = None, time_step: float | None = None
) -> list[Upload]:
    """Return the components of a file that was sent.

    Parameters
    ----------
    content
        Of the file.
    name
        What its sender calls it; used in words only.
    units, time_step
        As for `dcfp.motion.load.read_motions`.

    Raises
    ------
    InputError
        If it is too large, or no record.
    """
    shown = plain_name(name)
    if len(content) > LARGEST_FILE:
        raise InputError(too_large(shown))
    motions = motions_of(content, shown, units=units, time_step=time_step)
    for motion in motions:
        steps = motion.acceleration.size + LONGEST_TAIL / motion.time_step
        if steps > MOST_STEPS:
            msg = (
                f"{shown}: with a time step of {motion.time_step:g} s this record is too long for the page, which takes"
                f" {MOST_STEPS:,} steps; analyse it with dcfp respond."
            )
            raise InputError(msg)
    options: dict[str, str | float] = {}
    if units is not None:
        options["units"] = units
    if time_step is not None:
        options["time_step"] = time_step
    several = len(motions) > 1
    return [
        Upload(motion, f"{shown}::{motion.origin.component}" if several else shown, options)
        for motion in motions
    ]


def plain_name(name: str) -> str:
    """Return the last part of a file's name without control characters, shortened; never empty."""
    last = PurePosixPath(name.replace("\\", "/")).name
    clean = "".join(letter for letter in last if letter.isprintable()).strip()
    clean = re.sub(r"\s+", " ", clean).lstrip(".") or "record"
    return clean if len(clean) <= _LONGEST_NAME else f"{clean[: _LONGEST_NAME - 9]}…{clean[-8:]}"


def too_large(name: str) -> str:
    """Return what is said of a file that is too large."""
    return (
        f"{plain_name(name)}: the file is larger than {LARGEST_FILE / 1e6:.0f} MB, so it is not one record."
    )
