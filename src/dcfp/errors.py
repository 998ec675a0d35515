"""The two ways in which a call can fail, each with one sentence for the user."""


class DcfpError(Exception):
    """Root of every error that this package raises on purpose.

    Its text is one sentence that says what is wrong, where, and what would be right.
    """

    exit_status = 1


class InputError(DcfpError, ValueError):
    """The caller's input cannot be used: a file, a name, a number or a unit.

    Parameters
    ----------
    text
        The sentence.
    at
        Name of the value that is wrong, where several were checked together: a door may say where it was given.
    """

    exit_status = 2

    def __init__(self, text: str, *, at: str = "") -> None:
        super().__init__(text)
        self.at = at


class AnalysisError(DcfpError, RuntimeError):
    """The input was accepted, but the analysis could not be finished."""

    exit_status = 1
