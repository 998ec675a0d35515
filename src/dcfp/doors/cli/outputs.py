"""Where a command's results go besides standard output."""

import argparse
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.files import (
    DATA_EXTENSIONS,
    FIGURE_EXTENSIONS,
    check_outputs,
    known_extension,
    whole_files,
    write_data,
)

if TYPE_CHECKING:
    from dcfp.analysis import Response


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

    data: Path | None = None
    figure: Path | None = None
    overwrite: bool = False

    @classmethod
    def checked(
        cls,
        chosen: argparse.Namespace,
        reads: Iterable[Path] = (),
        data_extensions: tuple[str, ...] = DATA_EXTENSIONS,
    ) -> "Outputs":
        """Return the outputs of a command's options --out, --plot and --overwrite once it is known that each can be written in a known format.

        Parameters
        ----------
        chosen
            The options; a command may have no figure.
        reads
            Files that the command reads, and must not write over.
        data_extensions
            Formats of --out.

        Raises
        ------
        InputError
            If not.
        """
        data, figure = chosen.out, getattr(chosen, "plot", None)
        outputs = cls(
            known_extension(data, data_extensions, "data") if data is not None else None,
            known_extension(figure, FIGURE_EXTENSIONS, "a figure") if figure is not None else None,
            chosen.overwrite,
        )
        check_outputs(outputs.paths, overwrite=chosen.overwrite, inputs=reads)
        return outputs

    @property
    def paths(self) -> list[Path]:
        """Every file that is wanted."""
        return [path for path in (self.data, self.figure) if path is not None]

    def write(self, responses: "Sequence[Response]", data: Callable[[Path, str], None] | None = None) -> None:
        """Write the analyses into every file, or leave all files as they were; `data` as for `write_with`, where a command knows more formats."""
        self.write_with(
            data or (lambda part, kind: write_data(part, responses, kind)),
            lambda part, form: write_figure(part, responses, form),
        )

    def write_with(self, data: Callable[[Path, str], None], figure: Callable[[Path, str], None]) -> None:
        """Write every file that is wanted, or leave all files as they were.

        Parameters
        ----------
        data
            Writes a path as ``".nc"`` or ``".csv"``.
        figure
            Writes a path as ``"png"``, ``"pdf"`` or ``"svg"``.
        """
        writers: list[Callable[[Path], None]] = []
        if self.data is not None:
            kind = self.data.suffix.lower()
            writers.append(lambda part: data(part, kind))
        if self.figure is not None:
            form = self.figure.suffix.lower()[1:]
            writers.append(lambda part: figure(part, form))
        with whole_files(self.paths, overwrite=self.overwrite) as parts:
            for writer, part in zip(writers, parts, strict=True):
                writer(part)


def write_figure(path: Path, responses: "Sequence[Response]", form: str) -> None:
    """Draw one analysis, or an overview of several, into `path` as ``"png"``, ``"pdf"`` or ``"svg"``."""
    from dcfp.present.figures import (  # late: Matplotlib takes long to import
        plot_overview,
        plot_response,
        save_figure,
    )

    figure = plot_response(responses[0]) if len(responses) == 1 else plot_overview(responses)
    save_figure(figure, path, form)
