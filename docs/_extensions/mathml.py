"""Formulas as MathML, which browsers draw without a script, and equations under the numbers of the paper.

A label ``li-12`` is Eq. (12) of Li et al. (2020) and is shown as (12); any other equation has a letter for its page and a number, (A1), (A2) and so on.
"""

import re
import shutil
from html import escape
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.domains.math import MathDomain
from sphinx.util.math import get_node_equation_number

_PAPER = "li-"
#: Pages with equations of their own, in the order of their letters.
_PAGES = ("model", "friction", "motion", "prediction", "method", "others", "plane")
_FONT = "STIXTwoMath-Regular.ttf"


class NumberedMath(MathDomain):
    """Equations whose numbers are those of the paper, where they are the paper's."""

    def note_equation(self, docname: str, labelid: str, location: Any = None) -> None:
        """Give an equation its number."""
        super().note_equation(docname, labelid, location)
        number: Any = self.equations[labelid][1]
        if labelid.startswith(_PAPER):
            number = labelid.removeprefix(_PAPER)
        else:
            letter = "ABCDEFG"[_PAGES.index(docname.rpartition("/")[2])]
            own = [label for label, (page, _) in self.equations.items() if page == docname]
            number = f"{letter}{sum(not label.startswith(_PAPER) for label in own)}"
        self.equations[labelid] = (docname, number)


_BAR = re.compile(r"<mo[^>]*>(?:&#x0007C;|\\|)</mo>")
_BOLD = re.compile(r'<mi mathvariant="bold">([a-z])</mi>')
#: The first letter of the mathematical alphabet of bold small letters.
_BOLD_A = 0x1D41A


def markup(formula: str, display: str) -> str:
    """Return a formula as MathML, with bars close to what they enclose and bold letters as characters of their own, since browsers leave the attribute out."""
    found = _BAR.sub('<mo stretchy="false" lspace="0" rspace="0">|</mo>', convert(formula, display=display))
    return _BOLD.sub(lambda letter: f"<mi>{chr(_BOLD_A + ord(letter[1]) - ord('a'))}</mi>", found)


def visit_inline(translator: Any, node: nodes.math) -> None:
    """Write a formula in a line."""
    translator.body.append(markup(node.astext(), "inline"))
    raise nodes.SkipNode


def visit_block(translator: Any, node: nodes.math_block) -> None:
    """Write a formula on its own, with its number."""
    label = node.get("label")
    translator.body.append(
        f'<div class="equation"><div class="formula">{markup(node.astext(), "block")}</div>'
    )
    if node.get("number"):
        number = escape(str(get_node_equation_number(translator, node)))
        place = nodes.make_id(f"equation-{label}")
        translator.body.append(
            f'<span class="eqno">({number})<a class="headerlink" href="#{place}" title="Link to this equation">#</a></span>'
        )
    translator.body.append("</div>\n")
    raise nodes.SkipNode


def copy_font(app: Sphinx, exception: Exception | None) -> None:
    """Put the font of the formulas, STIX Two Math (SIL Open Font License), beside the pages."""
    if exception is None and app.builder.format == "html":
        with as_file(files("ziamath") / "fonts" / _FONT) as font:
            shutil.copyfile(font, Path(app.outdir) / "_static" / _FONT)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.add_domain(NumberedMath, override=True)
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    app.connect("build-finished", copy_font)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
