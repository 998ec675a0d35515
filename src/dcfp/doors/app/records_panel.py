"""The fields of the records: which, from which files, how treated and how strong."""

import asyncio
from collections.abc import Callable
from functools import partial
from typing import Any

from nicegui import ui
from nicegui.events import UploadEventArguments

from dcfp.doors.app.elements import FileDrop, Slider, Text
from dcfp.doors.app.fields import Alert, card, choice_field, more, parameter_field, switch_field
from dcfp.doors.app.session import LARGEST_FILE, MOST_FILES, Session, read_upload, too_large
from dcfp.errors import InputError
from dcfp.motion.formats.registry import FORMATS
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import HERTZ, SECOND

#: Most records that are analysed together.
MOST_CHOSEN = 8
_PGVS = (0.05, 1.5)
_CORNER = Parameter("high-pass filter, corner", HERTZ, step=0.01, absent="none", optional=True)
_TIME_STEP = Parameter("time step of one column", SECOND, step=0.005, absent="in the file", optional=True)
_UNITS = {"": "as the file says", **{unit: unit for unit in ("mm/s2", "cm/s2", "gal", "m/s2", "g")}}


def upload_words() -> str:
    """Return what is said of the files that may be sent."""
    return f"or drop them here: {', '.join(FORMATS)}; up to {MOST_FILES} of {LARGEST_FILE / 1e6:.0f} MB"


class RecordsPanel:
    """The fields of the records that a session holds; `changed` is called when one of them has changed."""

    def __init__(self, session: Session, changed: Callable[[], None]) -> None:
        self._session, self._changed = session, changed
        self._read: dict[str, Any] = {"units": None, "time_step": None}
        put: Any = partial(partial, self._put)
        read_as: Any = partial(partial, self._read_as)
        with card("Ground motion"):
            self._records = choice_field(
                "Records", session.choices(), session.chosen, self._choose, several=True, search=True
            )
            self._drop = FileDrop(
                upload_words(),
                LARGEST_FILE,
                on_upload=self._take,
            )
            self._drop.on("too_large", lambda event: self._alert.say(too_large(str(event.args))))
            self._drop.on(
                "refused",
                lambda event: self._alert.say(f"{str(event.args)[:80]}: the file could not be sent."),
            )
            self._alert = Alert()
            self._pgv = Slider("PGV of every record", "m/s", 2, session.pgv, _PGVS, 0.01, put("pgv"))
            switch_field("As recorded, not scaled", session.as_recorded, put("as_recorded"))
            with more("Treatment and plain files"):
                switch_field("Remove a linear baseline in velocity", session.baseline, put("baseline"))
                parameter_field(_CORNER, session.corner, put("corner"))
                with ui.element("div").classes("pair"):
                    choice_field("Unit of plain columns", _UNITS, "", read_as("units"))
                    parameter_field(_TIME_STEP, None, read_as("time_step"))
                Text("p", "K-NET, KiK-net and JMA files are raw: filter them at 0.05 Hz before trusting a PGV.").classes("note")  # fmt: skip

    def _choose(self, keys: Any) -> None:
        chosen = [str(key) for key in keys or ()]
        if len(chosen) > MOST_CHOSEN:
            self._alert.say(
                f"The page analyses at most {MOST_CHOSEN} records at a time; for more there are studies in Python and on the command line."
            )
            self._records.value = chosen[:MOST_CHOSEN]
            return
        if chosen != self._session.chosen:
            self._session.chosen = chosen
            self._changed()

    async def _take(self, event: UploadEventArguments) -> None:
        session, file = self._session, event.file
        try:
            session.refuse_more_files()
            if file.size() > LARGEST_FILE:
                raise InputError(too_large(file.name))
            content = await file.read()
            uploads = await asyncio.to_thread(read_upload, content, file.name, **self._read)
            keys = session.take(uploads)
        except InputError as error:
            self._alert.say(str(error))
            return
        self._alert.say("")
        self._records.set_options(session.choices(), value=keys[:1])

    def _put(self, name: str, value: Any) -> None:
        """Put a value into the session, and say so where the records are other ones by it."""
        setattr(self._session, name, value)
        if name == "as_recorded":
            self._pgv.set_off(value)
        if name != "pgv" or not self._session.as_recorded:
            self._changed()

    def _read_as(self, name: str, value: Any) -> None:
        """Say how plain files are read that are sent from now on."""
        self._read[name] = value or None
