"""What a command has found, and where it goes: standard output as text or JSON, a file of data, a figure; and what failed, to standard error."""

import argparse
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from dcfp.files import FIGURE_EXTENSIONS, check_outputs, known_extension, whole_files

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dcfp.doors.cli.console import Block, Page
    from dcfp.errors import DcfpError
    from dcfp.schema.table import Table


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
    failures
        What of it could not be found: each is told on standard error, and the last one's exit status is the command's.
    """

    document: Callable[[], Any]
    page: "Callable[[], Page]"
    data: Callable[[Path, str], str | None] | None = None
    figure: "Callable[[], Figure] | None" = None
    status: int = 0
    failures: "Sequence[DcfpError]" = ()

    @classmethod
    def of_table(
        cls, table: "Table", lines: "Block | None" = None, remarks: Iterable[str] = (), **more: Any
    ) -> "Answer":
        """Return the answer that is one table: as JSON, as text below `lines` and above `remarks`, and as CSV."""
        from dcfp.doors.cli.console import Page, grid  # late: rich takes long to import

        above = [] if lines is None else [lines]
        return cls(
            table.objects,
            lambda: Page([*above, grid(table)], list(remarks)),
            lambda part, kind: table.csv(),
            **more,
        )

    @classmethod
    def of_file(cls, name: str, data: Callable[[Path, str], str | None], document: Any = None) -> "Answer":
        """Return the answer that is one file, with what ``--json`` prints of it."""
        from dcfp.doors.cli.console import Page

        told = {"file": name} if document is None else document
        return cls(lambda: told, lambda: Page([f"{name}: written."]), data)


def drawn(name: str, *given: Any, **settings: Any) -> "Callable[[], Figure]":
    """Return what draws a figure: a function of `dcfp.present.figures`, such as ``"motions.plot_codes"``, and what it is given.

    Its module is imported when it is called, for Matplotlib takes long to import.
    """

    def figure() -> "Figure":
        module, _, function = f"dcfp.present.figures.{name}".rpartition(".")
        return getattr(import_module(module), function)(*given, **settings).figure

    return figure


def outputs_of(chosen: argparse.Namespace) -> dict[str, Path]:
    """Return the files that a command's options ``--out`` and ``--plot`` ask for, once it is known that each can be written in a known format.

    Raises
    ------
    InputError
        If not, or if one of them is a file that the command reads.
    """
    known = {"out": (chosen.kinds, chosen.noun), "plot": (FIGURE_EXTENSIONS, "a figure")}
    outputs = {
        option: known_extension(path, *known[option])
        for option in known
        if (path := getattr(chosen, option, None)) is not None
    }
    check_outputs(outputs.values(), overwrite=getattr(chosen, "overwrite", False), inputs=_inputs(chosen))
    return outputs


def deliver(
    answer: Answer | None,
    outputs: dict[str, Path],
    said: Callable[[str], str],
    *,
    overwrite: bool,
    as_json: bool,
) -> int:
    """Write every file that is wanted, or leave all files as they were; print what a command has found, as text or as one document; return the exit status.

    Parameters
    ----------
    answer
        None where there is nothing to say.
    outputs
        The files that are wanted.
    said
        Puts the sentences of a text in the words of the command line; a document is for any reader.
    overwrite
        Whether files may be there already.
    as_json
        Whether one document is printed instead of text.
    """
    if answer is None:
        return 0
    with whole_files(list(outputs.values()), overwrite=overwrite) as parts:
        for (option, path), part in zip(outputs.items(), parts, strict=True):
            _write(answer, option, part, path.suffix.lower())
    if as_json:
        import json  # late: a help text needs no document

        print(json.dumps(answer.document(), indent=2, allow_nan=False))
    else:
        answer.page().show(said)
    sys.stdout.flush()  # what failed is told below what was found
    for one in answer.failures:
        complain(said(str(one)))
    return answer.failures[-1].exit_status if answer.failures else answer.status


def complain(sentence: str) -> None:
    """Tell on standard error, in one line, what is wrong."""
    print(f"dcfp: {' '.join(sentence.split())}", file=sys.stderr)


def _write(answer: Answer, option: str, part: Path, kind: str) -> None:
    if option == "plot":
        from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

        assert answer.figure is not None
        save_figure(answer.figure(), part, kind.removeprefix("."))
        return
    assert answer.data is not None
    text = answer.data(part, kind)
    if text is not None:
        part.write_text(text, encoding="utf-8", newline="\n")


def _inputs(chosen: argparse.Namespace) -> Iterator[Path]:
    """Give every word of a command that may be the name of a file that it reads, alone or in ``FILE::COMPONENT``."""
    for name, value in vars(chosen).items():
        several: Any = cast("dict[str, Any]", value).values() if isinstance(value, dict) else value
        alone = isinstance(several, str) or not isinstance(several, Iterable)
        words = cast("Iterable[Any]", [value] if alone else several)
        for word in words:
            if isinstance(word, str) and name not in ("out", "plot", "example"):
                yield Path(word)
                yield Path(word.rpartition("::")[0] or word)
