"""Tables of parameters, quantities and methods, read from their declarations."""

from collections.abc import Iterable, Mapping
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from dcfp.analysis.rig import Loops as Loops  # every kind of result adds its quantities when it is imported
from dcfp.inference import Case as Case
from dcfp.methods import METHODS
from dcfp.motion.formats.registry import FORMATS
from dcfp.schema.citations import citation
from dcfp.schema.declared import parameters
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import NOMENCLATURE
from dcfp.study.factors import catalogue
from dcfp.system import Bearing
from dcfp.system.friction import FRICTION_LAWS
from dcfp.system.heating import HEATINGS
from dcfp.system.plan import Plan
from dcfp.system.storeys import Storey


def sources() -> dict[str, Mapping[str, Parameter]]:
    """Return the parameters that the pages list, by what they belong to."""
    return {
        "factors": catalogue(),
        "bearing": _of(Bearing),
        "building": _of(Plan),
        "storey": _of(Storey),
        **{f"friction {name}": _of(law) for name, law in FRICTION_LAWS.items()},
        **{f"heating {name}": _of(model) for name, model in HEATINGS.items()},
    }


def _of(kind: type) -> dict[str, Parameter]:
    return {parameter.key: parameter for parameter in parameters(kind).values()}


def parameter_table(listed: Mapping[str, Parameter], inner: bool = False) -> str:
    """Return a table of parameters in Markdown: with their defaults, or with the unit that they have in data sets."""
    rows = [
        [
            f"`{name}`",
            f"${one.symbol}$" if one.symbol else "",
            one.words,
            one.rule(),
            one.unit.inner_unit.name if inner else one.text(one.default),
        ]
        for name, one in listed.items()
    ]
    return _table(["name", "symbol", "meaning", "must be", "unit in results" if inner else "default"], rows)


def format_table() -> str:
    """Return the formats of record files as a table in Markdown."""
    return _table(["format", "files of"], [[name, one.words] for name, one in FORMATS.items()])


def quantity_table() -> str:
    """Return the nomenclature as a table in Markdown."""
    rows = [
        [f"${one.symbol}$", one.words, one.unit.inner_unit.name, one.shown.name, f"`{name}`"]
        for name, one in NOMENCLATURE.items()
        if one.symbol
    ]
    return _table(["symbol", "quantity", "unit inside", "shown in", "name in data sets"], rows)


def method_table() -> str:
    """Return every method that says how far a bearing moves, with its name in studies, as a table in Markdown."""
    rows = [
        [
            method.name,
            f"`{method.key}`",
            ", ".join(one.words for one in method.knows),
            "; ".join(f"{citation(key).partition(')')[0]})" for key in method.citations),
        ]
        for method in METHODS.values()
    ]
    return _table(["method", "name in studies", "knows", "source"], rows)


def _table(head: list[str], rows: Iterable[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in line)} |" for line in lines)


class Parameters(SphinxDirective):
    """The parameters of ``bearing``, of one ``friction`` law or ``heating`` model by name or of all, or all ``factors`` of studies."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """List them."""
        (wanted,) = self.arguments
        text: list[str] = []
        for name, listed in sources().items():
            if name == wanted:
                text.append(parameter_table(listed, inner=wanted == "factors"))
            elif name.startswith(f"{wanted} ") and listed:
                text += [f"`{name.removeprefix(wanted).strip()}`:", parameter_table(listed)]
        if not text:
            msg = f"there are no parameters of {wanted!r}."
            raise self.error(msg)
        return self.parse_text_to_nodes("\n\n".join(text))


class Quantities(SphinxDirective):
    """The nomenclature."""

    def run(self) -> list[nodes.Node]:
        """List it."""
        return self.parse_text_to_nodes(quantity_table())


class Formats(SphinxDirective):
    """The formats of record files."""

    def run(self) -> list[nodes.Node]:
        """List them."""
        return self.parse_text_to_nodes(format_table())


class Methods(SphinxDirective):
    """The methods of prediction and of codes."""

    def run(self) -> list[nodes.Node]:
        """List them."""
        return self.parse_text_to_nodes(method_table())


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.add_directive("dcfp-parameters", Parameters)
    app.add_directive("dcfp-quantities", Quantities)
    app.add_directive("dcfp-formats", Formats)
    app.add_directive("dcfp-methods", Methods)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
