"""What a command has found, and where it goes: standard output as text or JSON, a file of data, a figure."""

import argparse
import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from dcfp.files import FIGURE_EXTENSIONS, check_outputs, known_extension, whole_files

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dcfp.doors.cli.console import Page


@dataclass(frozen=True)
class Answer:
    """What a command has found, in the forms that it may be asked for; each is made when it is wanted.

    Attributes
    ----------
    document
        What ``--json`` prints.
    page
        What is printed otherwise.
    data
        Writes the file of ``--out``: its path for now, and its format such as ``".csv"``; or returns its text.
    figure
        Draws the figure of ``--plot``.
    status
        Exit status.
    """

    document: Callable[[], Any]
    page: "Callable[[], Page]"
    data: Callable[[Path, str], str | None] | None = None
    figure: "Callable[[], Figure] | None" = None
    status: int = 0


@dataclass(frozen=True)
class Outputs:
    """The files that a command writes.

    Attributes
    ----------
    data, figure
        None where it is not wanted.
    overwrite
        Whether files may be there already.
    """

    data: Path | None
    figure: Path | None
    overwrite: bool

    @classmethod
    def checked(cls, chosen: argparse.Namespace) -> "Outputs":
        """Return the outputs of a command's options ``--out``, ``--plot`` and ``--overwrite`` once it is known that each can be written in a known format.

        Raises
        ------
        InputError
            If not, or if one of them is a file that the command reads.
        """
        data, figure = getattr(chosen, "out", None), getattr(chosen, "plot", None)
        outputs = cls(
            known_extension(data, chosen.kinds, chosen.noun) if data is not None else None,
            known_extension(figure, FIGURE_EXTENSIONS, "a figure") if figure is not None else None,
            getattr(chosen, "overwrite", False),
        )
        check_outputs(outputs.paths, overwrite=outputs.overwrite, inputs=_inputs(chosen))
        return outputs

    @property
    def paths(self) -> list[Path]:
        """Every file that is wanted."""
        return [path for path in (self.data, self.figure) if path is not None]

    def write(self, answer: Answer) -> None:
        """Write every file that is wanted, or leave all files as they were."""
        writers: list[Callable[[Path], None]] = []
        if self.data is not None:
            writers.append(lambda part: _write_data(answer, part, cast("Path", self.data).suffix.lower()))
        if self.figure is not None:
            writers.append(lambda part: _write_figure(answer, part, cast("Path", self.figure).suffix.lower()))
        with whole_files(self.paths, overwrite=self.overwrite) as parts:
            for writer, part in zip(writers, parts, strict=True):
                writer(part)


def deliver(answer: Answer | None, outputs: Outputs, said: Callable[[str], str], *, as_json: bool) -> int:
    """Write and print what a command has found; return the exit status.

    Parameters
    ----------
    answer
        None where there is nothing to say.
    outputs
        The files that are wanted.
    said
        Puts the sentences of a text in the words of the command line; a document is for any reader.
    as_json
        Whether one document is printed instead of text.
    """
    if answer is None:
        return 0
    outputs.write(answer)
    if as_json:
        print(json.dumps(answer.document(), indent=2, allow_nan=False))
    else:
        answer.page().show(said)
    return answer.status


def _inputs(chosen: argparse.Namespace) -> Iterator[Path]:
    """Give every word of a command that may be the name of a file that it reads, alone or in ``FILE::COMPONENT`` and ``NAME=FILE``."""
    for name, value in vars(chosen).items():
        if name in ("out", "plot"):
            continue
        for word in cast("list[Any]", value) if isinstance(value, list) else [value]:
            if isinstance(word, str):
                file = word.rpartition("::")[0] or word
                yield Path(word)
                yield Path(file.partition("=")[2] or file)


def _write_data(answer: Answer, part: Path, kind: str) -> None:
    assert answer.data is not None
    text = answer.data(part, kind)
    if text is not None:
        part.write_text(text, encoding="utf-8", newline="\n")


def _write_figure(answer: Answer, part: Path, kind: str) -> None:
    from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

    assert answer.figure is not None
    save_figure(answer.figure(), part, kind.removeprefix("."))
