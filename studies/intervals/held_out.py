"""How far each method is from the analysis on the records outside of FEMA P-695: of Chi-Chi, of all others, and with earthquakes counted equally. ``python held_out.py FACTS.csv [FOLDER]``.

The facts are those that ``intervals.py`` derives from each record. Writes the table (``held_out.csv``) into `FOLDER`, by default beside the facts, and prints it as Markdown.
"""

import csv
import math
import re
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from dcfp.methods.li_2020 import LI_2020, predict_from_pgv

#: What the facts call the methods, and how they are told; the design method knows the PGV alone, and is computed here.
METHODS = {"pulse": "pulse", "simplified": "simplified", "design": "design", "pulse march": "march (ours)"}
#: Quantities of the facts, by what they are called.
QUANTITIES = {"dy": "dy_mm", "y_max": "y_mm"}

Fact = Mapping[str, str]


def read(file: Path) -> list[Fact]:
    """Return the facts, a line for each record and PGV."""
    with file.open(newline="", encoding="utf-8") as stream:
        return [fact | _by_design(fact) for fact in csv.DictReader(stream)]


def _by_design(fact: Fact) -> dict[str, str]:
    """Return what the design method says of a fact; of y_max, as the paper, its dy."""
    change = predict_from_pgv(1e3 * float(fact["pgv_m_s"]), LI_2020).displacement_change
    return {f"design {key}": f"{change:.5g}" for key in QUANTITIES.values()}


def earthquake(fact: Fact) -> str:
    """Return what tells earthquakes apart: of old headers name and date, without the hour, and without the AS of an aftershock that one of two headers has."""
    return re.sub(r" AS\b|(?<=/\d\d),? \d\d:?\d\d$", "", fact["event"].upper())


def is_chi_chi(fact: Fact) -> bool:
    """Return whether a record is of the earthquake of Chi-Chi."""
    return earthquake(fact).startswith("CHI-CHI")


def logarithms(facts: Sequence[Fact], method: str, key: str) -> tuple[np.ndarray, list[Fact]]:
    """Return ln of prediction over analysis where there is a prediction, and the facts of these; what predicts no y_max gives dy for it."""
    pairs: list[tuple[float, Fact]] = []
    for fact in facts:
        said = float(fact[f"{method} {key}"])
        if said > 0.0:
            pairs.append((math.log(said / float(fact[key])), fact))
    return np.array([one for one, _ in pairs]), [fact for _, fact in pairs]


def measures(values: np.ndarray, weights: np.ndarray) -> tuple[float, float]:
    """Return bias and dispersion, weighted: the geometric mean, and the standard deviation of the logarithm."""
    mean = float(np.average(values, weights=weights))
    # the effective number in place of n: with equal weights the usual n - 1
    share = weights / weights.sum()
    variance = float(share @ (values - mean) ** 2) / (1.0 - float(share @ share))
    return math.exp(mean), math.sqrt(variance)


def lines(facts: Sequence[Fact]) -> list[dict[str, object]]:
    """Return a line for each method, quantity, set of records and PGV, and all PGVs."""
    chi_chi = [fact for fact in facts if is_chi_chi(fact)]
    others = [fact for fact in facts if not is_chi_chi(fact)]
    sets = {"Chi-Chi": (chi_chi, False), "others": (others, False), "all, earthquakes counted equally": (facts, True)}  # fmt: skip
    pgvs = sorted({fact["pgv_m_s"] for fact in facts}, key=float)
    found: list[dict[str, object]] = []
    for method, title in METHODS.items():
        for words, key in QUANTITIES.items():
            for name, (chosen, equally) in sets.items():
                for pgv in (*pgvs, "all"):
                    these = [fact for fact in chosen if pgv in (fact["pgv_m_s"], "all")]
                    values, known = logarithms(these, method, key)
                    counts = Counter(earthquake(fact) for fact in known)
                    weights = np.array([1.0 / counts[earthquake(fact)] if equally else 1.0 for fact in known])  # fmt: skip
                    bias, dispersion = measures(values, weights)
                    found.append(
                        {
                            "method": title, "quantity": words, "records": name, "pgv_m_s": pgv, "cases": len(known),
                            "without": len(these) - len(known), "earthquakes": len(counts),
                            "bias": f"{bias:.3f}", "dispersion": f"{dispersion:.3f}",
                        }
                    )  # fmt: skip
    return found


def markdown(found: Sequence[Mapping[str, object]]) -> str:
    """Return the table of bias (dispersion), a line for each method, quantity and set of records."""
    pgvs = list(dict.fromkeys(str(one["pgv_m_s"]) for one in found))
    head = ["method", "quantity", "records", *(f"{one} m/s" if one != "all" else "all PGVs" for one in pgvs)]
    rows: dict[tuple[object, ...], list[str]] = {}
    for one in found:
        row = rows.setdefault((one["method"], one["quantity"], one["records"]), [])
        row.append(f"{float(str(one['bias'])):.2f} ({float(str(one['dispersion'])):.2f})")
    table = [head, ["---"] * 3 + ["---:"] * len(pgvs), *([*map(str, key), *row] for key, row in rows.items())]
    return "\n".join("| " + " | ".join(row) + " |" for row in table)


def main(file: Path, folder: Path) -> None:
    """Compute everything."""
    facts = read(file)
    found = lines(facts)
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "held_out.csv").open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(found[0]))
        writer.writeheader()
        writer.writerows(found)
    print(markdown(found))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: python held_out.py FACTS.csv [FOLDER]")
    source = Path(sys.argv[1])
    main(source, Path(sys.argv[2]) if len(sys.argv) == 3 else source.parent)
