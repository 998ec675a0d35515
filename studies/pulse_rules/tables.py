"""Tables in Markdown."""

from collections.abc import Iterable, Sequence

from ablation import Fineness, Row
from cases import BASES, RANGES, Marks
from held_out import HeldOut
from one_pulse import Wave

from dcfp.inference.coverage import Coverage
from dcfp.inference.statistics import Scatter
from dcfp.methods.li_2020 import Constants
from dcfp.schema.quantities import Quantity


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table; its first column is text, the others are numbers."""
    lines = [head, ["---", *["---:"] * (len(head) - 1)], *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _scatter(found: Scatter) -> list[str]:
    return [f"{found.bias:.2f}", f"{found.dispersion:.3f}"]


def rules(found: dict[str, Marks]) -> str:
    """Return the table of the rules."""
    head = ["rule", "pulses"]
    head += [f"{method}, {basis}" for method in RANGES for basis in BASES]
    head += ["kg, 4", "kg, 100", "zeta", "eps", "dy of 4", "bias dy", "disp. dy", "none", "disp. simpl."]
    head += ["unmatched", "unmoved"]
    rows = []
    for name, one in found.items():
        inside = [f"{one.inside[view]} ({one.inside_rounded[view]})" for view in one.inside]
        rows.append(
            [
                name,
                f"{one.pulses:.0f}",
                *inside,
                f"{one.slope:.0f}",
                f"{one.slope_of_all:.0f}",
                f"{one.zeta:.2f}",
                f"{one.eps:.2f}",
                f"{one.least:.2f}–{one.most:.2f}",
                *_scatter(one.change),
                str(one.change.without),
                f"{one.change_simplified.dispersion:.3f}",
                str(one.unmatched),
                str(one.unmoved),
            ]
        )
    return table(head, rows)


def ladder(found: dict[str, Row]) -> str:
    """Return the table of contributions."""
    head = ["", "bias dy", "disp. dy", "at 0.25", "0.5", "0.75", "1.0 m/s", "bias y", "disp. y"]
    head += ["bias V_dE", "disp. V_dE", "cases", "none"]
    rows = []
    for name, one in found.items():
        with_energy = "record itself" not in name
        rows.append(
            [
                name,
                *_scatter(one.change),
                *[f"{value:.2f}" for value in one.by_pgv],
                *_scatter(one.displacement),
                *(_scatter(one.energy) if with_energy else ["", ""]),
                str(one.change.number),
                str(one.without),
            ]
        )
    return table(head, rows)


def fineness(found: dict[tuple[float, int], Fineness]) -> str:
    """Return the table of tolerances and steps of the march."""
    head = ["tolerance", "steps", "nodes", "us", "bias dy", "disp. dy", "bias y", "disp. y"]
    head += ["bias V_E", "disp. V_E", "disp. V_dE"]
    head += ["disp. dy at 0.25", "0.5", "0.75", "1.0 m/s"]
    rows = [
        [
            f"{tolerance:g}",
            str(parts),
            f"{one.nodes:.0f}",
            f"{one.microseconds:.0f}",
            *_scatter(one.row.change),
            *_scatter(one.row.displacement),
            *_scatter(one.total),
            f"{one.row.energy.dispersion:.3f}",
            *[f"{value:.2f}" for value in one.row.by_pgv],
        ]
        for (tolerance, parts), one in found.items()
    ]
    return table(head, rows)


def waves(found: dict[float, Wave]) -> str:
    """Return the table of the half cosine against Eq. (20)."""
    head = ["ku/kg", "Eq. (20)", "× 1.5", "cosine", "factor", "V_dE, Eq. (23)", "× 1.5", "cosine"]
    rows = [
        [
            f"{ratio:.1f}",
            *(f"{value:.3f}" for value in (one.straight, one.amplified, one.cosine, one.factor)),
            *(f"{value:.3f}" for value in (one.energy, one.energy_amplified, one.energy_cosine)),
        ]
        for ratio, one in found.items()
    ]
    return table(head, rows)


def coverages(found: dict[tuple[str, Quantity], Coverage]) -> str:
    """Return the table of the intervals."""
    rows = [
        [
            f"{name}, {quantity.name}",
            f"{one.mean:.3f}",
            f"{one.low:.2f}–{one.high:.2f}",
            f"{one.width:.2f}",
        ]
        for (name, quantity), one in found.items()
    ]
    return table(["", "coverage", "5–95 % of splits", "upper over lower end"], rows)


def _held_out(one: HeldOut) -> list[str]:
    pairs = zip(one.bias, one.dispersion, strict=True)
    return [text for bias, dispersion in pairs for text in (f"{bias:.2f}", f"{dispersion:.3f}")]


_HELD_OUT = [f"{measure} {name}" for name in ("dy", "V_dE", "V_dEhr") for measure in ("bias", "disp.")]


def refits(found: dict[str, HeldOut]) -> str:
    """Return the table of refitted constants in held-out halves."""
    return table(["", *_HELD_OUT], ([name, *_held_out(one)] for name, one in found.items()))


def by_class(found: dict[tuple[str, str], tuple[HeldOut, dict[float, Constants]]]) -> str:
    """Return the table of classes of earthquakes, with the constants of each class."""
    rows = []
    for (method, name), (one, constants) in found.items():
        simplified = method == "simplified"
        said = "; ".join(
            f"{c.average_slope:.0f}, {c.fall_ratio:.2f}"
            if simplified
            else f"{c.change_ratio:.2f}, {c.fall_ratio:.2f}"
            for c in constants.values()
        )
        rows.append([f"{method}, classes by {name}", *_held_out(one), said])
    return table(["", *_HELD_OUT, "kg_ave or zeta, and eps, by class"], rows)
