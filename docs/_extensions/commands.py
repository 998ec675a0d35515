"""Commands that are run, and options that are listed, when the pages are made.

``{dcfp} respond NCC`` runs the command and shows it with what it prints, ``{dcfp-options} respond`` lists its options.
"""

import argparse
import shlex
import shutil
import tempfile
from contextlib import chdir, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from dcfp.doors.cli.main import COMMANDS, commands, main

DOCS = Path(__file__).parents[1]
#: Where the pictures that commands draw are put; Sphinx takes pictures from the folder of the sources only.
PICTURES = DOCS / "drawn"


class Command(SphinxDirective):
    """A command with what it prints; those in the body run before it, in the same empty folder.

    Options: ``lines`` of the output that are shown, ``copies`` of files it needs, a ``picture`` it draws with its ``alt`` text, and ``quiet`` where only
    the picture is of interest.

    The commands run in this process, which has the package and its kernels at hand; a process for each would take seconds only to start.
    """

    required_arguments = 1
    final_argument_whitespace = True
    has_content = True
    option_spec: ClassVar[dict[str, Any]] = {
        "lines": directives.positive_int,
        "copies": directives.unchanged,
        "picture": directives.unchanged,
        "alt": directives.unchanged,
        "quiet": directives.flag,
    }

    def run(self) -> list[nodes.Node]:
        """Run the commands and show them with the output of the last one."""
        commands = [line for line in [*self.content, self.arguments[0]] if line.strip()]
        picture = self.options.get("picture")
        shown: list[nodes.Node] = [self._block("\n".join(f"dcfp {one}" for one in commands), "sh", "command")]
        with tempfile.TemporaryDirectory() as folder, chdir(folder):
            for copy in shlex.split(self.options.get("copies", "")):
                shutil.copy(DOCS / copy, folder)
            for command in commands:
                output = self._output_of(command)
            if output and "quiet" not in self.options:
                shown.append(self._block(self._shortened(output), "text", "output"))
            if picture:
                shown.append(self._figure(Path(folder) / picture))
        return shown

    def _output_of(self, command: str) -> str:
        output, messages = StringIO(), StringIO()
        with redirect_stdout(output), redirect_stderr(messages):
            status = main(shlex.split(command))
        if status:
            msg = f"dcfp {command} ended with {status}: {messages.getvalue()}"
            raise self.error(msg)
        return (output.getvalue() or messages.getvalue()).rstrip("\n")

    def _shortened(self, output: str) -> str:
        lines = output.splitlines()
        most = self.options.get("lines", len(lines))
        return "\n".join(lines[:most] + ["..."] * (len(lines) > most))

    def _block(self, text: str, language: str, kind: str) -> nodes.literal_block:
        block = nodes.literal_block(text, text, classes=[kind], language=language)
        self.set_source_info(block)
        return block

    def _figure(self, drawn: Path) -> nodes.image:
        if not drawn.exists():
            msg = f"dcfp {self.arguments[0]} drew no {drawn.name}."
            raise self.error(msg)
        PICTURES.mkdir(exist_ok=True)
        name = f"{Path(self.env.docname).name}_{drawn.name}"
        shutil.copy(drawn, PICTURES / name)
        return nodes.image(uri=f"/{PICTURES.name}/{name}", alt=self.options.get("alt", ""))


class Options(SphinxDirective):
    """The arguments of a command from its parser, by group, as the options of a program that Sphinx knows."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """List the options."""
        (command,) = self.arguments
        parser = COMMANDS[command].parser
        lines = ["```{eval-rst}", f".. program:: dcfp {command}", ""]
        for group in parser._action_groups:
            actions = [
                action
                for action in group._group_actions
                if action.dest != "help" and action.help != argparse.SUPPRESS
            ]
            if actions:
                title = str(group.title).removeprefix("positional ").capitalize()
                lines += [f".. rubric:: {title}", "   :class: options", "", group.description or "", ""]
            for action in actions:
                text = (action.help or "") % {**vars(action), "prog": parser.prog}
                lines += [f".. option:: {_signature(action)}", "", f"   {text}", ""]
        return self.parse_text_to_nodes("\n".join([*lines, "```"]))


def _signature(action: argparse.Action) -> str:
    """Return an option with its values, as the help of argparse has it."""
    values = argparse.HelpFormatter("")._format_args(action, action.dest.upper())
    return ", ".join(f"{option} {values}".rstrip() for option in action.option_strings) or values


class CommandTable(SphinxDirective):
    """The commands of a group with what they do, each with a link to its page or section."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """List the commands."""
        rows = ["| command | what it does |", "|---|---|"]
        if self.arguments:
            (group,) = self.arguments
            rows += [
                f"| [`dcfp {group} {name}`](#dcfp-{group}-{name}) | {words} |"
                for name, words in commands(group).items()
            ]
        else:
            rows += [f"| [`dcfp {name}`](#guide-{name}) | {words} |" for name, words in commands().items()]
        return self.parse_text_to_nodes("\n".join(rows))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.add_directive("dcfp", Command)
    app.add_directive("dcfp-options", Options)
    app.add_directive("dcfp-commands", CommandTable)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
