"""Commands that are run, and options that are listed, when the pages are made.

``{dcfp} respond NCC`` runs the command and shows it with what it prints, ``{dcfp-options} respond`` lists its options.
"""

import argparse
import base64
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from kept import BUILD, kept
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from dcfp.doors.cli.main import COMMANDS, commands

DOCS = Path(__file__).parents[1]
#: Where the pictures that commands draw are put; Sphinx takes pictures from the folder of the sources only.
PICTURES = DOCS / "drawn"


def run(commands: list[str], copies: list[str], picture: str | None) -> dict[str, Any]:
    """Run commands in an empty folder with `copies` of files; return what the last one prints and the picture it draws."""
    with tempfile.TemporaryDirectory() as folder:
        for copy in copies:
            shutil.copy(DOCS / copy, folder)
        for number, command in enumerate(commands, 1):
            done = subprocess.run(
                [sys.executable, "-m", "dcfp.doors.cli.main", *shlex.split(command)],
                cwd=folder,
                capture_output=True,
                text=True,
                encoding="utf-8",
                timeout=600,
                check=False,
            )
            if done.returncode and number < len(commands):
                break
        drawn = ""
        if picture and (Path(folder) / picture).exists():
            drawn = base64.b64encode((Path(folder) / picture).read_bytes()).decode("ascii")
        return {"status": done.returncode, "output": done.stdout, "messages": done.stderr, "picture": drawn}


class Command(SphinxDirective):
    """A command with what it prints; those in the body run before it, in the same folder.

    Options: ``lines`` of the output that are shown, ``copies`` of files it needs, a ``picture`` it draws with its ``alt`` text,
    ``status`` it ends with, and ``quiet`` where only the picture is of interest.
    """

    required_arguments = 1
    final_argument_whitespace = True
    has_content = True
    option_spec: ClassVar[dict[str, Any]] = {
        "lines": directives.positive_int,
        "copies": directives.unchanged,
        "picture": directives.unchanged,
        "alt": directives.unchanged,
        "status": directives.nonnegative_int,
        "quiet": directives.flag,
    }

    def run(self) -> list[nodes.Node]:
        """Run the command."""
        said = " ".join(self.arguments[0].split())
        commands = [line.strip() for line in self.content if line.strip()] + [said]
        copies = shlex.split(self.options.get("copies", ""))
        picture = self.options.get("picture")
        name = f"{commands} {[(copy, (DOCS / copy).read_text(encoding='utf-8')) for copy in copies]}"
        done = kept(name, lambda: run(commands, copies, picture))
        wanted = self.options.get("status", 0)
        if done["status"] != wanted:
            msg = f"dcfp {said} and what is before it ended with {done['status']}, not {wanted}: {done['messages']}"
            raise self.error(msg)
        shown: list[nodes.Node] = [self._block("\n".join(f"dcfp {one}" for one in commands), "sh", "command")]
        output = (done["output"] or done["messages"]).rstrip("\n")
        if output and "quiet" not in self.options:
            shown.append(self._block(self._cut(output), "text", "output"))
        if picture:
            if not done["picture"]:
                msg = f"dcfp {said} drew no {picture}."
                raise self.error(msg)
            shown.append(self._figure(picture, base64.b64decode(done["picture"])))
        return shown

    def _cut(self, output: str) -> str:
        most = self.options.get("lines")
        lines = output.splitlines()
        return output if most is None or len(lines) <= most else "\n".join([*lines[:most], "..."])

    def _block(self, text: str, language: str, kind: str) -> nodes.literal_block:
        block = nodes.literal_block(text, text, classes=[kind])
        block["language"] = language
        self.set_source_info(block)
        return block

    def _figure(self, name: str, content: bytes) -> nodes.image:
        PICTURES.mkdir(exist_ok=True)
        path = PICTURES / f"{Path(self.env.docname).name}_{name}"
        if not path.exists() or path.read_bytes() != content:
            path.write_bytes(content)
        up = "../" * self.env.docname.count("/")
        return nodes.image(uri=f"{up}{PICTURES.name}/{path.name}", alt=self.options.get("alt", ""))


class Options(SphinxDirective):
    """The arguments of a command from its parser, by group."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """List the options."""
        parser = COMMANDS[self.arguments[0]].parser
        shown: list[nodes.Node] = []
        for group in parser._action_groups:
            actions = [
                one for one in group._group_actions if one.dest != "help" and one.help != argparse.SUPPRESS
            ]
            if not actions:
                continue
            title = {"positional arguments": "Arguments", "options": "Options"}.get(
                str(group.title), str(group.title).capitalize()
            )
            shown.append(nodes.rubric(title, title, classes=["options"]))
            if group.description:
                shown.append(nodes.paragraph(group.description, group.description))
            items = nodes.definition_list(classes=["options"])
            for action in actions:
                text = (action.help or "") % {**vars(action), "prog": parser.prog} if action.help else ""
                term = nodes.term("", "", nodes.literal("", _signature(action)))
                items += nodes.definition_list_item(
                    "", term, nodes.definition("", nodes.paragraph(text, text))
                )
            shown.append(items)
        return shown


def _signature(action: argparse.Action) -> str:
    """Return an option with its values, as the help of argparse has it."""
    plain = argparse.HelpFormatter("")
    if not action.option_strings:
        return plain._format_args(action, action.dest.upper())
    words = ", ".join(action.option_strings)
    return words if action.nargs == 0 else f"{words} {plain._format_args(action, action.dest.upper())}"


class CommandTable(SphinxDirective):
    """The commands of a group with what they do, each with a link to its page or section."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """List the commands."""
        if self.arguments:
            group = self.arguments[0]
            rows = [
                f"| [`dcfp {group} {name}`](#dcfp-{group}-{name}) | {words} |"
                for name, words in commands(group).items()
            ]
        else:
            rows = [f"| [`dcfp {name}`](#guide-{name}) | {words} |" for name, words in commands().items()]
        return self.parse_text_to_nodes("\n".join(["| command | what it does |", "|---|---|", *rows]))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    BUILD.mkdir(parents=True, exist_ok=True)
    app.add_directive("dcfp", Command)
    app.add_directive("dcfp-options", Options)
    app.add_directive("dcfp-commands", CommandTable)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
