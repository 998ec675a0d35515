"""The reproduction as one page that needs no other file."""

import base64
import io
from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

from dcfp.verify.reproduction import Finding
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.present.figures.li_2020 import PaperFigure


_STYLE = """
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.2rem; }
table { border-collapse: collapse; width: 100%; font-size: 0.85rem; }
th, td { text-align: left; vertical-align: top; padding: 0.35rem 0.6rem; border-bottom: 1px solid #ddd; }
td.sign { font-weight: bold; white-space: nowrap; } .yes { color: #00664a; } .no { color: #a03040; }
.note { color: #555; } figure { margin: 1.2rem 0; } figcaption { font-size: 0.85rem; color: #444; max-width: 46rem; }
figure img { max-width: 100%; height: auto; } .scroll { overflow-x: auto; } td { overflow-wrap: anywhere; }
@media (max-width: 40rem) { td.sign { white-space: normal; } th, td { padding: 0.3rem; } body { font-size: 14px; } }
"""

#: Whether a finding is as printed.
_SIGNS = {
    True: '<span class="yes">as printed</span>',
    False: '<span class="no">differs</span>',
    None: '<span class="note">not comparable</span>',
}
#: Of an inch of a figure on a screen.
_PIXELS = 120


def reproduction_page(
    findings: Sequence[Finding],
    figures: "Sequence[PaperFigure]",
    records: Sequence[str],
    missing: Sequence[str],
) -> str:
    """Return the page as HTML.

    Parameters
    ----------
    findings
        Of the paper and ours.
    figures
        In the form of the paper's.
    records
        Names of the records that were analysed.
    missing
        Names of those of the paper that were not there.
    """
    agreed = sum(one.agrees is True for one in findings)
    lacking = (
        f" Not at hand are {escape(', '.join(missing))}; ranges and means of the paper are of all eight records."
        if missing
        else ""
    )
    rows = "\n".join(_row(one) for one in findings)
    drawn = "\n".join(_figure(one) for one in figures)
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Li et al. (2020), section 6, made again</title>
<style>{_STYLE}</style>
</head>
<body>
<h1>Energy-based prediction of the displacement of DCFP bearings, made again</h1>
<p>Li et al. (2020), Applied Sciences 10(15), 5259, <a href="https://doi.org/10.3390/app10155259">doi:10.3390/app10155259</a>,
section 6. Records: {escape(", ".join(records))}, each at a PGV of 0.25, 0.50, 0.75 and 1.00 m/s, under the paper's bearing with its friction law and
simplified heating.{lacking} Made by dcfp {escape(version())} with <code>dcfp reproduce</code>.</p>
<h2>Findings</h2>
<p>{agreed} of {len(findings)} are found as printed. Where ours differs, the line says by how much and why.</p>
<div class="scroll"><table>
<thead><tr><th>Finding</th><th>Printed</th><th>Ours</th><th>100 components of FEMA P-695</th><th></th></tr></thead>
<tbody>
{rows}
</tbody></table></div>
<h2>Figures</h2>
<p>In the form of the paper's, with its numbers.</p>
{drawn}
</body>
</html>
"""


def _row(finding: Finding) -> str:
    sign = _SIGNS[finding.agrees]
    outside = "".join(f"<br>{escape(str(one))}" for one in finding.outside)
    return (
        f"<tr><td>{escape(finding.name)}<br><span class='note'>{escape(finding.place)}</span></td>"
        f"<td>{escape(finding.paper)}</td><td>{escape(finding.ours)}</td><td>{escape(finding.hundred)}</td>"
        f"<td class='sign'>{sign}</td></tr>\n"
        f"<tr><td colspan='5' class='note'>{escape(finding.words)}{outside}</td></tr>"
    )


def _figure(figure: "PaperFigure") -> str:
    title = f"Figure {figure.number}. {figure.title}"
    return (
        f'<figure><img alt="{escape(title)}" width="{_PIXELS * figure.figure.get_figwidth():.0f}" src="data:image/png;base64,{_image(figure)}">'
        f"<figcaption><strong>{escape(title)}</strong> {escape(figure.words)}</figcaption></figure>"
    )


def _image(figure: "PaperFigure") -> str:
    from dcfp.present.figures.style import save_figure

    stream = io.BytesIO()
    save_figure(figure.figure, stream, "png")
    return base64.b64encode(stream.getvalue()).decode("ascii")
