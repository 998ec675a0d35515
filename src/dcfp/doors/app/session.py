"""What belongs to one visitor: what is chosen, and records that are sent, read from memory, within limits."""

import re
from dataclasses import dataclass, field
from functools import cache
from pathlib import PurePosixPath

from dcfp.doors.app.forms import BearingForm
from dcfp.doors.app.units import Units
from dcfp.errors import InputError
from dcfp.motion.ground_motion import LONGEST_TAIL, GroundMotion
from dcfp.motion.load import motions_of
from dcfp.motion.named import named_motion, named_records

# Records that a visitor sends: read from memory, within limits.


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
    """Return the components of a file that was sent, with the name that its sender gave it; `units` and `time_step` are as for `dcfp.motion.load.read_motions`.

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
                f" {MOST_STEPS:,} steps; analyse it in Python or on the command line."
            )
            raise InputError(msg)
    given = {"units": units, "time_step": time_step}
    options = {name: value for name, value in given.items() if value is not None}
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


#: Before the key of a record that was sent.
_SENT = "sent-"


#: Records that come with the package stay in memory, for every change of a field analyses one anew.
_named = cache(named_motion)


@cache
def named_choices() -> dict[str, str]:
    """Return the named records that come with the package, in words: the paper's first."""
    rows = [row for row in named_records() if row.motion is not None]
    rows.sort(key=lambda row: not row.alias)
    return {
        row.alias or row.name: f"{row.alias or row.name} · {row.event} {row.year}, {row.station}"
        for row in rows
    }


@dataclass
class Session:
    """The state of one page.

    Attributes
    ----------
    bearing
        The fields of the bearing.
    units
        In which results are shown.
    sent
        Records that were sent, by key.
    files
        Number of files that they came in.
    chosen
        Keys of the records that are analysed.
    pgv
        PGV to which they are scaled [m/s].
    as_recorded
        Whether they are used as they are instead.
    baseline, corner
        How records are treated; the corner of a high-pass filter [Hz], or None.
    """

    bearing: BearingForm = field(default_factory=BearingForm)
    units: Units = field(default_factory=Units)
    sent: dict[str, Upload] = field(default_factory=dict[str, Upload])
    files: int = 0
    chosen: list[str] = field(default_factory=lambda: ["NCC"])
    pgv: float = 0.5
    as_recorded: bool = False
    baseline: bool = False
    corner: float | None = None

    def take(self, uploads: list[Upload]) -> list[str]:
        """Keep the records of one more file, and return their keys.

        Raises
        ------
        InputError
            If there are too many.
        """
        self.refuse_more_files()
        if len(self.sent) + len(uploads) > MOST_COMPONENTS:
            msg = (
                f"The page keeps at most {MOST_COMPONENTS} components of your files; reload it to begin anew."
            )
            raise InputError(msg)
        self.files += 1
        first = len(self.sent) + 1
        keys = [f"{_SENT}{number}" for number in range(first, first + len(uploads))]
        self.sent |= zip(keys, uploads, strict=True)
        return keys

    def refuse_more_files(self) -> None:
        """Refuse another file where there are too many.

        Raises
        ------
        InputError
            If so.
        """
        if self.files >= MOST_FILES:
            msg = f"The page keeps at most {MOST_FILES} of your files; reload it to begin anew."
            raise InputError(msg)

    def choices(self) -> dict[str, str]:
        """Return every record that can be chosen, in words: those that were sent first."""
        own = {key: f"{one.motion.name} · your file" for key, one in self.sent.items()}
        return own | named_choices()

    def motion(self, key: str) -> GroundMotion:
        """Return a record as it is."""
        return self.sent[key].motion if key in self.sent else _named(key)

    def file_of(self, key: str) -> str:
        """Return how a scenario names a record."""
        return self.sent[key].file if key in self.sent else key
