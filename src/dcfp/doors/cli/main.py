"""The console script ``dcfp``."""

import os
import sys
from collections.abc import Mapping, Sequence
from textwrap import fill

from dcfp.doors.cli import building_command as building_command
from dcfp.doors.cli import study_commands
from dcfp.doors.cli.commands import COMMANDS, Command
from dcfp.doors.cli.outputs import complain, deliver, outputs_of
from dcfp.doors.cli.parser import nearest
from dcfp.errors import DcfpError, InputError

#: Set this in the environment to see the whole traceback of an unexpected error.
TRACEBACK = "DCFP_TRACEBACK"

INTERRUPTED = 130
ABOUT = "Double concave friction pendulum bearings under recorded earthquakes."
#: Commands that have commands of their own, and the modules that these are in.
GROUPS = {"study": study_commands}
_ASK_HELP = ("-h", "--help", "help")
_WIDTH = 100


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status: 0 done, 1 failed analysis, 2 bad input.

    Parameters
    ----------
    argv
        The words after ``dcfp``; by default those that the process was started with.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    _write_what_can_be_written()
    try:
        status = _run(words)
        sys.stdout.flush()
    except DcfpError as error:
        complain(str(error))
        return error.exit_status
    except BrokenPipeError:
        _silence_output()  # the reader, for example `head`, has what it wanted
        return 0
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as error:  # the last resort: a user must not meet a traceback
        if os.environ.get(TRACEBACK):
            raise
        complain(
            f"an unexpected error, {type(error).__name__}: {error}; please report it with this command"
            f" (with {TRACEBACK}=1 in the environment it shows where it arose)."
        )
        return 1
    return status


def commands(group: str = "") -> dict[str, str]:
    """Return the names of the commands, or of those of a group, and what each does."""
    parts = {name: name.rpartition(" ") for name in COMMANDS}
    found = {last: COMMANDS[name].words for name, (first, _, last) in parts.items() if first == group}
    if group:
        return found
    found |= {name: module.ABOUT.partition("\n")[0] for name, module in GROUPS.items()}
    return dict(sorted(found.items()))


def command_of(words: Sequence[str]) -> tuple[Command, list[str]]:
    """Return the command that words name, and the words behind its name; a file alone is for the usual command of a group.

    Raises
    ------
    InputError
        If there is no such command.
    """
    group = words[0] if words[0] in GROUPS else ""
    name, *rest = words[1:] if group else words
    known = commands(group)
    if name not in known and group and ("." in name or "/" in name or name.startswith("-")):
        name, rest = GROUPS[group].USUAL, [name, *rest]
    if name not in known:
        near = nearest(name, known)
        meant = f"did you mean {near!r}?" if near else f"the commands are {', '.join(known)}."
        msg = f"there is no command {name!r}; {meant}"
        raise InputError(msg)
    return COMMANDS[f"{group} {name}".strip()], rest


def _run(words: list[str]) -> int:
    if words and words[0] in ("-V", "--version"):
        from dcfp.version import version

        print(f"dcfp {version()}")
        return 0
    group = words[0] if words and words[0] in GROUPS else ""
    rest = words[1:] if group else words
    if not rest or rest[0] in _ASK_HELP:
        print(_help(f"dcfp {group}".strip(), GROUPS[group].ABOUT if group else ABOUT, commands(group)))
        if not group:
            print("--version shows the version.")
        return 0
    return _carry_out(*command_of(words))


def _carry_out(command: Command, words: list[str]) -> int:
    parser = command.parser
    try:
        chosen = parser.parse_intermixed_args(words)
    except SystemExit:  # --help was printed
        return 0
    for name in ("records", "files"):
        if isinstance(listed := getattr(chosen, name, None), list):
            setattr(chosen, name, [*listed, *chosen.later_records])
    command.check(chosen)
    if chosen.needs_records and not chosen.records:
        msg = "name at least one RECORD, for example NCC or a file; dcfp records lists the named ones."
        raise InputError(msg)
    try:
        outputs = outputs_of(chosen)
        overwrite, as_json = getattr(chosen, "overwrite", False), getattr(chosen, "json", False)
        return deliver(command.run(chosen), outputs, parser.spoken, overwrite=overwrite, as_json=as_json)
    except DcfpError as error:
        error.args = (parser.spoken(str(error)),)
        raise


def _help(program: str, about: str, known: Mapping[str, str]) -> str:
    column = max(map(len, known)) + 4
    lines = [
        fill(
            words.rstrip("."),
            _WIDTH,
            initial_indent=f"  {name}".ljust(column),
            subsequent_indent=" " * column,
        )
        for name, words in known.items()
    ]
    parts = (
        f"usage: {program} COMMAND ...",
        about.strip(),
        "\n".join(lines),
        f"{program} COMMAND --help shows the options of a command.",
    )
    return "\n\n".join(parts)


def _write_what_can_be_written() -> None:
    """Put a question mark where a terminal's encoding has no sign, rather than fail."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="replace")


def _silence_output() -> None:
    """Point standard output where it can be flushed at the end of the process."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


if __name__ == "__main__":
    sys.exit(main())
