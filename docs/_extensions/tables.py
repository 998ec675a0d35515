"""Tables from the package itself: checks and findings."""

import platform
import re
from functools import cache
from importlib.metadata import PackageNotFoundError
from importlib.metadata import version as installed
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from dcfp.schema.table import Table
from dcfp.verify import CHECKS, run_checks
from dcfp.verify.reproduction import analyse, findings_of, paper_motions
from dcfp.version import version

_VERDICTS = {True: "agrees", False: "FAILS", None: "skipped"}


@cache
def checks() -> list[dict[str, Any]]:
    """Return the outcome of every check of ``dcfp verify``."""
    return Table(CHECKS, run_checks()).objects()


def table(head: list[str], rows: list[list[list[nodes.Node]]], widths: list[int], kind: str) -> nodes.Node:
    """Return a table whose cells are lists of nodes, in a box that scrolls sideways."""
    group = nodes.tgroup("", *(nodes.colspec(colwidth=width) for width in widths), cols=len(head))
    top = nodes.row("", *(nodes.entry("", _small(text)) for text in head))
    body = nodes.tbody("", *(nodes.row("", *(nodes.entry("", *cell) for cell in row)) for row in rows))
    group += [nodes.thead("", top), body]
    return nodes.container("", nodes.table("", group, classes=[kind]), classes=["scroll"])


_POWER = re.compile(r"(\d)e([+-])0*(\d+)")
_UNITS = {"mm/s2": "mm/s²", "N/mm2": "N/mm²", "degC": "°C", "w2": "ω²"}
_HIGH = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def _shown(text: str) -> str:
    """Return a text with its numbers and units as they are printed."""

    def power(found: re.Match[str]) -> str:
        sign = "-" if found[2] == "-" else ""
        return f"{found[1]} · 10{(sign + found[3]).translate(_HIGH)}"

    for plain, printed in _UNITS.items():
        text = text.replace(plain, printed)
    return _POWER.sub(power, text)


def _small(text: str, kind: str = "") -> nodes.paragraph:
    text = _shown(text)
    return nodes.paragraph(text, text, classes=[kind] if kind else [])


def _number(value: float | None) -> str:
    return "–" if value is None else _signed(f"{value:.6g}")


def _signed(text: str) -> str:
    return re.sub(r"^-", "−", text)


class Verification(SphinxDirective):
    """The checks of one group; without a group, how many there are in each."""

    optional_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """List the checks."""
        found = checks()
        if not self.arguments:
            return self._summary(found)
        chosen = [check for check in found if check["group"] == self.arguments[0]]
        if not chosen:
            msg = f"dcfp verify has no group {self.arguments[0]!r}."
            raise self.error(msg)
        rows = [self._row(check) for check in chosen]
        return [
            table(
                ["Check", "Found", "Reference", "Difference", "Allowed", "Verdict"],
                rows,
                [44, 12, 12, 12, 12, 8],
                "checks",
            )
        ]

    def _row(self, check: dict[str, Any]) -> list[list[nodes.Node]]:
        about: list[nodes.Node] = [_small(check["name"], "name")]
        if check["source"]:
            about.append(_small(f"Against: {check['source']}.", "source"))
        if check["note"]:
            about.append(_small(check["note"], "note"))
        unit = "" if check["unit"] == "-" else f" {check['unit']}"
        return [
            about,
            [_small(_number(check["computed"]) + unit)],
            [_small(_number(check["expected"]) + unit)],
            [_small(_signed(check["difference"]))],
            [_small(_signed(check["tolerance"]))],
            [_small(_VERDICTS[check["passed"]], f"verdict-{check['passed']}".lower())],
        ]

    def _summary(self, found: list[dict[str, Any]]) -> list[nodes.Node]:
        lines = [
            "| group | checks | agree | fail | skipped | nearest to its limit, difference over allowed |",
            "|---|---:|---:|---:|---:|---|",
        ]
        for group in dict.fromkeys(check["group"] for check in found):
            chosen = [check for check in found if check["group"] == group]
            verdicts = [check["passed"] for check in chosen]
            worst = max(chosen, key=lambda check: check["ratio"] or 0.0)
            nearest = f"{100.0 * (worst['ratio'] or 0.0):.0f} %: {_shown(worst['name'])}"
            place = nodes.make_id(group)
            lines.append(
                f"| [{group}](#{place}) | {len(chosen)} | {verdicts.count(True)} | {verdicts.count(False)} | {verdicts.count(None)} | {nearest} |"
            )
        return self.parse_text_to_nodes("\n".join(lines))


class Made(SphinxDirective):
    """How the numbers of a page were made, and with which versions."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """Say it."""
        others = ", ".join(f"{name} {_installed(name)}" for name in ("numpy", "scipy", "numba", "openseespy"))
        text = f"Made by `{self.arguments[0]}` when these pages were built: dcfp {version()}, Python {platform.python_version()}, {others}."
        return self.parse_text_to_nodes(text)


def _installed(name: str) -> str:
    try:
        return installed(name)
    except PackageNotFoundError:
        return "(not installed)"


class Findings(SphinxDirective):
    """What the paper finds and what is found here."""

    def run(self) -> list[nodes.Node]:
        """List the findings."""
        rows = [
            [
                [
                    _small(one.name, "name"),
                    _small(f"{str(one.basis).capitalize()}: {one.place}.", "source"),
                    *([_small(one.words, "note")] if one.words else []),
                    *(_small(str(case), "note") for case in one.outside),
                ],
                [_small(one.paper or "–")],
                [_small(one.ours)],
                [_small(one.hundred or "–")],
                [_small(one.sign, f"verdict-{one.agrees}".lower())],
            ]
            for one in findings_of(analyse(paper_motions()))
        ]
        return [
            table(["Finding", "Paper", "Ours", "100 components", ""], rows, [40, 16, 16, 18, 10], "checks")
        ]


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.add_directive("dcfp-verification", Verification)
    app.add_directive("dcfp-findings", Findings)
    app.add_directive("dcfp-made", Made)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
