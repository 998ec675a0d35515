"""The public names of a package: a table of all of them, then each with its documentation."""

import inspect
from collections.abc import Iterable
from importlib import import_module
from types import ModuleType
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective


def public_names(module: ModuleType) -> list[str]:
    """Return the names in a module that are defined in it or below it, in their order."""
    inside = f"{module.__name__}."
    return [
        name
        for name, value in vars(module).items()
        if not name.startswith("_")
        and not isinstance(value, ModuleType)
        and f"{getattr(value, '__module__', '')}.".startswith(inside)
    ]


def home_of(name: str, value: Any) -> str:
    """Return the package that documents a name: the outermost below ``dcfp`` that has it."""
    parts = value.__module__.split(".")
    packages = (".".join(parts[: last + 1]) for last in range(1, len(parts)))
    return next(package for package in packages if hasattr(import_module(package), name))


def table_of(module: ModuleType, names: Iterable[str]) -> list[str]:
    """Return a table of names with the first paragraph of what is documented of each."""
    lines = [".. list-table::", "   :widths: auto", ""]
    for name in names:
        value = getattr(module, name)
        words = " ".join((inspect.getdoc(value) or "").partition("\n\n")[0].split()).replace("|", r"\|")
        target = f"{name} <{home_of(name, value)}.{name}>"
        lines += [f"   * - :py:obj:`{target}`", f"     - {words}"]
    return [*lines, ""]


class PublicNames(SphinxDirective):
    """Document the public names of a package or a module; of ``dcfp`` itself, list them with links to where they are documented."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Write what autodoc then fills."""
        module = import_module(self.arguments[0])
        if module.__name__ == "dcfp":
            lines = table_of(module, module.__all__)
        else:
            names = public_names(module)
            lines = [f".. automodule:: {module.__name__}", "", *table_of(module, names)]
            for name in names:
                lines += [_documented(name, getattr(module, name)), ""]
        return self.parse_text_to_nodes("\n".join(["```{eval-rst}", *lines, "```"]))


def _documented(name: str, value: Any) -> str:
    if inspect.isclass(value):
        return f".. autoclass:: {name}\n   :members:"
    return f".. autofunction:: {name}" if inspect.isroutine(value) else f".. py:data:: {name}"


def escape_bars(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Keep ``|v|`` from being read as a substitution."""
    lines[:] = [line if ".. math::" in line else line.replace("|", r"\|") for line in lines]


#: What `put_aside` has taken, by the name that it documents.
_ASIDE: dict[str, list[str]] = {}


def put_aside(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Keep the docstring of a property from napoleon, which takes the words before a colon for a type."""
    if what in ("attribute", "property"):
        _ASIDE[name] = list(lines)
        lines.clear()


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
    app.add_directive("public-names", PublicNames)
    app.connect("autodoc-process-docstring", escape_bars, priority=400)
    app.connect("autodoc-process-docstring", put_aside, priority=450)
    app.connect("autodoc-process-docstring", take_back, priority=550)
    app.connect("autodoc-process-signature", shorten)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
