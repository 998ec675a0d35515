"""The public names of a package, read from its ``__init__``: a table of all of them, then each with its documentation."""

import inspect
import re
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from typing import Any

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.docutils import SphinxDirective

#: One word in single backticks, with no role before it.
_SINGLE = re.compile(r"(?<![`:\w])`([\w.]+)`(?!`)")
#: The modules of the codes, which have a page of their own.
CODES = (
    "asce_2016",
    "eurocode_8",
    "aij_2016",
    "equivalent_linear",
    "bilinear",
    "result",
    "panel",
    "iwan_1980",
    "hadjian_1982",
    "fajfar_1989",
    "uang_bertero_1988",
)
#: In the order in which data flow.
PACKAGES = (
    "motion",
    "system",
    "analysis",
    "analysis.rig",
    "analysis.building",
    "methods",
    "methods.li_2020",
    "methods.spectra",
    *(f"methods.{name}" for name in CODES),
    "inference",
    "inference.identification",
    "study",
    "study.assessment",
    "study.scenario",
    "present.figures",
    "present.figures.li_2020",
    "present.tables",
    "present.report",
    "exchange",
    "verify",
    "verify.reproduction",
)


def public_names(package: str) -> list[str]:
    """Return the names that a package exports with ``import X as X``, in their order, in itself or in its stub."""
    module = import_module(package)
    if not hasattr(module, "__path__"):
        return _names_of_module(module)
    stub = Path(inspect.getfile(module)).with_suffix(".pyi")
    lines = (stub.read_text() if stub.exists() else inspect.getsource(module)).splitlines()
    found = [line.split()[-1] for line in lines if line.startswith("from ") and " as " in line]
    return [name for name in found if not name.startswith("_")] or _names_of_modules(package)


def _names_of_modules(package: str) -> list[str]:
    """Return ``module.name`` of what the modules of a package define, where the package itself exports nothing."""
    found: list[str] = []
    for info in iter_modules(import_module(package).__path__):
        module = import_module(f"{package}.{info.name}")
        found += [f"{info.name}.{name}" for name in _names_of_module(module)]
    return found


def _names_of_module(module: ModuleType) -> list[str]:
    """Return the names of what a module defines."""
    return [
        name
        for name, value in vars(module).items()
        if not name.startswith("_") and getattr(value, "__module__", None) == module.__name__
    ]


def value_of(package: str, name: str) -> Any:
    """Return what a name of a package, with dots or without, stands for."""
    for part in name.split(".")[:-1]:
        package = f"{package}.{part}"
    return getattr(import_module(package), name.rpartition(".")[2])


def summary(value: Any) -> str:
    """Return the first sentence of what is documented of a class or function, for a table."""
    text = inspect.getdoc(value) or "" if inspect.isclass(value) or inspect.isroutine(value) else ""
    return text.partition("\n\n")[0].replace("\n", " ").replace("|", r"\|")


@cache
def _comment(package: str, name: str) -> str:
    """Return what the comment over a constant says, or the string under it."""
    definition = re.compile(
        rf"(?P<over>(?:^#: ?.*\n)*)^{re.escape(name.rpartition('.')[2])}\b[^\n]*=(?:[^\n]*\n(?:[ )].*\n)*)?",
        re.MULTILINE,
    )
    for path in sorted(Path(import_module(package).__file__ or "").parent.rglob("*.py")):
        found = definition.search(path.read_text(encoding="utf-8"))
        if found and found["over"]:
            return " ".join(line.removeprefix("#:").strip() for line in found["over"].splitlines())
    return ""


@cache
def _homes() -> dict[str, str]:
    """Return where each class and function is documented, by where it is defined."""
    homes: dict[str, str] = {}
    for package in PACKAGES:
        for name in public_names(f"dcfp.{package}"):
            value = value_of(f"dcfp.{package}", name)
            if inspect.isclass(value) or inspect.isroutine(value):
                homes.setdefault(f"{value.__module__}.{value.__qualname__}", f"dcfp.{package}.{name}")
                homes.setdefault(name, f"dcfp.{package}.{name}")
    return homes


class PublicNames(SphinxDirective):
    """Document the public names of a package."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Write what autodoc then fills."""
        package = self.arguments[0]
        module = import_module(package)
        names = public_names(package)
        if not names:
            msg = f"{package} exports nothing."
            raise self.error(msg)
        lines = ["```{eval-rst}", f".. py:module:: {package}", ""]
        lines += [
            *inspect.cleandoc(module.__doc__ or "").splitlines(),
            "",
            ".. list-table::",
            "   :widths: auto",
            "",
        ]
        for name in names:
            words = _as_code(summary(value_of(package, name)) or _comment(package, name), _homes())
            lines += [f"   * - :py:obj:`{name} <{package}.{name}>`", f"     - {words}"]
        lines.append("")
        for name in names:
            value = value_of(package, name)
            if inspect.isclass(value):
                lines += [f".. autoclass:: {package}.{name}", "   :members:", ""]
            elif inspect.isroutine(value):
                lines += [f".. autofunction:: {package}.{name}", ""]
            else:
                lines += [f".. py:data:: {package}.{name}", "", f"   {_comment(package, name)}", ""]
        return self.parse_text_to_nodes("\n".join([*lines, "```"]))


class TopNames(SphinxDirective):
    """The names of ``dcfp`` itself, each with a link to its package."""

    def run(self) -> list[nodes.Node]:
        """List them."""
        import dcfp

        rows = []
        homes = _homes()
        for name in public_names("dcfp"):
            value = getattr(dcfp, name)
            full = homes.get(
                f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', '')}",
                f"dcfp.system.{name}",
            )
            words = summary(value) or "The bearing of Li et al. (2020)."
            rows.append(f"| {{py:obj}}`dcfp.{name} <{full}>` | {words} |")
        return self.parse_text_to_nodes("\n".join(["| name | |", "|---|---|", *rows]))


def find_home(
    app: Sphinx, env: BuildEnvironment, node: pending_xref, contnode: nodes.Node
) -> nodes.Node | None:
    """Lead a reference to where a class is defined to where it is documented."""
    if node.get("refdomain") != "py":
        return None
    home = app.config.dcfp_homes.get(node["reftarget"])
    if home is None or home == node["reftarget"]:
        return None
    domain = env.domains["py"]
    return domain.resolve_xref(env, node.get("refdoc", ""), app.builder, "obj", home, node, contnode)


def _as_code(line: str, homes: dict[str, str]) -> str:
    def shown(text: re.Match[str]) -> str:
        word = text[1]
        known = word in homes or word in homes.values() or word.startswith("dcfp.")
        return f"`{word}`" if known else f"``{word}``"

    return _SINGLE.sub(shown, line)


def tidy(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Show names in backticks that are documented nowhere as code, and keep ``|v|`` from being read as a substitution."""
    for place, line in enumerate(lines):
        if ".. math::" in line:
            continue
        turned = _as_code(line, app.config.dcfp_homes)
        parts = turned.split("`")
        lines[place] = "`".join(part if i % 2 else part.replace("|", r"\|") for i, part in enumerate(parts))


#: What `put_aside` has taken, by the name that it is said of.
_ASIDE: dict[str, list[str]] = {}


def put_aside(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Keep what is said of a property from napoleon, which takes the words before a colon for a type."""
    if what in ("attribute", "property"):
        _ASIDE[name] = list(lines)
        lines[:] = []


def take_back(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Undo `put_aside`."""
    if what in ("attribute", "property"):
        lines[:] = _ASIDE.pop(name)


_FLOATS = "~numpy.ndarray[tuple[~typing.Any, ...], ~numpy.dtype[~numpy.float64]]"


def shorten(
    app: Sphinx, what: str, name: str, obj: Any, options: Any, signature: str | None, returned: str | None
) -> tuple[str | None, str | None]:
    """Write arrays of numbers as the sources do."""
    return tuple(text and text.replace(_FLOATS, "FloatArray") for text in (signature, returned))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.add_config_value("dcfp_homes", _homes(), "")
    app.add_directive("public-names", PublicNames)
    app.add_directive("top-names", TopNames)
    app.connect("missing-reference", find_home)
    app.connect("autodoc-process-signature", shorten)
    app.connect("autodoc-process-docstring", tidy, priority=400)
    app.connect("autodoc-process-docstring", put_aside, priority=450)
    app.connect("autodoc-process-docstring", take_back, priority=550)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
