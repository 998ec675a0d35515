"""What belongs to one visitor."""

from dataclasses import dataclass, field
from functools import cache

from dcfp.doors.app.forms import BearingForm
from dcfp.doors.app.units import Units
from dcfp.doors.app.uploads import MOST_COMPONENTS, MOST_FILES, Upload
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import named_motion, named_records

#: Before the key of a record that was sent.
_SENT = "sent-"


@cache
def named_choices() -> dict[str, str]:
    """Return the named records that come with the package, in words: the paper's first."""
    rows = [row for row in named_records() if row.available]
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
        return self.sent[key].motion if key in self.sent else named_motion(key)

    def file_of(self, key: str) -> str:
        """Return how a scenario names a record."""
        return self.sent[key].file if key in self.sent else key
