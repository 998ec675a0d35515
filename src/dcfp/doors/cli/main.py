"""The console script ``dcfp``."""

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from importlib import import_module
from types import ModuleType

from dcfp.doors.cli.parser import Parser
from dcfp.errors import DcfpError, InputError

#: Each sub-command, the module of this package that it is in, and what it does.
COMMANDS = {
    "app": "the web page: response, test machine and design chart in a browser",
    "building": "a multi-storey shear building on the bearing, beside the rigid structure",
    "codes": "what ASCE 7, Eurocode 8 and the AIJ say, with their verdicts",
    "compare": "predictions against response history analysis: ratios, scatter, refitted constants",
    "export": "a scenario for OpenSees, for spreadsheets, or as NetCDF and CSV",
    "identify": "friction law from measured tests",
    "predict": "displacement and energy from velocity pulses, or from the PGV alone",
    "records": "named records, or what is in a record file",
    "report": "calculation report of a scenario, as PDF or HTML",
    "reproduce": "the findings and figures of Li et al. (2020), section 6, beside our own",
    "respond": "response history analysis",
    "spectrum": "elastic response and input energy spectra of records",
    "study": "many analyses: records, intensities and bearings, and what follows from them",
    "test": "virtual test machine: test programs, measures per cycle, checks of codes",
    "verify": "what is checked against what, and by how much it differs",
}

#: Set this in the environment to see the whole traceback of an unexpected error.
TRACEBACK = "DCFP_TRACEBACK"

INTERRUPTED = 130
_ASK_HELP = ("-h", "--help", "help")


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
        _complain(str(error))
        return error.exit_status
    except BrokenPipeError:
        _silence_output()  # the reader, for example `head`, has what it wanted
        return 0
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as error:  # the last resort: a user must not meet a traceback
        if os.environ.get(TRACEBACK):
            raise
        _complain(
            f"an unexpected error, {type(error).__name__}: {error}; please report it with this command"
            f" (with {TRACEBACK}=1 in the environment it shows where it arose)."
        )
        return 1
    return status


def _run(words: list[str]) -> int:
    if words and words[0] in ("-V", "--version"):
        from dcfp.version import version

        print(f"dcfp {version()}")
        return 0
    if not words or words[0] in _ASK_HELP:
        print(
            _help("dcfp", "Double concave friction pendulum bearings under recorded earthquakes.", COMMANDS)
        )
        print("--version shows the version.")
        return 0
    return _dispatch("dcfp", "dcfp.doors.cli", COMMANDS, words)


def _dispatch(program: str, package: str, commands: Mapping[str, str], words: list[str]) -> int:
    """Run the command that the first word names, with the other words; a command may have commands of its own."""
    command = words[0]
    if command not in commands:
        near = get_close_matches(command, commands, n=1)
        meant = f"did you mean {near[0]!r}?" if near else f"the commands are {', '.join(commands)}."
        msg = f"there is no command {command!r}; {meant}"
        raise InputError(msg)
    module = import_module(f"{package}.{command}")  # only the one that is asked for
    own: Mapping[str, str] | None = getattr(module, "COMMANDS", None)
    if own is not None:
        return _dispatch_group(f"{program} {command}", module, own, words[1:])
    parser = Parser(prog=f"{program} {command}", description=module.__doc__)
    module.add_arguments(parser)
    run: Callable[[object], int] = module.run
    try:
        options = parser.parse_intermixed_args(words[1:])
    except SystemExit:  # --help was printed
        return 0
    return run(options)


def _dispatch_group(program: str, module: ModuleType, commands: Mapping[str, str], words: list[str]) -> int:
    """Run a command of a group; a word that looks like a file is for the group's usual command."""
    if not words or words[0] in _ASK_HELP:
        print(_help(program, str(module.__doc__), commands))
        return 0
    is_file = words[0] not in commands and ("." in words[0] or "/" in words[0] or words[0].startswith("-"))
    return _dispatch(program, module.__name__, commands, [module.USUAL, *words] if is_file else words)


def _help(program: str, about: str, commands: Mapping[str, str]) -> str:
    lines = [f"  {name:<11} {words}" for name, words in commands.items()]
    return "\n".join(
        [
            f"usage: {program} COMMAND ...",
            "",
            about.strip(),
            "",
            *lines,
            "",
            f"{program} COMMAND --help shows the options of a command.",
        ]
    )


def _complain(sentence: str) -> None:
    print(f"dcfp: {' '.join(sentence.split())}", file=sys.stderr)


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
